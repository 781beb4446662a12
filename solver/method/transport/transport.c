/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/transport/transport.h"

#include "base/strips.h"
#include "method/grid/grid_update.h"
#include "method/grid/symmetry.h"
#include "method/transfer/transfer.h"
#include "method/transport/scalar_nodes.h"
#include "method/transport/transport_edges.h"
#include "method/transport/transport_exchange.h"
#include "method/transport/transport_passes.h"
#include "method/transport/transport_rest.h"
#include "method/transport/transport_smoothing.h"

#include <float.h>
#include <string.h>

void mpm_nodal_scalar_layout(const struct mpm_state *state, struct mpm_nodal_scalar *scalar,
                             struct mpm_arena *arena)
{
    const size_t nodes = (size_t)mpm_grid_nodes(&state->grid) + MPM_ROW_PADDING;
    double **const arrays[] = {&scalar->content, &scalar->capacity, &scalar->value, &scalar->inflow,
                               &scalar->result};
    for (size_t k = 0; k < sizeof arrays / sizeof arrays[0]; k++)
        *arrays[k] = MPM_TAKE(arena, double, nodes);
    if (scalar->varies && scalar->transfer == MPM_SCALAR_FLIP)
        scalar->held = MPM_TAKE(arena, double, nodes);
    if (scalar->order > 1) {
        scalar->smoothed = MPM_TAKE(arena, double, nodes);
        scalar->filtered = MPM_TAKE(arena, double, nodes);
    }
    scalar->row_inflow =
        MPM_TAKE(arena, double, (size_t)(state->grid.rows + state->grid.field_rows));
}

static bool is_undeformed(const struct mpm_particles *particles)
{
    static const double one[MPM_GRADIENT_SIZE] = {[MPM_XX] = 1.0, [MPM_YY] = 1.0, [MPM_ZZ] = 1.0};
    for (int i = 0; i < MPM_GRADIENT_SIZE; i++)
        for (size_t p = 0; p < particles->count; p++)
            if (particles->deformation[i][p] != one[i])
                return false;
    return true;
}

/* Has it nodes whose particles do not follow them of themselves? */
static bool may_settle(const struct mpm_nodal_scalar *scalar)
{
    return !mpm_scalar_takes_values(scalar) && (scalar->hold_count > 0 || scalar->joins);
}

void mpm_transport_forget(struct mpm_state *state)
{
    state->transport.undeformed = state->scene->at_rest && is_undeformed(&state->particles);
    state->transport.fields_known = false;
    for (size_t k = 0; k < state->transport.count; k++) {
        struct mpm_nodal_scalar *const scalar = &state->transport.list[k];
        scalar->at_hand = false;
        scalar->settles = may_settle(scalar);
    }
}

/* ------------------------------------------------------------------- the nodes */

/* The scalar whose rows a pass works on. */
static const struct mpm_nodal_scalar *at_work(const struct mpm_state *state)
{
    return state->transport.conducted;
}

/* Zeros to add to: a row of one of the arrays. */
static void clear(const struct mpm_state *state, double *nodes, int64_t row)
{
    const struct mpm_row_span span = mpm_row_span(state, row);
    memset(nodes + span.first, 0, (size_t)(span.end - span.first) * sizeof *nodes);
}

static void row_clear_content(void *state, int64_t row, int worker)
{
    (void)worker;
    clear(state, at_work(state)->content, row);
}

static void row_clear_capacity(void *state, int64_t row, int worker)
{
    (void)worker;
    clear(state, at_work(state)->capacity, row);
}

static void row_clear_inflow(void *state, int64_t row, int worker)
{
    (void)worker;
    clear(state, at_work(state)->inflow, row);
}

static void row_clear_result(void *state, int64_t row, int worker)
{
    (void)worker;
    clear(state, at_work(state)->result, row);
}

static void row_clear_held(void *state, int64_t row, int worker)
{
    (void)worker;
    clear(state, at_work(state)->held, row);
}

/* v_i = (sum c m v S) / M_i; room for inflow. */
static void row_values(void *context, int64_t row, int worker)
{
    const struct mpm_state *const state = context;
    const struct mpm_row_span span = mpm_row_span(state, row);
    const struct mpm_nodal_scalar *const scalar = at_work(state);
    (void)worker;
    for (int64_t node = span.first; node < span.end; node++)
        scalar->value[node] = scalar->content[node] * mpm_inverse_mass(scalar->capacity[node]);
    clear(state, scalar->inflow, row);
}

/* What particles will read: dv_i/dt, or with others than FLIP v_i + dt dv_i/dt, of the v_i without
 * conditions, with XPIC of w_m. */
