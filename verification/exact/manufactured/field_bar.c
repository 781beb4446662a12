/* The first axial mode of a bar held sideways and at both ends,
 *
 *     u = A sin(pi X / L) sin(pi c t / L),   v = 0,   c the speed of a bar.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/manufactured/manufactured_field.h"

enum { AMPLITUDE, LENGTH };

static void prepare(struct manufactured_problem *problem)
{
    const double length = problem->parameter[LENGTH];
    problem->domain = (struct manufactured_domain){.high = {length, 0.25 * length}};
    for (int edge = 0; edge < MANUFACTURED_EDGES; edge++)
        problem->edge[edge] = MANUFACTURED_SLIDES;
    problem->period = 2.0 * length / manufactured_bar_speed(problem);
    problem->end = 0.4 * problem->period;
    problem->constant[0] = MANUFACTURED_PI / length;
    problem->constant[1] = 2.0 * MANUFACTURED_PI / problem->period;
}

static void swing(const struct manufactured_problem *problem, struct jet time,
                  struct jet swings[MANUFACTURED_SWINGS])
{
    swings[0] =
        jet_scale(problem->parameter[AMPLITUDE], jet_sin(jet_scale(problem->constant[1], time)));
}

static void displacement(const struct manufactured_problem *problem, const struct jet place[2],
                         const struct jet swings[MANUFACTURED_SWINGS], struct jet u[2])
{
    const struct jet wave = jet_sin(jet_scale(problem->constant[0], place[0]));
    u[0] = jet_multiply(wave, swings[0]);
    u[1] = jet_constant(0.0);
}

const struct manufactured_field MANUFACTURED_OF_LEVEL(bar) = {
    .name = "bar",
    .parameter = {[AMPLITUDE] = {"amplitude", 0.05, 1e-9, 0.3, "A, length"},
                  [LENGTH] = {"length", 1, 0.01, 100, "L, length"}},
    .prepare = prepare,
    .swing = swing,
    .displacement = displacement,
};
