/* A hollow sphere of perfect plasticity under inner pressure, at small strain (R. Hill, The
 * Mathematical Theory of Plasticity, ch. V.2; derived again here).
 *
 * By symmetry the stress is sigma_rr and sigma_tt = sigma_pp, so that von Mises and Tresca both
 * yield at sigma_tt - sigma_rr = Y, for any Poisson's ratio. Loading to p, yield begins at
 *
 *     p_Y = (2 Y/3) (1 - a^3/b^3)
 *
 * at the inner face, and reaches r = c where
 *
 *     p = 2 Y ln(c/a) + (2 Y/3) (1 - c^3/b^3).
 *
 * Elastic, r >= c (Lame's sphere from c on, on the verge of yield there):
 *
 *     sigma_rr = -(2 Y c^3/3) (1/r^3 - 1/b^3),   sigma_tt = (2 Y c^3/3) (1/(2 r^3) + 1/b^3),
 *     u = (2 Y c^3/(3 E)) ((1 + nu)/(2 r^2) + (1 - 2 nu) r/b^3).
 *
 * Plastic, r <= c: equilibrium, d sigma_rr/dr = 2 Y/r, gives sigma_rr = -p + 2 Y ln(r/a). Flow
 * leaves the volume, so that the trace of the strain is (1 - 2 nu)/E (3 sigma_rr + 2 Y), and
 * integrating (r^2 u)' from c on
 *
 *     u = (Y/E) ((1 - nu) c^3/r^2 - (2/3) (1 - 2 nu) r (1 + 3 ln(c/r) - c^3/b^3)).
 *
 * Unloading from p to p' subtracts Lame's elastic state of p - p', up to p - p' = 2 p_Y, where the
 * inner face yields again.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_EXACT_HILL_SPHERE_H
#define VERIFICATION_EXACT_HILL_SPHERE_H

struct hill_sphere {
    double inner, outer; /* radii 0 < a < b */
    double young, poisson, yield;
};

struct hill_sphere_state {
    double rr, tt; /* stress */
    double u;      /* radial displacement */
};

/* p_Y */
double hill_sphere_first_yield(const struct hill_sphere *sphere);

/* c of a pressure from 0 to that at which all has yielded, 2 Y ln(b/a); a below p_Y. NaN beyond. */
double hill_sphere_front(const struct hill_sphere *sphere, double pressure);

/* At a <= r <= b, after loading to `peak` and unloading to `pressure`, which is at most `peak` and
 * at least `peak` less 2 p_Y. NaN beyond. */
struct hill_sphere_state hill_sphere_state(const struct hill_sphere *sphere, double peak,
                                           double pressure, double radius);

#endif
