/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/heat/heat_edges.h"

#include "verification/exact/root.h"

#include <gsl/gsl_sf_bessel.h>
#include <math.h>

static const double PI = 3.14159265358979323846;
enum { TERMS_MAX = 400 };
static const double NOTHING = 40.0; /* exp(-40) is 4e-18 */

struct surface {
    enum heat_body body;
    double b;
};

/* Zero at the roots. */
static double balance(double z, void *context)
{
    const struct surface *const surface = context;
    switch (surface->body) {
    case HEAT_SLAB:
        return z * sin(z) - surface->b * cos(z);
    case HEAT_CYLINDER:
        return z * gsl_sf_bessel_J1(z) - surface->b * gsl_sf_bessel_J0(z);
    case HEAT_SPHERE:
        return z * cos(z) - (1.0 - surface->b) * sin(z);
    case HEAT_BODIES:
    default:
        return (double)NAN;
    }
}

double heat_convection_root(enum heat_body body, double b, unsigned n)
{
    struct surface surface = {body, b};
    double low = n * PI, high = (n + 0.5) * PI;
    if (body == HEAT_CYLINDER) {
        low = gsl_sf_bessel_zero_J1(n);
        high = gsl_sf_bessel_zero_J0(n + 1);
    } else if (body == HEAT_SPHERE) {
        low = n == 0 ? 1e-9 : low; /* 0 is none of them */
        high = (n + 1) * PI;
    }
    return root_between(balance, &surface, low, high, 1e-14);
}

static double term(const struct surface *surface, double z, double place)
{
    const double b = surface->b, s = sin(z), c = cos(z);
    switch (surface->body) {
    case HEAT_SLAB:
        return 2.0 * s / (z + s * c) * cos(z * place);
    case HEAT_CYLINDER:
        return 2.0 * b * b / ((z * z + b * b) * z * gsl_sf_bessel_J1(z)) *
               gsl_sf_bessel_J0(z * place);
    case HEAT_SPHERE:
        /* s - z c = b s: whichever does not cancel */
        return 2.0 * (b < 1.0 ? b * s : s - z * c) / (z - s * c) *
               (place == 0.0 ? 1.0 : sin(z * place) / (z * place));
    case HEAT_BODIES:
    default:
        return (double)NAN;
    }
}

double heat_surface_convection(enum heat_body body, double place, double tau, double b)
{
    const struct surface surface = {body, b};
    double sum = 0.0;
    for (unsigned n = 0; n < TERMS_MAX; n++) {
        const double z = heat_convection_root(body, b, n);
        if (z * z * tau > NOTHING)
            break;
        sum += term(&surface, z, place) * exp(-z * z * tau);
    }
    return 1.0 - sum;
}

double heat_radiated(double start, double rate, double time)
{
    return 1.0 / cbrt(1.0 / (start * start * start) + 3.0 * rate * time);
}
