/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "model/crack.h"

#include "base/orientation.h"

#include <math.h>

/* fmin and fmax are calls, for the sake of NaN. */
static inline double least(double a, double b)
{
    return a < b ? a : b;
}

static inline double greatest(double a, double b)
{
    return a > b ? a : b;
}

/* Do the ranges of a and b, and of c and d, have nothing in common? */
static inline bool apart(double a, double b, double c, double d)
{
    return least(a, b) > greatest(c, d) || greatest(a, b) < least(c, d);
}

/* --------------------------------------------------------------------- parts */

static void place_of(const struct mpm_crack_chain *chain, size_t k, double place[2])
{
    place[0] = chain->x[k];
    place[1] = chain->y[k];
}

static void include(struct mpm_crack_box *box, const double place[2])
{
    for (int axis = 0; axis < 2; axis++) {
        box->low[axis] = least(box->low[axis], place[axis]);
        box->high[axis] = greatest(box->high[axis], place[axis]);
    }
}

static double along_of(const struct mpm_crack_chain *chain, int axis, size_t k)
{
    return axis == 0 ? chain->x[k] : chain->y[k];
}

/* The axis along which its points follow each other on one line, or -1. */
static int straight_axis_of(const struct mpm_crack_chain *chain, const struct mpm_crack_part *part)
{
    const int axis = fabs(part->normal[0]) < fabs(part->normal[1]) ? 0 : 1;
    double first[2], last[2], place[2];
    place_of(chain, part->first, first);
    place_of(chain, part->end, last);
    const bool rises = last[axis] > first[axis];
    for (size_t k = part->first + 1; k <= part->end; k++) {
        place_of(chain, k, place);
        const double before = along_of(chain, axis, k - 1);
        if (place[axis] == before || (place[axis] > before) != rises ||
            mpm_orientation(first, last, place) != 0.0)
            return -1;
    }
    return axis;
}

/* Of the way between two places against the part's line; without bound if it leads back. */
static double slope_of(const struct mpm_crack_part *part, const double from[2], const double to[2])
{
    const double x = to[0] - from[0], y = to[1] - from[1];
    const double along = part->normal[1] * x - part->normal[0] * y;
    return along > 0.0 ? fabs(part->normal[0] * x + part->normal[1] * y) / along : HUGE_VAL;
}

struct mpm_crack_part mpm_crack_part_of(const struct mpm_crack_chain *chain, size_t first,
                                        size_t end, double slack)
{
    struct mpm_crack_part part = {
        .first = first, .end = end, .thickness = HUGE_VAL, .straight_axis = -1};
    double from[2], place[2];
    place_of(chain, first, from);
    place_of(chain, end, place);
    part.box = (struct mpm_crack_box){{from[0], from[1]}, {from[0], from[1]}};
    const double along[2] = {place[0] - from[0], place[1] - from[1]};
    const double length = sqrt(along[0] * along[0] + along[1] * along[1]);
    const bool has_line = length > slack;
    double farthest = 0.0, before[2] = {from[0], from[1]};
    if (has_line) {
        part.normal[0] = -along[1] / length;
        part.normal[1] = along[0] / length;
        part.offset = part.normal[0] * from[0] + part.normal[1] * from[1];
    }
    for (size_t k = first + 1; k <= end; k++) {
        place_of(chain, k, place);
        include(&part.box, place);
        farthest = greatest(farthest, fabs(mpm_crack_part_distance(&part, place)));
        part.steepest = greatest(part.steepest, slope_of(&part, before, place));
        before[0] = place[0];
        before[1] = place[1];
    }
    if (has_line)
        part.thickness = farthest + slack;
    if (farthest < slack)
        part.straight_axis = straight_axis_of(chain, &part);
    return part;
}

bool mpm_crack_part_near(const struct mpm_crack_chain *chain, const struct mpm_crack_box *box,
                         double slack, struct mpm_crack_part *part)
{
    size_t first = 0, end = 0;
    for (size_t k = 0; k + 1 < chain->count; k++) {
        double one[2], other[2];
        place_of(chain, k, one);
        place_of(chain, k + 1, other);
        if (apart(one[0], other[0], box->low[0], box->high[0]) ||
            apart(one[1], other[1], box->low[1], box->high[1]))
            continue;
        first = end == 0 ? k : first;
        end = k + 1;
    }
    if (end > 0)
        *part = mpm_crack_part_of(chain, first, end, slack);
    return end > 0;
}

/* ------------------------------------------------------------------ crossings */

