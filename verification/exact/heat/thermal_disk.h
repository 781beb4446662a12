/* Thermal stress in disks and cylinders, T = T(r), with free surfaces, at small strain (S. P.
 * Timoshenko, J. N. Goodier, Theory of Elasticity, secs 150, 151).
 *
 * With theta = T - T_0, hoop strain u/r and radial strain u', sigma = E/(1 - nu^2) (eps_r + nu
 * eps_t - (1 + nu) alpha theta) of plane stress in equilibrium, (r sigma_r)' = sigma_t, gives
 * ((r u)'/r)' = (1 + nu) alpha theta', and with sigma_r = 0 at r = a and b
 *
 *     I(r) = int_a^r theta s ds,   B = I(b)/(b^2 - a^2),
 *     sigma_r = alpha E ( (1 - a^2/r^2) B - I(r)/r^2 ),
 *     sigma_t = alpha E ( (1 + a^2/r^2) B + I(r)/r^2 - theta ),
 *     u = alpha ( (1 + nu) I(r)/r + ((1 - nu) r + (1 + nu) a^2/r) B ).
 *
 * Plane strain has E/(1 - nu^2), nu/(1 - nu), (1 + nu) alpha in place of E, nu, alpha, and sigma_z
 * = nu (sigma_r + sigma_t) - alpha E theta. theta is rise (1 - r^2/b^2) in a solid disk, a = 0, and
 * rise ln(b/r)/ln(b/a), of stationary conduction, in a hollow one.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_EXACT_THERMAL_DISK_H
#define VERIFICATION_EXACT_THERMAL_DISK_H

#include <stdbool.h>

struct thermal_disk {
    double inner, outer; /* radii 0 <= a < b */
    double young, poisson;
    double expansion, rise; /* alpha; theta at r = a */
    bool plane_stress;
};

struct thermal_disk_state {
    double rise;       /* theta */
    double rr, tt, zz; /* stress */
    double u;          /* radial displacement */
    double strain;     /* u' */
};

/* At a <= r <= b, r > 0. */
struct thermal_disk_state thermal_disk_state(const struct thermal_disk *disk, double radius);

#endif
