/* The motion of a field and the forces that it takes, at LANES places at a time ("a group").
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/manufactured/manufactured_field.h"
#include "verification/exact/manufactured/manufactured_stress.h"

enum { AXES = 2 };

/* Nearer to r = 0 than this part of the domain, quotients by R are their limits: the limits are
 * off by as much, and the quotients' round-off, eps over the part, would be as well. */
static const double NEAR_AXIS = 1e-8;

/* What a group of places has at one time. */
struct group {
    lanes place[AXES];
    lanes_mask on_axis; /* axisymmetric only */
    struct jet u[AXES];
    struct slope f[P_SIZE], p[P_SIZE];
};

LANES_INLINE void move_group(const struct manufactured_problem *problem, const struct jet swings[],
                             struct group *group)
{
    const struct jet place[AXES] = {jet_place(0, group->place[0]), jet_place(1, group->place[1])};
    problem->field->displacement(problem, place, swings, group->u);
}

/* u_r / R; where R = 0 its limit: (u_r)_R, (u_r)_RR / 2 and (u_r)_RZ */
LANES_INLINE struct slope hoop_stretch(const struct group *group)
{
    const struct jet *const u = &group->u[0];
    const lanes inverse = 1.0 / group->place[0];
    const struct slope quotient = {u->f * inverse, (u->x - u->f * inverse) * inverse,
                                   u->y * inverse};
    return (struct slope){lanes_select(group->on_axis, u->x, quotient.f),
                          lanes_select(group->on_axis, 0.5 * u->xx, quotient.x),
                          lanes_select(group->on_axis, u->xy, quotient.y)};
}

/* F = I + Grad u with its gradient, then P with its own. */
LANES_INLINE void strain_group(const struct manufactured_problem *problem, struct group *group)
{
    const struct jet *const u = group->u;
    struct slope *const f = group->f;
    f[P_XX] = (struct slope){1.0 + u[0].x, u[0].xx, u[0].xy};
    f[P_XY] = (struct slope){u[0].y, u[0].xy, u[0].yy};
    f[P_YX] = (struct slope){u[1].x, u[1].xx, u[1].xy};
    f[P_YY] = (struct slope){1.0 + u[1].y, u[1].xy, u[1].yy};
    f[P_ZZ] = (struct slope){.f = lanes_splat(1.0)};
    if (problem->geometry == MPM_AXISYMMETRIC) {
        group->on_axis = group->place[0] <= NEAR_AXIS * problem->domain.high[0];
        f[P_ZZ] = hoop_stretch(group);
        f[P_ZZ].f += 1.0;
    } else if (problem->geometry == MPM_PLANE_STRESS) {
        stress_free_thickness(problem, f);
    }
}

/* a / R, or the limit of a quotient whose numerator vanishes at R = 0 */
LANES_INLINE lanes over_radius(const struct group *group, struct slope a)
{
    return lanes_select(group->on_axis, a.x, a.f / group->place[0]);
}

/* Div P, and of it what has 1 / R. */
LANES_INLINE void diverge(const struct manufactured_problem *problem, const struct group *group,
                          const struct slope p[P_SIZE], lanes divergence[AXES], lanes hoop[AXES])
{
    hoop[0] = hoop[1] = lanes_splat(0.0);
    if (problem->geometry == MPM_AXISYMMETRIC) {
        hoop[0] = over_radius(group, slope_subtract(p[P_XX], p[P_ZZ]));
        hoop[1] = over_radius(group, p[P_YX]);
    }
    divergence[0] = p[P_XX].x + p[P_XY].y + hoop[0];
    divergence[1] = p[P_YX].x + p[P_YY].y + hoop[1];
}

/* ------------------------------------------------------------------- forces */

