/* The points of a bundle, and what is between them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/score/lattice.h"

#include <math.h>

static const double TAU = 6.283185307179586476925;

void lattice_point(const struct lattice *lattice, size_t index, double place[2])
{
    const size_t at[2] = {index % lattice->count[0], index / lattice->count[0]};
    double coordinate[2];
    for (int a = 0; a < 2; a++)
        coordinate[a] = lattice->count[a] == 1
                            ? 0.5 * (lattice->from[a] + lattice->to[a])
                            : lattice->from[a] + (lattice->to[a] - lattice->from[a]) *
                                                     (double)at[a] /
                                                     (double)(lattice->count[a] - 1);
    place[0] = lattice->polar ? coordinate[0] * cos(coordinate[1]) : coordinate[0];
    place[1] = lattice->polar ? coordinate[0] * sin(coordinate[1]) : coordinate[1];
}

/* Lagrange's polynomials through `number` points at 0, 1, ..., at the place `at`. */
static void lagrange(double at, size_t number, double *weight)
{
    for (size_t i = 0; i < number; i++) {
        weight[i] = 1.0;
        for (size_t j = 0; j < number; j++)
            if (j != i)
                weight[i] *= (at - (double)j) / ((double)i - (double)j);
    }
}

static bool locate_along(const struct lattice *lattice, int axis, double coordinate,
                         struct lattice_weights *weights)
{
    const size_t count = lattice->count[axis];
    const double extent = lattice->to[axis] - lattice->from[axis];
    const double at = (coordinate - lattice->from[axis]) / extent;
    weights->first[axis] = 0;
    weights->number[axis] = 1;
    weights->weight[axis][0] = 1.0;
    if (count == 1)
        return true;
    if (!(at >= -1e-6 && at <= 1 + 1e-6))
        return false;
    const size_t reach = lattice->linear || count < LATTICE_REACH ? 2 : LATTICE_REACH;
    const double place = fmin(fmax(at, 0.0), 1.0) * (double)(count - 1);
    const double below = floor(place) - (reach == LATTICE_REACH ? 1.0 : 0.0);
    const double first = fmin(fmax(below, 0.0), (double)(count - reach));
    weights->first[axis] = (size_t)first;
    weights->number[axis] = reach;
    lagrange(place - first, reach, weights->weight[axis]);
    return true;
}

bool lattice_locate(const struct lattice *lattice, const double place[2],
                    struct lattice_weights *weights)
{
    double coordinate[2] = {place[0], place[1]};
    if (lattice->polar) {
        coordinate[0] = hypot(place[0], place[1]);
        coordinate[1] = atan2(place[1], place[0]);
        if (coordinate[1] < lattice->from[1])
            coordinate[1] += TAU;
    }
    return locate_along(lattice, 0, coordinate[0], weights) &&
           locate_along(lattice, 1, coordinate[1], weights);
}

double lattice_value(const struct lattice *lattice, const struct lattice_weights *weights,
                     const double *values)
{
    double sum = 0.0;
    for (size_t j = 0; j < weights->number[1]; j++)
        for (size_t i = 0; i < weights->number[0]; i++)
            sum += weights->weight[0][i] * weights->weight[1][j] *
                   values[(weights->first[1] + j) * lattice->count[0] + weights->first[0] + i];
    return sum;
}
