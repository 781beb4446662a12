/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/contact/inclusion.h"

#include <math.h>

double inclusion_modulus(const struct inclusion *inclusion, int body)
{
    return inclusion->bulk[body] +
           (inclusion->dimensions == 2 ? inclusion->shear[body] / 3.0 : 0.0);
}

double inclusion_effective_modulus(const struct inclusion *inclusion)
{
    return 1.0 / (1.0 / inclusion_modulus(inclusion, 0) +
                  inclusion->dimensions / (inclusion->interface * inclusion->radius));
}

struct inclusion_state inclusion_state(const struct inclusion *inclusion, double r)
{
    const int d = inclusion->dimensions;
    const double k = inclusion_modulus(inclusion, 1), same = inclusion_effective_modulus(inclusion);
    const double shear = 2.0 * (d - 1) * inclusion->shear[1];
    /* B over A */
    const double share = pow(inclusion->radius, d) * d * (k - same) / (d * same + shear);
    const double a =
        inclusion->displacement / (inclusion->outer + share / pow(inclusion->outer, d - 1));
    const double b = share * a;
    if (r <= inclusion->radius) {
        const double stress = d * k * a - shear * b / pow(inclusion->radius, d);
        return (struct inclusion_state){
            .u = stress / (d * inclusion_modulus(inclusion, 0)) * r, .rr = stress, .tt = stress};
    }
    return (struct inclusion_state){
        .u = a * r + b / pow(r, d - 1),
        .rr = d * k * a - shear * b / pow(r, d),
        .tt = d * k * a + shear / (d - 1) * b / pow(r, d),
    };
}
