/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/heat/heat.h"

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

double heat_source_held(enum heat_body body, double place, double tau)
{
    const double axes = (double)body + 1.0;
    double sum = 0.0;
    for (unsigned n = 0; n < TERMS_MAX; n++) {
        double exponent;
        const double term = held_term(body, n, place, &exponent);
        if (exponent * tau > NOTHING)
            break;
        sum += term / exponent * exp(-exponent * tau);
    }
    return 0.5 / axes * (1.0 - place * place) - sum;
}

/* tan d = d between n pi and (n + 1/2) pi, by Newton's method of sin d - d cos d */
static double root_of_tangent(unsigned n)
{
    const double end = (n + 0.5) * PI;
    double root = end - 1.0 / end;
    for (int k = 0; k < 6; k++)
        root -= (sin(root) - root * cos(root)) / (root * sin(root));
    return root;
}

/* Of the term exp(-d^2 tau), over 2/d^2; *root is d. */
static double flux_term(enum heat_body body, unsigned n, double place, double *root)
{
    switch (body) {
    case HEAT_SLAB:
        *root = n * PI;
        return (n % 2 == 0 ? 1.0 : -1.0) * cos(*root * place);
    case HEAT_CYLINDER:
        *root = gsl_sf_bessel_zero_J1(n);
        return gsl_sf_bessel_J0(*root * place) / gsl_sf_bessel_J0(*root);
    case HEAT_SPHERE:
        *root = root_of_tangent(n);
        return (place == 0.0 ? *root : sin(*root * place) / place) / sin(*root);
    case HEAT_BODIES:
    default:
        *root = 0.0;
        return (double)NAN;
    }
}

double heat_surface_flux(enum heat_body body, double place, double tau)
{
    const double axes = (double)body + 1.0; /* that it is round or straight along */
    double sum = 0.0;
    for (unsigned n = 1; n < TERMS_MAX; n++) {
        double root;
        const double term = flux_term(body, n, place, &root);
        if (root * root * tau > NOTHING)
            break;
        sum += 2.0 * term * exp(-root * root * tau) / (root * root);
    }
    return axes * tau + 0.5 * place * place - 0.5 * axes / (axes + 2.0) - sum;
}

double heat_sphere_mode(double place, double tau)
{
    const double shape = place == 0.0 ? 1.0 : sin(PI * place) / (PI * place);
    return shape * exp(-PI * PI * tau);
}

double heat_product(const double place[2], double p, double q, double decayed)
{
    return cos(p * PI * place[0]) * cos(q * PI * place[1]) * exp(-decayed);
}

double heat_spot(const double place[2], double width, const double diffusivity[2], double time)
{
    const double first = width * width + 4.0 * diffusivity[0] * time;
    const double second = width * width + 4.0 * diffusivity[1] * time;
    return width * width / sqrt(first * second) *
           exp(-place[0] * place[0] / first - place[1] * place[1] / second);
}

double heat_passing_rod(double place, double speed, double diffusivity)
{
    return fmin(1.0, exp(speed / diffusivity * place));
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
