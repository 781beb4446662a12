/* A bar in its first axial mode, at any amplitude: the exact solution of case E3.
 *
 * The bar is held sideways (uniaxial strain), so F = diag(l, 1, 1) with the stretch
 * l = 1 + du/dX. The law `linear_elastic`, W = G |U - I|^2 + lambda/2 tr(U - I)^2, has
 * U = F there, hence
 *
 *     W(l) = M/2 (l - 1)^2,   P = dW/dl = M du/dX,   M = lambda + 2 G = K + 4/3 G.
 *
 * The nominal stress P is linear in du/dX and momentum in initial coordinates reads
 * rho0 u_tt = dP/dX: the wave equation u_tt = c^2 u_XX, c^2 = M / rho0, without any
 * assumption of small strain. So the standing wave
 *
 *     u(X, t) = A sin(k X) sin(omega t),   omega = c k,
 *
 * which starts undeformed with the velocity A omega sin(k X), is exact as long as no
 * stretch is lost, A k < 1, with
 *
 *     k = pi / L      both ends held: u(0) = u(L) = 0,
 *     k = pi / (2 L)  one end held, the other free: u(0) = 0, P(L) = M A k cos(k L) = 0.
 *
 * Its energy, A^2 omega^2 rho0 L / 4 per cross section, is constant: sin^2 and cos^2 of
 * k X both have the mean 1/2 over the bar.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_EXACT_VIBRATING_BAR_H
#define VERIFICATION_EXACT_VIBRATING_BAR_H

enum vibrating_bar_end { VIBRATING_BAR_HELD, VIBRATING_BAR_FREE };

struct vibrating_bar {
    double length;              /* L > 0 */
    double modulus;             /* M > 0, of uniaxial strain */
    double density;             /* rho0 > 0 */
    double amplitude;           /* A, |A| k < 1 */
    enum vibrating_bar_end end; /* what holds X = L; X = 0 is held */
};

/* k, 1/length */
double vibrating_bar_wave_number(const struct vibrating_bar *bar);

/* 2 pi / omega */
double vibrating_bar_period(const struct vibrating_bar *bar);

/* u(X, t) in the unit of length, 0 <= X <= L. */
double vibrating_bar_displacement(const struct vibrating_bar *bar, double start, double time);

/* du/dt */
double vibrating_bar_velocity(const struct vibrating_bar *bar, double start, double time);

/* du/dX = l - 1 */
double vibrating_bar_strain(const struct vibrating_bar *bar, double start, double time);

/* Kinetic energy and W over the whole bar, per cross section. */
double vibrating_bar_energy(const struct vibrating_bar *bar);

#endif
