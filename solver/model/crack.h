/* Geometry of explicit cracks: chains of massless points.
 *
 * Above is on the left of the way from a chain's first point to its last, below on the right.
 *
 * Does the line from a particle to a node cross a chain, and from which side? CRAMP, Appendix, line
 * crossing by signed areas: of a segment 3-4, a particle 1 and a node 2, the signs of the areas of
 * the triangles 123, 124, 341, 342, which are exact here: CRAMP (33) rounded tells a line that
 * passes a point of the chain within round-off from both segments there, or from none. A node on
 * the crack is crossed from both sides.
 *
 * Printed there are four patterns for each side; cases of chains are not among them. A line through
 * the point that two segments share crosses neither by the patterns, and a node on that point is
 * crossed twice, hence, two being even, not at all. Both happen all the time on regular lattices.
 * Here points on the line count as if on its right: a chain that goes through the line there
 * crosses it once, one that bends back not at all or twice. A node on such a point is crossed once,
 * from the side of the angle between both segments that the particle lies in. Both ends of the
 * chain belong to it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_MODEL_CRACK_H
#define MPM_MODEL_CRACK_H

#include <stdbool.h>
#include <stddef.h>

/* The velocity field of a node that a particle belongs to, CRAMP (2). */
enum mpm_crack_side {
    MPM_CRACK_SAME_SIDE, /* nothing is crossed, or an even number of segments */
    MPM_CRACK_ABOVE,     /* the particle is above the crack, the node below or on it */
    MPM_CRACK_BELOW,
};

struct mpm_crack_box {
    double low[2], high[2];
};

/* Points of one chain, and the boxes that it and pieces of it lie in. */
struct mpm_crack_chain {
    const double *x, *y;
    size_t count; /* 2 or more */
    struct mpm_crack_box whole;
    struct mpm_crack_box *pieces; /* of MPM_CRACK_PIECE segments each */
};
enum { MPM_CRACK_PIECE = 16 };

/* Pieces of a chain of that many points. */
static inline size_t mpm_crack_chain_pieces(size_t points)
{
    return (points - 1 + MPM_CRACK_PIECE - 1) / MPM_CRACK_PIECE;
}

/* Sets the boxes. */
void mpm_crack_chain_bound(struct mpm_crack_chain *chain);

/* Segments first..end - 1, and the box that they lie in. */
struct mpm_crack_range {
    size_t first, end;
    struct mpm_crack_box box;
};

/* Does a piece of the chain meet a box? */
bool mpm_crack_chain_meets(const struct mpm_crack_chain *chain, const struct mpm_crack_box *box);

/* All segments that meet a box, edges included, are in this range; first == end: none does. */
struct mpm_crack_range mpm_crack_chain_near(const struct mpm_crack_chain *chain,
                                            const struct mpm_crack_box *box);

/* On which side is the particle, seen from the node? Only segments in the range are looked at: it
 * must be that of a box with both places in it. `normal`, unless NULL, gets the unit normal from
 * above to below of the first segment that is crossed. Cost: some ns a segment. */
enum mpm_crack_side mpm_crack_chain_side(const struct mpm_crack_chain *chain,
                                         struct mpm_crack_range range, const double particle[2],
                                         const double node[2], double normal[2]);

#endif
