/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/uptake.h"

#include <math.h>

static const double PI = 3.14159265358979323846;

/* The root of z tan z = b in (n pi, (n + 1/2) pi): z sin z - b cos z changes its sign there once.
 */
static double root_of(double b, int n)
{
    double low = n * PI, high = (n + 0.5) * PI;
    const double sign = n % 2 == 0 ? 1.0 : -1.0;
    for (int k = 0; k < 60; k++) {
        const double z = 0.5 * (low + high);
        if (sign * (z * sin(z) - b * cos(z)) < 0.0)
            low = z;
        else
            high = z;
    }
    return 0.5 * (low + high);
}

double slab_uptake(double b, double tau)
{
    enum { TERMS = 2000 };
    double sum = 0.0;
    for (int n = 0; n < TERMS; n++) {
        const double z = root_of(b, n), square = z * z;
        const double decay = exp(-square * tau);
        if (decay < 1e-18)
            break;
        sum += 2.0 * b * b * decay / (square * (square + b * b + b));
    }
    return 1.0 - sum;
}
