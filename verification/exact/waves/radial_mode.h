/* Breathing modes of an elastic disk or cylinder: small radial motion that depends on r alone,
 * free rim, exact solution of case W2.
 *
 * With u = u(r) sin(omega t) the equation of motion of a linear elastic body,
 *
 *     C (u'' + u'/r - u/r^2) + rho omega^2 u = 0,   u = J1(k r),   omega = k sqrt(C / rho),
 *
 * has the same form in plane strain (a cylinder with its ends held) and in plane stress (a thin
 * disk); sigma_rr = C (u' + kappa u/r) with
 *
 *     plane strain   C = lambda + 2 G = E (1 - nu) / ((1 + nu)(1 - 2 nu)),  kappa = nu/(1 - nu)
 *     plane stress   C = E / (1 - nu^2),                                    kappa = nu
 *
 * and J1' = J0 - J1/x. The rim R is free, sigma_rr = 0, where x = k R solves
 *
 *     x J0(x) = (1 - kappa) J1(x).
 *
 * Between two zeros of J1 the left side less the right changes sign once (0 counts as one,
 * where it leaves upwards, kappa > -1), so that every interval holds one root; A. E. H. Love, A
 * Treatise on the Mathematical Theory of Elasticity, sec. 200.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_EXACT_RADIAL_MODE_H
#define VERIFICATION_EXACT_RADIAL_MODE_H

#include <stddef.h>

enum radial_mode_kind { RADIAL_MODE_CYLINDER, RADIAL_MODE_THIN_DISK };

struct radial_mode_body {
    enum radial_mode_kind kind;
    double radius;  /* R > 0 */
    double young;   /* E > 0 */
    double poisson; /* nu, from 0 to below 0.5 */
    double density; /* rho > 0 */
};

/* Wave number k of mode 1, 2, ..., 1/length: the root by GSL's Brent solver to 1e-14. NaN for
 * mode 0 or if GSL fails. */
double radial_mode_wave_number(const struct radial_mode_body *body, unsigned mode);

/* omega = k sqrt(C / rho) */
double radial_mode_frequency(const struct radial_mode_body *body, double wave_number);

/* u(r) = J1(k r) */
double radial_mode_displacement(double wave_number, double radius);

/* Coefficients of J1(k r) / r = sum c[m] r^(2m), m = 0 .. count - 1:
 * c[m] = (k/2) (-k^2/4)^m / (m! (m+1)!). With 24 terms the rest is below 1e-14 for k r <= 10. */
void radial_mode_series(double wave_number, size_t count, double *coefficients);

#endif
