/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/self_weight.h"

double self_weight_stress(const struct self_weight *column, double start)
{
    const double height = column->height;
    return column->weight * (height - start) +
           0.5 * column->slope * (height * height - start * start);
}

double self_weight_displacement(const struct self_weight *column, double start)
{
    const double height = column->height;
    return column->weight / column->modulus * start * (height - 0.5 * start) +
           column->slope / column->modulus * start * (0.5 * height * height - start * start / 6.0);
}
