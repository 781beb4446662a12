/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/grid/active_nodes.h"

#include <string.h>

static int64_t smaller(int64_t a, int64_t b)
{
    return a < b ? a : b;
}

static int64_t larger(int64_t a, int64_t b)
{
    return a > b ? a : b;
}

/* The columns of a box, in its rows. */
static void add_box(const struct mpm_node_box *box, int64_t *low, int64_t *high)
{
    const int64_t first = box->low[0] + MPM_GHOST_ROWS, last = box->high[0] + MPM_GHOST_ROWS;
    for (int64_t k = box->low[1]; k <= box->high[1]; k++) {
        const int64_t row = k + MPM_GHOST_ROWS;
        low[row] = first < low[row] ? first : low[row];
        high[row] = last > high[row] ? last : high[row];
    }
}

/* Nodes of a row that were active in the step before and are not any more lose their mass. */
static void forget_masses(const struct mpm_state *state, int64_t row)
{
    double *const mass = state->grid.mass + row * state->grid.columns;
    const int64_t first = state->fields.before.low[row], last = state->fields.before.high[row];
    const int64_t low = state->row_low[row], high = state->row_high[row];
    for (int64_t column = first; column <= last && column < low; column++)
        mass[column] = 0.0;
    for (int64_t column = last; column >= first && column > high; column--)
        mass[column] = 0.0;
}

/* In a row of a layer: images across a plane along y. */
static void add_images_in_row(struct mpm_state *state, const struct mpm_symmetry *plane,
                              int64_t row)
{
    const int64_t across = 2 * plane->line, place = row % state->grid.rows;
    const int64_t low = state->fields.reached.low[place], high = state->fields.reached.high[place];
    const int64_t first = across - state->row_high[row], last = across - state->row_low[row];
    if (state->row_low[row] > state->row_high[row])
        return;
    if (plane->inside > 0 && low < plane->line && last >= low)
        state->row_low[row] = smaller(state->row_low[row], larger(first, low));
    if (plane->inside < 0 && high > plane->line && first <= high)
        state->row_high[row] = larger(state->row_high[row], smaller(last, high));
}

/* The images of the rows of a layer across a plane along x; `base`: the layer's first row. */
static void add_image_rows(struct mpm_state *state, const struct mpm_symmetry *plane, int64_t base)
{
    const struct mpm_bands *const reached = &state->fields.reached;
    for (int64_t row = state->first_row; row <= state->last_row; row++) {
        const int64_t image = 2 * plane->line - row, beyond = base + row;
        if ((plane->line - row) * plane->inside <= 0 || image < 0 || image >= state->grid.rows ||
            state->row_low[base + image] > state->row_high[base + image])
            continue;
        const int64_t low = larger(state->row_low[base + image], reached->low[row]);
        const int64_t high = smaller(state->row_high[base + image], reached->high[row]);
        if (low > high)
            continue;
        state->row_low[beyond] = smaller(state->row_low[beyond], low);
        state->row_high[beyond] = larger(state->row_high[beyond], high);
    }
}

/* Across planes along y first: what lies beyond two planes is an image of those images. */
static void add_images(struct mpm_state *state)
{
    const int64_t layers = 1 + state->fields.layers, rows = state->grid.rows;
    for (int axis = 0; axis < 2; axis++)
        for (size_t k = 0; k < state->symmetries.count; k++) {
            const struct mpm_symmetry *const plane = &state->symmetries.planes[k];
            if (plane->axis != axis)
                continue;
            for (int64_t row = 0; row < layers * rows && axis == 0; row++)
                add_images_in_row(state, plane, row);
            for (int64_t layer = 0; layer < layers && axis == 1; layer++)
                add_image_rows(state, plane, layer * rows);
        }
}

static void find_active_of_layers(struct mpm_state *state)
{
    const int64_t layers = 1 + state->fields.layers, rows = layers * state->grid.rows;
    const struct mpm_bands *const before = &state->fields.before;
    memcpy(before->low, state->row_low, (size_t)rows * sizeof *before->low);
    memcpy(before->high, state->row_high, (size_t)rows * sizeof *before->high);
    for (int64_t row = 0; row < rows; row++) {
        state->row_low[row] = state->grid.columns;
        state->row_high[row] = -1;
    }
    for (int64_t s = 0; s < state->strip_count; s++)
        for (int64_t layer = 0; layer < layers; layer++)
            if (state->strips[s].begin < state->strips[s].end)
                add_box(&mpm_layer_boxes(state, &state->strips[s])[layer],
                        state->row_low + layer * state->grid.rows,
                        state->row_high + layer * state->grid.rows);
    add_images(state);
    for (int64_t row = 0; row < rows; row++)
        forget_masses(state, row);
}

void mpm_grid_find_active(struct mpm_state *state)
{
    const struct mpm_bands *const reached = &state->fields.reached;
    for (int64_t row = state->first_row; row <= state->last_row; row++) {
        reached->low[row] = state->grid.columns;
        reached->high[row] = -1;
    }
    state->first_row = state->grid.rows;
    state->last_row = -1;
    for (int64_t s = 0; s < state->strip_count; s++) {
        const struct mpm_strip *const strip = &state->strips[s];
        if (strip->begin == strip->end)
            continue;
        const int64_t first = strip->box.low[1] + MPM_GHOST_ROWS;
        const int64_t last = strip->box.high[1] + MPM_GHOST_ROWS;
        add_box(&strip->box, reached->low, reached->high);
        state->first_row = first < state->first_row ? first : state->first_row;
        state->last_row = last > state->last_row ? last : state->last_row;
    }
    if (state->fields.layers > 0)
        find_active_of_layers(state);
}
