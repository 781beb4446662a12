/* Sums over the nodes that shape functions owe to their definition.
 *
 * The hats reproduce constants and linear functions, sum N_i = 1 and sum x_i N_i = x, and
 * CPDI's interpolation from the corners keeps both over its parallelogram. Weighted with r
 * and averaged over the family's own domain (truncated if selected):
 *
 *   sum S = 1              sum G = 0            sum x_i (x) G = I
 *   sum x_i S = <w x>/<w>  with w = 1 (planar: the centre) or w = r (axisymmetric:
 *                          <r^2>/<r> and <r z>/<r>)
 *   sum T = 1/<r>          sum r_i T = 1        (axisymmetric)
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_MEASURES_SHAPE_IDENTITIES_H
#define VERIFICATION_MEASURES_SHAPE_IDENTITIES_H

#include "mpm.h"

#include <stddef.h>

enum shape_identity {
    SHAPE_SUM_S,  /* sum S - 1 */
    SHAPE_SUM_XS, /* (sum (x_i - x_p) S - (<w x>/<w> - x_p)) / cell, worst component */
    SHAPE_SUM_G,  /* cell sum G, worst component */
    SHAPE_SUM_XG, /* sum (x_i - x_p) (x) G - I in cells, worst of four components */
    SHAPE_SUM_RG, /* sum r_i G_r - 1: the same with r itself, axisymmetric */
    SHAPE_SUM_T,  /* <r> sum T - 1, axisymmetric */
    SHAPE_SUM_RT, /* sum r_i T - 1, axisymmetric */
    SHAPE_IDENTITY_COUNT,
};

/* Area means over the particle's domain, in the unit of length; for classic functions and
 * B-splines the point. Those of N&G (6)-(8): planar functions used axisymmetrically
 * (MPM_PLANAR) owe the same, and have sum x_i S = x_p instead. */
struct shape_moments {
    double radius;        /* <r>; 0 in planar geometry */
    double offset[2];     /* <w x>/<w> - x_p */
    double magnification; /* <|r|>/|<r>| or more, 1 unless the domain crosses the axis */
};
struct shape_moments shape_moments_of(const struct mpm_shape_query *query);

/* Largest residual of each identity so far; start from all zeros. A residual is without
 * unit and, for domains that cross the axis, divided by the magnification. */
struct shape_residuals {
    double residual[SHAPE_IDENTITY_COUNT];
    size_t samples;
};

/* Sums the stencil of one domain. NaN among the entries makes the residuals NaN. */
void shape_residuals_add(struct shape_residuals *residuals, const struct mpm_shape_query *query);

#endif
