/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/self_weight.h"

double self_weight_stress(const struct self_weight *column, double start)
{
    return column->weight * (column->height - start);
}

double self_weight_displacement(const struct self_weight *column, double start)
{
    return column->weight / column->modulus * start * (column->height - 0.5 * start);
}
