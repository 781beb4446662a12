/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/measures/error_norms.h"

#include "verification/measures/fields.h"

#include <math.h>

struct error_norms error_norms(size_t count, size_t components, const double *multiple,
                               const double *weight, const double *computed, const double *exact)
{
    struct error_norms norms = {0};
    double total = 0;
    for (size_t p = 0; p < count; p++) {
        const double mass = weight == NULL ? 1 : weight[p];
        double error = 0, size = 0;
        if (mass == 0)
            continue;
        for (size_t c = 0; c < components; c++) {
            const double times = multiple == NULL ? 1 : multiple[c];
            const double value = exact[components * p + c];
            const double difference = computed[components * p + c] - value;
            error += times * difference * difference;
            size += times * value * value;
        }
        total += mass;
        norms.l1 += mass * sqrt(error);
        norms.l2 += mass * error;
        norms.exact_l2 += mass * size;
        norms.linf = field_larger(norms.linf, sqrt(error));
        norms.exact_linf = field_larger(norms.exact_linf, sqrt(size));
    }
    norms.l1 /= total;
    norms.l2 = sqrt(norms.l2 / total);
    norms.exact_l2 = sqrt(norms.exact_l2 / total);
    if (!(total > 0))
        norms.linf = norms.exact_linf = (double)NAN;
    return norms;
}

struct error_norms error_norms_over_time(size_t count, const struct error_norms *norms)
{
    const double share = 1.0 / (double)count;
    struct error_norms total = {0};
    for (size_t k = 0; k < count; k++) {
        total.l1 += share * norms[k].l1;
        total.l2 += share * norms[k].l2 * norms[k].l2;
        total.exact_l2 += share * norms[k].exact_l2 * norms[k].exact_l2;
        total.linf = field_larger(total.linf, norms[k].linf);
        total.exact_linf = field_larger(total.exact_linf, norms[k].exact_linf);
    }
    total.l2 = sqrt(total.l2);
    total.exact_l2 = sqrt(total.exact_l2);
    if (count == 0)
        total =
            (struct error_norms){(double)NAN, (double)NAN, (double)NAN, (double)NAN, (double)NAN};
    return total;
}

double error_norms_relative(const struct error_norms *norms)
{
    return norms->l2 / norms->exact_l2;
}
