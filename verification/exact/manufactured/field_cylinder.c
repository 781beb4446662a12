/* M4: waves along and across a cylinder that slides in a box, for axisymmetry:
 *
 *     u_r = A sin(k R) cos(m Z) sin(w t),   u_z = -A cos(k R) sin(m Z) sin(w t),
 *     k = n pi / radius,  m = n pi / height,  w = pi c / radius, c the speed of a bar.
 *
 * sin(k R) is odd and cos(k R) even in R, so that the field is regular on the axis; there u_r / R
 * is A k cos(m Z) sin(w t), not small: near r = 0 the material is stretched as much as anywhere,
 * which is where rules at the axis differ. On R = radius, Z = 0 and Z = height the normal
 * displacement and both shear components of F vanish at any amplitude: the body slides on its
 * edges. Between them it is sheared, unlike M1. radius and height differ, so that as many cells
 * along both make cells that are not square. The opposite signs keep J away from 0 at larger A.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/manufactured/manufactured_field.h"

enum { AMPLITUDE, WAVES, RADIUS, HEIGHT };

static void prepare(struct manufactured_problem *problem)
{
    const double *const p = problem->parameter, speed = manufactured_bar_speed(problem);
    problem->domain = (struct manufactured_domain){.high = {p[RADIUS], p[HEIGHT]}};
    for (int edge = 0; edge < MANUFACTURED_EDGES; edge++)
        problem->edge[edge] = MANUFACTURED_SLIDES;
    problem->period = 2.0 * p[RADIUS] / speed;
    problem->end = 0.4 * problem->period;
    problem->constant[0] = 2.0 * MANUFACTURED_PI / problem->period;
    problem->constant[1] = MANUFACTURED_PI * p[WAVES] / p[RADIUS];
    problem->constant[2] = MANUFACTURED_PI * p[WAVES] / p[HEIGHT];
}

static void swing(const struct manufactured_problem *problem, struct jet time,
                  struct jet swings[MANUFACTURED_SWINGS])
{
    swings[0] =
        jet_scale(problem->parameter[AMPLITUDE], jet_sin(jet_scale(problem->constant[0], time)));
}

static void displacement(const struct manufactured_problem *problem, const struct jet place[2],
                         const struct jet swings[MANUFACTURED_SWINGS], struct jet u[2])
{
    const struct jet kr = jet_scale(problem->constant[1], place[0]);
    const struct jet mz = jet_scale(problem->constant[2], place[1]);
    struct jet s[2], c[2];
    jet_sin_cos(kr, &s[0], &c[0]);
    jet_sin_cos(mz, &s[1], &c[1]);
    u[0] = jet_multiply(jet_multiply(s[0], c[1]), swings[0]);
    u[1] = jet_scale(-1.0, jet_multiply(jet_multiply(c[0], s[1]), swings[0]));
}

const struct manufactured_field MANUFACTURED_OF_LEVEL(cylinder) = {
    .name = "cylinder",
    .parameter = {[AMPLITUDE] = {"amplitude", 0.05, 1e-9, 0.2, "A, length"},
                  [WAVES] = {"waves", 1, 1, 64, "n, half waves on radius and height"},
                  [RADIUS] = {"radius", 1, 0.01, 100, "length"},
                  [HEIGHT] = {"height", 0.75, 0.01, 100, "length"}},
    .prepare = prepare,
    .swing = swing,
    .displacement = displacement,
};
