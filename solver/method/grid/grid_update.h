/* Passes over the active nodes, row by row. Signature and use: mpm_rows_run.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_GRID_UPDATE_H
#define MPM_METHOD_GRID_UPDATE_H

#include "method/fields/fields.h"

/* The active nodes of a row: indices first..end - 1. */
struct mpm_row_span {
    int64_t first, end;
};

static inline struct mpm_row_span mpm_row_span(const struct mpm_state *state, int64_t row)
{
    const int64_t start = row * state->grid.columns;
    if (state->row_low[row] > state->row_high[row])
        return (struct mpm_row_span){start, start};
    return (struct mpm_row_span){start + state->row_low[row], start + state->row_high[row] + 1};
}

/* Is a node of the grid, of a layer or of packed fields in a span? Rows that are not active have
 * none. */
static inline bool mpm_node_is_active(const struct mpm_state *state, int64_t node)
{
    const int64_t row = node / state->grid.columns, column = node % state->grid.columns;
    return column >= state->row_low[row] && column <= state->row_high[row];
}

/* Do particles reach a node of the grid, or its copy in a layer? */
static inline bool mpm_node_is_reached(const struct mpm_state *state, int64_t node)
{
    const int64_t row = node / state->grid.columns, column = node % state->grid.columns;
    return column >= state->fields.reached.low[row] && column <= state->fields.reached.high[row];
}

/* The row of the grid that a row is, or is a copy of in a layer; -1: packed fields. */
static inline int64_t mpm_layer_row(const struct mpm_state *state, int64_t row)
{
    const int64_t rows = state->grid.rows;
    return row < rows ? row : row < (1 + state->fields.layers) * rows ? row % rows : -1;
}

/* A span without the nodes beyond planes of symmetry, which are images of others: what sums over
 * nodes ask for. */
static inline struct mpm_row_span mpm_row_span_inside(const struct mpm_state *state, int64_t row)
{
    struct mpm_row_span span = mpm_row_span(state, row);
    const int64_t place = state->symmetries.count == 0 ? -1 : mpm_layer_row(state, row);
    if (place < 0 && state->symmetries.passed) {
        const int64_t end = mpm_fields_first(state) + state->fields.inside;
        span.end = span.end < end ? span.end : span.first < end ? end : span.first;
    }
    for (size_t k = 0; place >= 0 && k < state->symmetries.count; k++) {
        const struct mpm_symmetry *const plane = &state->symmetries.planes[k];
        const int64_t on_plane = row * state->grid.columns + plane->line;
        if (plane->axis == 1 && (place - plane->line) * plane->inside < 0)
            span.end = span.first;
        else if (plane->axis == 0 && plane->inside > 0)
            span.first = span.first > on_plane ? span.first : on_plane;
        else if (plane->axis == 0)
            span.end = span.end < on_plane + 1 ? span.end : on_plane + 1;
    }
    return span;
}

/* Is a node none of those images? */
static inline bool mpm_node_is_inside(const struct mpm_state *state, int64_t node)
{
    if (state->symmetries.count == 0)
        return true;
    const int64_t columns = state->grid.columns, row = mpm_layer_row(state, node / columns);
    const int64_t place[2] = {node % columns, row};
    if (row < 0)
        return !state->symmetries.passed || node < mpm_fields_first(state) + state->fields.inside;
    for (size_t k = 0; k < state->symmetries.count; k++) {
        const struct mpm_symmetry *const plane = &state->symmetries.planes[k];
        if ((place[plane->axis] - plane->line) * plane->inside < 0)
            return false;
    }
    return true;
}

/* 1 / m_i; 0 for a node without mass, so that it has no motion. */
static inline double mpm_inverse_mass(double mass)
{
    return mass == 0.0 ? 0.0 : 1.0 / mass;
}

static inline void mpm_node_set_gradient(const struct mpm_grid *grid, int64_t node,
                                         const double v[2])
{
    for (int axis = 0; axis < 2; axis++)
        grid->gradient[node][axis][0] = grid->gradient[node][axis][1] = v[axis];
}

/* Runs a pass over all active rows, those of additional velocity fields last. */
void mpm_grid_rows_run(struct mpm_state *state, mpm_pass *pass);

/* The active row that comes after `row` there, or -1: `for (row = state->first_row; row >= 0; row =
 * mpm_grid_next_row(state, row))`. */
static inline int64_t mpm_grid_next_row(const struct mpm_state *state, int64_t row)
{
    const int64_t next = row == state->last_row ? state->grid.rows : row + 1;
    return next < state->grid.rows + state->fields.rows ? next : -1;
}

void mpm_row_clear(void *state, int64_t row, int worker);
/* m_i: adds the masses that fast kernels leave in the sums (struct mpm_node_sum) */
void mpm_row_gather_mass(void *state, int64_t row, int worker);
/* v_i = p_i / m_i: N&G (11), Notes (28) */
void mpm_row_start_velocity(void *state, int64_t row, int worker);
/* the same, where the masses came with the momenta (struct mpm_node_sum) */
void mpm_row_start_from_sums(void *state, int64_t row, int worker);
/* a_i = f_i / m_i, v_i^{n+1} = v_i^n + dt a_i: CRAMP (29), Notes (24) */
void mpm_row_update(void *state, int64_t row, int worker);
/* the same, where f_i += m_i b comes first: N&G (4) for a uniform b, since then
 * sum_p m_p b S_ip = b sum_p m_p S_ip = m_i b */
void mpm_row_update_with_body_force(void *state, int64_t row, int worker);
/* the row's part of sum m_i (v_i^n + v_i^{n+1}), conditions included. A uniform b does in the
 * step the work
 *   sum_p m_p b . sum_i S_ip (v_i^n + v_i^{n+1})/2 dt = b . sum_i m_i (v_i^n + v_i^{n+1}) dt/2 */
void mpm_row_momentum(void *state, int64_t row, int worker);
/* FLIP fraction beta, Notes (45) without its last term, by the velocity update as it is:
 *   v_p - (1 - beta)(v_p - sum S v_i^n) + dt sum S a_i = beta v_p + dt sum S a'_i,
 *   a'_i = a_i + (1 - beta) v_i^n / dt
 * Puts a'_i in the place of a_i, and moves v_i^{n+1} so that the velocity at which positions
 * move, v_i^{n+1} - dt/2 a_i in the midpoint update, stays. beta v_p: mpm_pass_keep_fraction. */
void mpm_row_flip_fraction(void *state, int64_t row, int worker);
/* velocity of the re-extrapolated momentum: CRAMP (31), (34) */
void mpm_row_extrapolated_velocity(void *state, int64_t row, int worker);

#endif
