/* Straight segments in the plane: the way to one, and whether two meet.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_BASE_SEGMENT_H
#define MPM_BASE_SEGMENT_H

#include <stdbool.h>

/* From a to b, which are not the same place. */
struct mpm_segment {
    double a[2], b[2];
};

/* The way from a place to the nearest point of the segment. */
void mpm_segment_find_way(const struct mpm_segment *segment, const double place[2], double way[2]);

/* Do two segments cross, or come within `near`? Crossing is decided exactly, nearness but for
 * round-off. */
bool mpm_segments_meet(const struct mpm_segment *one, const struct mpm_segment *other, double near);

/* The next segment shares the point one->b: does it fold back on this one, within `near`? */
bool mpm_segments_fold(const struct mpm_segment *one, const struct mpm_segment *next, double near);

#endif
