/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/transport/transport_passes.h"

#include "base/simd.h"
#include "base/strips.h"
#include "method/transfer/transfer.h"

#include <math.h>

void mpm_scalar_pass_run(struct mpm_state *state, int workers,
                         const struct mpm_nodal_scalar *scalar, mpm_pass *pass)
{
    state->transport.conducted = scalar;
    mpm_strips_run(state->strip_count, workers, pass, state);
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

/* c m */
static double capacity_of(const struct mpm_state *state, const struct mpm_nodal_scalar *scalar,
                          size_t p)
{
    return scalar->weight[state->particles.body[p]] * state->particles.mass[p];
}

static void pass_spread(void *context, int64_t index, int worker)
{
    const struct mpm_state *const state = context;
    const struct mpm_strip *const strip = &state->strips[index];
    const struct mpm_nodal_scalar *const scalar = state->transport.conducted;
    const double *const values = mpm_scalar_values(scalar, &state->particles);
    (void)worker;
    for (size_t p = strip->begin; p < strip->end; p++) {
        struct mpm_stencil room;
        const struct mpm_stencil *const stencil = mpm_particle_stencil(state, p, &room);
        const double capacity = capacity_of(state, scalar, p);
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

static void pass_conduct(void *context, int64_t index, int worker)
{
    const struct mpm_state *const state = context;
    struct mpm_strip *const strip = &state->strips[index];
    const struct mpm_particles *const particles = &state->particles;
    const struct mpm_nodal_scalar *const scalar = state->transport.conducted;
    double *const inflow = scalar->inflow + state->node_zero;
    double largest = 0.0;
    (void)worker;
    for (size_t p = strip->begin; p < strip->end; p++) {
        const struct mpm_scalar_body *const body = &scalar->bodies[particles->body[p]];
        const double density = state->bodies[particles->body[p]].material.density;
        struct mpm_stencil room;
        double f[MPM_GRADIENT_SIZE], gradient[2], flow[2];
        const struct mpm_stencil *const stencil = mpm_particle_stencil(state, p, &room);
        mpm_particle_deformation(particles, p, f);
        const double j = mpm_determinant(f), volume = particles->mass[p] * j;
        const double source = scalar->source == NULL ? 0.0 : particles->source[p] / density;
        find_gradient(stencil, scalar->value + state->node_zero, gradient);
        conduct(body, f, gradient, flow);
        largest = fmax(largest, j * body->diffusivity);
        for (int k = 0; k < stencil->count; k++) {
            const struct mpm_stencil_node *const entry = &stencil->node[k];
            const double along = flow[0] * entry->g[0] + flow[1] * entry->g[1];
            inflow[entry->node] += volume * (source * entry->s - along);
        }
    }
    strip->diffusivity = largest;
}

MPM_INLINE void update(const struct mpm_state *state, int64_t index, bool spreads)
{
    const struct mpm_strip *const strip = &state->strips[index];
    const struct mpm_nodal_scalar *const scalar = state->transport.conducted;
    const bool pic = scalar->transfer == MPM_SCALAR_PIC;
    double *const values = mpm_scalar_values(scalar, &state->particles);
    for (size_t p = strip->begin; p < strip->end; p++) {
        struct mpm_stencil room;
        const struct mpm_stencil *const stencil = mpm_particle_stencil(state, p, &room);
        const double result = gather(stencil, scalar->result + state->node_zero);
        values[p] = pic ? result : values[p] + state->time_step * result;
        if (spreads)
            add(stencil, capacity_of(state, scalar, p) * values[p],
                scalar->content + state->node_zero);
    }
}

static MPM_PASS(pass_update, update, false) static MPM_PASS(pass_update_and_spread, update, true)

    static void pass_filter(void *context, int64_t index, int worker)
{
    const struct mpm_state *const state = context;
    const struct mpm_strip *const strip = &state->strips[index];
    const struct mpm_nodal_scalar *const scalar = state->transport.conducted;
    (void)worker;
    for (size_t p = strip->begin; p < strip->end; p++) {
        struct mpm_stencil room;
        const struct mpm_stencil *const stencil = mpm_particle_stencil(state, p, &room);
        const double value = gather(stencil, scalar->value + state->node_zero);
        add(stencil, capacity_of(state, scalar, p) * value, scalar->result + state->node_zero);
    }
}

const struct mpm_scalar_passes mpm_scalar_passes = {
    .spread = pass_spread,
    .conduct = pass_conduct,
    .conduct_undeformed = pass_conduct,
    .update = pass_update,
    .update_and_spread = pass_update_and_spread,
    .filter = pass_filter,
};
