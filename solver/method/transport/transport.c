/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/transport/transport.h"

#include "base/strips.h"
#include "method/grid/grid_update.h"
#include "method/grid/symmetry.h"
#include "method/transfer/projection.h"
#include "method/transfer/transfer.h"
#include "method/transport/transport_edges.h"

#include <float.h>
#include <string.h>

void mpm_nodal_scalar_layout(const struct mpm_state *state, struct mpm_nodal_scalar *scalar,
                             struct mpm_arena *arena)
{
    const size_t nodes = (size_t)mpm_grid_nodes(&state->grid) + MPM_ROW_PADDING;
    scalar->content = mpm_arena_take(arena, nodes, sizeof *scalar->content);
    scalar->value = mpm_arena_take(arena, nodes, sizeof *scalar->value);
    scalar->inflow = mpm_arena_take(arena, nodes, sizeof *scalar->inflow);
    scalar->result = mpm_arena_take(arena, nodes, sizeof *scalar->result);
    scalar->row_inflow =
        MPM_TAKE(arena, double, (size_t)(state->grid.rows + state->grid.field_rows));
}

void mpm_transport_forget(struct mpm_state *state)
{
    for (size_t k = 0; k < state->transport.count; k++) {
        state->transport.list[k].at_hand = false;
        state->transport.list[k].settles = state->transport.list[k].hold_count > 0;
    }
}

/* ------------------------------------------------------------------- the nodes */

/* The scalar whose rows a pass works on. */
static const struct mpm_nodal_scalar *at_work(const struct mpm_state *state)
{
    return state->transport.conducted;
}

static void run_rows(struct mpm_state *state, const struct mpm_nodal_scalar *scalar, mpm_pass *pass)
{
    state->transport.conducted = scalar;
    mpm_grid_rows_run(state, pass);
    state->transport.conducted = NULL;
}

static void row_clear_content(void *context, int64_t row, int worker)
{
    const struct mpm_state *const state = context;
    const struct mpm_row_span span = mpm_row_span(state, row);
    const struct mpm_nodal_scalar *const scalar = at_work(state);
    (void)worker;
    memset(scalar->content + span.first, 0,
           (size_t)(span.end - span.first) * sizeof *scalar->content);
}

/* v_i = (sum c m v S) / M_i; room for inflow. Where held nodes are to settle, number 1 will say
 * which they are. */
static void row_values(void *context, int64_t row, int worker)
{
    const struct mpm_state *const state = context;
    const struct mpm_row_span span = mpm_row_span(state, row);
    const struct mpm_nodal_scalar *const scalar = at_work(state);
    (void)worker;
    for (int64_t node = span.first; node < span.end; node++) {
        const double *const content = scalar->content[node];
        const double value = content[0] * mpm_inverse_mass(content[2]);
        scalar->value[node][0] = value;
        scalar->value[node][1] = scalar->settles ? 0.0 : value;
    }
    memset(scalar->inflow + span.first, 0,
           (size_t)(span.end - span.first) * sizeof *scalar->inflow);
}

/* What particles will read: dv_i/dt, or with PIC v_i + dt dv_i/dt of the v_i without conditions. */
static inline void find_result(const struct mpm_state *state, int64_t row, bool pic)
{
    const struct mpm_row_span span = mpm_row_span(state, row);
    const struct mpm_nodal_scalar *const scalar = at_work(state);
    double sum = 0.0;
    for (int64_t node = span.first; node < span.end; node++) {
        const double *const content = scalar->content[node], *const inflow = scalar->inflow[node];
        const double inverse = mpm_inverse_mass(content[2]);
        const double rate = (inflow[0] + inflow[1]) * inverse;
        scalar->result[node][0] = pic ? content[0] * inverse + state->time_step * rate : rate;
        sum += inflow[0] + inflow[1];
    }
    scalar->row_inflow[row] = sum;
}

static void row_rates(void *state, int64_t row, int worker)
{
    (void)worker;
    find_result(state, row, false);
}

static void row_pic(void *state, int64_t row, int worker)
{
    (void)worker;
    find_result(state, row, true);
}

/* -------------------------------------------------------------- prescribed values */

