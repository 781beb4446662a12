/* Scalars that a scene conducts: made when the simulation is created, and what they add to the
 * history.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/transport/transport.h"
#include "method/contact/body_contact.h"
#include "method/transport/scalar_nodes.h"
#include "method/transport/transport_edges.h"
#include "method/transport/transport_smoothing.h"

#include "simulation/simulation.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* ----------------------------------------------------------------- creating */

unsigned mpm_transport_uses(const struct mpm_scene *scene)
{
    unsigned uses = 0;
    for (size_t which = 0; which < MPM_SCALAR_COUNT; which++) {
        uses |= scene->scalars[which].asked ? mpm_scalar_rows[which].use : 0;
        uses |= scene->scalars[which].source != NULL ? MPM_USE_SOURCE : 0;
    }
    uses |= mpm_scene_expands(scene) ? MPM_USE_FREE_STRAIN : 0;
    if (mpm_scene_heats(scene) || mpm_scene_reads_temperature(scene) ||
        (scene->scalars[MPM_TEMPERATURE].asked && mpm_scene_softens(scene)))
        uses |= MPM_USE_LAW_TEMPERATURE;
    return uses;
}

static enum mpm_status create_scalar(const struct mpm_simulation *simulation, enum mpm_scalar which,
                                     struct mpm_nodal_scalar *scalar, struct mpm_error *error)
{
    const struct mpm_scene *const scene = simulation->scene;
    const struct mpm_scalar_spec *const spec = &scene->scalars[which];
    const char *const *const names = mpm_scene_coordinates(scene);
    *scalar = (struct mpm_nodal_scalar){
        .which = which,
        .row = &mpm_scalar_rows[which],
        .transfer =
            spec->order > 1 || spec->transfer == MPM_SCALAR_FLIP ? spec->transfer : MPM_SCALAR_PIC,
        .order = spec->order,
    };
    const size_t each = sizeof(struct mpm_expression *);
    scalar->conditions = calloc(spec->condition_count + 1, each);
    if (scalar->conditions == NULL)
        return mpm_error_memory(error, each, "the expressions");
    for (size_t k = 0; k < spec->condition_count; k++)
        MPM_TRY(mpm_expression_create(spec->conditions[k].value, names, true, 1,
                                      &scalar->conditions[k], error));
    return spec->source == NULL
               ? MPM_OK
               : mpm_expression_create(spec->source, names, true, simulation->state.workers,
                                       &scalar->source, error);
}

static double condition_value(const void *context, int32_t condition, const double position[2],
                              double time)
{
    const struct mpm_nodal_scalar *const scalar = context;
    return mpm_expression_value(scalar->conditions[condition], 0, position, time);
}

enum mpm_status mpm_transport_create(struct mpm_simulation *simulation, struct mpm_error *error)
{
    struct mpm_transport *const transport = &simulation->state.transport;
    if (mpm_transport_uses(simulation->scene) == 0)
        return MPM_OK;
    transport->list = calloc(MPM_SCALAR_COUNT, sizeof *transport->list);
    if (transport->list == NULL)
        return mpm_error_memory(error, sizeof *transport->list, "the scalars");
    for (int which = 0; which < MPM_SCALAR_COUNT; which++) {
        if (!simulation->scene->scalars[which].asked)
            continue;
        struct mpm_nodal_scalar *const scalar = &transport->list[transport->count++];
        MPM_TRY(create_scalar(simulation, (enum mpm_scalar)which, scalar, error));
        MPM_TRY(mpm_scalar_holds_list(simulation->scene, &simulation->state.grid, scalar->which,
                                      condition_value, scalar, &scalar->holds, &scalar->hold_count,
                                      error));
    }
    return MPM_OK;
}

