/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/transport/transport_passes.h"

#include "base/simd.h"
#include "base/strips.h"
#include "method/grid/grid_update.h"
#include "method/transfer/law_state.h"
#include "method/transfer/transfer.h"

#include <math.h>

void mpm_scalar_pass_run(struct mpm_state *state, int workers,
                         const struct mpm_nodal_scalar *scalar, mpm_pass *pass)
{
    state->transport.conducted = scalar;
    mpm_strips_run(state->strip_count, workers, pass, state);
    state->transport.conducted = NULL;
}

void mpm_scalar_rows_run(struct mpm_state *state, const struct mpm_nodal_scalar *scalar,
                         mpm_pass *pass)
{
    state->transport.conducted = scalar;
    mpm_grid_rows_run(state, pass);
    state->transport.conducted = NULL;
}

static void add(const struct mpm_stencil *stencil, double value, double *nodes)
{
    for (int k = 0; k < stencil->count; k++)
        nodes[stencil->node[k].node] += value * stencil->node[k].s;
}

static double gather(const struct mpm_stencil *stencil, const double *nodes)
{
    double sum = 0.0;
    for (int k = 0; k < stencil->count; k++)
        sum += stencil->node[k].s * nodes[stencil->node[k].node];
    return sum;
}

/* Without tables all below is of constants, and `tables` is known when this is compiled. */
static const struct mpm_property *table_of(const struct mpm_state *state,
                                           const struct mpm_nodal_scalar *scalar, size_t p,
                                           enum mpm_table which)
{
    return &scalar->bodies[state->particles.body[p]].tables[which];
}

/* c m, c at the particle's value v. */
MPM_INLINE double capacity_of(const struct mpm_state *state, const struct mpm_nodal_scalar *scalar,
                              size_t p, double v, bool tables)
{
    const struct mpm_property *const table =
        tables ? table_of(state, scalar, p, MPM_TABLE_CAPACITY) : NULL;
    const double c = tables && table->count > 0 ? mpm_property_value(table, v)
                                                : scalar->weight[state->particles.body[p]];
    return c * state->particles.mass[p];
}

MPM_INLINE void spread(const struct mpm_state *state, int64_t index, bool tables)
{
    const struct mpm_strip *const strip = &state->strips[index];
    const struct mpm_nodal_scalar *const scalar = state->transport.conducted;
    const double *const values = mpm_scalar_values(scalar, &state->particles);
    for (size_t p = strip->begin; p < strip->end; p++) {
        struct mpm_stencil room;
        const struct mpm_stencil *const stencil = mpm_particle_stencil(state, p, &room);
        const double capacity = capacity_of(state, scalar, p, values[p], tables);
        add(stencil, capacity * values[p], scalar->content + state->node_zero);
        add(stencil, capacity, scalar->capacity + state->node_zero);
    }
}

/* k grad v; k turned by R of F = R U, the rotation by the angle of (F_xx + F_yy, F_yx - F_xy) */
static void conduct(const struct mpm_scalar_body *body, const double f[MPM_GRADIENT_SIZE],
                    const double gradient[2], double flow[2])
{
    double cosine = 1.0, sine = 0.0;
    if (body->turns) {
        const double sum = f[MPM_XX] + f[MPM_YY], difference = f[MPM_YX] - f[MPM_XY];
        const double inverse = 1.0 / sqrt(sum * sum + difference * difference);
        cosine = sum * inverse;
        sine = difference * inverse;
    }
    const double along[2] = {cosine * gradient[0] + sine * gradient[1],
                             cosine * gradient[1] - sine * gradient[0]};
    const double turned[2] = {body->k[0] * along[0] + body->k[2] * along[1],
                              body->k[2] * along[0] + body->k[1] * along[1]};
    flow[0] = cosine * turned[0] - sine * turned[1];
    flow[1] = sine * turned[0] + cosine * turned[1];
}

static void find_gradient(const struct mpm_stencil *stencil, const double *value,
                          double gradient[2])
{
    gradient[0] = gradient[1] = 0.0;
    for (int k = 0; k < stencil->count; k++) {
        const struct mpm_stencil_node *const entry = &stencil->node[k];
        gradient[0] += value[entry->node] * entry->g[0];
        gradient[1] += value[entry->node] * entry->g[1];
    }
}

/* What a conductivity of a table is over that of the body: its value; else 1. */
MPM_INLINE double table_factor(const struct mpm_state *state, const struct mpm_nodal_scalar *scalar,
                               size_t p, bool tables)
{
    const struct mpm_property *const table =
        tables ? table_of(state, scalar, p, MPM_TABLE_CONDUCTIVITY) : NULL;
    return tables && table->count > 0
               ? mpm_property_value(table, mpm_scalar_values(scalar, &state->particles)[p])
               : 1.0;
}

