/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/grid/conditions.h"

#include "method/fields/fields.h"
#include "method/grid/grid_update.h"
#include "method/grid/symmetry.h"

#include <math.h>

static enum mpm_status not_finite(const char *what, const double position[2], double time,
                                  double value, struct mpm_error *error)
{
    return mpm_error_fail(error, MPM_CAUSE_CONDITION,
                          "the velocity prescribed by %s at (%g, %g), time %g is %g: not finite",
                          what, position[0], position[1], time, value);
}

static bool any_field_has_mass(const struct mpm_state *state, int64_t node)
{
    const struct mpm_field_node *const several = mpm_field_node_at(state, node);
    const int64_t first = mpm_fields_first(state);
    for (int i = 0; several != NULL && i < several->count; i++)
        if (state->grid.mass[first + several->first + i] != 0.0)
            return true;
    for (int64_t layer = 1; layer <= state->fields.layers; layer++)
        if (state->grid.mass[node + mpm_layer_shift(state, layer)] != 0.0)
            return true;
    return false;
}

static inline bool has_mass(const struct mpm_state *state, int64_t node)
{
    return state->grid.mass[node] != 0.0 ||
           (state->grid.field_rows > 0 && any_field_has_mass(state, node));
}

/* For one velocity field of a node, if it has mass. `held`: of the field, if its node is listed. */
static void append_field(struct mpm_state *state, int64_t field, uint8_t *held,
                         struct mpm_active_condition condition)
{
    condition.node = field;
    if (state->grid.mass[field] == 0.0)
        return;
    if (held != NULL)
        *held |= (uint8_t)(1u << condition.component);
    state->conditions.active[state->conditions.active_count++] = condition;
}

/* For the packed fields of a node that are not on a free surface along any of these axes. */
static void append_packed(struct mpm_state *state, const struct mpm_field_node *several,
                          unsigned axes, struct mpm_active_condition condition)
{
    struct mpm_additional_field *const list = state->fields.list + several->first;
    const int64_t first = mpm_fields_first(state) + several->first;
    for (int i = 0; i < several->count; i++)
        if ((list[i].free & axes) == 0)
            append_field(state, first + i, &list[i].held, condition);
}

/* Layers that the source does not drive, since contact acts between it and their bodies; bits. */
static unsigned not_driven(const struct mpm_state *state, uint32_t source)
{
    return state->contact.touched == NULL || source >= state->scene->body_count
               ? 0u
               : state->contact.touched[source];
}

static void append_to_fields(struct mpm_state *state, struct mpm_field_node *several,
                             struct mpm_active_condition condition)
{
    const int64_t node = condition.node;
    const unsigned skipped = not_driven(state, condition.source);
    if ((skipped & 1u) == 0)
        append_field(state, node, several == NULL ? NULL : &several->held, condition);
    if ((skipped & 1u) == 0 && several != NULL)
        append_packed(state, several, 0, condition);
    for (int64_t layer = 1; layer <= state->fields.layers; layer++)
        if ((skipped >> layer & 1u) == 0)
            append_field(state, node + mpm_layer_shift(state, layer), NULL, condition);
}

/* Of a node that has mass: for all of its velocity fields */
static inline void append(struct mpm_state *state, struct mpm_active_condition condition)
{
    struct mpm_field_node *const several = mpm_field_node_at(state, condition.node);
    if (several == NULL && state->fields.layers == 0 && state->contact.touched == NULL)
        state->conditions.active[state->conditions.active_count++] = condition;
    else
        append_to_fields(state, several, condition);
}

/* For the node's images beyond planes of symmetry too, so that they stay images. Conditions that
 * are given for nodes beyond are not used. */
