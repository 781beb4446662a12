/* Shape functions by adaptive quadrature of their definitions.
 *
 * S, G and T of one particle domain and any node, N&G (6)-(8) and Notes (16), (17), from
 * the grid's hat functions alone: no closed form of the literature is used.
 *
 *   classic  chi is A_p times a delta function: S = N_i, G = grad N_i, T = N_i / r_p.
 *   uGIMP    chi = 1 over the undeformed rectangle around the particle. The integrals
 *            split into one of r and one of z, each done by QAGP with break points on
 *            the grid lines and on r = 0. Truncated, the rectangle is cut at r = 0 and
 *            normalised by the area and the centroid of what remains.
 *   CPDI     N&G (30), (36): over the parallelogram with domain vectors d1 = F (half_r, 0)
 *            and d2 = F (0, half_z), N_i replaced by its bilinear interpolation from the
 *            four corners; nested adaptive quadrature in (rho, zeta). Truncated, d1 and
 *            d2 shrink by r_p / (|d1r| + |d2r|) if that is less than one.
 *   B-splines, of points: S = phi_i, G = grad phi_i, T = phi_i / r_p, see spline_quadrature.h;
 *            folded at the first and the last node of a grid that has edges, and at r = 0.
 *
 * In axisymmetry the weight is r and the normalisation A_p <r_p>, with the area mean of r
 * over the same domain; an untruncated domain that crosses r = 0 keeps the sign of r. The
 * planar functions used axisymmetrically (MPM_PLANAR) have the weight one and T = S / r_p.
 *
 * Results are without unit: S, G_x dx, G_y dy (dx, dy the cell's edges) and T <r_p>, each
 * of which is of order one wherever the weight keeps its sign.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_EXACT_SHAPE_QUADRATURE_H
#define VERIFICATION_EXACT_SHAPE_QUADRATURE_H

#include "mpm.h"

#include <stdbool.h>
#include <stdint.h>

/* Order of the values of a node. */
enum shape_value { SHAPE_S, SHAPE_GX, SHAPE_GY, SHAPE_T, SHAPE_VALUES };

struct shape_reference {
    double value[SHAPE_VALUES];
    double estimate[SHAPE_VALUES]; /* the quadrature's own bound on the error; 0 in classic */
    /* How far the domain (CPDI: its deepest corner) reaches into the support of the node,
     * in cells: <= 0 means that S = G = T = 0 by definition. -1 for nodes at r < 0 of a
     * truncated domain. */
    double depth;
};

/* What the nodes of one domain have in common. */
struct shape_domain {
    int64_t first[2];   /* node, column and row: every node that the domain reaches and a */
    int64_t last[2];    /* ring of at least one node around them lie within, inclusive */
    double mean_radius; /* <r_p> in the unit of length; 0 in planar geometry */
    bool crosses_axis;  /* an untruncated domain with r < 0 in it */
    /* Area mean of |r| over |<r_p>|, from the domain's reach in r: the factor by which the
     * sign change of the weight magnifies rounding. 1 unless crosses_axis. */
    double magnification;
};

struct shape_quadrature; /* work space and the domain prepared last */

/* NULL when out of memory. */
struct shape_quadrature *shape_quadrature_create(void);
void shape_quadrature_free(struct shape_quadrature *quadrature);

/* Takes a particle's domain: half_size up to one cell for uGIMP, |F| without limit for
 * CPDI, r_p > 0 (truncated uGIMP: r_p >= 0). Returns false if a value is not finite, out of
 * that range, or if a quadrature did not reach its tolerance. Cost: a few us for uGIMP. */
bool shape_quadrature_prepare(struct shape_quadrature *quadrature,
                              const struct mpm_shape_query *query, struct shape_domain *domain);

/* The values of one node of the domain prepared last. Returns false if a quadrature did not
 * reach its tolerance. Cost: 10 us for CPDI, else nothing. */
bool shape_quadrature_node(struct shape_quadrature *quadrature, int64_t column, int64_t row,
                           struct shape_reference *reference);

#endif