/* 1 from above, -1 from below, 0: not crossed. Of points on the line, the first one of a segment
 * that is crossed from above belongs to it, and the last one of one that is crossed from below: as
 * if they all lay on the line's right, a chain that only touches the line crosses it not at all or
 * twice. `opens`, `closes`: the segment has an end of the chain, which always belongs to it. */
static inline int crossing(const double particle[2], const double node[2], const double first[2],
                           const double last[2], bool opens, bool closes)
{
    const double beside = mpm_orientation(first, last, particle);
    const double sign = beside > 0.0 ? 1.0 : -1.0;
    if (beside == 0.0 || sign * mpm_orientation(first, last, node) > 0.0)
        return 0;
    const double at_first = sign * mpm_orientation(particle, node, first);
    const double at_last = sign * mpm_orientation(particle, node, last);
    if (at_first > 0.0 || (at_first == 0.0 && !opens && beside < 0.0))
        return 0;
    if (at_last < 0.0 || (at_last == 0.0 && !closes && beside > 0.0))
        return 0;
    return beside > 0.0 ? 1 : -1;
}

/* The same for a node on the point `at` that two segments share: above is what lies between both,
 * on their left. 0: the particle is on the crack. */
static int crossing_at_point(const double particle[2], const double before[2], const double at[2],
                             const double after[2])
{
    const double one = mpm_orientation(before, at, particle),
                 other = mpm_orientation(at, after, particle);
    const bool turns_left = mpm_orientation(before, at, after) > 0.0;
    if (turns_left ? one > 0.0 && other > 0.0 : one > 0.0 || other > 0.0)
        return 1;
    return (turns_left ? one < 0.0 || other < 0.0 : one < 0.0 && other < 0.0) ? -1 : 0;
}

void mpm_crack_segment_normal(const struct mpm_crack_chain *chain, size_t segment, double normal[2])
{
    const double along[2] = {chain->x[segment + 1] - chain->x[segment],
                             chain->y[segment + 1] - chain->y[segment]};
    const double length = sqrt(along[0] * along[0] + along[1] * along[1]);
    normal[0] = along[1] / length;
    normal[1] = -along[0] / length;
}

static inline bool are_same(const double a[2], const double b[2])
{
    return a[0] == b[0] && a[1] == b[1];
}

/* Of segment k. A node on a point of two segments counts with the later one. */
static inline int crossing_of(const struct mpm_crack_chain *chain, size_t k,
                              const double particle[2], const double node[2], const double first[2],
                              const double last[2])
{
    const bool opens = k == 0, closes = k + 2 == chain->count;
    if (!closes && are_same(node, last))
        return 0;
    if (!opens && are_same(node, first)) {
        const double before[2] = {chain->x[k - 1], chain->y[k - 1]};
        return crossing_at_point(particle, before, first, last);
    }
    return crossing(particle, node, first, last, opens, closes);
}

/* Of segment k, if it is near enough. */
static int crossing_near(const struct mpm_crack_chain *chain, size_t k, const double particle[2],
                         const double node[2])
{
    double first[2], last[2];
    place_of(chain, k, first);
    place_of(chain, k + 1, last);
    if (apart(particle[0], node[0], first[0], last[0]) ||
        apart(particle[1], node[1], first[1], last[1]))
        return 0;
    return crossing_of(chain, k, particle, node, first, last);
}

/* Of several crossed segments *segment is the middle one. */
static enum mpm_crack_side side_by_segments(const struct mpm_crack_chain *chain,
                                            const struct mpm_crack_part *part,
                                            const double particle[2], const double node[2],
                                            size_t *segment)
{
    int count = 0, sum = 0;
    size_t k = part->first;
    if (apart(particle[0], node[0], part->box.low[0], part->box.high[0]) ||
        apart(particle[1], node[1], part->box.low[1], part->box.high[1]))
        return MPM_CRACK_SAME_SIDE;
    for (size_t found = part->first; found < part->end; found++) {
        const int from = crossing_near(chain, found, particle, node);
        k = from != 0 && count == 0 ? found : k;
        count += from != 0;
        sum += from;
    }
    /* an even number of crossings, or none, leaves both on one side */
    if (count % 2 == 0)
        return MPM_CRACK_SAME_SIDE;
    for (int before = count / 2; before > 0; before--)
        do
            k++;
        while (crossing_near(chain, k, particle, node) == 0);
    if (segment != NULL)
        *segment = k;
    return sum > 0 ? MPM_CRACK_ABOVE : MPM_CRACK_BELOW;
}

