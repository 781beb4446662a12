/* The motion of a field and the forces that it takes, at two places at a time.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/manufactured_field.h"
#include "verification/exact/manufactured_stress.h"

enum { AXES = 2 };

/* Nearer to r = 0 than this part of the domain, quotients by R are their limits: the limits are
 * off by as much, and the quotients' round-off, eps over the part, would be as well. */
static const double NEAR_AXIS = 1e-8;

/* What a pair of places has at one time. */
struct pair {
    lanes place[AXES];
    lanes_mask on_axis; /* axisymmetric only */
    struct jet u[AXES];
    struct slope f[P_SIZE], p[P_SIZE];
};

LANES_INLINE void move_pair(const struct manufactured_problem *problem, const struct jet swings[],
                            struct pair *pair)
{
    const struct jet place[AXES] = {jet_place(0, pair->place[0]), jet_place(1, pair->place[1])};
    problem->field->displacement(problem, place, swings, pair->u);
}

/* u_r / R; where R = 0 its limit: (u_r)_R, (u_r)_RR / 2 and (u_r)_RZ */
LANES_INLINE struct slope hoop_stretch(const struct pair *pair)
{
    const struct jet *const u = &pair->u[0];
    const lanes inverse = 1.0 / pair->place[0];
    const struct slope quotient = {u->f * inverse, (u->x - u->f * inverse) * inverse,
                                   u->y * inverse};
    return (struct slope){lanes_select(pair->on_axis, u->x, quotient.f),
                          lanes_select(pair->on_axis, 0.5 * u->xx, quotient.x),
                          lanes_select(pair->on_axis, u->xy, quotient.y)};
}

/* F = I + Grad u with its gradient, then P with its own. */
LANES_INLINE void strain_pair(const struct manufactured_problem *problem, struct pair *pair)
{
    const struct jet *const u = pair->u;
    struct slope *const f = pair->f;
    f[P_XX] = (struct slope){1.0 + u[0].x, u[0].xx, u[0].xy};
    f[P_XY] = (struct slope){u[0].y, u[0].xy, u[0].yy};
    f[P_YX] = (struct slope){u[1].x, u[1].xx, u[1].xy};
    f[P_YY] = (struct slope){1.0 + u[1].y, u[1].xy, u[1].yy};
    f[P_ZZ] = (struct slope){.f = lanes_splat(1.0)};
    if (problem->geometry == MPM_AXISYMMETRIC) {
        pair->on_axis = pair->place[0] <= NEAR_AXIS * problem->domain.high[0];
        f[P_ZZ] = hoop_stretch(pair);
        f[P_ZZ].f += 1.0;
    } else if (problem->geometry == MPM_PLANE_STRESS) {
        stress_free_thickness(problem, f);
    }
}

/* a / R, or the limit of a quotient whose numerator vanishes at R = 0 */
LANES_INLINE lanes over_radius(const struct pair *pair, struct slope a)
{
    return lanes_select(pair->on_axis, a.x, a.f / pair->place[0]);
}

/* Div P, and of it what has 1 / R. */
LANES_INLINE void diverge(const struct manufactured_problem *problem, const struct pair *pair,
                          const struct slope p[P_SIZE], lanes divergence[AXES], lanes hoop[AXES])
{
    hoop[0] = hoop[1] = lanes_splat(0.0);
    if (problem->geometry == MPM_AXISYMMETRIC) {
        hoop[0] = over_radius(pair, slope_subtract(p[P_XX], p[P_ZZ]));
        hoop[1] = over_radius(pair, p[P_YX]);
    }
    divergence[0] = p[P_XX].x + p[P_XY].y + hoop[0];
    divergence[1] = p[P_YX].x + p[P_YY].y + hoop[1];
}

/* ------------------------------------------------------------------- forces */

LANES_INLINE void pair_force(const struct manufactured_problem *problem, const struct jet swings[],
                             struct pair *pair, lanes force[AXES])
{
    lanes divergence[AXES], hoop[AXES];
    move_pair(problem, swings, pair);
    strain_pair(problem, pair);
    stress_of_law(problem, pair->f, pair->p);
    diverge(problem, pair, pair->p, divergence, hoop);
    for (int axis = 0; axis < AXES; axis++)
        force[axis] = pair->u[axis].tt - divergence[axis] / problem->density;
}

void manufactured_load_evaluate(void *load, double time, size_t count, const uint32_t id[],
                                double *const force[2])
{
    const struct manufactured_load *const given = load;
    struct jet swings[MANUFACTURED_SWINGS];
    given->problem->field->swing(given->problem, jet_time(time), swings);
    for (size_t k = 0; k < count; k += LANES) {
        const size_t last = k + 1 < count ? k + 1 : k;
        const double *const first = given->places + AXES * (size_t)id[k];
        const double *const second = given->places + AXES * (size_t)id[last];
        struct pair pair = {.place = {{first[0], second[0]}, {first[1], second[1]}}};
        lanes b[AXES];
        pair_force(given->problem, swings, &pair, b);
        for (int axis = 0; axis < AXES; axis++) {
            force[axis][last] = b[axis][1];
            force[axis][k] = b[axis][0];
        }
    }
}

/* -------------------------------------------------------------------- state */

static void copy_tensors(const struct pair *pair, struct manufactured_state *state)
{
    for (int k = 0; k < P_SIZE; k++) {
        state->deformation[k] = pair->f[k].f[0];
        state->nominal[k] = pair->p[k].f[0];
    }
    const double *const f = state->deformation, *const p = state->nominal;
    const double j = (f[P_XX] * f[P_YY] - f[P_XY] * f[P_YX]) * f[P_ZZ];
    /* P F^T / J */
    state->stress[0] = (p[P_XX] * f[P_XX] + p[P_XY] * f[P_XY]) / j;
    state->stress[1] = (p[P_YX] * f[P_YX] + p[P_YY] * f[P_YY]) / j;
    state->stress[2] = p[P_ZZ] * f[P_ZZ] / j;
    state->stress[3] = (p[P_XX] * f[P_YX] + p[P_XY] * f[P_YY]) / j;
}

void manufactured_evaluate(const struct manufactured_problem *problem, const double place[2],
                           double time, struct manufactured_state *state)
{
    struct pair pair = {.place = {lanes_splat(place[0]), lanes_splat(place[1])}};
    lanes force[AXES], divergence[AXES], hoop[AXES], linear[AXES], unused[AXES];
    struct jet swings[MANUFACTURED_SWINGS];
    problem->field->swing(problem, jet_time(time), swings);
    pair_force(problem, swings, &pair, force);
    diverge(problem, &pair, pair.p, divergence, hoop);
    copy_tensors(&pair, state);
    stress_hooke(problem, pair.f, pair.p);
    diverge(problem, &pair, pair.p, linear, unused);
    for (int axis = 0; axis < AXES; axis++) {
        state->displacement[axis] = pair.u[axis].f[0];
        state->velocity[axis] = pair.u[axis].t[0];
        state->acceleration[axis] = pair.u[axis].tt[0];
        state->divergence[axis] = divergence[axis][0];
        state->hoop[axis] = hoop[axis][0];
        state->linear[axis] = linear[axis][0];
        state->body_force[axis] = force[axis][0];
    }
}
