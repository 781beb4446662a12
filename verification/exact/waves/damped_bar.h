/* A bar with both ends held, in its first axial mode, under damping: case E6.
 *
 * u_tt + alpha(X) u_t = c^2 u_XX, u(0) = u(L) = 0, with k = pi/L and
 *
 *     alpha = a   or   alpha = a (1 - cos 2 k X), which is strongest in the middle,
 *
 * or alpha = a in a band about the middle that may be narrower than a cell.
 *
 * u = exp(l t) sum_n q_n sin n k X, n odd, gives (l^2 + w_n^2 + a l) q_n = 0 for a constant rate,
 * with w_n = n c k, so l = -a/2 +- i sqrt(w_1^2 - a^2/4). For the other, cos 2kX sin nkX = (sin
 * (n+2)kX + sin (n-2)kX)/2 couples neighbours, (l^2 + w_n^2 + a l + [n = 1] a l/2) q_n = (a
 * l/2)(q_{n-2} + q_{n+2}): the determinant is a continued fraction, whose root near i w_1 is l. To
 * first order in a it is -3a/4 + i w_1: the mean of alpha with sin^2 is 3a/2.
 *
 * On a grid of hat functions with n particles a cell that stay where they are (bar_dispersion.h)
 * the nodal velocities v_i = sin k x_i lose, in a unit of time and projected on themselves:
 *
 *     nodes           sum alpha(x_i) v_i^2 / sum v_i^2 on the grid; times s once particles have
 * read it particles       nothing on the grid; the same as nodes at the particles particle_rate
 * nothing on the grid; the projection of S+ (alpha(x_p) S v) own             nothing on the grid;
 * alpha_p at the particles, for a constant rate
 *
 * Own derivation.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_EXACT_DAMPED_BAR_H
#define VERIFICATION_EXACT_DAMPED_BAR_H

#include "verification/exact/waves/bar_dispersion.h"

enum damped_bar_form {
    DAMPED_BAR_NODES,
    DAMPED_BAR_PARTICLES,
    DAMPED_BAR_PARTICLE_RATE,
    DAMPED_BAR_OWN,
    DAMPED_BAR_FORMS,
};

enum damped_bar_profile {
    DAMPED_BAR_UNIFORM, /* a */
    DAMPED_BAR_COSINE,  /* a (1 - cos 2 k X) */
    DAMPED_BAR_BAND,    /* a within `width` of the middle, to either side */
    DAMPED_BAR_PROFILES,
};

struct damped_bar {
    double length, speed; /* L, c > 0 */
    double rate;          /* a, from 0 to w_1 */
    enum damped_bar_profile profile;
    double width;
};

/* -l of the first mode: its frequency (imaginary part) and decay (real part). NaN if the iteration
 * does not settle, and for a band. */
struct bar_dispersion_result damped_bar_mode(const struct damped_bar *bar);

/* Sets drag and drag_end of the bar on its grid, whose cells divide L. NaN: own with a varying
 * rate. The others are exact to first order in the rate where it varies. */
void damped_bar_set_drag(const struct damped_bar *bar, enum damped_bar_form form,
                         struct bar_dispersion *grid);

#endif
