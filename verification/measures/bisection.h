/* The border between what passes and what fails along one axis, by a ladder and bisection.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_MEASURES_BISECTION_H
#define VERIFICATION_MEASURES_BISECTION_H

#include "mpm.h"

/* Sets *passes to whether `value` passes; a failure ends the search. */
typedef enum mpm_status bisection_test(void *context, double value, bool *passes,
                                       struct mpm_error *error);

struct bisection_border {
    double passes; /* largest value known to pass below the first that fails; 0: none does */
    double fails;  /* smallest value known to fail above it; infinite: none does */
    size_t passed; /* rungs of the ladder that pass, */
    size_t stray;  /* those of them above one that fails: passing is not monotonic */
};

/* Tests every rung of `ladder` (count >= 1, positive, rising), then halves the ratio between
 * the first rung that fails and the one before it until it is at most 1 + tolerance
 * (tolerance > 0). What is tested and found depends on the answers alone. */
enum mpm_status bisection_find(const double *ladder, size_t count, double tolerance,
                               bisection_test *test, void *context, struct bisection_border *border,
                               struct mpm_error *error);

#endif
