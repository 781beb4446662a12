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

/* The least n . x + m |t . x| of a parallelogram, with t across n and m = MPM_EDGE_SLOPE; `from` is
 * its centre and `edge` its half edges d1x d1y d2x d2y. *beside: the least |t . x|.
 *
 * |m t . x| is the largest s t . x with |s| <= m, and least and largest may change places, since
 * the expression is linear in both. With c for `from`, that gives
 *     max over s of  (n + s t) . c - |(n + s t) . d1| - |(n + s t) . d2|,
 * which is concave in s, with kinks where a term is zero: the best of both ends and those. Where
 * all of the domain is on one side of the line through the node along n, one end is it. Round-off:
 * a few eps of |c| + |d1| + |d2|. */
double mpm_domain_nearest(const double edge[4], const double from[2], const double n[2],
                          double *beside);

#endif