static inline void append_with_images(struct mpm_state *state,
                                      struct mpm_active_condition condition)
{
    struct mpm_symmetry_image images[MPM_SYMMETRY_IMAGES];
    append(state, condition);
    const int count =
        state->symmetries.count == 0 ? 0 : mpm_symmetry_images(state, condition.node, images);
    for (int k = 0; k < count; k++) {
        const double sign = images[k].sign[condition.component];
        if (has_mass(state, images[k].node))
            append(state, (struct mpm_active_condition){images[k].node, condition.component,
                                                        condition.source, sign * condition.start,
                                                        sign * condition.end});
    }
}

/* -------------------------------------------------------------- boundaries */

/* Planes of symmetry hold their nodes themselves, but fields on free surfaces: symmetry.h. */
static inline bool is_reflected(const struct mpm_state *state,
                                const struct mpm_condition *condition)
{
    return condition->boundary != MPM_AXIS_CONDITION &&
           state->scene->boundaries[condition->boundary].symmetry;
}

/* The plane holds the fields of the grid and of layers, and this the others, except those on a
 * free surface. */
static void hold_on_plane(struct mpm_state *state, struct mpm_active_condition condition)
{
    struct mpm_field_node *const several = mpm_field_node_at(state, condition.node);
    const unsigned bit = 1u << condition.component;
    if (several == NULL)
        return;
    several->held |= (uint8_t)bit;
    append_packed(state, several, bit, condition);
}

static enum mpm_status gather_boundaries(struct mpm_state *state, struct mpm_error *error)
{
    for (size_t k = 0; k < state->conditions.count; k++) {
        const struct mpm_condition *const condition = &state->conditions.list[k];
        if (!mpm_node_is_reached(state, condition->node) || !has_mass(state, condition->node))
            continue;
        struct mpm_active_condition active = {condition->node, condition->component,
                                              MPM_FROM_BOUNDARY, 0.0, 0.0};
        if (is_reflected(state, condition)) {
            hold_on_plane(state, active);
            continue;
        }
        if (!mpm_node_is_inside(state, condition->node))
            continue;
        if (condition->boundary != MPM_AXIS_CONDITION) {
            const struct mpm_expression *const velocity =
                state->conditions.boundary_velocity[condition->boundary]
                    .component[condition->component];
            double position[2];
            mpm_grid_edge_position(&state->grid, condition->node, position);
            const double end = state->time + state->time_step;
            active.start = mpm_expression_value(velocity, 0, position, state->time);
            active.end = mpm_expression_value(velocity, 0, position, end);
            if (!isfinite(active.start) || !isfinite(active.end))
                return not_finite("a boundary", position, state->time,
                                  isfinite(active.start) ? active.end : active.start, error);
        }
        append_with_images(state, active);
    }
    return MPM_OK;
}

/* ------------------------------------------------------------ rigid bodies */

/* The node moves with the body during the step, so its velocity at the end is taken
 * where it has got to: a body whose velocity varies in space deforms consistently. */
enum mpm_status mpm_rigid_velocity(const struct mpm_state *state, uint32_t body, int axis,
                                   const double position[2], double *start, double *end,
                                   struct mpm_error *error)
{
    const struct mpm_vector_field *const field = &state->conditions.body_velocity[body];
    const double dt = state->time_step;
    double carried[2] = {position[0], position[1]};
    for (int k = 0; k < 2; k++)
        if (field->component[k] != NULL)
            carried[k] += dt * mpm_expression_value(field->component[k], 0, position, state->time);
    *start = mpm_expression_value(field->component[axis], 0, position, state->time);
    *end = mpm_expression_value(field->component[axis], 0, carried, state->time + dt);
    if (!isfinite(*start) || !isfinite(*end))
        return not_finite(state->scene->bodies[body].name, position, state->time,
                          isfinite(*start) ? *end : *start, error);
    return MPM_OK;
}

