/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/cracks/struck_crack.h"

#include <math.h>

double struck_crack_celerity(const struct struck_crack *crack)
{
    const double nu = crack->poisson;
    return sqrt(crack->modulus * (1.0 - nu) / ((1.0 + nu) * (1.0 - 2.0 * nu) * crack->density));
}

/* int_0^t sqrt(s) ds */
static double integral_of_root(double time)
{
    return time > 0.0 ? 2.0 / 3.0 * time * sqrt(time) : 0.0;
}

double struck_crack_intensity(const struct struck_crack *crack, double time)
{
    const double pi = acos(-1.0), nu = crack->poisson;
    const double scale = 2.0 * crack->stress / (1.0 - nu) *
                         sqrt(struck_crack_celerity(crack) * (1.0 - 2.0 * nu) / pi);
    return scale * (integral_of_root(time) - integral_of_root(time - crack->rise)) / crack->rise;
}
