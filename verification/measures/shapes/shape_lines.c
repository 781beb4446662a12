/* One-dimensional shape functions out of the stencil; see shape_lines.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/measures/shapes/shape_lines.h"

/* Where the other edge is. */
static const int64_t OUT_OF_SIGHT = INT64_C(1) << 40;

struct shape_line_value shape_line_at(const struct shape_line *line, int64_t node, double radius)
{
    const struct mpm_shape_query query = {
        .shape = line->shape,
        .geometry = line->geometry,
        .axis = line->axis,
        .origin = {0, 0},
        .cell = {1, 1},
        .cells = {line->edge ? OUT_OF_SIGHT : 0, 0},
        .position = {radius, 0.5},
        .half_size = {line->size / 2, line->size / 2},
        .deformation_gradient = {1, 0, 0, 1},
    };
    struct mpm_stencil_entry entries[MPM_STENCIL_MAX];
    const size_t count = mpm_shape_evaluate(&query, entries);
    struct shape_line_value value = {0};
    for (size_t i = 0; i < count; i++) {
        if (entries[i].column == node) {
            value.s += entries[i].s;
            value.ds += entries[i].g[0] / 2;
            value.t += entries[i].t;
        }
    }
    return value;
}
