/* The solver's shape functions against the quadrature of their definitions.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_MEASURES_SHAPE_COMPARISON_H
#define VERIFICATION_MEASURES_SHAPE_COMPARISON_H

#include "verification/exact/shapes/shape_quadrature.h"

#include <stddef.h>

/* Running totals over domains; start from all zeros.
 *
 * An error is |code - reference| / max(1, |reference|, magnification) of S, G_x dx, G_y dy
 * or T <r_p>: absolute where the function is of order one, relative where a domain across
 * the axis makes it large. Estimates are measured by the same scale. */
struct shape_comparison {
    double error[SHAPE_VALUES];    /* largest so far; NaN once a value was NaN */
    double estimate[SHAPE_VALUES]; /* largest of the quadrature's own bound */
    size_t samples;                /* domains compared */
    size_t nodes_reached;          /* nodes compared, over all domains */
    size_t nodes_outside;          /* nodes out of reach, which must have no entry */
    size_t strays;                 /* entries of such nodes, of a node twice, or all zero */
};

/* Compares one domain at every node that it reaches and at the ring around them. A node
 * without an entry counts as S = G = T = 0. A node whose support ends within 1e-11 of a cell
 * from the domain may have an entry or none. Returns false if the reference failed. */
bool shape_comparison_add(struct shape_comparison *comparison, struct shape_quadrature *quadrature,
                          const struct mpm_shape_query *query);

/* The largest of the four; NaN if one of them is. */
double shape_comparison_error(const struct shape_comparison *comparison);
/* The largest error of the function that errs least; T only in axisymmetry. Zero means that
 * one of them was not compared. */
double shape_comparison_least(const struct shape_comparison *comparison, bool has_t);
double shape_comparison_estimate(const struct shape_comparison *comparison);

#endif
