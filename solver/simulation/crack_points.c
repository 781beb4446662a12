/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "simulation/crack_points.h"

#include "method/cracks/crack_opening.h"
#include "model/region.h"

#include <math.h>
#include <stdint.h>

/* May cracks cut the body? */
static bool is_cut(const struct mpm_scene *scene, size_t body)
{
    const struct mpm_contact_spec *const contact = &scene->contact;
    return !scene->bodies[body].rigid &&
           (contact->field_count == 0 ||
            contact->field_of[contact->group_of[body]] == contact->cracked_field);
}

bool mpm_crack_point_is_in_a_body(const struct mpm_scene *scene, const double place[2])
{
    static const double around[4][2] = {{-1.0, -1.0}, {1.0, -1.0}, {-1.0, 1.0}, {1.0, 1.0}};
    const double aside = 1e-6 * fmin(scene->cell[0], scene->cell[1]);
    for (size_t k = 0; k < scene->body_count; k++)
        for (int i = 0; i < 4 && is_cut(scene, k); i++) {
            const double near[2] = {place[0] + aside * around[i][0],
                                    place[1] + aside * around[i][1]};
            if (mpm_region_contains(&scene->bodies[k].region, near, 0.1 * aside))
                return true;
        }
    return false;
}

/* ------------------------------------------------------------------- mouths */

/* A place on the scene's chain. */
struct place {
    size_t segment;
    double part; /* of the segment, from its first point */
};

static void find_place(const struct mpm_crack_spec *spec, const struct place *place, double x[2])
{
    const double *const a = spec->points[place->segment], *const b =
                                                              spec->points[place->segment + 1];
    for (int axis = 0; axis < 2; axis++)
        x[axis] = place->part == 1.0 ? b[axis] : a[axis] + place->part * (b[axis] - a[axis]);
}

static bool is_inside(const struct mpm_scene *scene, const struct mpm_crack_spec *spec,
                      const struct place *place)
{
    double x[2];
    find_place(spec, place, x);
    return mpm_crack_point_is_in_a_body(scene, x);
}

static double segment_length(const struct mpm_crack_spec *spec, size_t segment)
{
    const double *const a = spec->points[segment], *const b = spec->points[segment + 1];
    return hypot(b[0] - a[0], b[1] - a[1]);
}

/* Halves the way between a place outside and one inside, on one segment, to the last bits. */
static struct place find_edge(const struct mpm_scene *scene, const struct mpm_crack_spec *spec,
                              struct place outside, struct place inside)
{
    enum { HALVINGS = 52 };
    for (int k = 0; k < HALVINGS; k++) {
        const struct place middle = {inside.segment, 0.5 * (outside.part + inside.part)};
        if (is_inside(scene, spec, &middle))
            inside = middle;
        else
            outside = middle;
    }
    return inside;
}

/* Searches along the chain from one of its ends. False: it begins inside, or is outside as a whole.
 */
static bool find_mouth(const struct mpm_scene *scene, const struct mpm_crack_spec *spec, int end,
                       struct place *mouth)
{
    static const double LOOKS_A_CELL = 32.0;
    const double apart = fmin(scene->cell[0], scene->cell[1]) / LOOKS_A_CELL;
    const size_t segments = spec->point_count - 1;
    for (size_t k = 0; k < segments; k++) {
        const size_t segment = end == 0 ? k : segments - 1 - k;
        const double looks = ceil(segment_length(spec, segment) / apart);
        struct place before = {segment, end == 0 ? 0.0 : 1.0};
        for (double i = 0.0; i <= looks; i++) {
            const double part = i / looks;
            const struct place now = {segment, end == 0 ? part : 1.0 - part};
            if (is_inside(scene, spec, &now)) {
                if (k == 0 && i == 0.0)
                    return false;
                *mouth = find_edge(scene, spec, before, now);
                return true;
            }
            before = now;
        }
    }
    return false;
}

/* ------------------------------------------------------------------- points */

