/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/strips.h"
#include "method/contact/body_contact.h"
#include "method/cracks/crack_detection.h"
#include "method/fields/fields.h"
#include "method/kernels.h"
#include "method/loads/nodal_force.h"
#include "method/transfer/law_state.h"
#include "method/transfer/nearby.h"
#include "method/transfer/transfer.h"
#include "method/transfer/transfers.h"
#include "model/fill.h"
#include "simulation/interface_limit.h"
#include "simulation/simulation.h"

#include <math.h>
#include <stdlib.h>

/* -------------------------------------------------------------- expressions */

enum mpm_status mpm_vector_field_create(const struct mpm_scene *scene,
                                        const struct mpm_vector_expression *text, bool has_time,
                                        int workers, struct mpm_vector_field *field,
                                        struct mpm_error *error)
{
    const char *const *const names = mpm_scene_coordinates(scene);
    for (int axis = 0; axis < 2; axis++)
        if (text->text[axis] != NULL)
            MPM_TRY(mpm_expression_create(text->text[axis], names, has_time, workers,
                                          &field->component[axis], error));
    return MPM_OK;
}

void mpm_vector_field_free(struct mpm_vector_field *field)
{
    for (int axis = 0; axis < 2; axis++)
        mpm_expression_free(field->component[axis]);
    *field = (struct mpm_vector_field){0};
}

/* An array of calloc, or NULL. */
static void free_fields(struct mpm_vector_field *fields, size_t count)
{
    for (size_t k = 0; fields != NULL && k < count; k++)
        mpm_vector_field_free(&fields[k]);
    free(fields);
}

static enum mpm_body_force_kind body_force_kind(const struct mpm_vector_field *field,
                                                enum mpm_body_force_place place)
{
    enum mpm_body_force_kind kind = MPM_NO_BODY_FORCE;
    for (int axis = 0; axis < 2; axis++) {
        const struct mpm_expression *const force = field->component[axis];
        if (force != NULL && !mpm_expression_is_uniform(force))
            return place == MPM_BODY_FORCE_AT_NODES ? MPM_NODAL_BODY_FORCE : MPM_VARYING_BODY_FORCE;
        if (force != NULL)
            kind = MPM_UNIFORM_BODY_FORCE;
    }
    return kind;
}

static enum mpm_status create_expressions(struct mpm_simulation *simulation,
                                          struct mpm_error *error)
{
    const struct mpm_scene *const scene = simulation->scene;
    struct mpm_state *const state = &simulation->state;
    state->conditions.boundary_velocity =
        calloc(scene->boundary_count + 1, sizeof *state->conditions.boundary_velocity);
    state->conditions.body_velocity =
        calloc(scene->body_count, sizeof *state->conditions.body_velocity);
    if (state->conditions.boundary_velocity == NULL || state->conditions.body_velocity == NULL)
        return mpm_error_memory(error, sizeof *state->conditions.boundary_velocity,
                                "the expressions");
    for (size_t k = 0; k < scene->boundary_count; k++)
        MPM_TRY(mpm_vector_field_create(scene, &scene->boundaries[k].velocity, true, 1,
                                        &state->conditions.boundary_velocity[k], error));
    for (size_t k = 0; k < scene->body_count; k++)
        if (scene->bodies[k].rigid)
            MPM_TRY(mpm_vector_field_create(scene, &scene->bodies[k].velocity, true, 1,
                                            &state->conditions.body_velocity[k], error));
    MPM_TRY(mpm_vector_field_create(scene, &scene->body_force, true, state->workers,
                                    &state->body_force, error));
    state->body_force_kind = body_force_kind(&state->body_force, scene->body_force_at);
    MPM_TRY(mpm_damping_create(simulation, error));
    return mpm_transport_create(simulation, error);
}

static double boundary_value(const void *context, int32_t boundary, int32_t component,
                             const double position[2], double time)
{
    const struct mpm_state *const state = context;
    return mpm_expression_value(state->conditions.boundary_velocity[boundary].component[component],
                                0, position, time);
}

