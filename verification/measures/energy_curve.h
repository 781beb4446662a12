/* What a curve of energies over time shows: which way the total moves, how far, when, and how much
 * of that is the half step between strains and velocities. Pure functions; a NaN in a curve stays
 * in what is measured of it.
 *
 * A row is a time, the total energy over that of the start, and the strain energy over the same.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_MEASURES_ENERGY_CURVE_H
#define VERIFICATION_MEASURES_ENERGY_CURVE_H

#include <stddef.h>

struct energy_curve {
    size_t count, stride; /* rows, and numbers from one row to the next */
    const double *time;   /* rising */
    const double *total;  /* E/E(0) */
    const double *strain; /* U/E(0) */
};

/* The value of E/E(0) - 1 with the largest magnitude, with its sign. */
double energy_curve_extreme(const struct energy_curve *curve);

/* Mean of E/E(0) - 1 over the rows with from <= time <= to; NaN if there is none. */
double energy_curve_mean(const struct energy_curve *curve, double from, double to);

/* The first time at which |E/E(0) - 1| exceeds `limit`; NaN if there is none. */
double energy_curve_time_off(const struct energy_curve *curve, double limit);

/* The part of the half step: the coefficient a of the least squares fit
 *
 *     E/E(0) - 1 = a (dt/2) d(U/E(0))/dt + b + c t,
 *
 * with central differences in time. Strains that are a step of symplectic Euler ahead of the
 * velocities (MUSL) keep E - (dt/2) dU/dt, those behind (USF) E + (dt/2) dU/dt, to second order
 * in dt for shape functions that do not move: a is 1 and -1. The rows must be closer than an
 * eighth of the fastest period in U that matters (the difference then loses 10 %). NaN for fewer
 * than five rows or U without change. dt > 0. Cost: three passes. */
double energy_curve_swing(const struct energy_curve *curve, double time_step);

#endif