void mpm_transport_free(struct mpm_simulation *simulation)
{
    const struct mpm_transport *const transport = &simulation->state.transport;
    for (size_t k = 0; k < transport->count; k++) {
        const struct mpm_nodal_scalar *const scalar = &transport->list[k];
        const struct mpm_scalar_spec *const spec = &simulation->scene->scalars[scalar->which];
        for (size_t i = 0; scalar->conditions != NULL && i < spec->condition_count; i++)
            mpm_expression_free(scalar->conditions[i]);
        free(scalar->conditions);
        free(scalar->holds);
        mpm_expression_free(scalar->source);
    }
    free(transport->list);
}

static bool has_capacity_table(const struct mpm_scene *scene, enum mpm_scalar which)
{
    bool any = false;
    for (size_t k = 0; k < scene->material_count; k++)
        any = any || scene->materials[k].conduction[which].tables[MPM_TABLE_CAPACITY].count > 0;
    return any;
}

void mpm_transport_layout(struct mpm_state *state, struct mpm_arena *arena)
{
    for (size_t k = 0; k < state->transport.count; k++) {
        struct mpm_nodal_scalar *const scalar = &state->transport.list[k];
        scalar->weight = MPM_TAKE(arena, double, state->scene->body_count);
        scalar->bodies = MPM_TAKE(arena, struct mpm_scalar_body, state->scene->body_count);
        scalar->hold_fields = mpm_scalar_fields(state);
        scalar->varies = has_capacity_table(state->scene, scalar->which);
        scalar->settling = MPM_TAKE(arena, double, scalar->hold_count *(size_t)scalar->hold_fields);
        scalar->passage_capacity = mpm_body_contact_is_used(state)
                                       ? state->contact.pair_capacity
                                       : 2 * state->fields.node_capacity;
        scalar->joins =
            scalar->transfer == MPM_SCALAR_FLIP && mpm_contacts_join(state->scene, scalar->which);
        scalar->passages = MPM_TAKE(arena, struct mpm_scalar_passage, scalar->passage_capacity);
        mpm_nodal_scalar_layout(state, scalar, arena);
    }
}

/* ------------------------------------------------------------------ filling */

/* Of the tensor xx yy xy. */
static double largest_conductivity(const double k[3])
{
    return 0.5 * (k[0] + k[1] + hypot(k[0] - k[1], 2.0 * k[2]));
}

/* k / (c rho_0), at any temperature; `k` is over the density. */
static double largest_diffusivity(const struct mpm_conduction *given, const double k[3])
{
    const struct mpm_property *const capacities = &given->tables[MPM_TABLE_CAPACITY];
    const struct mpm_property *const conductivities = &given->tables[MPM_TABLE_CONDUCTIVITY];
    const double largest = largest_conductivity(k);
    if (conductivities->count == 0)
        return largest / given->capacity;
    if (capacities->count == 0)
        return largest * mpm_property_largest(conductivities) / given->capacity;
    return largest * mpm_property_largest_ratio(conductivities, capacities);
}

static void describe_bodies(const struct mpm_state *state, struct mpm_nodal_scalar *scalar)
{
    const struct mpm_scene *const scene = state->scene;
    for (size_t body = 0; body < scene->body_count; body++) {
        const struct mpm_body_spec *const spec = &scene->bodies[body];
        const struct mpm_material_spec *const material = &scene->materials[spec->material];
        const struct mpm_conduction *const given = &material->conduction[scalar->which];
        struct mpm_scalar_body *const made = &scalar->bodies[body];
        if (spec->rigid)
            continue;
        scalar->weight[body] = given->capacity;
        for (int i = 0; i < 3; i++)
            made->k[i] = given->k[i] / material->density;
        made->turns = given->anisotropic;
        made->diffusivity = largest_diffusivity(given, made->k);
        made->tables = given->tables;
    }
}

/* Is c that of all deformable bodies? */
static bool is_uniform(const struct mpm_scene *scene, const struct mpm_nodal_scalar *scalar)
{
    double first = 0.0;
    for (size_t body = 0; body < scene->body_count; body++) {
        if (scene->bodies[body].rigid)
            continue;
        if (first != 0.0 && scalar->weight[body] != first)
            return false;
        first = scalar->weight[body];
    }
    return !scalar->varies;
}

