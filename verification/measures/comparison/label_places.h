/* Where the labels of points are in a picture, so that they cover neither points nor each
 * other. Pure functions.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_MEASURES_LABEL_PLACES_H
#define VERIFICATION_MEASURES_LABEL_PLACES_H

#include <stdbool.h>
#include <stddef.h>

/* A picture's inside, 0 .. width and 0 .. height, with marks of that half width. */
struct label_frame {
    double width, height, mark;
};

struct label_place {
    double x, y;          /* of the point */
    double width, height; /* of the label; width 0: it has none */
    bool placed;          /* found: whether there is room beside the point */
    double left, low;     /* and the label's lower left corner */
};

/* Places the labels in their order, each as near to its point as there is room: right, left,
 * above, below, at the corners, then further out. All points are obstacles. Returns how many
 * were placed. Cost: O(count^2). */
size_t label_places_find(struct label_place *labels, size_t count, const struct label_frame *frame);

#endif
