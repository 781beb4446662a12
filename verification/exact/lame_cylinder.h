/* A thick-walled cylinder under pressure, held along its axis: G. Lame's solution at small
 * strain (S. P. Timoshenko, J. N. Goodier, Theory of Elasticity, sec. 28).
 *
 *     sigma_rr = A - B/r^2,   sigma_tt = A + B/r^2,   sigma_zz = nu (sigma_rr + sigma_tt),
 *     u_r = (1 + nu)/E ( (1 - 2 nu) A r + B/r ),
 *     A = (p_i a^2 - p_o b^2)/(b^2 - a^2),   B = (p_i - p_o) a^2 b^2/(b^2 - a^2).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_EXACT_LAME_CYLINDER_H
#define VERIFICATION_EXACT_LAME_CYLINDER_H

struct lame_cylinder {
    double inner, outer;                   /* radii 0 < a < b */
    double inner_pressure, outer_pressure; /* p_i, p_o */
    double young, poisson;
};

struct lame_state {
    double rr, tt, zz; /* stress */
    double u;          /* radial displacement */
};

/* At a <= r <= b. */
struct lame_state lame_cylinder_state(const struct lame_cylinder *cylinder, double radius);

#endif
