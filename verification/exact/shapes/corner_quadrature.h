/* CPDI's functions by nested adaptive quadrature, N&G (30), (36); see shape_quadrature.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_EXACT_CORNER_QUADRATURE_H
#define VERIFICATION_EXACT_CORNER_QUADRATURE_H

#include "verification/exact/shapes/shape_quadrature.h"

struct corner_quadrature; /* work space */

/* NULL when out of memory. */
struct corner_quadrature *corner_quadrature_create(void);
void corner_quadrature_free(struct corner_quadrature *quadrature);

/* A domain: centre, domain vectors d1 and d2, and r = 0, in cells from node 0. */
struct parallelogram {
    long double centre[2], zero;
    double domain_vector[2][2];
    bool radial; /* the weight is r, else one; then the value of T <r> is S */
};

/* The values of one node. Tolerances grow with `magnification`. Returns false if a quadrature
 * did not reach its tolerance. Cost: 10 us. */
bool corner_quadrature_node(struct corner_quadrature *quadrature, const struct parallelogram *shape,
                            double magnification, int64_t column, int64_t row,
                            struct shape_reference *reference);

#endif
