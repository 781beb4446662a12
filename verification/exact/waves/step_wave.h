/* A step wave in an elastic bar: exact solution of case W1, and what dispersion makes of it.
 *
 * A bar held sideways (uniaxial strain, modulus M, wave speed c = sqrt(M/rho)) moves at -V
 * and hits a wall at x = 0. From there a front runs at c; behind it the bar is at rest under
 *
 *     sigma = -rho c V,  x < c t;    sigma = 0, v = -V ahead of it,
 *
 * until the front reaches the free end: momentum rho V per length is stopped at the rate c
 * by the force rho c V. For the law `linear_elastic` this holds at any V < c (vibrating_bar.h).
 *
 * A method whose waves run at omega = c k (1 - b (k h)^2) spreads the front into
 *
 *     sigma / (-rho c V) = integral from xi to infinity of Ai(s) ds,
 *     xi = (x - c t) / (3 b h^2 c t)^(1/3),
 *
 * the long-wave limit of the integral over all k (stationary phase at k = 0; G. B. Whitham,
 * Linear and Nonlinear Waves, sec. 11.7 has the same for waves in water): 1/3 at the front, a
 * largest value of 1.2743 at xi = -2.338, the first zero of Ai, and behind that an oscillation that
 * falls as |xi|^(-3/4). Neither height falls with h; the front's width falls as h^(2/3), and the L1
 * norm of the error, which the slow fall of the oscillation adds to, as h^(1/2).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_EXACT_STEP_WAVE_H
#define VERIFICATION_EXACT_STEP_WAVE_H

struct step_wave {
    double modulus; /* M > 0 */
    double density; /* rho > 0 */
    double speed;   /* V > 0 */
};

double step_wave_celerity(const struct step_wave *wave); /* c */

/* rho c V > 0, the pressure behind the front. */
double step_wave_pressure(const struct step_wave *wave);

/* xi of a place x at time t > 0 for waves of dispersion b > 0 on cells h > 0. */
double step_wave_similarity(const struct step_wave *wave, double dispersion, double cell, double x,
                            double time);

/* The integral of Ai from xi to infinity, to 1e-10; xi from -200 to 20. NaN if GSL fails. */
double step_wave_dispersed(double similarity);

#endif
