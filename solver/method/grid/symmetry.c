/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/grid/symmetry.h"

#include "method/fields/fields.h"
#include "method/grid/grid_update.h"

/* Adds to both values of a pair of images what the other has, with the sign of the image. */
static inline void fold(double *inside, double *beyond, double sign)
{
    *inside += sign * *beyond;
    *beyond = sign * *inside;
}

static inline double sign_of(const struct mpm_symmetry *plane, int axis)
{
    return axis == plane->axis ? -1.0 : 1.0;
}

int64_t mpm_symmetry_original(const struct mpm_state *state, int64_t node, double sign[2])
{
    const int64_t columns = state->grid.columns;
    sign[0] = sign[1] = 1.0;
    for (size_t k = 0; k < state->symmetries.count; k++) {
        const struct mpm_symmetry *const plane = &state->symmetries.planes[k];
        const int64_t place[2] = {node % columns, node / columns};
        const int64_t depth = (plane->line - place[plane->axis]) * plane->inside;
        if (depth <= 0)
            continue;
        node += 2 * depth * plane->inside * (plane->axis == 0 ? 1 : columns);
        sign[plane->axis] = -1.0;
    }
    return node;
}

static void fold_momentum(const struct mpm_state *state, const struct mpm_symmetry *plane,
                          int64_t inside, int64_t beyond)
{
    const struct mpm_grid *const grid = &state->grid;
    fold(&grid->mass[inside], &grid->mass[beyond], 1.0);
    for (int axis = 0; axis < 2; axis++)
        fold(&grid->sum[inside][axis].momentum, &grid->sum[beyond][axis].momentum,
             sign_of(plane, axis));
}

static void hold_momentum(const struct mpm_state *state, int axis, int64_t node)
{
    state->grid.sum[node][axis].momentum = 0.0;
}

static void fold_force(const struct mpm_state *state, const struct mpm_symmetry *plane,
                       int64_t inside, int64_t beyond)
{
    for (int axis = 0; axis < 2; axis++)
        fold(&state->grid.sum[inside][axis].force, &state->grid.sum[beyond][axis].force,
             sign_of(plane, axis));
}

static void hold_force(const struct mpm_state *state, int axis, int64_t node)
{
    state->grid.sum[node][axis].force = 0.0;
}

static void fold_extrapolated(const struct mpm_state *state, const struct mpm_symmetry *plane,
                              int64_t inside, int64_t beyond)
{
    for (int axis = 0; axis < 2; axis++)
        fold(&state->grid.gradient[inside][axis][0], &state->grid.gradient[beyond][axis][0],
             sign_of(plane, axis));
}

static void hold_extrapolated(const struct mpm_state *state, int axis, int64_t node)
{
    state->grid.gradient[node][axis][0] = 0.0;
}

/* What is done to a pair of images, and to a node on the plane. */
struct reflection {
    void (*fold)(const struct mpm_state *, const struct mpm_symmetry *, int64_t, int64_t);
    void (*hold)(const struct mpm_state *, int axis, int64_t node);
};

/* All nodes of the grid or of a layer beyond the plane that are active; images inside are reached
 * by the same particles. */
static void reflect_across(const struct mpm_state *state, const struct mpm_symmetry *plane,
                           const struct reflection *reflection, int64_t shift)
{
    const int64_t columns = state->grid.columns;
    for (int64_t row = state->first_row; row <= state->last_row; row++)
        for (int64_t column = state->row_low[row]; column <= state->row_high[row]; column++) {
            const int64_t place[2] = {column, row};
            const int64_t depth = (plane->line - place[plane->axis]) * plane->inside;
            const int64_t node = shift + row * columns + column;
            const int64_t stride = plane->axis == 0 ? 1 : columns;
            if (depth == 0)
                reflection->hold(state, plane->axis, node);
            else if (depth > 0)
                reflection->fold(state, plane, node + 2 * depth * plane->inside * stride, node);
        }
}

static void reflect(struct mpm_state *state, const struct reflection *reflection)
{
    for (size_t k = 0; k < state->symmetries.count; k++)
        for (int64_t layer = 0; layer <= state->fields.layers; layer++)
            reflect_across(state, &state->symmetries.planes[k], reflection,
                           mpm_layer_shift(state, layer));
}

void mpm_symmetries_reflect_momentum(struct mpm_state *state)
{
    reflect(state, &(struct reflection){fold_momentum, hold_momentum});
}

void mpm_symmetries_reflect_force(struct mpm_state *state)
{
    reflect(state, &(struct reflection){fold_force, hold_force});
}

void mpm_symmetries_reflect_extrapolated(struct mpm_state *state)
{
    reflect(state, &(struct reflection){fold_extrapolated, hold_extrapolated});
}

/* ------------------------------------------------------------------- images */

/* The image of an image across one plane; false if it is the node itself, or not active. */
static bool find_image(const struct mpm_state *state, const struct mpm_symmetry *plane,
                       const struct mpm_symmetry_image *of, struct mpm_symmetry_image *image)
{
    const int64_t columns = state->grid.columns;
    const int64_t shift = of->node - mpm_field_parent(state, of->node);
    int64_t place[2] = {of->node % columns, (of->node - shift) / columns};
    if (place[plane->axis] == plane->line)
        return false;
    place[plane->axis] = 2 * plane->line - place[plane->axis];
    if (place[0] < 0 || place[0] >= columns || place[1] < 0 || place[1] >= state->grid.rows)
        return false;
    *image = *of;
    image->node = shift + place[1] * columns + place[0];
    image->sign[plane->axis] = -of->sign[plane->axis];
    return mpm_node_is_active(state, image->node);
}

int mpm_symmetry_images(const struct mpm_state *state, int64_t node,
                        struct mpm_symmetry_image images[MPM_SYMMETRY_IMAGES])
{
    const struct mpm_symmetry_image itself = {node, {1.0, 1.0}};
    int count = 0;
    for (size_t k = 0; k < state->symmetries.count; k++) {
        const int before = count;
        for (int of = -1; of < before && count < MPM_SYMMETRY_IMAGES; of++)
            if (find_image(state, &state->symmetries.planes[k], of < 0 ? &itself : &images[of],
                           &images[count]))
                count++;
    }
    return count;
}

double mpm_symmetry_whole_mass(const struct mpm_state *state, int64_t node)
{
    const int64_t columns = state->grid.columns, parent = mpm_field_parent(state, node);
    const int64_t first = mpm_fields_first(state);
    const unsigned free = node < first ? 0u : state->fields.list[node - first].free;
    double mass = state->grid.mass[node];
    for (size_t k = 0; k < state->symmetries.count; k++) {
        const struct mpm_symmetry *const plane = &state->symmetries.planes[k];
        if ((free >> plane->axis & 1u) == 0 &&
            (plane->axis == 0 ? parent % columns : parent / columns) == plane->line)
            mass *= 2.0;
    }
    return mass;
}
