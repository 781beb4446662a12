/* Norms of the error of a field known at particles, against its exact values there.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_MEASURES_ERROR_NORMS_H
#define VERIFICATION_MEASURES_ERROR_NORMS_H

#include <stddef.h>

/* With e_p = |computed - exact| at particle p, the root of the weighted sum of squares of the
 * components' differences, and w_p the particle's share of the body (w sums to 1):
 *   l1 = sum w_p e_p,  l2 = sqrt(sum w_p e_p^2),  linf = max e_p,
 * all in the unit of the field; exact_l2 and exact_linf are the same of the exact field. */
struct error_norms {
    double l1, l2, linf;
    double exact_l2, exact_linf;
};

/* `count` particles of `components` values each, particle-major. `weight`: of any common factor
 * (initial volumes, so that they hold no error; masses, where the density is one); a particle of
 * weight 0 is left out; NULL: all alike. `multiple`: how often a component counts in the square,
 * NULL for once (the off-diagonal one of a symmetric tensor counts twice). NaN if no particle is
 * left or a value of one is NaN. */
struct error_norms error_norms(size_t count, size_t components, const double *multiple,
                               const double *weight, const double *computed, const double *exact);

/* The norms over several instants as well: means of l1, root mean squares of l2, maxima of linf,
 * and so for the exact field. NaN if count is 0. An error that waves carry to and fro passes
 * through zero at times, where its order is not that of its size; norms over time do not. */
struct error_norms error_norms_over_time(size_t count, const struct error_norms *norms);

/* l2 over exact_l2. */
double error_norms_relative(const struct error_norms *norms);

#endif
