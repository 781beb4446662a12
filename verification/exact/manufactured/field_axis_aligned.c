/* M1: waves along the axes of a square (Wallstedt and Guilkey 2008, J. Comput. Phys. 227, 9628),
 *
 *     u = A sin(2 n pi X) sin(c pi t),   v = A sin(2 n pi Y) sin(c pi t + pi),
 *
 * on the unit square, c the speed of a bar. The normal displacement vanishes on all edges, and so
 * does shear everywhere.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/manufactured/manufactured_field.h"

enum { AMPLITUDE, WAVES };

static void prepare(struct manufactured_problem *problem)
{
    const double speed = manufactured_bar_speed(problem);
    problem->domain = (struct manufactured_domain){.high = {1.0, 1.0}};
    for (int edge = 0; edge < MANUFACTURED_EDGES; edge++)
        problem->edge[edge] = MANUFACTURED_SLIDES;
    problem->period = 2.0 / speed;
    problem->end = 0.4 * problem->period;
    problem->constant[0] = MANUFACTURED_PI * speed;
}

static void swing(const struct manufactured_problem *problem, struct jet time,
                  struct jet swings[MANUFACTURED_SWINGS])
{
    const struct jet phase = jet_scale(problem->constant[0], time);
    swings[0] = jet_scale(problem->parameter[AMPLITUDE], jet_sin(phase));
    swings[1] =
        jet_scale(problem->parameter[AMPLITUDE], jet_sin(jet_shift(phase, MANUFACTURED_PI)));
}

static void displacement(const struct manufactured_problem *problem, const struct jet place[2],
                         const struct jet swings[MANUFACTURED_SWINGS], struct jet u[2])
{
    const double k = 2.0 * MANUFACTURED_PI * problem->parameter[WAVES];
    for (int axis = 0; axis < 2; axis++)
        u[axis] = jet_multiply(jet_sin(jet_scale(k, place[axis])), swings[axis]);
}

const struct manufactured_field MANUFACTURED_OF_LEVEL(axis_aligned) = {
    .name = "axis_aligned",
    .parameter = {[AMPLITUDE] = {"amplitude", 0.05, 1e-9, 0.15, "A, length; the side is 1"},
                  [WAVES] = {"waves", 1, 1, 64, "n, on the side"}},
    .prepare = prepare,
    .swing = swing,
    .displacement = displacement,
};
