/* M3: the generalized vortex (Kamojjala, Brannon, Sadeghirad and Guilkey 2015, Eng. Comput. 31,
 * 193): circles turn about the origin, each by an angle of its own,
 *
 *     alpha = A sin(2 pi t / T) (1 - 16 (R - 1)^2)^2,   0.75 <= R <= 1.25,
 *
 * which is 1 - 32 (R - 1)^2 + 256 (R - 1)^4. Both it and its slope vanish on the rims, and with
 * them displacement, strain and traction. The shear reaches 6.2 A; J = 1. A and T are ours: T is
 * twice the time that a wave of a bar needs for the radius 1.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/manufactured/manufactured_field.h"

enum { AMPLITUDE };

static void prepare(struct manufactured_problem *problem)
{
    problem->domain = (struct manufactured_domain){MANUFACTURED_ANNULUS, .high = {1.25, 1.25},
                                                   .inner = 0.75, .outer = 1.25};
    problem->edge[MANUFACTURED_INNER] = problem->edge[MANUFACTURED_OUTER] =
        MANUFACTURED_FREE | MANUFACTURED_HELD;
    problem->period = 2.0 / manufactured_bar_speed(problem);
    problem->end = 0.2 * problem->period;
    problem->constant[0] = 2.0 * MANUFACTURED_PI / problem->period;
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
    (void)problem;
    const struct jet r = jet_root(jet_add(jet_square(place[0]), jet_square(place[1])));
    const struct jet bump = jet_shift(jet_scale(-16.0, jet_square(jet_shift(r, -1.0))), 1.0);
    struct jet s, c;
    jet_sin_cos(jet_multiply(swings[0], jet_square(bump)), &s, &c);
    const struct jet less = jet_shift(c, -1.0);
    u[0] = jet_subtract(jet_multiply(less, place[0]), jet_multiply(s, place[1]));
    u[1] = jet_add(jet_multiply(s, place[0]), jet_multiply(less, place[1]));
}

const struct manufactured_field MANUFACTURED_OF_LEVEL(vortex) = {
    .name = "vortex",
    .parameter = {[AMPLITUDE] = {"amplitude", 0.2, 1e-9, 1, "A, largest angle"}},
    .prepare = prepare,
    .swing = swing,
    .displacement = displacement,
};
