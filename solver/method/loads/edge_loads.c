/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/loads/edge_loads.h"

#include "base/strips.h"
#include "method/fields/fields.h"
#include "method/transfer/transfer.h"

#include <math.h>

static const struct mpm_edge_load_spec *spec_of(const struct mpm_state *state,
                                                const struct mpm_edge_site *site)
{
    return &state->scene->edge_loads[site->load];
}

/* ------------------------------------------------------------------ placing */

/* The first site of that particle, or of the next one that has any. */
static size_t first_site(const struct mpm_edge_loads *loads, uint32_t id)
{
    size_t low = 0, high = loads->count;
    while (low < high) {
        const size_t middle = low + (high - low) / 2;
        if (loads->sites[middle].id < id)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

void mpm_edge_loads_place(struct mpm_state *state)
{
    struct mpm_edge_loads *const loads = &state->edge_loads;
    const uint32_t *const id = state->particles.id;
    size_t n = 0;
    if (loads->count == 0)
        return;
    for (int64_t s = 0; s < state->strip_count; s++) {
        loads->first[s] = n;
        for (size_t p = state->strips[s].begin; p < state->strips[s].end; p++)
            for (size_t k = first_site(loads, id[p]);
                 k < loads->count && loads->sites[k].id == id[p]; k++) {
                loads->edges[n].particle = p;
                loads->edges[n++].site = &loads->sites[k];
            }
    }
    loads->first[state->strip_count] = n;
}

/* ---------------------------------------------------------------- preparing */

static double depth_of(const struct mpm_state *state, size_t p)
{
    const double thickness = state->scene->thickness;
    if (state->scene->geometry != MPM_PLANE_STRESS || !mpm_shape_edges_deform(state->family))
        return thickness;
    return thickness * state->particles.deformation[MPM_ZZ][p];
}

static void place_of(const struct mpm_state *state, const struct mpm_edge_site *site,
                     const struct mpm_shape_domain *domain, double place[2])
{
    const struct mpm_edge_line line =
        mpm_edge_find(state->family, &state->shape_grid, domain, site->edge);
    const double *const taken = spec_of(state, site)->on_particles ? domain->position : line.middle;
    place[0] = taken[0];
    place[1] = taken[1];
}

void mpm_edge_load_place(const struct mpm_state *state, const struct mpm_edge_site *site, size_t p,
                         double place[2])
{
    const struct mpm_shape_domain domain = mpm_particle_carried_domain(state, p);
    place_of(state, site, &domain, place);
}

/* From the components along the outward normal and the edge to those along the axes. */
static void turn(const struct mpm_state *state, const struct mpm_edge_site *site,
                 const struct mpm_shape_domain *domain, double value[2])
{
    if (spec_of(state, site)->frame == MPM_FRAME_GLOBAL)
        return;
    const bool along_first = site->edge == MPM_EDGE_BOTTOM || site->edge == MPM_EDGE_TOP;
    const bool forwards = site->edge == MPM_EDGE_BOTTOM || site->edge == MPM_EDGE_RIGHT;
    const double *const d = along_first ? domain->edge : domain->edge + 2;
    const double scale = (forwards ? 1.0 : -1.0) / sqrt(d[0] * d[0] + d[1] * d[1]);
    const double along[2] = {scale * d[0], scale * d[1]};
    const double normal = value[0], tangential = value[1];
    value[0] = normal * along[1] + tangential * along[0];
    value[1] = tangential * along[1] - normal * along[0];
}

static void find_traction(const struct mpm_state *state, const struct mpm_shape_domain *domain,
                          int worker, struct mpm_strip *strip, struct mpm_loaded_edge *edge)
{
    const struct mpm_vector_field *const value = &state->edge_loads.value[edge->site->load];
    double place[2];
    place_of(state, edge->site, domain, place);
    for (int axis = 0; axis < 2; axis++) {
        const struct mpm_expression *const e = value->component[axis];
        edge->traction[axis] =
            e == NULL ? 0.0 : mpm_expression_value(e, worker, place, state->time);
        if (!isfinite(edge->traction[axis])) {
            const struct mpm_failure failure = {.kind = MPM_TRACTION_NOT_FINITE,
                                                .particle = edge->site->id,
                                                .axis = axis,
                                                .value = edge->traction[axis],
                                                .load = edge->site->load};
            mpm_failure_merge(&strip->failure, &failure);
            edge->traction[0] = edge->traction[1] = 0.0;
            return;
        }
    }
    turn(state, edge->site, domain, edge->traction);
}

/* Into the velocity fields of its particle. */
static void divert(const struct mpm_state *state, struct mpm_loaded_edge *edge)
{
    struct mpm_stencil plain;
    const int64_t layer = state->bodies[state->particles.body[edge->particle]].layer;
    const int64_t shift = mpm_layer_shift(state, layer);
    for (int k = 0; k < edge->weights.count; k++)
        edge->weights.entry[k].node += shift;
    if (mpm_field_use_of(state, edge->particle) == NULL)
        return;
    mpm_particle_plain_stencil(state, edge->particle, &plain);
    mpm_fields_divert_edge(state, edge->particle, &plain, &edge->weights);
}

static void give_by_shape(const struct mpm_state *state, struct mpm_loaded_edge *edge, double area)
{
    struct mpm_stencil room;
    const struct mpm_stencil *const stencil = mpm_particle_stencil(state, edge->particle, &room);
    mpm_edge_weights_add(&edge->weights, stencil, area);
}

static void prepare_strip(void *context, int64_t index, int worker)
{
    struct mpm_state *const state = context;
    struct mpm_edge_loads *const loads = &state->edge_loads;
    for (size_t k = loads->first[index]; k < loads->first[index + 1]; k++) {
        struct mpm_loaded_edge *const edge = &loads->edges[k];
        const struct mpm_shape_domain domain = mpm_particle_carried_domain(state, edge->particle);
        find_traction(state, &domain, worker, &state->strips[index], edge);
        edge->weights.count = 0;
        if (spec_of(state, edge->site)->on_particles) {
            give_by_shape(state, edge, edge->site->area);
            continue;
        }
        mpm_edge_integrate(state->family, &state->shape_grid, &domain, edge->site->edge,
                           depth_of(state, edge->particle), &edge->weights);
        divert(state, edge);
    }
}

void mpm_edge_loads_prepare(struct mpm_state *state)
{
    if (state->edge_loads.count > 0)
        mpm_strips_run(state->strip_count, state->workers, prepare_strip, state);
}

/* ---------------------------------------------------------------- spreading */

static void add_force(const struct mpm_state *state, int64_t offset, const double traction[2],
                      double weight)
{
    struct mpm_node_sum *const sum = state->grid.sum[state->node_zero + offset];
    sum[0].force += weight * traction[0];
    sum[1].force += weight * traction[1];
}

/* Takes nodes without mass out, and returns what they would get; 0 as a rule. */
static double take_massless(const struct mpm_state *state, struct mpm_edge_weights *weights)
{
    double taken = 0.0;
    int kept = 0;
    for (int k = 0; k < weights->count; k++)
        if (state->grid.mass[state->node_zero + weights->entry[k].node] == 0.0)
            taken += weights->entry[k].w;
        else
            weights->entry[kept++] = weights->entry[k];
    weights->count = kept;
    return taken;
}

static void spread_strip(void *context, int64_t index, int worker)
{
    struct mpm_state *const state = context;
    const struct mpm_edge_loads *const loads = &state->edge_loads;
    (void)worker;
    for (size_t k = loads->first[index]; k < loads->first[index + 1]; k++) {
        struct mpm_loaded_edge *const edge = &loads->edges[k];
        if (spec_of(state, edge->site)->flux != MPM_NO_FLUX)
            continue;
        const double taken = take_massless(state, &edge->weights);
        if (taken != 0.0)
            give_by_shape(state, edge, taken);
        for (int i = 0; i < edge->weights.count; i++)
            add_force(state, edge->weights.entry[i].node, edge->traction, edge->weights.entry[i].w);
    }
}

void mpm_edge_loads_spread(struct mpm_state *state, int workers)
{
    if (state->edge_loads.count > 0)
        mpm_strips_run(state->strip_count, workers, spread_strip, state);
}

/* ------------------------------------------------------------------- work */

static void work_strip(void *context, int64_t index, int worker)
{
    struct mpm_state *const state = context;
    const struct mpm_edge_loads *const loads = &state->edge_loads;
    double power = 0.0; /* twice of it */
    (void)worker;
    for (size_t k = loads->first[index]; k < loads->first[index + 1]; k++) {
        const struct mpm_loaded_edge *const edge = &loads->edges[k];
        if (spec_of(state, edge->site)->flux != MPM_NO_FLUX)
            continue;
        for (int i = 0; i < edge->weights.count; i++) {
            const int64_t node = state->node_zero + edge->weights.entry[i].node;
            const double *const start = state->grid.start[node];
            const double *const end = state->grid.motion[node].end;
            power += edge->weights.entry[i].w * (edge->traction[0] * (start[0] + end[0]) +
                                                 edge->traction[1] * (start[1] + end[1]));
        }
    }
    state->strips[index].external_work = 0.5 * state->time_step * power;
}

double mpm_edge_loads_work(struct mpm_state *state, int workers)
{
    double work = 0.0;
    if (state->edge_loads.count == 0)
        return 0.0;
    mpm_strips_run(state->strip_count, workers, work_strip, state);
    for (int64_t s = 0; s < state->strip_count; s++)
        work += state->strips[s].external_work;
    return work;
}
