/* Exact fields of heat conduction in slabs, cylinders and spheres, and in bodies that move (H. S.
 * Carslaw, J. C. Jaeger, Conduction of Heat in Solids; N&G 3.4): v_t = kappa div grad v.
 *
 * With tau = kappa t/a^2 and x, r from the insulated face or the centre, whose distance to the
 * surface is a:
 *
 *   slab, cylinder, sphere with v = 0 at first and v = 1 on the surface from t = 0 on:
 *     1 - v = (4/pi) sum_n (-1)^n/(2n+1) exp(-((2n+1) pi/2)^2 tau) cos((2n+1) pi x/(2a))
 *     1 - v = 2 sum_n J0(b_n r/a) exp(-b_n^2 tau)/(b_n J1(b_n)),   J0(b_n) = 0
 *     1 - v = 2 sum_n (-1)^(n+1) exp(-n^2 pi^2 tau) sin(n pi r/a)/(n pi r/a)
 *
 *   slab, cylinder, sphere with v = 0 at first and a flux of k/a through the surface, so that
 *   a v_x = 1:
 *     v = tau + (3 x^2 - a^2)/(6 a^2) - (2/pi^2) sum_n (-1)^n exp(-n^2 pi^2 tau) cos(n pi x/a)/n^2
 *     v = 2 tau + r^2/(2 a^2) - 1/4 - 2 sum_n exp(-c_n^2 tau) J0(c_n r/a)/(c_n^2 J0(c_n)),
 *                                                                        J1(c_n) = 0, c_n > 0
 *     v = 3 tau + r^2/(2 a^2) - 3/10 - 2 sum_n exp(-d_n^2 tau) sin(d_n r/a)/(d_n^2 sin(d_n) r/a),
 *                                                                    tan d_n = d_n, d_n > 0
 *
 *   slab, cylinder, sphere, m = 1, 2, 3, with v = 0 at first and on the surface, and a source of
 *   k/a^2 per volume; w_n exp(-b_n^2 tau) are the terms of 1 - v above:
 *     v = (1 - x^2/a^2)/(2 m) - sum_n w_n/b_n^2 exp(-b_n^2 tau)
 *
 *   slab with v = 0 at first and at x = 0, and v = sin(w t) at x = a: with s_n = kappa (n pi/a)^2,
 *     v = (x/a) sin w t + sum_n (2 (-1)^n w/(n pi)) sin(n pi x/a)
 *                               (s_n cos w t + w sin w t - s_n exp(-s_n t))/(s_n^2 + w^2)
 *
 *   sphere whose surface is at 0, with the first term of its series alone at first:
 *     v = sin(pi r/a)/(pi r/a) exp(-pi^2 tau)
 *
 *   a manufactured field on a unit square, planar or of r and z, with no flow through its sides and
 *   the axis where p and q are whole; what source it needs is with the scenes of case H5:
 *     v = cos(p pi x) cos(q pi y) exp(-decay t)
 *
 *   an instantaneous source in a plane with diffusivities k_1, k_2 along its axes, that has spread
 *   to exp(-(x^2 + y^2)/w^2) at t = 0:
 *     v = w^2/(w_1 w_2) exp(-x^2/w_1^2 - y^2/w_2^2),    w_i^2 = w^2 + 4 k_i t
 *
 *   a long rod that is cold at first and moves with the speed u through the place x = 0, where it
 * is held at 1, in the steady state u v_x = kappa v_xx; the part that has passed stays warm: v =
 * min(1, exp(u x/kappa))
 *
 * Each satisfies the equation term by term and its conditions on the surface; the tests hold them
 * against differences, and near t = 0 against the start.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_EXACT_HEAT_H
#define VERIFICATION_EXACT_HEAT_H

enum heat_body { HEAT_SLAB, HEAT_CYLINDER, HEAT_SPHERE, HEAT_BODIES };

/* place: x/a or r/a, 0 to 1; tau > 0. Series end where terms are below 1e-17; down to tau = 1e-4.
 */
double heat_surface_held(enum heat_body body, double place, double tau);
double heat_surface_flux(enum heat_body body, double place, double tau);
double heat_source_held(enum heat_body body, double place, double tau);
/* place = x/a; rate = kappa/a^2 > 0, frequency w > 0. */
double heat_slab_driven(double place, double rate, double frequency, double time);
double heat_sphere_mode(double place, double tau);
/* decayed = decay t */
double heat_product(const double place[2], double p, double q, double decayed);
/* place: from the middle along the axes; width w > 0. */
double heat_spot(const double place[2], double width, const double diffusivity[2], double time);
double heat_passing_rod(double place, double speed, double diffusivity);

#endif