/* A value that a table of the body does not have. */
static enum mpm_status check_tables(const struct mpm_simulation *simulation,
                                    const struct mpm_nodal_scalar *scalar, uint32_t body,
                                    const double position[2], double value, struct mpm_error *error)
{
    const struct mpm_body_spec *const spec = &simulation->scene->bodies[body];
    for (int k = 0; k < MPM_TABLE_COUNT; k++) {
        const struct mpm_property *const table = &scalar->bodies[body].tables[k];
        if (!mpm_property_covers(table, value))
            return mpm_scene_error(error, simulation->scene, spec->line, "bodies",
                                   "initial %s of body '%s' is %g at (%g, %g); allowed: %g to %g, "
                                   "the range of the %s of '%s'",
                                   scalar->row->name, spec->name, value, position[0], position[1],
                                   table->points[0][0], table->points[table->count - 1][0],
                                   scalar->row->tables[k],
                                   simulation->scene->materials[spec->material].name);
    }
    return MPM_OK;
}

static enum mpm_status set_start(const struct mpm_simulation *simulation,
                                 const struct mpm_nodal_scalar *scalar, uint32_t body,
                                 const struct mpm_expression *start, size_t first, size_t end,
                                 struct mpm_error *error)
{
    const struct mpm_particles *const particles = &simulation->state.particles;
    double *const value = mpm_particle_array(particles, scalar->row->field, 0);
    for (size_t p = first; p < end; p++) {
        const double position[2] = {particles->position[0][p], particles->position[1][p]};
        value[p] = mpm_expression_value(start, 0, position, 0.0);
        if (!isfinite(value[p]))
            return mpm_scene_error(error, simulation->scene, simulation->scene->bodies[body].line,
                                   "bodies",
                                   "initial %s of body '%s' is %g at (%g, %g); allowed: "
                                   "finite",
                                   scalar->row->name, simulation->scene->bodies[body].name,
                                   value[p], position[0], position[1]);
        MPM_TRY(check_tables(simulation, scalar, body, position, value[p], error));
    }
    return MPM_OK;
}

/* Particles are still in creation order: those of a body stand together. */
static enum mpm_status set_starts(const struct mpm_simulation *simulation,
                                  const struct mpm_nodal_scalar *scalar, struct mpm_error *error)
{
    const struct mpm_scene *const scene = simulation->scene;
    const struct mpm_particles *const particles = &simulation->state.particles;
    enum mpm_status status = MPM_OK;
    for (size_t p = 0, end; p < particles->count && status == MPM_OK; p = end) {
        const uint32_t body = particles->body[p];
        const char *const own = scene->bodies[body].start[scalar->which];
        struct mpm_expression *start = NULL;
        for (end = p + 1; end < particles->count && particles->body[end] == body;)
            end++;
        status = mpm_expression_create(own != NULL ? own : scene->scalars[scalar->which].start,
                                       mpm_scene_coordinates(scene), false, 1, &start, error);
        if (status == MPM_OK)
            status = set_start(simulation, scalar, body, start, p, end, error);
        mpm_expression_free(start);
    }
    return status;
}

static enum mpm_status check_conditions(const struct mpm_simulation *simulation,
                                        const struct mpm_nodal_scalar *scalar,
                                        struct mpm_error *error)
{
    const struct mpm_scene *const scene = simulation->scene;
    for (size_t k = 0; k < scalar->hold_count; k++) {
        const struct mpm_scalar_hold *const hold = &scalar->holds[k];
        double position[2];
        char key[96];
        mpm_grid_edge_position(&simulation->state.grid, hold->node, position);
        const double value = condition_value(scalar, hold->condition, position, 0.0);
        if (isfinite(value))
            continue;
        (void)snprintf(key, sizeof key, "transport.%s.conditions.%d.value", scalar->row->name,
                       (int)hold->condition);
        return mpm_scene_error(
            error, scene, scene->scalars[scalar->which].conditions[hold->condition].line, key,
            "is %g at (%g, %g), time 0; allowed: finite", value, position[0], position[1]);
    }
    return MPM_OK;
}

