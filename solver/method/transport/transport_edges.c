/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/transport/transport_edges.h"

#include "base/strips.h"
#include "method/transfer/extent.h"
#include "method/transfer/transfer.h"

double mpm_flux_slope(const struct mpm_edge_load_spec *flux, double value)
{
    switch (flux->flux) {
    case MPM_FLUX_CONVECTS:
        return flux->coefficient;
    case MPM_FLUX_RADIATES:
        return 4.0 * flux->coefficient * fabs(value * value * value);
    case MPM_FLUX_GIVEN:
    case MPM_NO_FLUX:
        break;
    }
    return 0.0;
}

/* phi; `given` is the value of the expression. */
static double flux_at(const struct mpm_edge_load_spec *flux, double given, double value)
{
    switch (flux->flux) {
    case MPM_FLUX_GIVEN:
        return given;
    case MPM_FLUX_CONVECTS:
        return flux->coefficient * (given - value);
    case MPM_FLUX_RADIATES:
        return flux->coefficient *
               (given * given * (given * given) - value * value * (value * value));
    case MPM_NO_FLUX:
        break;
    }
    return 0.0;
}

/* Shares of nodes without capacity go to the particle's nodes by S. */
static void share_out(const struct mpm_state *state, const struct mpm_nodal_scalar *scalar,
                      struct mpm_loaded_edge *edge)
{
    struct mpm_edge_weights *const weights = &edge->weights;
    double taken = 0.0;
    int kept = 0;
    for (int k = 0; k < weights->count; k++)
        if (scalar->capacity[state->node_zero + weights->entry[k].node] == 0.0)
            taken += weights->entry[k].w;
        else
            weights->entry[kept++] = weights->entry[k];
    weights->count = kept;
    if (taken != 0.0) {
        struct mpm_stencil room;
        mpm_edge_weights_add(weights, mpm_particle_stencil(state, edge->particle, &room), taken);
    }
}

static void spread_edge(struct mpm_state *state, const struct mpm_nodal_scalar *scalar,
                        const struct mpm_edge_load_spec *flux, struct mpm_loaded_edge *edge,
                        struct mpm_strip *strip)
{
    const struct mpm_edge_weights *const weights = &edge->weights;
    const uint32_t body = state->particles.body[edge->particle];
    double area = 0.0, value = 0.0;
    share_out(state, scalar, edge);
    for (int k = 0; k < weights->count; k++) {
        area += weights->entry[k].w;
        value += weights->entry[k].w * scalar->value[state->node_zero + weights->entry[k].node];
    }
    value = area == 0.0 ? 0.0 : value / area;
    if (flux->flux == MPM_FLUX_RADIATES && value < 0.0)
        mpm_strip_record(strip, MPM_BELOW_ZERO, edge->site->id, MPM_RADIATES_ITSELF, value);
    if (flux->flux == MPM_FLUX_RADIATES && edge->traction[0] < 0.0)
        mpm_strip_record(strip, MPM_BELOW_ZERO, edge->site->id, MPM_RADIATES_TO, edge->traction[0]);
    const double phi = flux_at(flux, edge->traction[0], value);
    for (int k = 0; k < weights->count; k++)
        scalar->inflow[state->node_zero + weights->entry[k].node] += weights->entry[k].w * phi;
    strip->inflow += area * phi;
    strip->film =
        fmax(strip->film, mpm_flux_slope(flux, value) /
                              (scalar->weight[body] * state->bodies[body].material.density));
}

static void spread_strip(void *context, int64_t index, int worker)
{
    struct mpm_state *const state = context;
    const struct mpm_edge_loads *const loads = &state->edge_loads;
    const struct mpm_nodal_scalar *const scalar = state->transport.conducted;
    struct mpm_strip *const strip = &state->strips[index];
    (void)worker;
    strip->inflow = strip->film = 0.0;
    for (size_t k = loads->first[index]; k < loads->first[index + 1]; k++) {
        const struct mpm_edge_load_spec *const flux =
            &state->scene->edge_loads[loads->edges[k].site->load];
        if (flux->flux != MPM_NO_FLUX && flux->scalar == scalar->which)
            spread_edge(state, scalar, flux, &loads->edges[k], strip);
    }
}

void mpm_transport_edges_spread(struct mpm_state *state, int workers,
                                struct mpm_nodal_scalar *scalar)
{
    if (state->edge_loads.count == 0)
        return;
    state->transport.conducted = scalar;
    mpm_strips_run(state->strip_count, workers, spread_strip, state);
    state->transport.conducted = NULL;
    for (int64_t s = 0; s < state->strip_count; s++)
        scalar->totals.edges += state->time_step * state->strips[s].inflow;
}