/* Does the node bear the condition itself? One beyond a plane of symmetry is an image. */
static bool is_held(const struct mpm_state *state, const struct mpm_nodal_scalar *scalar,
                    int64_t node)
{
    return mpm_node_is_reached(state, node) && mpm_node_is_inside(state, node) &&
           scalar->content[node][2] != 0.0;
}

static enum mpm_status prescribed(const struct mpm_state *state,
                                  const struct mpm_nodal_scalar *scalar,
                                  const struct mpm_scalar_hold *hold, double time, double *value,
                                  struct mpm_error *error)
{
    double position[2];
    mpm_grid_edge_position(&state->grid, hold->node, position);
    *value = mpm_expression_value(scalar->conditions[hold->condition], 0, position, time);
    if (isfinite(*value))
        return MPM_OK;
    return mpm_error_fail(error, MPM_CAUSE_CONDITION,
                          "the %s prescribed by transport.%s.conditions.%d at (%g, %g), time %g is "
                          "%g: not finite",
                          scalar->row->name, scalar->row->name, (int)hold->condition, position[0],
                          position[1], time, *value);
}

/* A number of the node's values and of those of its images. */
static void set_number(const struct mpm_state *state, double (*const values)[MPM_NODE_VALUES],
                       int64_t node, int number, double value)
{
    struct mpm_symmetry_image images[MPM_SYMMETRY_IMAGES];
    const int count = state->symmetries.count == 0 ? 0 : mpm_symmetry_images(state, node, images);
    values[node][number] = value;
    for (int i = 0; i < count; i++)
        values[images[i].node][number] = value;
}

static enum mpm_status hold_values(const struct mpm_state *state,
                                   const struct mpm_nodal_scalar *scalar, struct mpm_error *error)
{
    for (size_t k = 0; k < scalar->hold_count; k++) {
        const struct mpm_scalar_hold *const hold = &scalar->holds[k];
        double value;
        if (!is_held(state, scalar, hold->node))
            continue;
        MPM_TRY(prescribed(state, scalar, hold, state->time, &value, error));
        set_number(state, scalar->value, hold->node, 0, value);
        set_number(state, scalar->value, hold->node, 1, scalar->settles ? 1.0 : value);
    }
    return MPM_OK;
}

static void row_clear_result(void *context, int64_t row, int worker)
{
    const struct mpm_state *const state = context;
    const struct mpm_row_span span = mpm_row_span(state, row);
    const struct mpm_nodal_scalar *const scalar = at_work(state);
    (void)worker;
    memset(scalar->result + span.first, 0,
           (size_t)(span.end - span.first) * sizeof *scalar->result);
}

static void row_restore_values(void *context, int64_t row, int worker)
{
    const struct mpm_state *const state = context;
    const struct mpm_row_span span = mpm_row_span(state, row);
    const struct mpm_nodal_scalar *const scalar = at_work(state);
    (void)worker;
    for (int64_t node = span.first; node < span.end; node++)
        scalar->value[node][1] = scalar->value[node][0];
}

/* D of each held node: what the nodes have at the places of its particles, less what those have;
 * both as sums with S_bp. */
static void settle(struct mpm_state *state, int workers, struct mpm_nodal_scalar *scalar)
{
    const struct mpm_projection filter = {
        .components = 2,
        .field = scalar->row->field,
        .from = scalar->value[0],
        .to = scalar->result[0],
        .weight = scalar->weight,
    };
    if (!scalar->settles) {
        for (size_t k = 0; k < scalar->hold_count; k++)
            scalar->settling[k] = 0.0;
        return;
    }
    run_rows(state, scalar, row_clear_result);
    mpm_projection_run(state, workers, &filter);
    mpm_symmetries_reflect_scalar(state, scalar->result);
    for (size_t k = 0; k < scalar->hold_count; k++) {
        const int64_t node = scalar->holds[k].node;
        const double *const filtered = scalar->result[node];
        scalar->settling[k] = is_held(state, scalar, node)
                                  ? (filtered[0] - scalar->content[node][0]) / filtered[2]
                                  : 0.0;
    }
    run_rows(state, scalar, row_restore_values);
    scalar->settles = false;
}