/* The condition that a rigid body has already put on a component of a node, or NULL. */
static const struct mpm_active_condition *find_rigid(const struct mpm_state *state,
                                                     size_t first_rigid, int64_t node, int axis)
{
    for (size_t k = first_rigid; k < state->conditions.active_count; k++)
        if (mpm_field_parent(state, state->conditions.active[k].node) == node &&
            state->conditions.active[k].component == axis)
            return &state->conditions.active[k];
    return NULL;
}

static enum mpm_status drive_node(struct mpm_state *state, size_t first_rigid, uint32_t body,
                                  int64_t node, struct mpm_error *error)
{
    const bool contested = state->conditions.rigid_owner[node] != 0;
    state->conditions.rigid_owner[node] = body + 1;
    for (int axis = 0; axis < 2; axis++) {
        if (state->conditions.body_velocity[body].component[axis] == NULL ||
            (state->conditions.fixed[node] & (1u << axis)) != 0)
            continue;
        struct mpm_active_condition active = {node, axis, body, 0.0, 0.0};
        double position[2];
        mpm_grid_position(&state->grid, node, position);
        MPM_TRY(mpm_rigid_velocity(state, body, axis, position, &active.start, &active.end, error));
        const struct mpm_active_condition *const other =
            contested ? find_rigid(state, first_rigid, node, axis) : NULL;
        if (other == NULL)
            append_with_images(state, active);
        else if (other->start != active.start || other->end != active.end)
            return mpm_error_fail(
                error, MPM_CAUSE_RIGID,
                "rigid bodies '%s' and '%s' both drive the node at (%g, %g), with "
                "different velocities %g and %g",
                state->scene->bodies[other->source].name, state->scene->bodies[body].name,
                position[0], position[1], other->start, active.start);
    }
    return MPM_OK;
}

void mpm_rigid_particle_stencil(const struct mpm_state *state, size_t p,
                                struct mpm_stencil *stencil)
{
    const struct mpm_rigid_particles *const rigid = &state->rigid;
    const double *const half = state->bodies[rigid->body[p]].half_size;
    const struct mpm_shape_domain domain = {
        .position = {rigid->position[0][p], rigid->position[1][p]},
        .half_size = {half[0], half[1]},
        .edge = {half[0], 0.0, 0.0, half[1]},
    };
    state->family->evaluate(&state->shape_grid, &domain, stencil);
}

/* A node of which all fields have contact with its owner is on no list. */
static void forget_all_owners(struct mpm_state *state)
{
    for (size_t p = 0; p < state->rigid.count; p++) {
        struct mpm_stencil stencil;
        mpm_rigid_particle_stencil(state, p, &stencil);
        for (int k = 0; k < stencil.count; k++)
            if (stencil.node[k].s != 0.0)
                state->conditions.rigid_owner[state->node_zero + stencil.node[k].node] = 0;
    }
}

/* A body does not drive a node that it owns already: none may be left for the next step. */
static void forget_owners(struct mpm_state *state, size_t first_rigid)
{
    if (state->contact.touched != NULL) {
        forget_all_owners(state);
        return;
    }
    for (size_t k = first_rigid; k < state->conditions.active_count; k++)
        state->conditions.rigid_owner[mpm_field_parent(state, state->conditions.active[k].node)] =
            0;
}

static enum mpm_status gather_rigid(struct mpm_state *state, struct mpm_error *error)
{
    const size_t first_rigid = state->conditions.active_count;
    for (size_t p = 0; p < state->rigid.count; p++) {
        const uint32_t body = state->rigid.body[p];
        struct mpm_stencil stencil;
        mpm_rigid_particle_stencil(state, p, &stencil);
        for (int k = 0; k < stencil.count; k++) {
            if (stencil.node[k].s == 0.0)
                continue;
            const int64_t node = state->node_zero + stencil.node[k].node;
            if (!mpm_node_is_reached(state, node) || !has_mass(state, node) ||
                state->conditions.rigid_owner[node] == body + 1 || !mpm_node_is_inside(state, node))
                continue;
            MPM_TRY(drive_node(state, first_rigid, body, node, error));
        }
    }
    forget_owners(state, first_rigid);
    return MPM_OK;
}