static double beside_line(const struct mpm_crack_chain *chain, size_t point,
                          const double particle[2], const double node[2])
{
    double place[2];
    place_of(chain, point, place);
    return mpm_orientation(particle, node, place);
}

/* The first segment with points on both sides of the line; points on it count as on its right. */
static size_t first_crossed(const struct mpm_crack_chain *chain, const struct mpm_crack_part *part,
                            const double particle[2], const double node[2])
{
    const bool right = beside_line(chain, part->first, particle, node) <= 0.0;
    size_t k = part->first + 1;
    while (k < part->end && (beside_line(chain, k, particle, node) <= 0.0) == right)
        k++;
    return k - 1;
}

/* A line that is steeper than all segments crosses one. */
static bool crosses_one(const struct mpm_crack_part *part, const double particle[2],
                        const double node[2])
{
    const double x = node[0] - particle[0], y = node[1] - particle[1];
    return fabs(part->normal[0] * x + part->normal[1] * y) >
           part->steepest * fabs(part->normal[1] * x - part->normal[0] * y);
}

/* Of several the middle one, whichever end the chain begins at. */
static size_t middle_crossed(const struct mpm_crack_chain *chain, const struct mpm_crack_part *part,
                             const double particle[2], const double node[2])
{
    size_t first = part->first, last = part->end;
    bool right = beside_line(chain, first, particle, node) <= 0.0;
    for (;; right = !right) {
        size_t low = first + 1, high = last - 1;
        while (low < last && (beside_line(chain, low, particle, node) <= 0.0) == right)
            low++;
        while (high >= low && (beside_line(chain, high, particle, node) <= 0.0) != right)
            high--;
        if (high < low)
            return low - 1;
        first = low;
        last = high;
    }
}

/* Is the node on a straight part, inside of it? Then *segment is the one that it is on: of two, the
 * later one. */
static bool is_on_part(const struct mpm_crack_chain *chain, const struct mpm_crack_part *part,
                       const double node[2], size_t *segment)
{
    const int axis = part->straight_axis;
    double first[2], last[2];
    if (axis < 0)
        return false;
    place_of(chain, part->first, first);
    place_of(chain, part->end, last);
    const bool rises = last[axis] > first[axis];
    const double low = rises ? first[axis] : last[axis], high = rises ? last[axis] : first[axis];
    if (!(node[axis] > low && node[axis] < high) || mpm_orientation(first, last, node) != 0.0)
        return false;
    size_t k = part->first;
    while (rises ? along_of(chain, axis, k + 1) <= node[axis]
                 : along_of(chain, axis, k + 1) >= node[axis])
        k++;
    if (segment != NULL)
        *segment = k;
    return true;
}

/* Both beyond the thickness of the part's line, on two sides of it. */
static enum mpm_crack_side side_by_line(const struct mpm_crack_chain *chain,
                                        const struct mpm_crack_part *part, const double particle[2],
                                        const double node[2], size_t *segment)
{
    const double first = beside_line(chain, part->first, particle, node),
                 last = beside_line(chain, part->end, particle, node);
    if (first == 0.0 || last == 0.0)
        return side_by_segments(chain, part, particle, node, segment);
    if ((first > 0.0) == (last > 0.0))
        return MPM_CRACK_SAME_SIDE;
    if (segment != NULL)
        *segment = crosses_one(part, particle, node) ? first_crossed(chain, part, particle, node)
                                                     : middle_crossed(chain, part, particle, node);
    return mpm_crack_part_distance(part, particle) > 0.0 ? MPM_CRACK_ABOVE : MPM_CRACK_BELOW;
}

enum mpm_crack_side mpm_crack_part_side(const struct mpm_crack_chain *chain,
                                        const struct mpm_crack_part *part, const double particle[2],
                                        const double node[2], size_t *segment)
{
    const double from = mpm_crack_part_distance(part, particle),
                 to = mpm_crack_part_distance(part, node);
    if (mpm_crack_part_is_beside(part, from, to))
        return MPM_CRACK_SAME_SIDE;
    if (fabs(from) > part->thickness && fabs(to) <= part->thickness &&
        is_on_part(chain, part, node, segment))
        return from > 0.0 ? MPM_CRACK_ABOVE : MPM_CRACK_BELOW;
    if (fabs(from) <= part->thickness || fabs(to) <= part->thickness)
        return side_by_segments(chain, part, particle, node, segment);
    return side_by_line(chain, part, particle, node, segment);
}
