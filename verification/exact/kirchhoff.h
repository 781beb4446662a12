/* Kirchhoff's transform of conduction with a conductivity that depends on the temperature (Carslaw
 * and Jaeger, Conduction of Heat in Solids, 1.6): with theta(T) the integral of k dT,
 *
 *     rho c T_t = div(k grad T)   is   (rho c/k) theta_t = div grad theta,
 *
 * linear where k/c is constant, and in the steady state for any c. The conductivity is a table,
 * linear between its points.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_EXACT_KIRCHHOFF_H
#define VERIFICATION_EXACT_KIRCHHOFF_H

#include <stddef.h>

enum { KIRCHHOFF_POINTS = 16 };

struct kirchhoff {
    size_t count;                      /* of points, at least 2 */
    double point[KIRCHHOFF_POINTS][2]; /* T and k > 0, T rising */
};

/* From the first point on, of T in the table. Trapezia. */
double kirchhoff_theta(const struct kirchhoff *table, double temperature);

/* T with theta(T) = theta(from) + rise, by halving intervals: to round-off. NaN if it is not in the
 * table. */
double kirchhoff_temperature(const struct kirchhoff *table, double from, double rise);

#endif