/* ------------------------------------------------------------------- mirrors */

/* Their velocities are known when they are applied, after all others. */
static void gather_mirrors(struct mpm_state *state)
{
    const struct mpm_bands *const reached = &state->fields.reached;
    for (int64_t row = state->first_row; row <= state->last_row; row++)
        for (int64_t column = reached->low[row]; column <= reached->high[row]; column++) {
            const int64_t node = row * state->grid.columns + column;
            if (column < state->conditions.mirror_column && has_mass(state, node))
                append(state, (struct mpm_active_condition){node, 0, MPM_FROM_MIRROR, 0.0, 0.0});
        }
}

/* The node at -r. Every domain that reaches r < 0 has its centre at r > 0 and reaches it. Of an
 * additional velocity field, the same one there, if there is one. */
static int64_t mirror_image(const struct mpm_state *state, int64_t node)
{
    const int64_t parent = mpm_field_parent(state, node), first = mpm_fields_first(state);
    const int64_t image =
        parent + 2 * (state->conditions.mirror_column - parent % state->grid.columns);
    if (node < first)
        return image + (node - parent);
    const struct mpm_field_node *const there = mpm_field_node_at(state, image);
    const int64_t field =
        there == NULL ? -1 : mpm_field_of(state, there, state->fields.list[node - first].key);
    return field >= 0 ? field : image;
}

enum mpm_status mpm_conditions_gather(struct mpm_state *state, struct mpm_error *error)
{
    state->conditions.active_count = 0;
    MPM_TRY(gather_boundaries(state, error));
    if (state->rigid.count > 0)
        MPM_TRY(gather_rigid(state, error));
    state->conditions.first_mirror = state->conditions.active_count;
    if (state->conditions.mirror_column > 0)
        gather_mirrors(state);
    return MPM_OK;
}

enum mpm_status mpm_rigid_advance(struct mpm_state *state, struct mpm_error *error)
{
    struct mpm_rigid_particles *const rigid = &state->rigid;
    for (size_t p = 0; p < rigid->count; p++) {
        const double start[2] = {rigid->position[0][p], rigid->position[1][p]};
        const struct mpm_vector_field *const field =
            &state->conditions.body_velocity[rigid->body[p]];
        for (int axis = 0; axis < 2; axis++) {
            if (field->component[axis] == NULL)
                continue;
            const double v = mpm_expression_value(field->component[axis], 0, start, state->time);
            rigid->position[axis][p] += state->time_step * v;
            rigid->velocity[axis][p] = v;
        }
        for (int axis = 0; axis < 2; axis++) {
            const double x = rigid->position[axis][p], low = state->grid.origin[axis];
            const double high = mpm_grid_end(&state->grid, axis);
            const bool past_axis = axis == 0 && state->shape_grid.axisymmetric && !(x > 0.0);
            if (x >= low && x < high && !past_axis)
                continue;
            return mpm_error_fail(error, MPM_CAUSE_LEFT_GRID,
                                  "particle %u of rigid body '%s' left the grid: %s = %g; allowed: "
                                  "%g to %g",
                                  rigid->id[p], state->scene->bodies[rigid->body[p]].name,
                                  axis == 0 ? "first coordinate" : "second coordinate", x,
                                  past_axis ? 0.0 : low, high);
        }
    }
    return MPM_OK;
}

/* ----------------------------------------------------------------- applying */

static void set_gradient(struct mpm_state *state, const struct mpm_active_condition *active,
                         double velocity)
{
    double *const gradient = state->grid.gradient[active->node][active->component];
    gradient[0] = gradient[1] = velocity;
}

static void apply_start(struct mpm_state *state, const struct mpm_active_condition *active)
{
    state->grid.start[active->node][active->component] = active->start;
    set_gradient(state, active, active->start);
}

