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

static void include(struct mpm_crack_box *box, const struct mpm_crack_box *other)
{
    for (int axis = 0; axis < 2; axis++) {
        box->low[axis] = least(box->low[axis], other->low[axis]);
        box->high[axis] = greatest(box->high[axis], other->high[axis]);
    }
}

static struct mpm_crack_box segment_box(const struct mpm_crack_chain *chain, size_t k)
{
    return (struct mpm_crack_box){
        .low = {least(chain->x[k], chain->x[k + 1]), least(chain->y[k], chain->y[k + 1])},
        .high = {greatest(chain->x[k], chain->x[k + 1]), greatest(chain->y[k], chain->y[k + 1])},
    };
}

void mpm_crack_chain_bound(struct mpm_crack_chain *chain)
{
    chain->whole = segment_box(chain, 0);
    for (size_t k = 0; k + 1 < chain->count; k++) {
        const struct mpm_crack_box box = segment_box(chain, k);
        struct mpm_crack_box *const piece = &chain->pieces[k / MPM_CRACK_PIECE];
        include(&chain->whole, &box);
        if (k % MPM_CRACK_PIECE == 0)
            *piece = box;
        include(piece, &box);
    }
}

static inline bool meet(const struct mpm_crack_box *a, const struct mpm_crack_box *b)
{
    return a->low[0] <= b->high[0] && a->high[0] >= b->low[0] && a->low[1] <= b->high[1] &&
           a->high[1] >= b->low[1];
}

bool mpm_crack_chain_meets(const struct mpm_crack_chain *chain, const struct mpm_crack_box *box)
{
    if (!meet(&chain->whole, box))
        return false;
    for (size_t k = 0; k < mpm_crack_chain_pieces(chain->count); k++)
        if (meet(&chain->pieces[k], box))
            return true;
    return false;
}

struct mpm_crack_range mpm_crack_chain_near(const struct mpm_crack_chain *chain,
                                            const struct mpm_crack_box *box)
{
    struct mpm_crack_range range = {.first = 0, .end = 0};
    if (!meet(&chain->whole, box))
        return range;
    for (size_t k = 0; k + 1 < chain->count; k++) {
        if (k % MPM_CRACK_PIECE == 0 && !meet(&chain->pieces[k / MPM_CRACK_PIECE], box)) {
            k += MPM_CRACK_PIECE - 1;
            continue;
        }
        const struct mpm_crack_box segment = segment_box(chain, k);
        if (!meet(&segment, box))
            continue;
        if (range.end == 0) {
            range.first = k;
            range.box = segment;
        }
        range.end = k + 1;
    }
    for (size_t k = range.first; k < range.end; k++) {
        const struct mpm_crack_box segment = segment_box(chain, k);
        include(&range.box, &segment);
    }
    return range;
}

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

static inline bool apart(double a, double b, double c, double d)
{
    return least(a, b) > greatest(c, d) || greatest(a, b) < least(c, d);
}

static void find_normal(const double first[2], const double last[2], double normal[2])
{
    const double along[2] = {last[0] - first[0], last[1] - first[1]};
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

enum mpm_crack_side mpm_crack_chain_side(const struct mpm_crack_chain *chain,
                                         struct mpm_crack_range range, const double particle[2],
                                         const double node[2], double normal[2])
{
    int count = 0, sum = 0;
    if (range.first == range.end ||
        apart(particle[0], node[0], range.box.low[0], range.box.high[0]) ||
        apart(particle[1], node[1], range.box.low[1], range.box.high[1]))
        return MPM_CRACK_SAME_SIDE;
    for (size_t k = range.first; k < range.end; k++) {
        const double first[2] = {chain->x[k], chain->y[k]};
        const double last[2] = {chain->x[k + 1], chain->y[k + 1]};
        if (apart(particle[0], node[0], first[0], last[0]) ||
            apart(particle[1], node[1], first[1], last[1]))
            continue;
        const int from = crossing_of(chain, k, particle, node, first, last);
        if (from == 0)
            continue;
        if (count == 0 && normal != NULL)
            find_normal(first, last, normal);
        count++;
        sum += from;
    }
    /* an even number of crossings, or none, leaves both on one side */
    if (count % 2 == 0)
        return MPM_CRACK_SAME_SIDE;
    return sum > 0 ? MPM_CRACK_ABOVE : MPM_CRACK_BELOW;
}