static enum mpm_status check_source(const struct mpm_simulation *simulation,
                                    const struct mpm_nodal_scalar *scalar, struct mpm_error *error)
{
    const struct mpm_scene *const scene = simulation->scene;
    const struct mpm_particles *const particles = &simulation->state.particles;
    for (size_t p = 0; scalar->source != NULL && p < particles->count; p++) {
        const double position[2] = {particles->position[0][p], particles->position[1][p]};
        const double value = mpm_expression_value(scalar->source, 0, position, 0.0);
        char key[64];
        if (isfinite(value))
            continue;
        (void)snprintf(key, sizeof key, "transport.%s.source", scalar->row->name);
        return mpm_scene_error(error, scene, scene->scalars[scalar->which].line, key,
                               "is %g at (%g, %g), time 0; allowed: finite", value, position[0],
                               position[1]);
    }
    return MPM_OK;
}

/* Before the first step: of the fluxes at the highest temperature that is there or around. */
static double first_film(const struct mpm_simulation *simulation,
                         const struct mpm_nodal_scalar *scalar)
{
    const struct mpm_scene *const scene = simulation->scene;
    double extremes[2], film = 0.0;
    (void)mpm_transport_content(&simulation->state, scalar, extremes);
    for (size_t k = 0; k < scene->edge_load_count; k++) {
        const struct mpm_edge_load_spec *const spec = &scene->edge_loads[k];
        const double density = simulation->state.bodies[spec->body].material.density;
        if (spec->flux != MPM_NO_FLUX && spec->scalar == scalar->which)
            film = fmax(film,
                        mpm_flux_slope(spec, extremes[1]) / (density * scalar->weight[spec->body]));
    }
    return film;
}

/* What bodies that meet settle by is a jump of temperatures: with c of their start particles would
 * miss it (transport_passes.h). */
static enum mpm_status check_joins(const struct mpm_scene *scene,
                                   const struct mpm_nodal_scalar *scalar, struct mpm_error *error)
{
    if (!scalar->joins || !scalar->varies)
        return MPM_OK;
    return mpm_scene_error(error, scene, scene->scalars[scalar->which].line, "contact",
                           "heat: perfect between bodies that may part, with a %s and transfer: "
                           "flip; allowed: law: bonded, heat: conductance, or another transfer",
                           scalar->row->tables[MPM_TABLE_CAPACITY]);
}

enum mpm_status mpm_transport_fill(struct mpm_simulation *simulation, struct mpm_error *error)
{
    struct mpm_state *const state = &simulation->state;
    for (size_t k = 0; k < state->transport.count; k++) {
        struct mpm_nodal_scalar *const scalar = &state->transport.list[k];
        MPM_TRY(check_joins(simulation->scene, scalar, error));
        describe_bodies(state, scalar);
        scalar->uniform = is_uniform(simulation->scene, scalar);
        MPM_TRY(set_starts(simulation, scalar, error));
        MPM_TRY(check_conditions(simulation, scalar, error));
        MPM_TRY(check_source(simulation, scalar, error));
        simulation->film =
            fmax(simulation->film, mpm_scalar_stiffness(scalar) * first_film(simulation, scalar));
        for (size_t body = 0; body < simulation->scene->body_count; body++)
            simulation->diffusivity =
                fmax(simulation->diffusivity,
                     mpm_scalar_stiffness(scalar) * scalar->bodies[body].diffusivity);
    }
    state->transport.diffusivity = simulation->diffusivity;
    state->transport.film = simulation->film;
    return MPM_OK;
}

/* ------------------------------------------------------------------ history */

