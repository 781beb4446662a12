/* How far computed values agree with exact ones, in percent: 100 less the relative error.
 *
 * An answer of zero agrees to 0 %, a perfect one to 100 %, so that a band about 100 % holds neither
 * nothing nor the initial state.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_MEASURES_AGREEMENT_H
#define VERIFICATION_MEASURES_AGREEMENT_H

#include <stddef.h>

enum agreement_norm { AGREEMENT_L1, AGREEMENT_L2, AGREEMENT_LINF, AGREEMENT_MEAN, AGREEMENT_NORMS };

/* Sums over the points that were added; zeros are none. */
struct agreement {
    double error, size; /* sums of |computed - exact| and |exact| */
    double error_square, size_square;
    double error_largest, size_largest;
    double computed_sum, exact_sum; /* of all components */
};

/* Adds a point with the values of `components`; `multiple`: how often each counts in the squares
 * (an off-diagonal component of a symmetric tensor twice). A value that is not finite makes every
 * norm NaN. */
void agreement_add(struct agreement *agreement, size_t components, const double *multiple,
                   const double *computed, const double *exact);

/* Adds the points of `more`. */
void agreement_join(struct agreement *agreement, const struct agreement *more);

/* 100 (1 - E): E is sum e / sum s, sqrt(sum e^2 / sum s^2) or max e / max s, where e and s are
 * |computed - exact| and |exact| of a point; or, as the mean, 100 sum computed / sum exact. NaN if
 * the exact field is zero. */
double agreement_percent(const struct agreement *agreement, enum agreement_norm norm);

/* What the norm is, in words. */
const char *agreement_norm_words(enum agreement_norm norm);

#endif