/* ------------------------------------------------------------------- memory */

/* Domains are functions of F, and kept only where F changes while they must not: before
 * the step's last task. */
static bool keeps_domains(const struct mpm_state *state)
{
    return state->family->convected && state->order->before > 0.0;
}

static struct mpm_particle_needs needs_of(const struct mpm_simulation *simulation)
{
    const struct mpm_scene *const scene = simulation->scene;
    unsigned uses = MPM_USE_DEFORMABLE;
    uses |= keeps_domains(&simulation->state) ? MPM_USE_DOMAINS : 0;
    uses |= mpm_transfer_of(scene->transfer)->carries;
    if (mpm_crack_detection_needs_surfaces(scene) || mpm_contacts_have_interfaces(scene) ||
        scene->derived)
        uses |= MPM_USE_ORIGINS;
    uses |= simulation->state.damping.particles ? MPM_USE_DRAG : 0;
    uses |= mpm_transport_uses(scene);
    uses |= mpm_law_uses(scene);
    return (struct mpm_particle_needs){.uses = uses,
                                       .law_states = (uint8_t)mpm_law_states_of(scene)};
}

/* Has the balance of forces those of contact? */
static bool rest_sums_contact(const struct mpm_scene *scene)
{
    return scene->rest.asked && (mpm_scene_has_contact(scene) || mpm_cracks_have_contact(scene));
}

static void layout(struct mpm_simulation *simulation, const struct mpm_fill_counts *counts,
                   struct mpm_arena *arena)
{
    struct mpm_state *const state = &simulation->state;
    struct mpm_grid *const grid = &state->grid;
    const size_t nodes = (size_t)(grid->columns * grid->rows);
    const size_t rows = (size_t)(grid->rows + grid->field_rows);
    const size_t longest = (size_t)(grid->rows > grid->columns ? grid->rows : grid->columns);
    mpm_particles_layout(&state->particles, counts->deformable, needs_of(simulation), arena);
    mpm_rigid_particles_layout(&state->rigid, counts->rigid, arena);
    mpm_grid_layout(grid, state->kernels.smooth != NULL, rest_sums_contact(state->scene), arena);
    state->bodies = MPM_TAKE(arena, struct mpm_body, simulation->scene->body_count);
    state->strips = MPM_TAKE(arena, struct mpm_strip, (size_t)state->strip_count);
    state->row_low = MPM_TAKE(arena, int64_t, rows);
    state->row_high = MPM_TAKE(arena, int64_t, rows);
    if (state->body_force_kind == MPM_UNIFORM_BODY_FORCE)
        state->row_momentum = mpm_arena_take(arena, rows, sizeof *state->row_momentum);
    mpm_nodal_force_layout(state, arena);
    mpm_damping_layout(state, arena);
    mpm_edge_loads_layout(state, arena);
    mpm_cracks_layout(state, arena);
    mpm_body_contact_layout(state, arena);
    if (state->fields.keys > 0 || mpm_body_contact_is_used(state))
        mpm_nearby_layout(state, arena);
    mpm_fields_layout(state, arena);
    mpm_j_integrals_layout(simulation, arena);
    mpm_openings_layout(state, arena);
    mpm_transport_layout(state, arena);
    state->sort_counts = MPM_TAKE(arena, uint32_t, longest + 1);
    const bool has_images = state->symmetries.count > 0; /* of nodes, which are driven with them */
    const size_t driven = !has_images && counts->rigid * MPM_STENCIL_MAX < nodes
                              ? counts->rigid * MPM_STENCIL_MAX
                              : nodes;
    state->conditions.active_capacity =
        (state->conditions.count + 2 * driven + rows * (size_t)state->conditions.mirror_column) *
        (size_t)(1 + state->fields.keys + state->fields.layers);
    state->conditions.active =
        MPM_TAKE(arena, struct mpm_active_condition, state->conditions.active_capacity);
    if (counts->rigid > 0) {
        state->conditions.rigid_owner = MPM_TAKE(arena, uint32_t, nodes);
        state->conditions.fixed = MPM_TAKE(arena, uint8_t, nodes);
    }
    mpm_parting_layout(simulation, counts->deformable, arena);
    mpm_backup_layout(simulation, arena);
}

