/* A tube of perfect plasticity (von Mises) under inner pressure, held along its axis, at small
 * strain, for any Poisson's ratio: no closed form is known, since the axial stress turns while the
 * tube yields. Integrated here, apart from the solver, by linear finite elements along r.
 *
 * Equilibrium in weak form, per radian and length: for each v(r)
 *
 *     integral (sigma_rr v' + sigma_tt v/r) r dr = p a v(a),
 *     e_rr = u', e_tt = u/r, e_zz = 0,
 *     sigma = K tr(e) I + 2 G (dev e - e_p),   |dev sigma| <= sqrt(2/3) Y,
 *
 * e_p by backward Euler along the normal, with one point in the middle of each element. Newton's
 * method with the tangent that belongs to the return, to 1e-9 of Y a. Stress and displacement
 * are of second order in the elements, the axial stress of first order in the steps of the load.
 * For nu -> 1/2 the axial stress is the mean of the other two, and with k = Y/sqrt(3)
 *
 *     p = 2 k ln(c/a) + k (1 - c^2/b^2),   sigma_rr = -p + 2 k ln(r/a) at r <= c
 *
 * (R. Hill, The Mathematical Theory of Plasticity, ch. V.3). The tests hold this file against that
 * and, below yield, against Lame.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_EXACT_PLASTIC_TUBE_H
#define VERIFICATION_EXACT_PLASTIC_TUBE_H

#include <stdbool.h>
#include <stddef.h>

struct plastic_tube {
    double inner, outer; /* radii 0 < a < b */
    double young, poisson, yield;
    size_t elements; /* along r */
    size_t steps;    /* of each change of the load */
};

struct plastic_tube_state {
    double rr, tt, zz; /* stress */
    double u;          /* radial displacement */
};

struct plastic_tube_run;

/* The tube at rest without load. Free it. */
struct plastic_tube_run *plastic_tube_create(const struct plastic_tube *tube);
void plastic_tube_free(struct plastic_tube_run *run);

/* Brings the load from what it was to `pressure`, in `steps` equal parts. False: no equilibrium
 * was found, as beyond the limit load. Cost: a few operations for each element, step and round. */
bool plastic_tube_load(struct plastic_tube_run *run, double pressure);

/* The radius up to which the tube has yielded so far; a if nowhere. */
double plastic_tube_front(const struct plastic_tube_run *run);

/* At a <= r <= b, between the elements' middles and beyond the last ones by straight lines. */
struct plastic_tube_state plastic_tube_at(const struct plastic_tube_run *run, double radius);

#endif
