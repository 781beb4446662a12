/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "model/laws/viscosity.h"

#include <math.h>

double mpm_viscous_pressure(const struct mpm_viscosity *viscosity, double h, double wave_squared,
                            double rate)
{
    const double speed = h * fmax(-rate, 0.0);
    return speed * (viscosity->linear * sqrt(wave_squared) + viscosity->quadratic * speed);
}

double mpm_viscous_wave_squared(const struct mpm_viscosity *viscosity, double h,
                                double wave_squared, double rate)
{
    const double speed = h * fmax(-rate, 0.0);
    const double viscous =
        viscosity->linear * sqrt(wave_squared) + 2.0 * viscosity->quadratic * speed;
    const double sum = viscous + sqrt(viscous * viscous + wave_squared);
    return sum * sum;
}