MPM_INLINE void conduct_particles(const struct mpm_state *state, int64_t index, bool tables)
{
    struct mpm_strip *const strip = &state->strips[index];
    const struct mpm_particles *const particles = &state->particles;
    const struct mpm_nodal_scalar *const scalar = state->transport.conducted;
    double *const inflow = scalar->inflow + state->node_zero;
    double largest = 0.0;
    for (size_t p = strip->begin; p < strip->end; p++) {
        const struct mpm_scalar_body *const body = &scalar->bodies[particles->body[p]];
        const double density = state->bodies[particles->body[p]].material.density;
        struct mpm_stencil room;
        double f[MPM_GRADIENT_SIZE], gradient[2], flow[2];
        const struct mpm_stencil *const stencil = mpm_particle_stencil(state, p, &room);
        mpm_particle_deformation(particles, p, f);
        const double j = mpm_determinant(f), volume = particles->mass[p] * j;
        const double source = scalar->source == NULL ? 0.0 : particles->source[p] / density;
        const double factor = table_factor(state, scalar, p, tables);
        find_gradient(stencil, scalar->value + state->node_zero, gradient);
        conduct(body, f, gradient, flow);
        for (int axis = 0; axis < 2; axis++)
            flow[axis] *= factor;
        largest = fmax(largest, j * body->diffusivity);
        for (int k = 0; k < stencil->count; k++) {
            const struct mpm_stencil_node *const entry = &stencil->node[k];
            const double along = flow[0] * entry->g[0] + flow[1] * entry->g[1];
            inflow[entry->node] += volume * (source * entry->s - along);
        }
    }
    strip->diffusivity = largest;
}

/* Of tables: the enthalpy changes by c times what free nodes change the value by, what they have
 * given; held nodes change the value. Returns what that takes. */
static double follow(const struct mpm_nodal_scalar *scalar, const struct mpm_property *table,
                     double free, double held, double *value)
{
    const double c = mpm_property_value(table, *value);
    const double given = *value + mpm_property_rise(table, *value, c * free);
    *value = given + held;
    return scalar->held == NULL
               ? 0.0
               : mpm_property_integral(table, *value) - mpm_property_integral(table, given);
}

/* Returns what held nodes have given. */
MPM_INLINE double update_by_tables(const struct mpm_state *state,
                                   const struct mpm_nodal_scalar *scalar, size_t p,
                                   const struct mpm_stencil *stencil, double result, double *value)
{
    const uint32_t body = state->particles.body[p];
    const struct mpm_property *const table = table_of(state, scalar, p, MPM_TABLE_CAPACITY);
    const double dt = state->time_step, mass = state->particles.mass[p];
    const double held =
        scalar->held == NULL ? 0.0 : dt * gather(stencil, scalar->held + state->node_zero);
    const double change = mpm_scalar_takes_values(scalar) ? result - *value : dt * result;
    if (table->count > 0)
        return mass * follow(scalar, table, change - held, held, value);
    *value += change;
    return mass * scalar->weight[body] * held;
}

MPM_INLINE void update(const struct mpm_state *state, int64_t index, bool spreads, bool tables)
{
    struct mpm_strip *const strip = &state->strips[index];
    const struct mpm_nodal_scalar *const scalar = state->transport.conducted;
    const bool takes = mpm_scalar_takes_values(scalar);
    double *const values = mpm_scalar_values(scalar, &state->particles);
    double held = 0.0;
    for (size_t p = strip->begin; p < strip->end; p++) {
        struct mpm_stencil room;
        const struct mpm_stencil *const stencil = mpm_particle_stencil(state, p, &room);
        const double result = gather(stencil, scalar->result + state->node_zero);
        if (tables) {
            held += update_by_tables(state, scalar, p, stencil, result, &values[p]);
            mpm_strip_judge_tables(strip, scalar->which,
                                   scalar->bodies[state->particles.body[p]].tables,
                                   state->particles.id[p], values[p]);
        } else {
            values[p] = takes ? result : values[p] + state->time_step * result;
        }
        if (spreads)
            add(stencil, capacity_of(state, scalar, p, values[p], tables) * values[p],
                scalar->content + state->node_zero);
    }
    strip->inflow = held;
}

MPM_INLINE void filter(const struct mpm_state *state, int64_t index, bool tables)
{
    const struct mpm_strip *const strip = &state->strips[index];
    const struct mpm_nodal_scalar *const scalar = state->transport.conducted;
    const double *const values = mpm_scalar_values(scalar, &state->particles);
    for (size_t p = strip->begin; p < strip->end; p++) {
        struct mpm_stencil room;
        const struct mpm_stencil *const stencil = mpm_particle_stencil(state, p, &room);
        const double value = gather(stencil, scalar->value + state->node_zero);
        add(stencil, capacity_of(state, scalar, p, values[p], tables) * value,
            scalar->result + state->node_zero);
    }
}

/* clang-format off */
#define PASSES(name, tables)                                                                       \
    static MPM_PASS(name##_spread, spread, tables)                                                 \
    static MPM_PASS(name##_conduct, conduct_particles, tables)                                     \
    static MPM_PASS(name##_update, update, false, tables)                                          \
    static MPM_PASS(name##_update_and_spread, update, true, tables)                                \
    static MPM_PASS(name##_filter, filter, tables)                                                 \
    const struct mpm_scalar_passes mpm_##name##_passes = {                                         \
        .spread = name##_spread,                                                                   \
        .conduct = name##_conduct,                                                                 \
        .conduct_undeformed = name##_conduct,                                                      \
        .update = name##_update,                                                                   \
        .update_and_spread = name##_update_and_spread,                                             \
        .filter = name##_filter,                                                                   \
    };

PASSES(scalar, false)
PASSES(table_scalar, true)
/* clang-format on */
