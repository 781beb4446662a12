/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/heat.h"

#include <gsl/gsl_sf_bessel.h>
#include <math.h>

static const double PI = 3.14159265358979323846;
enum { TERMS_MAX = 400 };
/* exp(-40) is 4e-18. */
static const double NOTHING = 40.0;

static double held_term(enum heat_body body, unsigned n, double place, double *exponent)
{
    double root;
    switch (body) {
    case HEAT_SLAB:
        root = (n + 0.5) * PI;
        *exponent = root * root;
        return (n % 2 == 0 ? 2.0 : -2.0) / root * cos(root * place);
    case HEAT_CYLINDER:
        root = gsl_sf_bessel_zero_J0(n + 1);
        *exponent = root * root;
        return 2.0 * gsl_sf_bessel_J0(root * place) / (root * gsl_sf_bessel_J1(root));
    case HEAT_SPHERE:
        root = (n + 1) * PI;
        *exponent = root * root;
        return (n % 2 == 0 ? 2.0 : -2.0) *
               (place == 0.0 ? 1.0 : sin(root * place) / (root * place));
    case HEAT_BODIES:
    default:
        *exponent = 0.0;
        return (double)NAN;
    }
}

double heat_surface_held(enum heat_body body, double place, double tau)
{
    double sum = 0.0;
    for (unsigned n = 0; n < TERMS_MAX; n++) {
        double exponent;
        const double term = held_term(body, n, place, &exponent);
        if (exponent * tau > NOTHING)
            break;
        sum += term * exp(-exponent * tau);
    }
    return 1.0 - sum;
}

double heat_surface_flux(enum heat_body body, double place, double tau)
{
    const double square = place * place;
    double sum = 0.0;
    for (unsigned n = 1; n < TERMS_MAX; n++) {
        const double root = body == HEAT_SLAB ? n * PI : gsl_sf_bessel_zero_J1(n);
        if (root * root * tau > NOTHING)
            break;
        const double shape = body == HEAT_SLAB
                                 ? (n % 2 == 0 ? 1.0 : -1.0) * cos(root * place)
                                 : gsl_sf_bessel_J0(root * place) / gsl_sf_bessel_J0(root);
        sum += 2.0 * shape * exp(-root * root * tau) / (root * root);
    }
    if (body == HEAT_SLAB)
        return tau + 0.5 * square - 1.0 / 6.0 - sum;
    return body == HEAT_CYLINDER ? 2.0 * tau + 0.5 * square - 0.25 - sum : (double)NAN;
}

double heat_slab_driven(double place, double rate, double frequency, double time)
{
    const double w = frequency;
    double sum = place * sin(w * time);
    for (int n = 1; n < TERMS_MAX; n++) {
        const double s = rate * (n * PI) * (n * PI);
        const double grown = s * cos(w * time) + w * sin(w * time) - s * exp(-s * time);
        sum += (n % 2 == 0 ? 2.0 : -2.0) * w / (n * PI) * sin(n * PI * place) * grown /
               (s * s + w * w);
    }
    return sum;
}
