/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/waves/bar_dispersion.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

/* mean of x (1 - x), x in cells */
static double spread(unsigned particles)
{
    double sum = 0.0;
    for (unsigned p = 0; p < particles; p++) {
        const double x = (p + 0.5) / particles;
        sum += x * (1.0 - x);
    }
    return sum / particles;
}

/* One step for (e, v dt), as the header has it. */
static void step(enum bar_dispersion_order order, double q, double s, double g, double kept,
                 const double in[2], double out[2])
{
    const double e = in[0], v = in[1];
    switch (order) {
    case BAR_DISPERSION_USL:
        out[0] = e + kept * v - q * e;
        out[1] = g * v - s * q * e;
        break;
    case BAR_DISPERSION_MUSL:
        out[1] = g * v - s * q * e;
        out[0] = e + out[1];
        break;
    case BAR_DISPERSION_USF:
        out[0] = e + v;
        out[1] = g * v - s * q * out[0];
        break;
    case BAR_DISPERSION_USAVG:
        out[1] = g * v - s * q * (e + 0.5 * v);
        out[0] = e + 0.5 * v + 0.5 * out[1];
        break;
    case BAR_DISPERSION_ORDERS:
    default:
        out[0] = out[1] = (double)NAN;
        break;
    }
}

struct bar_dispersion_result bar_dispersion(const struct bar_dispersion *bar, double wave_number)
{
    static const double UNIT[2][2] = {{1, 0}, {0, 1}};
    const double kh = wave_number * bar->cell;
    const double s = 1.0 - 2.0 * spread(bar->particles) * (1.0 - cos(kh));
    const double g = bar->fraction + (1.0 - bar->fraction) * s - bar->drag * bar->step;
    const double kept = 1.0 - bar->drag_end * bar->step;
    const double omega_grid = 2.0 / bar->cell * bar->speed * sin(0.5 * kh);
    const double q = omega_grid * omega_grid * bar->step * bar->step;
    double column[2][2];
    for (size_t k = 0; k < 2; k++)
        step(bar->order, q, s, g, kept, UNIT[k], column[k]);
    const double determinant = column[0][0] * column[1][1] - column[1][0] * column[0][1];
    const double trace = column[0][0] + column[1][1];
    return (struct bar_dispersion_result){
        .frequency = acos(0.5 * trace / sqrt(determinant)) / bar->step,
        .decay = -0.5 * log(determinant) / bar->step,
    };
}