/* ------------------------------------------------------------------ filling */

static void add_body_size(struct mpm_state *state, size_t body)
{
    double reach[2];
    mpm_shape_reach(state->family, &state->shape_grid, state->bodies[body].half_size, reach);
    for (int axis = 0; axis < 2; axis++) {
        state->widest[axis] = fmax(state->widest[axis], reach[axis]);
        if (!state->scene->bodies[body].rigid &&
            (state->deformable_bodies == 0 || reach[axis] < state->sort_size[axis]))
            state->sort_size[axis] = reach[axis];
    }
    state->deformable_bodies += !state->scene->bodies[body].rigid;
}

static void describe_bodies(struct mpm_simulation *simulation)
{
    const struct mpm_scene *const scene = simulation->scene;
    struct mpm_state *const state = &simulation->state;
    for (size_t k = 0; k < scene->body_count; k++) {
        mpm_body_half_size(scene, &state->grid, k, state->bodies[k].half_size);
        add_body_size(state, k);
        if (scene->bodies[k].rigid)
            continue;
        const struct mpm_material_spec *const spec = &scene->materials[scene->bodies[k].material];
        state->bodies[k].given = spec;
        state->bodies[k].material =
            mpm_material_make(spec->law, spec->density, spec->parameter, &spec->hardening);
    }
}

static enum mpm_status set_velocities(struct mpm_simulation *simulation, struct mpm_error *error)
{
    const struct mpm_scene *const scene = simulation->scene;
    struct mpm_particles *const particles = &simulation->state.particles;
    enum mpm_status status = MPM_OK;
    size_t p = 0; /* still in creation order: the particles of a body stand together */
    for (size_t body = 0; body < scene->body_count && status == MPM_OK; body++) {
        struct mpm_vector_field field = {0};
        if (scene->bodies[body].rigid)
            continue;
        status =
            mpm_vector_field_create(scene, &scene->bodies[body].velocity, false, 1, &field, error);
        for (; status == MPM_OK && p < particles->count && particles->body[p] == body; p++) {
            const double position[2] = {particles->position[0][p], particles->position[1][p]};
            for (int axis = 0; axis < 2 && status == MPM_OK; axis++) {
                const double v = mpm_expression_value(field.component[axis], 0, position, 0.0);
                particles->velocity[axis][p] = v;
                if (!isfinite(v))
                    status =
                        mpm_scene_error(error, scene, scene->bodies[body].line, "bodies.velocity",
                                        "initial velocity of body '%s' is %g at (%g, %g); "
                                        "allowed: finite",
                                        scene->bodies[body].name, v, position[0], position[1]);
            }
        }
        mpm_vector_field_free(&field);
    }
    return status;
}

static void set_rigid_velocities(struct mpm_state *state)
{
    struct mpm_rigid_particles *const rigid = &state->rigid;
    for (size_t p = 0; p < rigid->count; p++) {
        const double position[2] = {rigid->position[0][p], rigid->position[1][p]};
        for (int axis = 0; axis < 2; axis++) {
            struct mpm_expression *const e =
                state->conditions.body_velocity[rigid->body[p]].component[axis];
            rigid->velocity[axis][p] = e == NULL ? 0.0 : mpm_expression_value(e, 0, position, 0.0);
        }
    }
}

/* What rigid bodies do not move. */
static void set_fixed(struct mpm_state *state)
{
    const struct mpm_grid *const grid = &state->grid;
    if (state->rigid.count == 0)
        return;
    for (size_t k = 0; k < state->conditions.count; k++)
        state->conditions.fixed[state->conditions.list[k].node] |=
            (uint8_t)(1u << state->conditions.list[k].component);
    for (int64_t row = 0; row < grid->rows; row++)
        for (int64_t column = 0; column < state->conditions.mirror_column; column++)
            state->conditions.fixed[row * grid->columns + column] |= 1u;
}

