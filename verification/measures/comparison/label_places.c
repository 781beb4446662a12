/* Where the labels of points are in a picture.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/measures/comparison/label_places.h"

#include <math.h>

/* Sides of the point: 1 is beyond the mark, -1 before it, 0 beside it in the middle. */
static const int sides[][2] = {{1, 0}, {-1, 0}, {0, 1},  {0, -1},
                               {1, 1}, {1, -1}, {-1, 1}, {-1, -1}};

enum { SIDES = sizeof sides / sizeof sides[0], DISTANCES = 4 };

/* The lower end of a length beside a point at `at` with that much room kept. */
static double beside(double at, int side, double room, double length)
{
    if (side == 0)
        return at - 0.5 * length;
    return side > 0 ? at + room : at - room - length;
}

static bool covers_label(const struct label_place *one, const struct label_place *other)
{
    return other->placed && one->left < other->left + other->width &&
           other->left < one->left + one->width && one->low < other->low + other->height &&
           other->low < one->low + one->height;
}

static bool covers_mark(const struct label_place *label, const struct label_place *point,
                        double mark)
{
    return point->x > label->left - mark && point->x < label->left + label->width + mark &&
           point->y > label->low - mark && point->y < label->low + label->height + mark;
}

static bool has_room(const struct label_place *labels, size_t count, size_t own,
                     const struct label_frame *frame)
{
    const struct label_place *label = &labels[own];
    if (label->left < 0.0 || label->low < 0.0 || label->left + label->width > frame->width ||
        label->low + label->height > frame->height)
        return false;
    for (size_t i = 0; i < count; i++)
        if (covers_mark(label, &labels[i], frame->mark) ||
            (i != own && covers_label(label, &labels[i])))
            return false;
    return true;
}

static bool find_place(struct label_place *labels, size_t count, size_t own,
                       const struct label_frame *frame)
{
    struct label_place *label = &labels[own];
    for (int distance = 0; distance < DISTANCES; distance++) {
        const double room = (1.3 + 0.75 * distance) * frame->mark;
        for (int side = 0; side < SIDES; side++) {
            label->left = beside(label->x, sides[side][0], room, label->width);
            label->low = beside(label->y, sides[side][1], room, label->height);
            if (has_room(labels, count, own, frame))
                return true;
        }
    }
    return false;
}

size_t label_places_find(struct label_place *labels, size_t count, const struct label_frame *frame)
{
    size_t placed = 0;
    for (size_t i = 0; i < count; i++)
        labels[i].placed = false;
    for (size_t i = 0; i < count; i++) {
        labels[i].placed = labels[i].width > 0.0 && find_place(labels, count, i, frame);
        placed += labels[i].placed;
    }
    return placed;
}