/* The nodes reach the value at the end of the step; what that takes beside the inflow is counted.
 * With PIC they come from the value that particles gave them. */
static enum mpm_status hold_results(const struct mpm_state *state, struct mpm_nodal_scalar *scalar,
                                    struct mpm_error *error)
{
    const double dt = state->time_step;
    const bool pic = scalar->transfer == MPM_SCALAR_PIC;
    for (size_t k = 0; k < scalar->hold_count; k++) {
        const struct mpm_scalar_hold *const hold = &scalar->holds[k];
        const double *const content = scalar->content[hold->node];
        const double *const inflow = scalar->inflow[hold->node];
        double end;
        if (!is_held(state, scalar, hold->node))
            continue;
        MPM_TRY(prescribed(state, scalar, hold, state->time + dt, &end, error));
        const double change = pic ? end - content[0] / content[2]
                                  : end - scalar->value[hold->node][0] + scalar->settling[k];
        scalar->totals.held += content[2] * change - dt * (inflow[0] + inflow[1]);
        set_number(state, scalar->result, hold->node, 0, pic ? end : change / dt);
    }
    return MPM_OK;
}

/* --------------------------------------------------------------------- the source */

static void pass_source(void *context, int64_t index, int worker)
{
    const struct mpm_state *const state = context;
    struct mpm_strip *const strip = &state->strips[index];
    const struct mpm_particles *const particles = &state->particles;
    const struct mpm_nodal_scalar *const scalar = at_work(state);
    double sum = 0.0;
    for (size_t p = strip->begin; p < strip->end; p++) {
        const double position[2] = {particles->position[0][p], particles->position[1][p]};
        double f[MPM_GRADIENT_SIZE];
        double s = mpm_expression_value(scalar->source, worker, position, state->time);
        if (!isfinite(s)) {
            mpm_strip_record(strip, MPM_SOURCE_NOT_FINITE, particles->id[p], 0, s);
            s = 0.0; /* the step goes on to its end before it fails */
        }
        mpm_particle_deformation(particles, p, f);
        particles->source[p] = s;
        sum += particles->mass[p] * mpm_determinant(f) * s /
               state->bodies[particles->body[p]].material.density;
    }
    strip->inflow = sum;
}

static void run_particles(struct mpm_state *state, int workers, struct mpm_nodal_scalar *scalar,
                          mpm_pass *pass)
{
    state->transport.conducted = scalar;
    mpm_strips_run(state->strip_count, workers, pass, state);
    state->transport.conducted = NULL;
}

static void find_sources(struct mpm_state *state, int workers, struct mpm_nodal_scalar *scalar)
{
    if (scalar->source == NULL)
        return;
    run_particles(state, workers, scalar, pass_source);
    for (int64_t s = 0; s < state->strip_count; s++)
        scalar->totals.source += state->time_step * state->strips[s].inflow;
}

/* --------------------------------------------------------------------- conduction */

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

static void find_gradient(const struct mpm_stencil *stencil, double (*const value)[MPM_NODE_VALUES],
                          double gradient[2])
{
    gradient[0] = gradient[1] = 0.0;
    for (int k = 0; k < stencil->count; k++) {
        const struct mpm_stencil_node *const entry = &stencil->node[k];
        gradient[0] += value[entry->node][0] * entry->g[0];
        gradient[1] += value[entry->node][0] * entry->g[1];
    }
}

void mpm_pass_conduct(void *context, int64_t index, int worker)
{
    const struct mpm_state *const state = context;
    struct mpm_strip *const strip = &state->strips[index];
    const struct mpm_particles *const particles = &state->particles;
    const struct mpm_nodal_scalar *const scalar = at_work(state);
    double(*const inflow)[MPM_NODE_VALUES] = scalar->inflow + state->node_zero;
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
            inflow[entry->node][0] += volume * source * entry->s;
            inflow[entry->node][1] -= volume * (flow[0] * entry->g[0] + flow[1] * entry->g[1]);
        }
    }
    strip->diffusivity = largest;
}

/* ------------------------------------------------------------------------ the step */

static void spread(struct mpm_state *state, int workers, struct mpm_nodal_scalar *scalar)
{
    const struct mpm_projection content = {
        .components = 1,
        .field = scalar->row->field,
        .to = scalar->content[0],
        .weight = scalar->weight,
        .whole = true,
    };
    run_rows(state, scalar, row_clear_content);
    mpm_projection_run(state, workers, &content);
}

