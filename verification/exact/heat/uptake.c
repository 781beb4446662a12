/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/heat/uptake.h"

#include "verification/exact/heat/heat_edges.h"

#include <math.h>

double slab_uptake(double b, double tau)
{
    enum { TERMS = 2000 };
    double sum = 0.0;
    for (unsigned n = 0; n < TERMS; n++) {
        const double z = heat_convection_root(HEAT_SLAB, b, n), square = z * z;
        const double decay = exp(-square * tau);
        if (decay < 1e-18)
            break;
        sum += 2.0 * b * b * decay / (square * (square + b * b + b));
    }
    return 1.0 - sum;
}
