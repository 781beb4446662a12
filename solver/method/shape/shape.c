/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/shape/shape.h"

static const struct mpm_shape_family *const families[] = {
    [MPM_CLASSIC] = &mpm_shape_classic,   [MPM_UGIMP] = &mpm_shape_ugimp,
    [MPM_CPDI] = &mpm_shape_cpdi,         [MPM_BSPLINE2] = &mpm_shape_bspline2,
    [MPM_BSPLINE3] = &mpm_shape_bspline3,
};

const struct mpm_shape_family *mpm_shape_family(enum mpm_shape shape)
{
    return families[shape];
}

/* The axis is an edge: grids that begin beyond it have nodes on it. */
static void put_edge_on_axis(struct mpm_shape_grid *grid)
{
    const double axis = mpm_shape_cells(-grid->origin[0] * grid->inverse_cell[0]);
    if (axis == nearbyint(axis) && (double)grid->edge_low[0] < axis)
        grid->edge_low[0] = (int64_t)axis;
}

struct mpm_shape_grid mpm_shape_grid_describe(const double origin[2], const double cell[2],
                                              const int64_t cells[2], enum mpm_geometry geometry,
                                              enum mpm_axis axis)
{
    struct mpm_shape_grid grid = {
        .axisymmetric = geometry == MPM_AXISYMMETRIC,
        .radial = geometry == MPM_AXISYMMETRIC && axis != MPM_PLANAR,
        .truncated = axis == MPM_TRUNCATED,
    };
    for (int k = 0; k < 2; k++) {
        grid.origin[k] = origin[k];
        grid.inverse_cell[k] = 1.0 / cell[k];
        grid.edge_low[k] = cells[k] > 0 ? 0 : INT64_MIN;
        grid.edge_high[k] = cells[k] > 0 ? cells[k] : INT64_MAX;
    }
    if (grid.axisymmetric)
        put_edge_on_axis(&grid);
    return grid;
}

void mpm_shape_reach(const struct mpm_shape_family *family, const struct mpm_shape_grid *grid,
                     const double half_size[2], double reach[2])
{
    const struct mpm_shape_domain domain = {.half_size = {half_size[0], half_size[1]},
                                            .edge = {half_size[0], 0.0, 0.0, half_size[1]}};
    family->reach(grid, &domain, reach);
}

/* Wide enough that column and row can be told apart from an offset. */
static const int64_t QUERY_COLUMNS = INT64_C(1) << 32;

size_t mpm_shape_evaluate(const struct mpm_shape_query *query,
                          struct mpm_stencil_entry entries[MPM_STENCIL_MAX])
{
    struct mpm_shape_grid grid = mpm_shape_grid_describe(query->origin, query->cell, query->cells,
                                                         query->geometry, query->axis);
    grid.columns = QUERY_COLUMNS;
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