/* Kinetic energy of what a condition changes at once: from the velocity that the node has without
 * it, and within the step. Of the velocity that it gives at most, so that what strikes a wall at
 * rest is not counted. */
static double sudden_energy(const struct mpm_state *state,
                            const struct mpm_active_condition *active)
{
    const double before = state->grid.start[active->node][active->component];
    const double change = fabs(active->start - before) + fabs(active->end - active->start);
    const double speed = fmin(change, fmax(fabs(active->start), fabs(active->end)));
    return 0.5 * state->grid.mass[active->node] * speed * speed;
}

void mpm_conditions_apply_start(struct mpm_state *state)
{
    double sudden = 0.0;
    for (size_t k = 0; k < state->conditions.first_mirror; k++) {
        sudden += sudden_energy(state, &state->conditions.active[k]);
        apply_start(state, &state->conditions.active[k]);
    }
    state->sudden_energy = fmax(state->sudden_energy, sudden);
}

void mpm_mirrors_apply_start(struct mpm_state *state)
{
    for (size_t k = state->conditions.first_mirror; k < state->conditions.active_count; k++) {
        struct mpm_active_condition *const mirror = &state->conditions.active[k];
        mirror->start = -state->grid.start[mirror_image(state, mirror->node)][0];
        apply_start(state, mirror);
    }
}

static void apply_end(struct mpm_state *state, const struct mpm_active_condition *active)
{
    const int axis = active->component;
    struct mpm_node_motion *const motion = &state->grid.motion[active->node];
    const double acceleration = (active->end - active->start) / state->time_step;
    const double force = state->grid.sum[active->node][axis].force;
    const double reaction = state->grid.mass[active->node] * acceleration - force;
    if (mpm_node_is_inside(state, active->node))
        state->external_work += reaction * (0.5 * state->time_step * (active->start + active->end));
    motion->acceleration[axis] = acceleration;
    motion->end[axis] = active->end;
    if (!state->order->extrapolate)
        set_gradient(state, active, active->end);
}

void mpm_conditions_apply_end(struct mpm_state *state)
{
    for (size_t k = 0; k < state->conditions.first_mirror; k++)
        apply_end(state, &state->conditions.active[k]);
}

void mpm_mirrors_apply_end(struct mpm_state *state)
{
    for (size_t k = state->conditions.first_mirror; k < state->conditions.active_count; k++) {
        struct mpm_active_condition *const mirror = &state->conditions.active[k];
        mirror->end = -state->grid.motion[mirror_image(state, mirror->node)].end[0];
        apply_end(state, mirror);
    }
}

void mpm_conditions_apply_extrapolated(struct mpm_state *state)
{
    for (size_t k = 0; k < state->conditions.first_mirror; k++)
        set_gradient(state, &state->conditions.active[k], state->conditions.active[k].end);
}

void mpm_mirrors_apply_extrapolated(struct mpm_state *state)
{
    for (size_t k = state->conditions.first_mirror; k < state->conditions.active_count; k++) {
        const struct mpm_active_condition *const mirror = &state->conditions.active[k];
        set_gradient(state, mirror, -state->grid.gradient[mirror_image(state, mirror->node)][0][0]);
    }
}

void mpm_conditions_apply_smoothed(struct mpm_state *state)
{
    struct mpm_node_motion *const smoothed = state->grid.smoothed;
    for (size_t k = 0; k < state->conditions.first_mirror; k++) {
        struct mpm_node_motion *const held = &smoothed[state->conditions.active[k].node];
        const int axis = state->conditions.active[k].component;
        held->acceleration[axis] = held->end[axis];
    }
    for (size_t k = state->conditions.first_mirror; k < state->conditions.active_count; k++) {
        const int64_t node = state->conditions.active[k].node;
        smoothed[node].acceleration[0] = -smoothed[mirror_image(state, node)].acceleration[0];
    }
}
