/* Agreement of computed with exact values.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/measures/comparison/agreement.h"

#include <math.h>

/* Not fmax, which passes over NaN. */
static double larger(double a, double b)
{
    return isnan(a) || a > b ? a : b;
}

void agreement_add(struct agreement *agreement, size_t components, const double *multiple,
                   const double *computed, const double *exact)
{
    double error = 0.0, size = 0.0;
    for (size_t c = 0; c < components; c++) {
        error += multiple[c] * (computed[c] - exact[c]) * (computed[c] - exact[c]);
        size += multiple[c] * exact[c] * exact[c];
        agreement->computed_sum += computed[c];
        agreement->exact_sum += exact[c];
    }
    agreement->error += sqrt(error);
    agreement->size += sqrt(size);
    agreement->error_square += error;
    agreement->size_square += size;
    agreement->error_largest = larger(agreement->error_largest, sqrt(error));
    agreement->size_largest = larger(agreement->size_largest, sqrt(size));
}

void agreement_join(struct agreement *agreement, const struct agreement *more)
{
    agreement->error += more->error;
    agreement->size += more->size;
    agreement->error_square += more->error_square;
    agreement->size_square += more->size_square;
    agreement->error_largest = larger(agreement->error_largest, more->error_largest);
    agreement->size_largest = larger(agreement->size_largest, more->size_largest);
    agreement->computed_sum += more->computed_sum;
    agreement->exact_sum += more->exact_sum;
}

double agreement_percent(const struct agreement *agreement, enum agreement_norm norm)
{
    const struct {
        double part, whole;
    } shares[AGREEMENT_NORMS] = {
        [AGREEMENT_L1] = {agreement->error, agreement->size},
        [AGREEMENT_L2] = {sqrt(agreement->error_square), sqrt(agreement->size_square)},
        [AGREEMENT_LINF] = {agreement->error_largest, agreement->size_largest},
        [AGREEMENT_MEAN] = {agreement->computed_sum, agreement->exact_sum},
    };
    if (!(fabs(shares[norm].whole) > 0))
        return (double)NAN;
    const double share = shares[norm].part / shares[norm].whole;
    return 100.0 * (norm == AGREEMENT_MEAN ? share : 1.0 - share);
}

const char *agreement_norm_words(enum agreement_norm norm)
{
    static const char *const words[AGREEMENT_NORMS] = {
        [AGREEMENT_L1] =
            "100 % less the sum of |computed - reference| over the sum of |reference|, "
            "all points and instants",
        [AGREEMENT_L2] = "100 % less the root of the sum of |computed - reference|^2 over that of "
                         "|reference|^2, all points and instants",
        [AGREEMENT_LINF] = "100 % less the largest |computed - reference| over the largest "
                           "|reference|, all points and instants",
        [AGREEMENT_MEAN] = "sum of computed over sum of reference, all points and instants",
    };
    return words[norm];
}
