/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/transfer/extent.h"

void mpm_strip_record(struct mpm_strip *strip, enum mpm_failure_kind kind, uint32_t particle,
                      int axis, double value)
{
    const struct mpm_failure failure = {
        .kind = kind, .particle = particle, .axis = axis, .value = value};
    mpm_failure_merge(&strip->failure, &failure);
}

static bool check_way(const struct mpm_state *state, const struct mpm_placement *placement,
                      uint32_t particle, struct mpm_strip *strip)
{
    const struct mpm_grid *const grid = &state->grid;
    if (state->shape_grid.axisymmetric && !(placement->position[0] > 0.0)) {
        mpm_strip_record(strip, MPM_PAST_AXIS, particle, 0, placement->position[0]);
        return false;
    }
    for (int axis = 0; axis < 2; axis++) {
        const double x = placement->position[axis];
        if (!(x >= grid->origin[axis] && x < mpm_grid_end(grid, axis))) {
            mpm_strip_record(strip, isfinite(x) ? MPM_LEFT_GRID : MPM_NOT_FINITE, particle, axis,
                             x);
            return false;
        }
        const double cells = fabs(placement->step[axis]) * grid->inverse_cell[axis];
        if (!(cells <= 1.0)) {
            mpm_strip_record(strip, MPM_OUTRAN_CELL, particle, axis, cells);
            return false;
        }
    }
    return true;
}

bool mpm_domain_check(const struct mpm_state *state, const struct mpm_placement *placement,
                      uint32_t particle, struct mpm_strip *strip)
{
    const struct mpm_grid *const grid = &state->grid;
    for (int axis = 0; axis < 2; axis++) {
        const double ghost = mpm_ghost_reach(grid, axis);
        const double low = placement->position[axis] - placement->reach[axis];
        const double high = placement->position[axis] + placement->reach[axis];
        if (!(low > grid->origin[axis] - ghost && high < mpm_grid_end(grid, axis) + ghost)) {
            mpm_strip_record(strip, MPM_DOMAIN_TOO_BIG, particle, axis,
                             placement->reach[axis] * grid->inverse_cell[axis]);
            return false;
        }
    }
    return true;
}

bool mpm_placement_check(const struct mpm_state *state, const struct mpm_placement *placement,
                         uint32_t particle, struct mpm_strip *strip)
{
    return check_way(state, placement, particle, strip) &&
           mpm_domain_check(state, placement, particle, strip);
}

void mpm_extents_begin(const struct mpm_state *state, struct mpm_extents *extents)
{
    for (int64_t layer = 0; layer <= state->fields.layers; layer++)
        extents->of[layer] = MPM_NO_EXTENT;
}

void mpm_extents_add(struct mpm_extents *extents, int64_t layer,
                     const struct mpm_placement *placement)
{
    struct mpm_extent *const extent = &extents->of[layer];
    for (int axis = 0; axis < 2; axis++) {
        const double low = placement->position[axis] - placement->reach[axis];
        const double high = placement->position[axis] + placement->reach[axis];
        extent->low[axis] = low < extent->low[axis] ? low : extent->low[axis];
        extent->high[axis] = high > extent->high[axis] ? high : extent->high[axis];
    }
}

/* Node positions beyond the extremes, in cells: round-off must not decide. */
static const double BOX_SLACK = 1e-9;

static struct mpm_node_box box_of(const struct mpm_state *state, const struct mpm_extent *extent)
{
    const struct mpm_grid *const grid = &state->grid;
    struct mpm_node_box box = MPM_NO_BOX;
    for (int axis = 0; axis < 2 && extent->low[axis] <= extent->high[axis]; axis++) {
        const double scale = grid->inverse_cell[axis], origin = grid->origin[axis];
        box.low[axis] = (int64_t)floor((extent->low[axis] - origin) * scale - BOX_SLACK);
        box.high[axis] = (int64_t)floor((extent->high[axis] - origin) * scale + BOX_SLACK) +
                         state->family->nodes_past_end;
        /* no domain reaches beyond the ghost rows, so no node there is visited */
        if (box.high[axis] > grid->cells[axis] + MPM_GHOST_ROWS)
            box.high[axis] = grid->cells[axis] + MPM_GHOST_ROWS;
        if (box.low[axis] < -MPM_GHOST_ROWS)
            box.low[axis] = -MPM_GHOST_ROWS;
    }
    return box;
}

static void widen(struct mpm_node_box *box, const struct mpm_node_box *by)
{
    if (mpm_box_is_empty(by))
        return;
    if (mpm_box_is_empty(box))
        *box = *by;
    for (int axis = 0; axis < 2; axis++) {
        box->low[axis] = by->low[axis] < box->low[axis] ? by->low[axis] : box->low[axis];
        box->high[axis] = by->high[axis] > box->high[axis] ? by->high[axis] : box->high[axis];
    }
}

void mpm_strip_set_boxes(const struct mpm_state *state, struct mpm_strip *strip,
                         const struct mpm_extents *extents)
{
    const int64_t layers = state->fields.layers;
    strip->box = box_of(state, &extents->of[0]);
    if (layers == 0)
        return;
    struct mpm_node_box *const boxes = mpm_layer_boxes(state, strip);
    boxes[0] = strip->box;
    for (int64_t layer = 1; layer <= layers; layer++) {
        boxes[layer] = box_of(state, &extents->of[layer]);
        widen(&strip->box, &boxes[layer]);
    }
}