enum mpm_status mpm_vector_field_check(const struct mpm_simulation *simulation,
                                       const struct mpm_vector_field *field,
                                       const double position[2], int line, const char *key,
                                       struct mpm_error *error)
{
    for (int axis = 0; axis < 2; axis++) {
        if (field->component[axis] == NULL)
            continue;
        const double value = mpm_expression_value(field->component[axis], 0, position, 0.0);
        if (!isfinite(value))
            return mpm_scene_error(error, simulation->scene, line, key,
                                   "'%s' is %g at (%g, %g), time 0; allowed: finite",
                                   mpm_expression_text(field->component[axis]), value, position[0],
                                   position[1]);
    }
    return MPM_OK;
}

/* Velocities and forces that are prescribed must be finite at the start. */
static enum mpm_status check_start(const struct mpm_simulation *simulation, struct mpm_error *error)
{
    const struct mpm_scene *const scene = simulation->scene;
    const struct mpm_state *const state = &simulation->state;
    const struct mpm_particles *const particles = &state->particles;
    const struct mpm_rigid_particles *const rigid = &state->rigid;
    for (size_t k = 0; k < state->conditions.count; k++) {
        const struct mpm_condition *const condition = &state->conditions.list[k];
        double position[2];
        mpm_grid_position(&state->grid, condition->node, position);
        if (condition->boundary != MPM_AXIS_CONDITION &&
            !mpm_grid_is_ghost(&state->grid, condition->node))
            MPM_TRY(mpm_vector_field_check(
                simulation, &state->conditions.boundary_velocity[condition->boundary], position,
                scene->boundaries[condition->boundary].line, "boundary.velocity", error));
    }
    for (size_t p = 0; p < rigid->count; p++) {
        const double position[2] = {rigid->position[0][p], rigid->position[1][p]};
        MPM_TRY(mpm_vector_field_check(simulation, &state->conditions.body_velocity[rigid->body[p]],
                                       position, scene->bodies[rigid->body[p]].line,
                                       "bodies.rigid.velocity", error));
    }
    for (size_t p = 0; p < particles->count; p++) {
        const double position[2] = {particles->position[0][p], particles->position[1][p]};
        MPM_TRY(mpm_vector_field_check(simulation, &state->body_force, position,
                                       scene->line_body_force, "loads.body_force", error));
    }
    return mpm_edge_loads_check_start(simulation, error);
}

/* Every body is undeformed, but it may have been free of stress at other values of scalars. */
static double initial_wave_speed(const struct mpm_simulation *simulation)
{
    double fastest = 0.0;
    if (simulation->state.law_states)
        return mpm_fastest_wave(&simulation->state);
    for (size_t k = 0; k < simulation->scene->body_count; k++)
        if (!simulation->scene->bodies[k].rigid)
            fastest = fmax(fastest, mpm_material_start_wave(&simulation->state.bodies[k].material));
    return sqrt(fastest);
}

static void describe_method(struct mpm_simulation *simulation, int threads)
{
    const struct mpm_scene *const scene = simulation->scene;
    struct mpm_state *const state = &simulation->state;
    state->scene = scene;
    state->workers = threads;
    state->order = mpm_stress_order(scene->stress_update);
    state->family = mpm_shape_family(scene->shape);
    state->grid = mpm_grid_describe(scene);
    state->strip_count = (state->grid.cells[1] + MPM_STRIP_ROWS - 1) / MPM_STRIP_ROWS;
    state->shape_grid = mpm_shape_grid_describe(state->grid.origin, state->grid.cell,
                                                state->grid.cells, scene->geometry, scene->axis);
    state->shape_grid.columns = state->grid.columns;
    state->law_states = mpm_law_uses(scene) != 0 || mpm_scene_couples(scene);
    const int64_t axis_column = MPM_GHOST_ROWS - llround(scene->origin[0] / scene->cell[0]);
    if (scene->axis_nodes == MPM_AXIS_NODES_MIRRORED && axis_column > 0)
        state->conditions.mirror_column = axis_column;
}

