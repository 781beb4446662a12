/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/waves/radial_mode.h"

#include "verification/exact/root.h"

#include <gsl/gsl_sf_bessel.h>
#include <math.h>

static double ratio(const struct radial_mode_body *body)
{
    return body->kind == RADIAL_MODE_CYLINDER ? body->poisson / (1.0 - body->poisson)
                                              : body->poisson;
}

static double stiffness(const struct radial_mode_body *body)
{
    const double nu = body->poisson;
    return body->kind == RADIAL_MODE_CYLINDER
               ? body->young * (1.0 - nu) / ((1.0 + nu) * (1.0 - 2.0 * nu))
               : body->young / (1.0 - nu * nu);
}

/* sigma_rr at the rim, up to a factor */
static double rim_stress(double x, void *kappa)
{
    return x * gsl_sf_bessel_J0(x) - (1.0 - *(const double *)kappa) * gsl_sf_bessel_J1(x);
}

double radial_mode_wave_number(const struct radial_mode_body *body, unsigned mode)
{
    static const double ABOVE_ZERO = 1e-3, TOLERANCE = 1e-14;
    double kappa = ratio(body);
    if (mode == 0)
        return (double)NAN;
    const double low = mode == 1 ? ABOVE_ZERO : gsl_sf_bessel_zero_J1(mode - 1);
    return root_between(rim_stress, &kappa, low, gsl_sf_bessel_zero_J1(mode), TOLERANCE) /
           body->radius;
}

double radial_mode_frequency(const struct radial_mode_body *body, double wave_number)
{
    return wave_number * sqrt(stiffness(body) / body->density);
}

double radial_mode_displacement(double wave_number, double radius)
{
    return gsl_sf_bessel_J1(wave_number * radius);
}

void radial_mode_series(double wave_number, size_t count, double *coefficients)
{
    double term = 0.5 * wave_number;
    for (size_t m = 0; m < count; m++) {
        coefficients[m] = term;
        term *= -0.25 * wave_number * wave_number / (double)((m + 1) * (m + 2));
    }
}
