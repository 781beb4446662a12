/* What a slab takes up through its surface: v_t = kappa v_xx for 0 < x < a, insulated at x = 0,
 * with v_x = (b/a) (1 - v) at x = a, v = 0 at first. With tau = kappa t / a^2 and the roots z tan z
 * = b,
 *
 *   mean v = 1 - sum 2 b^2 exp(-z^2 tau) / (z^2 (z^2 + b^2 + b))
 *
 * (J. Crank, The Mathematics of Diffusion; from v = 1 - sum c cos(z x/a) exp(-z^2 tau) with
 * c = 2 b / ((z^2 + b^2 + b) cos z), whose mean over x has the factor sin z / z = b cos z / z^2).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_EXACT_UPTAKE_H
#define VERIFICATION_EXACT_UPTAKE_H

/* b > 0; tau >= 0. The sum ends with its 2000th term: error below 1e-7 b^2 at tau = 0, round-off
 * from tau = 1e-5 on. */
double slab_uptake(double b, double tau);

#endif
