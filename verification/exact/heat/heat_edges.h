/* Bodies that exchange heat, or a solvent, with what is around them: v_t = kappa div grad v, v = 0
 * at first and
 *
 *     a v_x = b (1 - v)   at the surface, b = h a/k   (convection; H. S. Carslaw, J. C. Jaeger)
 *
 * With tau = kappa t/a^2, and x, r from the insulated face or the centre:
 *
 *     1 - v = sum_n c_n f(z_n x/a) exp(-z_n^2 tau)
 *
 *   slab      f = cos,         z tan z = b,            c = 2 sin z/(z + sin z cos z)
 *   cylinder  f = J0,          z J1(z) = b J0(z),      c = 2 b^2/((z^2 + b^2) z J1(z))
 *   sphere    f = sin(z)/z,    z cos z = (1 - b) sin z,
 *                                             c = 2 (sin z - z cos z)/(z - sin z cos z)
 *
 * and a body of one temperature, absolute, that radiates into the cold: with
 * rate = e sigma A/(rho c V), T_t = -rate T^4, so that
 *
 *     T^-3 = start^-3 + 3 rate t
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_EXACT_HEAT_EDGES_H
#define VERIFICATION_EXACT_HEAT_EDGES_H

#include "verification/exact/heat/heat.h"

/* z_n, n = 0, 1, ...; b > 0. */
double heat_convection_root(enum heat_body body, double b, unsigned n);
/* place: x/a or r/a, 0 to 1; tau > 0. The series ends where exp(-z^2 tau) is below 4e-18; down to
 * tau = 1e-4. */
double heat_surface_convection(enum heat_body body, double place, double tau, double b);
double heat_radiated(double start, double rate, double time);

#endif
