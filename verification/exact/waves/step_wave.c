/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/waves/step_wave.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <gsl/gsl_sf_airy.h>
#include <math.h>

double step_wave_celerity(const struct step_wave *wave)
{
    return sqrt(wave->modulus / wave->density);
}

double step_wave_pressure(const struct step_wave *wave)
{
    return wave->density * step_wave_celerity(wave) * wave->speed;
}

double step_wave_similarity(const struct step_wave *wave, double dispersion, double cell, double x,
                            double time)
{
    const double run = step_wave_celerity(wave) * time;
    return (x - run) / cbrt(3.0 * dispersion * cell * cell * run);
}

static double airy(double s, void *unused)
{
    (void)unused;
    return gsl_sf_airy_Ai(s, GSL_PREC_DOUBLE);
}

double step_wave_dispersed(double similarity)
{
    enum { INTERVALS = 400 };
    static const double TOLERANCE = 1e-11;
    gsl_function integrand = {.function = airy, .params = NULL};
    double value = (double)NAN, estimate = 0.0;
    gsl_error_handler_t *const handler = gsl_set_error_handler_off();
    gsl_integration_workspace *const space = gsl_integration_workspace_alloc(INTERVALS);
    /* from xi to 0; the rest, from 0 on, is 1/3 */
    if (space == NULL ||
        gsl_integration_qag(&integrand, similarity, 0.0, TOLERANCE, 0.0, INTERVALS,
                            GSL_INTEG_GAUSS61, space, &value, &estimate) != GSL_SUCCESS)
        value = (double)NAN;
    if (space != NULL)
        gsl_integration_workspace_free(space);
    gsl_set_error_handler(handler);
    return 1.0 / 3.0 + value;
}
