/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/measures/interaction_integral.h"

#include <math.h>

/* Stress xx yy xy of a displacement gradient, by Hooke's law of the plane. */
static void stress_of(const struct williams_field *tip, const double u[4], double stress[3])
{
    const double lame = tip->shear * (3.0 - tip->kappa) / (tip->kappa - 1.0);
    stress[0] = 2.0 * tip->shear * u[0] + lame * (u[0] + u[3]);
    stress[1] = 2.0 * tip->shear * u[3] + lame * (u[0] + u[3]);
    stress[2] = tip->shear * (u[1] + u[2]);
}

/* (s_ij a_i,1) q,j of a stress and a gradient. */
static double work(const double stress[3], const double gradient[4], const double direction[2],
                   const double q[2])
{
    double slope[2];
    for (int i = 0; i < 2; i++)
        slope[i] = gradient[2 * i] * direction[0] + gradient[2 * i + 1] * direction[1];
    return (stress[0] * slope[0] + stress[2] * slope[1]) * q[0] +
           (stress[2] * slope[0] + stress[1] * slope[1]) * q[1];
}

/* The integrand of M, of a particle. */
static double integrand(const struct williams_field *other, const double place[2],
                        const double gradient[4], const double stress[3], const double q[2])
{
    double a[4], t[3];
    williams_field_gradient(other, place, a);
    stress_of(other, a, t);
    const double energy = stress[0] * a[0] + stress[1] * a[3] + stress[2] * (a[1] + a[2]);
    return work(stress, a, other->direction, q) + work(t, gradient, other->direction, q) -
           energy * (q[0] * other->direction[0] + q[1] * other->direction[1]);
}

/* dq/dr of q = (1 + cos(pi (r - inner)/(outer - inner)))/2. */
static double slope_of(double r, double inner, double outer)
{
    const double rate = acos(-1.0) / (outer - inner);
    return -0.5 * rate * sin(rate * (r - inner));
}

void interaction_integral(const struct interaction_particles *particles,
                          const struct williams_field *tip, double inner, double outer,
                          double intensity[2])
{
    size_t found = 0;
    intensity[0] = intensity[1] = 0.0;
    for (size_t p = 0; p < particles->count; p++) {
        const double *const place = particles->place + 2 * p, *const f =
                                                                  particles->gradient + 5 * p;
        const double *const s = particles->stress + 4 * p;
        const double x = place[0] - tip->tip[0], y = place[1] - tip->tip[1], r = hypot(x, y);
        if (r <= inner || r >= outer)
            continue;
        const double slope = slope_of(r, inner, outer) / r, q[2] = {slope * x, slope * y};
        const double gradient[4] = {f[0] - 1.0, f[1], f[2], f[3] - 1.0};
        const double stress[3] = {s[0], s[1], s[3]};
        for (int mode = 0; mode < 2; mode++) {
            struct williams_field other = *tip;
            other.mode_1 = mode == 0 ? 1.0 : 0.0;
            other.mode_2 = mode == 1 ? 1.0 : 0.0;
            other.parallel = 0.0;
            intensity[mode] += 0.5 * williams_field_modulus(tip) * particles->volume[p] *
                               integrand(&other, place, gradient, stress, q);
        }
        found++;
    }
    if (found == 0)
        intensity[0] = intensity[1] = (double)NAN;
}