LANES_INLINE void group_force(const struct manufactured_problem *problem, const struct jet swings[],
                              struct group *group, lanes force[AXES])
{
    lanes divergence[AXES], hoop[AXES];
    move_group(problem, swings, group);
    strain_group(problem, group);
    stress_of_law(problem, group->f, group->p);
    diverge(problem, group, group->p, divergence, hoop);
    for (int axis = 0; axis < AXES; axis++)
        force[axis] = group->u[axis].tt - divergence[axis] / problem->density;
}

static void evaluate_load(void *load, double time, size_t count, const uint32_t id[],
                          double *const force[2])
{
    const struct manufactured_load *const given = load;
    struct jet swings[MANUFACTURED_SWINGS];
    given->problem->field->swing(given->problem, jet_time(time), swings);
    for (size_t first = 0; first < count; first += LANES) {
        const size_t lanes_used = count - first < LANES ? count - first : LANES;
        struct group group = {.place = {lanes_splat(0.0), lanes_splat(0.0)}};
        lanes b[AXES];
        for (size_t k = 0; k < LANES; k++) { /* those left over are the first one again */
            const size_t particle = id[first + (k < lanes_used ? k : 0)];
            for (size_t axis = 0; axis < AXES; axis++)
                group.place[axis][k] = given->places[AXES * particle + axis];
        }
        group_force(given->problem, swings, &group, b);
        for (size_t axis = 0; axis < AXES; axis++)
            for (size_t k = 0; k < lanes_used; k++)
                force[axis][first + k] = b[axis][k];
    }
}

/* -------------------------------------------------------------------- state */

static void copy_tensors(const struct group *group, struct manufactured_state *state)
{
    for (int k = 0; k < P_SIZE; k++) {
        state->deformation[k] = group->f[k].f[0];
        state->nominal[k] = group->p[k].f[0];
    }
    const double *const f = state->deformation, *const p = state->nominal;
    const double j = (f[P_XX] * f[P_YY] - f[P_XY] * f[P_YX]) * f[P_ZZ];
    /* P F^T / J */
    state->stress[0] = (p[P_XX] * f[P_XX] + p[P_XY] * f[P_XY]) / j;
    state->stress[1] = (p[P_YX] * f[P_YX] + p[P_YY] * f[P_YY]) / j;
    state->stress[2] = p[P_ZZ] * f[P_ZZ] / j;
    state->stress[3] = (p[P_XX] * f[P_YX] + p[P_XY] * f[P_YY]) / j;
}

static void evaluate(const struct manufactured_problem *problem, const double place[2], double time,
                     struct manufactured_state *state)
{
    struct group group = {.place = {lanes_splat(place[0]), lanes_splat(place[1])}};
    lanes force[AXES], divergence[AXES], hoop[AXES], linear[AXES], unused[AXES];
    struct jet swings[MANUFACTURED_SWINGS];
    problem->field->swing(problem, jet_time(time), swings);
    group_force(problem, swings, &group, force);
    diverge(problem, &group, group.p, divergence, hoop);
    copy_tensors(&group, state);
    stress_hooke(problem, group.f, group.p);
    diverge(problem, &group, group.p, linear, unused);
    for (int axis = 0; axis < AXES; axis++) {
        state->displacement[axis] = group.u[axis].f[0];
        state->velocity[axis] = group.u[axis].t[0];
        state->acceleration[axis] = group.u[axis].tt[0];
        state->divergence[axis] = divergence[axis][0];
        state->hoop[axis] = hoop[axis][0];
        state->linear[axis] = linear[axis][0];
        state->body_force[axis] = force[axis][0];
    }
}

#define FIELD_OF(name) &MANUFACTURED_OF_LEVEL(name),
#define DECLARE(name)  extern const struct manufactured_field MANUFACTURED_OF_LEVEL(name);
MANUFACTURED_FIELDS(DECLARE)
static const struct manufactured_field *const fields[] = {MANUFACTURED_FIELDS(FIELD_OF)};

const struct manufactured_kernels MANUFACTURED_OF_LEVEL(kernels) = {fields, evaluate,
                                                                    evaluate_load};