/* (62), Notes (142); nothing moves in a scene at rest, and the next step's contents are those of
 * the values that particles have now. */
static void update_particles(struct mpm_state *state, int workers, struct mpm_nodal_scalar *scalar)
{
    const bool again = state->scene->at_rest;
    const struct mpm_projection update = {
        .components = 1,
        .field = scalar->row->field,
        .from = scalar->result[0],
        .to = again ? scalar->content[0] : NULL,
        .weight = scalar->weight,
        .whole = true,
        .adds = scalar->transfer == MPM_SCALAR_FLIP,
        .stores = true,
        .factor = state->time_step,
    };
    if (again)
        run_rows(state, scalar, row_clear_content);
    mpm_projection_run(state, workers, &update);
    scalar->at_hand = again;
}

static enum mpm_status check_finite(const struct mpm_state *state,
                                    const struct mpm_nodal_scalar *scalar, struct mpm_error *error)
{
    for (int64_t row = state->first_row; row >= 0; row = mpm_grid_next_row(state, row))
        if (!isfinite(scalar->row_inflow[row]))
            return mpm_error_fail(error, MPM_CAUSE_NOT_FINITE,
                                  "%s: what flows to the nodes of row %lld is not finite",
                                  scalar->row->name, (long long)(row - MPM_GHOST_ROWS));
    return MPM_OK;
}

static enum mpm_status advance(struct mpm_state *state, int workers,
                               struct mpm_nodal_scalar *scalar, struct mpm_error *error)
{
    if (!scalar->at_hand)
        spread(state, workers, scalar);
    mpm_symmetries_reflect_scalar(state, scalar->content);
    run_rows(state, scalar, row_values);
    MPM_TRY(hold_values(state, scalar, error));
    settle(state, workers, scalar);
    find_sources(state, workers, scalar);
    run_particles(state, workers, scalar, state->kernels.conduct);
    mpm_transport_edges_spread(state, workers, scalar);
    mpm_symmetries_reflect_scalar(state, scalar->inflow);
    run_rows(state, scalar, scalar->transfer == MPM_SCALAR_PIC ? row_pic : row_rates);
    MPM_TRY(check_finite(state, scalar, error));
    MPM_TRY(hold_results(state, scalar, error));
    update_particles(state, workers, scalar);
    for (int64_t s = 0; s < state->strip_count; s++) {
        state->transport.diffusivity =
            fmax(state->transport.diffusivity, state->strips[s].diffusivity);
        state->transport.film = fmax(state->transport.film, state->strips[s].film);
    }
    return MPM_OK;
}

enum mpm_status mpm_transport_advance(struct mpm_state *state, int workers, struct mpm_error *error)
{
    state->transport.diffusivity = state->transport.film = 0.0;
    for (size_t k = 0; k < state->transport.count; k++)
        MPM_TRY(advance(state, workers, &state->transport.list[k], error));
    return MPM_OK;
}

/* ------------------------------------------------------------------------ measures */

double mpm_transport_stable_step(const struct mpm_grid *grid, double diffusivity, double film)
{
    const double x = grid->inverse_cell[0], y = grid->inverse_cell[1];
    const double rate = 2.0 * diffusivity * (x * x + y * y) + film * (x + y);
    return rate > 0.0 ? 1.0 / rate : HUGE_VAL;
}

double mpm_transport_content(const struct mpm_state *state, const struct mpm_nodal_scalar *scalar,
                             double extremes[2])
{
    const struct mpm_particles *const particles = &state->particles;
    const double *const value = mpm_particle_array(particles, scalar->row->field, 0);
    double sum = 0.0, low = DBL_MAX, high = -DBL_MAX;
    for (size_t p = 0; p < particles->count; p++) {
        sum += scalar->weight[particles->body[p]] * particles->mass[p] * value[p];
        low = fmin(low, value[p]);
        high = fmax(high, value[p]);
    }
    if (extremes != NULL) {
        extremes[0] = low;
        extremes[1] = high;
    }
    return sum;
}
