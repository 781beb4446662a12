/* A long rod that penetrates a half space and erodes: Alekseevskii's and Tate's model. With the
 * speed v of the rod, u of the bottom of the crater, l the length of the rod, Y its strength and R
 * the resistance of the target,
 *
 *     1/2 rho_p (v - u)^2 + Y = 1/2 rho_t u^2 + R,   dv/dt = -Y/(rho_p l),   dl/dt = -(v - u),
 *
 * until u or l is 0. It has no impact shock: u has its steady value from the start.
 * (V. P. Alekseevskii, Combust. Explos. Shock Waves 2 (1966) 63-66; A. Tate, J. Mech. Phys. Solids
 * 15 (1967) 387-399.) Runge and Kutta's rule of fourth order.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_EXACT_ALEKSEEVSKII_TATE_H
#define VERIFICATION_EXACT_ALEKSEEVSKII_TATE_H

#include <stdbool.h>

struct penetration {
    double rod_density, target_density;
    double strength, resistance; /* Y, R */
    double length, speed;        /* of the rod at t = 0, when its nose is at 0 */
};

struct penetration_state {
    double nose, tail; /* along the rod's way */
    double velocity;   /* u */
    bool ended;        /* it has come to rest, or is eroded, before */
};

/* At a time >= 0; 1e-6 of the length. */
struct penetration_state penetration_at(const struct penetration *problem, double time);

/* u of a rod that moves at `speed`, 0 if it does not penetrate. */
double penetration_velocity(const struct penetration *problem, double speed);

#endif