static inline void find_result(const struct mpm_state *state, int64_t row,
                               enum mpm_scalar_transfer transfer)
{
    const struct mpm_row_span span = mpm_row_span(state, row);
    const struct mpm_nodal_scalar *const scalar = at_work(state);
    double sum = 0.0;
    for (int64_t node = span.first; node < span.end; node++) {
        const double inverse = mpm_inverse_mass(scalar->capacity[node]);
        const double rate = scalar->inflow[node] * inverse;
        const double value =
            transfer == MPM_SCALAR_XPIC ? scalar->smoothed[node] : scalar->content[node] * inverse;
        scalar->result[node] = transfer == MPM_SCALAR_FLIP ? rate : value + state->time_step * rate;
        sum += scalar->inflow[node];
    }
    scalar->row_inflow[row] = sum;
}

/* clang-format off */
static MPM_PASS(row_rates, find_result, MPM_SCALAR_FLIP)
static MPM_PASS(row_pic, find_result, MPM_SCALAR_PIC)
static MPM_PASS(row_xpic, find_result, MPM_SCALAR_XPIC)
    /* clang-format on */

    static mpm_pass *const result_rows[] = {
        [MPM_SCALAR_FLIP] = row_rates,
        [MPM_SCALAR_PIC] = row_pic,
        [MPM_SCALAR_XPIC] = row_xpic,
        [MPM_SCALAR_FMPM] = row_pic, /* and then the orders beyond the first */
};

/* -------------------------------------------------------------- prescribed values */

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

static enum mpm_status hold_values(const struct mpm_state *state,
                                   const struct mpm_nodal_scalar *scalar, struct mpm_error *error)
{
    for (size_t k = 0; k < scalar->hold_count; k++)
        for (int i = 0; i < scalar->hold_fields; i++) {
            const struct mpm_scalar_hold *const hold = &scalar->holds[k];
            const int64_t field = mpm_scalar_field_at(state, scalar, hold->node, i);
            double value;
            if (field < 0)
                continue;
            MPM_TRY(prescribed(state, scalar, hold, state->time, &value, error));
            mpm_scalar_set(state, scalar->value, field, value);
        }
    return MPM_OK;
}

/* result_i = sum_p c m S_ip sum_j S_jp value_j */
static void filter(struct mpm_state *state, int workers, const struct mpm_nodal_scalar *scalar)
{
    mpm_scalar_rows_run(state, scalar, row_clear_result);
    mpm_scalar_pass_run(state, workers, scalar, state->kernels.scalar->filter);
    mpm_symmetries_reflect_scalar(state, scalar->result);
}

static void row_less_content(void *context, int64_t row, int worker)
{
    const struct mpm_state *const state = context;
    const struct mpm_row_span span = mpm_row_span(state, row);
    const struct mpm_nodal_scalar *const scalar = at_work(state);
    (void)worker;
    for (int64_t node = span.first; node < span.end; node++)
        scalar->result[node] -= scalar->content[node];
}

/* The field that a place in `settling` is of, or -1. */
static int64_t held_field(const struct mpm_state *state, const struct mpm_nodal_scalar *scalar,
                          size_t place)
{
    const size_t fields = (size_t)scalar->hold_fields;
    return mpm_scalar_field_at(state, scalar, scalar->holds[place / fields].node,
                               (int)(place % fields));
}

/* D of each held node: what the nodes have at the places of its particles, less what those have;
 * both as sums with S_bp. */
static void settle(struct mpm_state *state, int workers, struct mpm_nodal_scalar *scalar)
{
    struct mpm_nodal_scalar held = *scalar;
    const size_t places = scalar->hold_count * (size_t)scalar->hold_fields;
    for (size_t k = 0; k < places; k++)
        scalar->settling[k] = 0.0;
    if (!scalar->settles)
        return;
    filter(state, workers, scalar);
    mpm_scalar_rows_run(state, scalar, row_less_content);
    mpm_scalar_exchange_lags(state, scalar);
    for (size_t k = 0; k < places; k++) {
        const int64_t field = held_field(state, scalar, k);
        if (field >= 0) {
            scalar->settling[k] = scalar->result[field];
            mpm_scalar_set(state, scalar->inflow, field, 1.0);
        }
    }
    held.value = scalar->inflow; /* 1 at held and joined nodes: nothing has flowed in yet */
    filter(state, workers, &held);
    mpm_scalar_exchange_settle(state, scalar);
    for (size_t k = 0; k < places; k++) {
        const int64_t field = held_field(state, scalar, k);
        if (field >= 0)
            scalar->settling[k] /= scalar->result[field];
    }
    mpm_scalar_rows_run(state, scalar, row_clear_inflow);
    scalar->settles =
        may_settle(scalar) && state->scene->scalars[scalar->which].heats; /* in each step */
}

/* The nodes reach the value at the end of the step; what that takes beside the inflow is counted,
 * or will be when particles have followed (count_held). But with FLIP they come from the value that
 * particles gave them. */