/* What goes along a chain: it counts points, places them if there is room, and meets mouths. */
struct walk {
    const struct mpm_scene *scene;
    const struct mpm_crack_spec *spec;
    double *x, *y; /* NULL: points are only counted */
    size_t count;
    bool has_mouth[2];
    struct place mouth[2];
    size_t at[2]; /* the mouths' points, once they are met */
};

static void put(struct walk *walk, const struct place *place, double part)
{
    double x[2];
    const struct place there = {place->segment, part};
    find_place(walk->spec, &there, x);
    if (walk->x != NULL) {
        walk->x[walk->count] = x[0];
        walk->y[walk->count] = x[1];
    }
    walk->count++;
}

/* Parts that a piece of a segment is cut into. */
static size_t parts_of(const struct walk *walk, size_t segment, double piece)
{
    const double longest = walk->spec->spacing * fmin(walk->scene->cell[0], walk->scene->cell[1]);
    const double length = piece * segment_length(walk->spec, segment);
    return (size_t)fmax(ceil(length / longest * (1.0 - 1e-9)), 1.0);
}

/* All points of a piece of a segment but its last. */
static void walk_piece(struct walk *walk, size_t segment, double from, double to)
{
    const struct place place = {segment, from};
    const size_t parts = parts_of(walk, segment, to - from);
    for (size_t i = 0; i < parts; i++)
        put(walk, &place, from + (to - from) * ((double)i / (double)parts));
}

/* Places so near to each other, in parts, are one. */
static const double NEAR = 1e-6;

/* The part that the mouth is a point of, whose segment need not be cut; or -1. */
static double point_at(const struct walk *walk, int end)
{
    const struct place *const mouth = &walk->mouth[end];
    const double place = mouth->part * (double)parts_of(walk, mouth->segment, 1.0);
    return fabs(place - round(place)) <= NEAR || walk->spec->cohesive.law != NULL ? round(place)
                                                                                  : -1.0;
}

static void walk_segment(struct walk *walk, size_t segment)
{
    const size_t first = walk->count;
    bool here[2], cut = false;
    double from = 0.0;
    for (int end = 0; end < 2; end++) {
        here[end] = walk->has_mouth[end] && walk->mouth[end].segment == segment;
        cut = cut || (here[end] && point_at(walk, end) < 0.0);
    }
    for (int end = 0; end < 2; end++) { /* the first mouth comes before the last */
        if (here[end] && !cut)
            walk->at[end] = first + (size_t)point_at(walk, end);
        if (!here[end] || !cut)
            continue;
        if (walk->mouth[end].part > from)
            walk_piece(walk, segment, from, walk->mouth[end].part);
        from = walk->mouth[end].part;
        walk->at[end] = walk->count;
    }
    if (from < 1.0)
        walk_piece(walk, segment, from, 1.0);
}

static struct walk walk_chain(const struct mpm_scene *scene, const struct mpm_crack_spec *spec,
                              double *x, double *y)
{
    struct walk walk = {.scene = scene, .spec = spec, .x = x, .y = y, .at = {SIZE_MAX, SIZE_MAX}};
    const size_t segments = spec->point_count - 1;
    const struct place last = {segments - 1, 1.0};
    for (int end = 0; end < 2 && mpm_crack_is_followed(spec); end++) {
        double *const part = &walk.mouth[end].part;
        walk.has_mouth[end] = find_mouth(scene, spec, end, &walk.mouth[end]);
        *part = *part < NEAR ? 0.0 : *part > 1.0 - NEAR ? 1.0 : *part;
    }
    for (size_t k = 0; k < segments; k++)
        walk_segment(&walk, k);
    put(&walk, &last, 1.0);
    return walk;
}

size_t mpm_crack_points_place(const struct mpm_scene *scene, const struct mpm_crack_spec *spec,
                              double *x, double *y)
{
    return walk_chain(scene, spec, x, y).count;
}

void mpm_crack_points_mouths(const struct mpm_scene *scene, const struct mpm_crack_spec *spec,
                             size_t first, size_t mouths[2])
{
    const struct walk walk = walk_chain(scene, spec, NULL, NULL);
    for (int end = 0; end < 2; end++)
        mouths[end] = walk.at[end] == SIZE_MAX ? SIZE_MAX : first + walk.at[end];
}
