/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/cracks/cantilever_crack.h"

#include <math.h>

double cantilever_crack_rotation(double poisson)
{
    const double ratio = 2.0 * (1.0 + poisson), gamma = 1.18 * ratio;
    const double part = gamma / (1.0 + gamma);
    return sqrt(ratio / 11.0 * (3.0 - 2.0 * part * part));
}

double cantilever_crack_release(const struct cantilever_crack *crack)
{
    const double h = crack->height;
    const double moment =
        crack->force * (crack->length + cantilever_crack_rotation(crack->poisson) * h);
    return 12.0 * moment * moment / (crack->modulus * h * h * h);
}

double cantilever_crack_intensity(const struct cantilever_crack *crack)
{
    const double pi = acos(-1.0), slender = crack->length / crack->height;
    return crack->force / sqrt(crack->height) *
           (sqrt(12.0) * (slender + 0.673) + sqrt(2.0 / (pi * slender)) -
            1.0 / (0.815 * pow(slender, 0.619) + 0.429));
}