static double content(const struct mpm_state *state, const struct mpm_nodal_scalar *scalar)
{
    return mpm_transport_content(state, scalar, NULL);
}

static double held(const struct mpm_state *state, const struct mpm_nodal_scalar *scalar)
{
    (void)state;
    return scalar->totals.held;
}

static double from_source(const struct mpm_state *state, const struct mpm_nodal_scalar *scalar)
{
    (void)state;
    return scalar->totals.source;
}

static double through_edges(const struct mpm_state *state, const struct mpm_nodal_scalar *scalar)
{
    (void)state;
    return scalar->totals.edges;
}

static double lowest(const struct mpm_state *state, const struct mpm_nodal_scalar *scalar)
{
    double extremes[2];
    (void)mpm_transport_content(state, scalar, extremes);
    return extremes[0];
}

static double highest(const struct mpm_state *state, const struct mpm_nodal_scalar *scalar)
{
    double extremes[2];
    (void)mpm_transport_content(state, scalar, extremes);
    return extremes[1];
}

/* Names: what the scalar, its content or its flow is called, between two words. */
static const struct quantity {
    const char *before, *after, *description;
    enum { OF_CONTENT, OF_FLOW, OF_VALUE } of;
    double (*value)(const struct mpm_state *state, const struct mpm_nodal_scalar *scalar);
} quantities[] = {
    {"", "", "sum of capacity times value of all particles; of a table its integral from 0",
     OF_CONTENT, content},
    {"boundary_", "", "taken in at nodes with a prescribed value since t = 0", OF_FLOW, held},
    {"source_", "", "put in by the source since t = 0", OF_FLOW, from_source},
    {"edge_", "", "taken in through edges of particles since t = 0", OF_FLOW, through_edges},
    {"", "_min", "smallest value of a particle", OF_VALUE, lowest},
    {"", "_max", "largest value of a particle", OF_VALUE, highest},
};
enum { QUANTITIES = sizeof quantities / sizeof quantities[0] };

/* The scalar of the scene that `index` counts to. */
static enum mpm_scalar scalar_at(const struct mpm_scene *scene, size_t index)
{
    size_t before = index / QUANTITIES;
    int which = 0;
    while (!scene->scalars[which].asked || before-- > 0)
        which++;
    return (enum mpm_scalar)which;
}

size_t mpm_scene_transport_quantity_count(const struct mpm_scene *scene)
{
    size_t count = 0;
    for (size_t which = 0; which < MPM_SCALAR_COUNT; which++)
        count += scene->scalars[which].asked ? QUANTITIES : 0;
    return count;
}

struct mpm_quantity_info mpm_scene_transport_quantity(const struct mpm_scene *scene, size_t index)
{
    const struct mpm_scalar_row *const row = &mpm_scalar_rows[scalar_at(scene, index)];
    const struct quantity *const quantity = &quantities[index % QUANTITIES];
    const char *const words[] = {
        [OF_CONTENT] = row->content_name, [OF_FLOW] = row->flow_name, [OF_VALUE] = row->name};
    struct mpm_quantity_info info = {
        .dimension =
            quantity->of == OF_VALUE ? mpm_particle_rows[row->field].info.dimension : row->content,
        .description = quantity->description,
    };
    (void)snprintf(info.name, sizeof info.name, "%s%s%s", quantity->before, words[quantity->of],
                   quantity->after);
    return info;
}

double mpm_simulation_transport_quantity(const struct mpm_simulation *simulation, size_t index)
{
    const struct mpm_state *const state = &simulation->state;
    return quantities[index % QUANTITIES].value(state, &state->transport.list[index / QUANTITIES]);
}

bool mpm_scene_is_at_rest(const struct mpm_scene *scene)
{
    return scene->at_rest;
}

bool mpm_scene_has_transport(const struct mpm_scene *scene)
{
    return mpm_scene_transport_quantity_count(scene) > 0;
}