/* Numbers that are finite one by one may have sums that are not. */
static enum mpm_status begin_totals(struct mpm_simulation *simulation, struct mpm_error *error)
{
    struct mpm_ledger ledger;
    mpm_simulation_ledger(simulation, &ledger);
    const struct {
        const char *name;
        double value;
    } sums[] = {
        {"speed of waves", simulation->wave_speed},
        {"mass", ledger.mass},
        {"momentum", ledger.momentum[0]},
        {"momentum", ledger.momentum[1]},
        {"angular momentum", ledger.angular_momentum},
        {"kinetic energy", ledger.kinetic_energy},
        {"strain energy", ledger.strain_energy},
        {"energy of all mass at the speed of waves",
         ledger.mass * simulation->wave_speed * simulation->wave_speed},
    };
    for (size_t k = 0; k < sizeof sums / sizeof sums[0]; k++)
        if (!isfinite(sums[k].value))
            return mpm_error_set(error, MPM_BAD_INPUT,
                                 "start: %s is %g; allowed: finite. Densities, moduli, velocities "
                                 "or coordinates are too large for numbers of 64 bits",
                                 sums[k].name, sums[k].value);
    simulation->mass = ledger.mass;
    simulation->rest.largest_energy = ledger.kinetic_energy + fabs(ledger.strain_energy);
    simulation->strain_start = ledger.strain_energy;
    simulation->state.energy = (struct mpm_energy_balance){
        .measured = simulation->scene->energy_balance,
        .particles = ledger.kinetic_energy,
    };
    simulation->energy_start = ledger.kinetic_energy + fabs(ledger.strain_energy);
    return MPM_OK;
}

enum mpm_status mpm_simulation_open(struct mpm_simulation *simulation, double wave_speed,
                                    struct mpm_error *error)
{
    struct mpm_state *const state = &simulation->state;
    simulation->wave_speed = wave_speed;
    simulation->wave_speed_start = wave_speed;
    simulation->particle_speed = mpm_particle_speed(&state->particles, 0, state->particles.count);
    simulation->lightest = mpm_lightest_particle(&state->particles);
    MPM_TRY(begin_totals(simulation, error));
    MPM_TRY(mpm_time_step_check(simulation, error));
    MPM_TRY(mpm_interface_check(simulation, error));
    MPM_TRY(mpm_damping_check_start(simulation, error));
    MPM_TRY(mpm_openings_check_start(simulation, error));
    mpm_stability_advise(simulation);
    double unused[MPM_PHASE_COUNT] = {0.0}; /* part of the set-up */
    mpm_step_sort(state, simulation->backup.particles, unused);
    state->workers = mpm_threads_choose(state, state->workers, NULL);
    if (mpm_step_collect(state) != MPM_OK)
        return mpm_health_refuse_start(simulation, error);
    mpm_backup_save(simulation);
    return MPM_OK;
}

/* Refuses a scene that is too large before loads and conditions look at its particles and nodes;
 * what these take is not in the estimate. */
static enum mpm_status check_memory(struct mpm_simulation *simulation,
                                    const struct mpm_fill_counts *counts, struct mpm_error *error)
{
    struct mpm_arena measure = {.base = NULL};
    layout(simulation, counts, &measure);
    return mpm_memory_check(measure.used, error);
}