static enum mpm_status hold_result(const struct mpm_state *state, struct mpm_nodal_scalar *scalar,
                                   const struct mpm_scalar_hold *hold, int64_t field,
                                   double settling, struct mpm_error *error)
{
    const double dt = state->time_step, capacity = scalar->capacity[field];
    const bool values = mpm_scalar_takes_values(scalar);
    double end;
    MPM_TRY(prescribed(state, scalar, hold, state->time + dt, &end, error));
    const double change =
        values ? end - scalar->content[field] / capacity : end - scalar->value[field] + settling;
    scalar->totals.held +=
        (scalar->held == NULL ? capacity * change : 0.0) - dt * scalar->inflow[field];
    mpm_scalar_set(state, scalar->result, field, values ? end : change / dt);
    if (scalar->held != NULL)
        mpm_scalar_set(state, scalar->held, field, change / dt);
    return MPM_OK;
}

static enum mpm_status hold_results(struct mpm_state *state, struct mpm_nodal_scalar *scalar,
                                    struct mpm_error *error)
{
    const size_t fields = (size_t)scalar->hold_fields;
    if (scalar->held != NULL)
        mpm_scalar_rows_run(state, scalar, row_clear_held);
    for (size_t k = 0; k < scalar->hold_count * fields; k++) {
        const int64_t field = held_field(state, scalar, k);
        if (field >= 0)
            MPM_TRY(hold_result(state, scalar, &scalar->holds[k / fields], field,
                                scalar->settling[k], error));
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

static void find_sources(struct mpm_state *state, int workers, struct mpm_nodal_scalar *scalar)
{
    if (scalar->source == NULL)
        return;
    mpm_scalar_pass_run(state, workers, scalar, pass_source);
    for (int64_t s = 0; s < state->strip_count; s++)
        scalar->totals.source += state->time_step * state->strips[s].inflow;
}

/* ------------------------------------------------------------------------ the step */

static void spread(struct mpm_state *state, int workers, const struct mpm_nodal_scalar *scalar)
{
    mpm_scalar_rows_run(state, scalar, row_clear_content);
    mpm_scalar_rows_run(state, scalar, row_clear_capacity);
    mpm_scalar_pass_run(state, workers, scalar, state->kernels.scalar->spread);
    mpm_symmetries_reflect_scalar(state, scalar->capacity);
}

/* What particles have taken of held nodes, where that is not capacities times changes. */
static void count_held(const struct mpm_state *state, struct mpm_nodal_scalar *scalar)
{
    for (int64_t s = 0; s < state->strip_count && scalar->held != NULL; s++)
        scalar->totals.held += state->strips[s].inflow;
}

/* (62), Notes (142); nothing moves in a scene at rest, and the next step's contents are those of
 * the values that particles have now; capacities too, unless they follow from tables. */
static void update_particles(struct mpm_state *state, int workers, struct mpm_nodal_scalar *scalar)
{
    const struct mpm_scalar_passes *const passes = state->kernels.scalar;
    const bool again = state->scene->at_rest && !scalar->varies;
    if (again)
        mpm_scalar_rows_run(state, scalar, row_clear_content);
    mpm_scalar_pass_run(state, workers, scalar, again ? passes->update_and_spread : passes->update);
    count_held(state, scalar);
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

static mpm_pass *conduction(const struct mpm_state *state)
{
    return state->transport.undeformed ? state->kernels.scalar->conduct_undeformed
                                       : state->kernels.scalar->conduct;
}

/* From contents to what gradients are made of, and what flows in otherwise. */
static enum mpm_status prepare(struct mpm_state *state, int workers,
                               struct mpm_nodal_scalar *scalar, struct mpm_error *error)
{
    mpm_symmetries_reflect_scalar(state, scalar->content);
    mpm_scalar_rows_run(state, scalar, row_values);
    mpm_scalar_exchange_values(state, scalar);
    MPM_TRY(hold_values(state, scalar, error));
    settle(state, workers, scalar);
    find_sources(state, workers, scalar);
    mpm_transport_edges_spread(state, workers, scalar);
    return MPM_OK;
}

/* From inflow to what particles read. */
static enum mpm_status conclude(struct mpm_state *state, int workers,
                                struct mpm_nodal_scalar *scalar, struct mpm_error *error)
{
    const double stiffness = mpm_scalar_stiffness(scalar);
    mpm_symmetries_reflect_scalar(state, scalar->inflow);
    mpm_scalar_smooth_start(state, workers, scalar);
    mpm_scalar_rows_run(state, scalar, result_rows[scalar->transfer]);
    MPM_TRY(check_finite(state, scalar, error));
    mpm_scalar_exchange_results(state, scalar);
    MPM_TRY(hold_results(state, scalar, error));
    mpm_scalar_smooth_end(state, workers, scalar);
    for (int64_t s = 0; s < state->strip_count; s++) {
        state->transport.diffusivity =
            fmax(state->transport.diffusivity, stiffness * state->strips[s].diffusivity);
        state->transport.film = fmax(state->transport.film, stiffness * state->strips[s].film);
    }
    return MPM_OK;
}

static enum mpm_status advance(struct mpm_state *state, int workers,
                               struct mpm_nodal_scalar *scalar, struct mpm_error *error)
{
    if (!scalar->at_hand)
        spread(state, workers, scalar);
    MPM_TRY(prepare(state, workers, scalar, error));
    mpm_scalar_pass_run(state, workers, scalar, conduction(state));
    MPM_TRY(conclude(state, workers, scalar, error));
    update_particles(state, workers, scalar);
    return MPM_OK;
}

enum mpm_status mpm_transport_advance(struct mpm_state *state, int workers, struct mpm_error *error)
{
    state->transport.diffusivity = state->transport.film = 0.0;
    for (size_t k = 0; k < state->transport.count; k++)
        MPM_TRY(advance(state, workers, &state->transport.list[k], error));
    return MPM_OK;
}

void mpm_transport_begin(struct mpm_state *state)
{
    mpm_scalar_rows_run(state, state->transport.list, row_clear_content);
    if (!state->transport.list->uniform)
        mpm_scalar_rows_run(state, state->transport.list, row_clear_capacity);
}

/* M_i = c m_i; masses may still be beside the momenta, see struct mpm_node_sum. */
static void row_capacity_of_mass(void *context, int64_t row, int worker)
{
    const struct mpm_state *const state = context;
    const struct mpm_row_span span = mpm_row_span(state, row);
    const struct mpm_nodal_scalar *const scalar = at_work(state);
    const bool in_sums = state->kernels.start_rows == mpm_row_start_from_sums;
    (void)worker;
    for (int64_t node = span.first; node < span.end; node++)
        scalar->capacity[node] = scalar->weight[state->particles.body[0]] *
                                 (in_sums ? state->grid.sum[node][0].mass : state->grid.mass[node]);
}

/* Capacities of a scalar that went along with mechanics; planes of symmetry have reflected masses.
 */
static void find_capacity(struct mpm_state *state, const struct mpm_nodal_scalar *scalar)
{
    if (scalar->uniform)
        mpm_scalar_rows_run(state, scalar, row_capacity_of_mass);
    else
        mpm_symmetries_reflect_scalar(state, scalar->capacity);
}

enum mpm_status mpm_transport_prepare(struct mpm_state *state, int workers, struct mpm_error *error)
{
    const struct mpm_passes *const passes = state->kernels.passes;
    struct mpm_nodal_scalar *const scalar = state->transport.list;
    state->transport.diffusivity = state->transport.film = 0.0;
    find_capacity(state, scalar);
    MPM_TRY(prepare(state, workers, scalar, error));
    if (passes->stress_before == NULL && passes->to_particles == NULL)
        mpm_scalar_pass_run(state, workers, scalar, conduction(state));
    return MPM_OK;
}

enum mpm_status mpm_transport_conclude(struct mpm_state *state, int workers,
                                       struct mpm_error *error)
{
    MPM_TRY(conclude(state, workers, state->transport.list, error));
    mpm_transport_measure_rest(state);
    return MPM_OK;
}

/* ------------------------------------------------------------------------ measures */

double mpm_transport_stable_step(const struct mpm_grid *grid, double diffusivity, double film)
{
    const double x = grid->inverse_cell[0], y = grid->inverse_cell[1];
    const double rate = 2.0 * diffusivity * (x * x + y * y) + film * (x + y);
    return rate > 0.0 ? 1.0 / rate : HUGE_VAL;
}

/* c v, or the integral of c from 0 to v. */
static double content_per_mass(const struct mpm_nodal_scalar *scalar, uint32_t body, double value)
{
    const struct mpm_property *const table = &scalar->bodies[body].tables[MPM_TABLE_CAPACITY];
    return table->count == 0 ? scalar->weight[body] * value : mpm_property_integral(table, value);
}

double mpm_transport_content(const struct mpm_state *state, const struct mpm_nodal_scalar *scalar,
                             double extremes[2])
{
    const struct mpm_particles *const particles = &state->particles;
    const double *const value = mpm_particle_array(particles, scalar->row->field, 0);
    double sum = 0.0, low = DBL_MAX, high = -DBL_MAX;
    for (size_t p = 0; p < particles->count; p++) {
        sum += particles->mass[p] * content_per_mass(scalar, particles->body[p], value[p]);
        low = fmin(low, value[p]);
        high = fmax(high, value[p]);
    }
    if (extremes != NULL) {
        extremes[0] = low;
        extremes[1] = high;
    }
    return sum;
}
