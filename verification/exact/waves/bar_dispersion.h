/* What the method itself makes of a small standing wave: frequency and decay of a mode of a bar
 * on a regular grid, exact for particles that stay where they are.
 *
 * A row of cells of width h holds n particles each, at x_p = h (2 p - 1) / (2 n), whose weights
 * are the hat functions of their cell (classic; uGIMP, as l_p = 1/n keeps domains within a cell;
 * CPDI, whose corners are on its edges). A field sin(k x_i) on the nodes, k x = 0 or pi/2 at the
 * ends, stays one in every task of a step:
 *
 *   particles to grid of grid to particles: sum_p m_p S_ip sum_j S_jp / m_i  =  s,
 *       s = 1 - 2 c (1 - cos k h),  c = mean of x (1 - x) over the particles of a cell,
 *   force of a strain over the mass of a node: a = -Omega^2 u,  Omega = (2/h) sqrt(M/rho) sin(k
 * h/2).
 *
 * With v the amplitude of the node velocities extrapolated from the particles at the start of
 * the step, e the displacement whose gradient the particles hold, and q = (Omega dt)^2 <= 4, the
 * step of FLIP with fraction f, v' = f (v + s dt a) + (1 - f) s (v + dt a), is a matrix of (e, v
 * dt):
 *
 *     USL          e' = e + v - q e,         v' = g v - s q e,   g = f + (1 - f) s
 *     MUSL         v' = g v - s q e,         e' = e + v'
 *     USF          e' = e + v,               v' = g v - s q e'
 *     USAVG        e* = e + v/2,  v' = g v - s q e*,  e' = e* + v'/2
 *
 * whose eigenvalues exp((-gamma +- i omega) dt) have the determinant D and the trace T:
 * exp(-2 gamma dt) = D, cos omega dt = T / (2 sqrt D). For FLIP (f = 1): D = 1 and
 * 2 sin(omega dt/2) = Omega dt sqrt(s) with MUSL, USF and USAVG; D = 1 - q (1 - s) with USL. So
 * omega = c k (1 - (k h)^2 (1/24 + c/2 - C^2/24)) to second order, C = c dt / h.
 *
 * Damping (damped_bar.h) takes drag v from the particles' velocities in a unit of time, g - drag dt
 * in the place of g, and drag_end v from the nodes' at the end of the step, v - drag_end dt v - q e
 * in USL.
 *
 * Own derivation; the dispersion of lumped linear elements, c = 0, is in any text on finite
 * elements.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_EXACT_BAR_DISPERSION_H
#define VERIFICATION_EXACT_BAR_DISPERSION_H

#include <stdbool.h>

enum bar_dispersion_order {
    BAR_DISPERSION_USL,
    BAR_DISPERSION_MUSL,
    BAR_DISPERSION_USF,
    BAR_DISPERSION_USAVG,
    BAR_DISPERSION_ORDERS,
};

struct bar_dispersion {
    enum bar_dispersion_order order;
    unsigned particles; /* n >= 1, in a cell along the bar */
    double fraction;    /* f of FLIP, 0 (PIC) to 1 */
    double speed;       /* sqrt(M/rho) > 0 */
    double cell;        /* h > 0 */
    double step;        /* dt > 0 */
    double drag;        /* 1/time; 0 without damping */
    double drag_end;    /* 1/time */
};

struct bar_dispersion_result {
    double frequency; /* omega */
    double decay;     /* gamma */
};

/* Frequency and decay of the mode with wave number k > 0, k h <= pi. NaN where the mode does not
 * oscillate: overdamped or unstable. */
struct bar_dispersion_result bar_dispersion(const struct bar_dispersion *bar, double wave_number);

#endif
