/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/loads/nodal_force.h"

#include "method/fields/fields.h"
#include "method/grid/grid_update.h"
#include "method/grid/symmetry.h"
#include "method/transfer/transfer.h"

#include <math.h>

void mpm_nodal_force_layout(struct mpm_state *state, struct mpm_arena *arena)
{
    struct mpm_nodal_force *const force = &state->nodal_force;
    const size_t nodes = (size_t)mpm_grid_nodes(&state->grid) + MPM_ROW_PADDING;
    if (state->body_force_kind != MPM_NODAL_BODY_FORCE)
        return;
    force->value = mpm_arena_take(arena, nodes, sizeof *force->value);
    force->row = MPM_TAKE(arena, struct mpm_nodal_force_row,
                          (size_t)(state->grid.rows + state->grid.field_rows));
}

static void place_of(const struct mpm_state *state, int64_t node, double sign[2], double place[2])
{
    const int64_t parent = mpm_field_parent(state, node);
    mpm_grid_position(&state->grid, mpm_symmetry_original(state, parent, sign), place);
}

static void row_add(void *context, int64_t row, int worker)
{
    const struct mpm_state *const state = context;
    const struct mpm_row_span span = mpm_row_span(state, row);
    struct mpm_nodal_force_row *const result = &state->nodal_force.row[row];
    result->refused = -1;
    for (int64_t node = span.first; node < span.end; node++) {
        const double mass = state->grid.mass[node];
        double *const value = state->nodal_force.value[node];
        double sign[2], place[2];
        value[0] = value[1] = 0.0;
        if (mass == 0.0)
            continue;
        place_of(state, node, sign, place);
        for (int axis = 0; axis < 2; axis++) {
            const struct mpm_expression *const force = state->body_force.component[axis];
            if (force != NULL)
                value[axis] = sign[axis] * mpm_expression_value(force, worker, place, state->time);
            if (!isfinite(value[axis])) {
                result->refused = node;
                result->axis = axis;
                return;
            }
            state->grid.sum[node][axis].force += mass * value[axis];
        }
    }
}

enum mpm_status mpm_nodal_force_add(struct mpm_state *state, struct mpm_error *error)
{
    if (state->body_force_kind != MPM_NODAL_BODY_FORCE)
        return MPM_OK;
    mpm_grid_rows_run(state, row_add);
    for (int64_t row = state->first_row; row >= 0; row = mpm_grid_next_row(state, row)) {
        const struct mpm_nodal_force_row *const result = &state->nodal_force.row[row];
        double sign[2], place[2];
        if (result->refused < 0)
            continue;
        place_of(state, result->refused, sign, place);
        return mpm_error_fail(error, MPM_CAUSE_LOAD,
                              "the body force at the node (%g, %g) is not finite: "
                              "loads.body_force.%d = %g",
                              place[0], place[1], result->axis,
                              state->nodal_force.value[result->refused][result->axis]);
    }
    return MPM_OK;
}

static void row_work(void *context, int64_t row, int worker)
{
    const struct mpm_state *const state = context;
    const struct mpm_row_span span = mpm_row_span_inside(state, row);
    double power = 0.0;
    (void)worker;
    for (int64_t node = span.first; node < span.end; node++)
        for (int axis = 0; axis < 2; axis++)
            power += state->grid.mass[node] * state->nodal_force.value[node][axis] *
                     (state->grid.start[node][axis] + state->grid.motion[node].end[axis]);
    state->nodal_force.row[row].work = 0.5 * state->time_step * power;
}

double mpm_nodal_force_work(struct mpm_state *state)
{
    double work = 0.0;
    if (state->body_force_kind != MPM_NODAL_BODY_FORCE)
        return work;
    mpm_grid_rows_run(state, row_work);
    for (int64_t row = state->first_row; row >= 0; row = mpm_grid_next_row(state, row))
        work += state->nodal_force.row[row].work;
    return work;
}
