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

/* Points of one chain. */
struct mpm_crack_chain {
    const double *x, *y;
    size_t count; /* 2 or more */
};

/* Segments first..end - 1, at least one, and what of them is known beforehand. */
struct mpm_crack_part {
    size_t first, end;
    struct mpm_crack_box box;
    /* all points lie within `thickness` of the line normal . x = offset from the first point to
     * the last; the normal points to the left. Infinite: no line is near to all. */
    double normal[2], offset, thickness;
    double steepest; /* the largest slope of a segment against that line */
    /* Its points lie on one line to the last bit, in order along this axis; -1: they do not. */
    int straight_axis;
};

/* Describes a part of a chain. `slack`: far more than the round-off of places of the scene, by
 * which the line is thicker. Cost: some ns a segment. */
struct mpm_crack_part mpm_crack_part_of(const struct mpm_crack_chain *chain, size_t first,
                                        size_t end, double slack);

/* The part that has all segments which meet a box, edges included; false: none does. Cost: some ns
 * for each segment of the chain. */
bool mpm_crack_part_near(const struct mpm_crack_chain *chain, const struct mpm_crack_box *box,
                         double slack, struct mpm_crack_part *part);

/* The distance of a place from the part's line, positive on the left. */
static inline double mpm_crack_part_distance(const struct mpm_crack_part *part,
                                             const double place[2])
{
    return part->normal[0] * place[0] + part->normal[1] * place[1] - part->offset;
}

/* Do two places at these distances have the whole part on one side? Then nothing is crossed. */
static inline bool mpm_crack_part_is_beside(const struct mpm_crack_part *part, double one,
                                            double other)
{
    return (one > part->thickness && other > part->thickness) ||
           (one < -part->thickness && other < -part->thickness);
}

/* On which side is the particle, seen from the node? Only segments of the part are looked at: it
 * must have all that meet the box around both places. `segment`, unless NULL, gets the first one
 * that is crossed, where an odd number is.
 *
 * Places that are farther from the part's line than its points are see it as one segment: with
 * both on one side nothing is crossed; else the line between them passes all segments of the part
 * or none of them beside it, and crosses an odd number if its first and last point lie on
 * different sides of it. A node on a part that is straight to the last bit is crossed from where
 * the particle is. Others take the segments one by one. Cost: some ns, or some ns a segment. */
enum mpm_crack_side mpm_crack_part_side(const struct mpm_crack_chain *chain,
                                        const struct mpm_crack_part *part, const double particle[2],
                                        const double node[2], size_t *segment);

/* The unit normal of a segment, from above to below. */
void mpm_crack_segment_normal(const struct mpm_crack_chain *chain, size_t segment,
                              double normal[2]);

#endif