static enum mpm_status build(struct mpm_simulation *simulation,
                             const struct mpm_simulation_options *options, struct mpm_error *error)
{
    const struct mpm_scene *const scene = simulation->scene;
    struct mpm_state *const state = &simulation->state;
    struct mpm_fill_counts counts;
    describe_method(simulation, options->threads);
    mpm_cracks_create(state);
    mpm_contacts_create(state);
    MPM_TRY(mpm_kernels_choose(scene, state->fields.keys > 0, options, &state->kernels, error));
    MPM_TRY(create_expressions(simulation, error));
    MPM_TRY(mpm_bodies_count(scene, &state->grid, &counts, error));
    MPM_TRY(check_memory(simulation, &counts, error));
    MPM_TRY(mpm_symmetries_create(simulation, error));
    MPM_TRY(mpm_edge_loads_create(simulation, error));
    MPM_TRY(mpm_conditions_list(scene, &state->grid, boundary_value, state, &state->conditions.list,
                                &state->conditions.count, error));
    layout(simulation, &counts, &simulation->arena);
    MPM_TRY(mpm_arena_allocate(&simulation->arena, error));
    layout(simulation, &counts, &simulation->arena);
    state->node_zero = mpm_grid_index(&state->grid, 0, 0);
    state->last_row = -1;
    for (int64_t row = 0; row < state->grid.rows + state->grid.field_rows; row++) {
        state->row_low[row] = state->grid.columns;
        state->row_high[row] = -1;
    }
    mpm_bands_clear(state, &state->fields.reached);
    describe_bodies(simulation);
    MPM_TRY(mpm_bodies_fill(scene, &state->grid, &state->particles, &state->rigid, error));
    MPM_TRY(mpm_parting_fill(simulation, error));
    mpm_law_states_begin(state);
    MPM_TRY(mpm_edge_loads_fill(simulation, error));
    mpm_cracks_fill(state);
    mpm_contacts_fill(state);
    MPM_TRY(mpm_symmetries_fill(simulation, error));
    MPM_TRY(mpm_openings_fill(simulation, error));
    MPM_TRY(mpm_transport_fill(simulation, error));
    if (mpm_law_scalars_begin(state) != MPM_OK)
        return mpm_health_refuse_start(simulation, error);
    MPM_TRY(set_velocities(simulation, error));
    for (size_t p = 0; p < state->particles.count; p++)
        mpm_particle_set_domain(state, p);
    MPM_TRY(mpm_j_integrals_fill(simulation, error));
    set_rigid_velocities(state);
    set_fixed(state);
    MPM_TRY(check_start(simulation, error));
    return mpm_simulation_open(simulation, initial_wave_speed(simulation), error);
}

enum mpm_status mpm_simulation_create(const struct mpm_scene *scene,
                                      const struct mpm_simulation_options *options,
                                      struct mpm_simulation **simulation, struct mpm_error *error)
{
    *simulation = NULL;
    if (options->threads < 1)
        return mpm_error_set(error, MPM_BAD_INPUT, "threads: %d; allowed: 1 or more",
                             options->threads);
    struct mpm_simulation *const made = calloc(1, sizeof *made);
    if (made == NULL)
        return mpm_error_memory(error, sizeof *made, "the simulation");
    made->scene = scene;
    const enum mpm_status status = build(made, options, error);
    if (status != MPM_OK) {
        mpm_simulation_free(made);
        return status;
    }
    made->monitor = options->monitor;
    mpm_simulation_look(made, MPM_AT_START);
    *simulation = made;
    return MPM_OK;
}

void mpm_simulation_free(struct mpm_simulation *simulation)
{
    if (simulation == NULL)
        return;
    mpm_simulation_look(simulation, MPM_AT_END);
    struct mpm_state *const state = &simulation->state;
    free_fields(state->conditions.boundary_velocity, simulation->scene->boundary_count);
    free_fields(state->conditions.body_velocity, simulation->scene->body_count);
    free_fields(state->edge_loads.value, simulation->scene->edge_load_count);
    mpm_vector_field_free(&state->body_force);
    free(state->symmetries.planes);
    mpm_damping_free(&state->damping);
    mpm_transport_free(simulation);
    free(state->conditions.list);
    mpm_arena_free(&simulation->user_force);
    mpm_arena_free(&simulation->arena);
    free(simulation);
}
