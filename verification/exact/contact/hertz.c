/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/contact/hertz.h"

#include <gsl/gsl_sf_gamma.h>
#include <math.h>

static const double PI = 3.14159265358979323846;

double hertz_modulus(const struct hertz *hertz)
{
    return hertz->young / (1.0 - hertz->poisson * hertz->poisson);
}

double hertz_radius(const struct hertz *hertz, double indentation)
{
    return sqrt(hertz->radius * indentation);
}

double hertz_force(const struct hertz *hertz, double indentation)
{
    return 4.0 / 3.0 * hertz_modulus(hertz) * sqrt(hertz->radius) * pow(indentation, 1.5);
}

double hertz_pressure(const struct hertz *hertz, double indentation)
{
    return 2.0 * hertz_radius(hertz, indentation) * hertz_modulus(hertz) / (PI * hertz->radius);
}

double hertz_plates_indentation(const struct hertz *hertz, double radius_of_contact)
{
    const double local = radius_of_contact * radius_of_contact / hertz->radius;
    return local - (1.0 + hertz->poisson) * (3.0 - 2.0 * hertz->poisson) *
                       hertz_force(hertz, local) / (4.0 * PI * hertz->young * hertz->radius);
}

double hertz_plates_radius(const struct hertz *hertz, double indentation)
{
    enum { HALVINGS = 60 };
    double low = 0.0, high = hertz_radius(hertz, 2.0 * indentation);
    for (int k = 0; k < HALVINGS; k++) {
        const double middle = 0.5 * (low + high);
        *(hertz_plates_indentation(hertz, middle) < indentation ? &low : &high) = middle;
    }
    return low;
}

double hertz_deepest(const struct hertz *hertz)
{
    return pow(15.0 * hertz->mass * hertz->speed * hertz->speed /
                   (16.0 * hertz_modulus(hertz) * sqrt(hertz->radius)),
               0.4);
}

double hertz_duration(const struct hertz *hertz)
{
    return 0.8 * gsl_sf_beta(0.4, 0.5) * hertz_deepest(hertz) / hertz->speed;
}

static double slowing(const struct hertz *hertz, double indentation)
{
    return -hertz_force(hertz, fmax(indentation, 0.0)) / hertz->mass;
}

double hertz_indentation_at(const struct hertz *hertz, double time, unsigned steps)
{
    if (time >= hertz_duration(hertz))
        return 0.0;
    const double h = time / steps;
    double x = 0.0, v = hertz->speed;
    for (unsigned k = 0; k < steps; k++) {
        const double a1 = slowing(hertz, x), v2 = v + 0.5 * h * a1;
        const double a2 = slowing(hertz, x + 0.5 * h * v), v3 = v + 0.5 * h * a2;
        const double a3 = slowing(hertz, x + 0.5 * h * v2), v4 = v + h * a3;
        const double a4 = slowing(hertz, x + h * v3);
        x += h / 6.0 * (v + 2.0 * v2 + 2.0 * v3 + v4);
        v += h / 6.0 * (a1 + 2.0 * a2 + 2.0 * a3 + a4);
    }
    return x;
}
