/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/shape.h"

static const struct mpm_shape_family *const families[] = {
    [MPM_CLASSIC] = &mpm_shape_classic,
    [MPM_UGIMP] = &mpm_shape_ugimp,
    [MPM_CPDI] = &mpm_shape_cpdi,
};

const struct mpm_shape_family *mpm_shape_family(enum mpm_shape shape)
{
    return families[shape];
}

/* Wide enough that column and row can be told apart from an offset. */
static const int64_t QUERY_COLUMNS = INT64_C(1) << 32;

size_t mpm_shape_evaluate(const struct mpm_shape_query *query,
                          struct mpm_stencil_entry entries[MPM_STENCIL_MAX])
{
    const struct mpm_shape_grid grid = {
        .origin = {query->origin[0], query->origin[1]},
        .inverse_cell = {1.0 / query->cell[0], 1.0 / query->cell[1]},
        .columns = QUERY_COLUMNS,
        .axisymmetric = query->geometry == MPM_AXISYMMETRIC,
        .truncated = query->axis == MPM_TRUNCATED,
    };
    const double *const half = query->half_size;
    struct mpm_shape_domain domain = {
        .position = {query->position[0], query->position[1]},
        .half_size = {half[0], half[1]},
    };
    mpm_shape_push_forward(query->deformation_gradient, half, domain.edge);
    struct mpm_stencil stencil;
    mpm_shape_family(query->shape)->evaluate(&grid, &domain, &stencil);
    for (int k = 0; k < stencil.count; k++) {
        const struct mpm_stencil_node *const from = &stencil.node[k];
        const int64_t half_width = QUERY_COLUMNS / 2;
        int64_t column = (from->node + half_width) % QUERY_COLUMNS;
        if (column < 0)
            column += QUERY_COLUMNS;
        column -= half_width;
        entries[k] = (struct mpm_stencil_entry){
            .column = column,
            .row = (from->node - column) / QUERY_COLUMNS,
            .s = from->s,
            .g = {from->g[0], from->g[1]},
            .t = from->t,
        };
    }
    return (size_t)stencil.count;
}
