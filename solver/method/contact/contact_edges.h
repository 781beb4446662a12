/* How far the particles of two fields go towards each other at a node.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_CONTACT_EDGES_H
#define MPM_METHOD_CONTACT_EDGES_H

#include "method/contact/contact_particles.h"

/* The edges of both fields of pairs with a normal: how far their particles, with the domains that F
 * carries, go along the line through the node along the normal. What lies beside that line counts
 * for less, by MPM_EDGE_SLOPE of its distance: of curved surfaces and corners the part at the node
 * is meant. Cost: the same particles, without stencils. */
void mpm_contact_edges_find(struct mpm_state *state, int workers);
#define MPM_EDGE_SLOPE 1.0

/* Of a domain from the node: parts along the normal and across it, of its centre and of both of its
 * half edges. */
struct mpm_domain_seen {
    double along, across;
    double edge_along[2], edge_across[2];
};

/* The least (n + s t) . x of the domain. */
static inline double mpm_domain_least(const struct mpm_domain_seen *seen, double s)
{
    /* both at once: round-off of a mirrored domain, whose edges change places, is the same */
    return seen->along + s * seen->across -
           (fabs(seen->edge_along[0] + s * seen->edge_across[0]) +
            fabs(seen->edge_along[1] + s * seen->edge_across[1]));
}

/* Where the line through the node crosses the domain: the largest one has s at an end or where a
 * term changes its sign. */
static inline double mpm_domain_crossed(const struct mpm_domain_seen *seen)
{
    const double low = mpm_domain_least(seen, -MPM_EDGE_SLOPE),
                 high = mpm_domain_least(seen, MPM_EDGE_SLOPE);
    double largest = low > high ? low : high;
    for (int k = 0; k < 2; k++) {
        const double s = -seen->edge_along[k];
        if (!(fabs(s) < MPM_EDGE_SLOPE * fabs(seen->edge_across[k])))
            continue;
        const double least = mpm_domain_least(seen, s / seen->edge_across[k]);
        largest = least > largest ? least : largest;
    }
    return largest;
}

/* The least n . x + m |t . x| of a parallelogram, with t across n and m = MPM_EDGE_SLOPE; `from` is
 * its centre and `edge` its half edges d1x d1y d2x d2y. *beside: the least |t . x|.
 *
 * |m t . x| is the largest s t . x with |s| <= m, and least and largest may change places, since
 * the expression is linear in both. With c for `from`, that gives
 *     max over s of  (n + s t) . c - |(n + s t) . d1| - |(n + s t) . d2|,
 * which is concave in s, with kinks where a term is zero: the best of both ends and those. Where
 * all of the domain is on one side of the line through the node along n, one end is it. Round-off:
 * a few eps of |c| + |d1| + |d2|. */
MPM_INLINE double mpm_domain_nearest(const double edge[4], const double from[2], const double n[2],
                                     double *beside)
{
    const struct mpm_domain_seen seen = {
        .along = n[0] * from[0] + n[1] * from[1],
        .across = n[0] * from[1] - n[1] * from[0],
        .edge_along = {n[0] * edge[0] + n[1] * edge[1], n[0] * edge[2] + n[1] * edge[3]},
        .edge_across = {n[0] * edge[1] - n[1] * edge[0], n[0] * edge[3] - n[1] * edge[2]},
    };
    const double apart =
        fabs(seen.across) - (fabs(seen.edge_across[0]) + fabs(seen.edge_across[1]));
    *beside = apart > 0.0 ? apart : 0.0;
    if (apart > 0.0)
        return mpm_domain_least(&seen, seen.across > 0.0 ? MPM_EDGE_SLOPE : -MPM_EDGE_SLOPE);
    return mpm_domain_crossed(&seen);
}

#endif
