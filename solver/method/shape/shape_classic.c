/* Classic MPM: chi_p is a delta function, so that S = N_i, G = grad N_i and T = N_i / r
 * at the particle (N&G, after (14)).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/shape/shape.h"

#include <math.h>

/* The hat functions of the two nodes around a point, along one axis. A point on a
 * grid line belongs to the cell beyond it; the node behind then has no weight. */
struct hats {
    int64_t first;
    double n[2];
};

static struct hats hats_of_cell(int64_t cell, double coordinate)
{
    const double u = coordinate - (double)cell;
    return (struct hats){.first = cell, .n = {1.0 - u, u}};
}

static struct hats hats_at(double coordinate)
{
    return hats_of_cell(mpm_floor(coordinate), coordinate);
}

static void continue_to(const struct mpm_shape_grid *grid, const double home[2],
                        const double place[2], struct mpm_stencil *stencil)
{
    struct hats hats[2];
    for (int axis = 0; axis < 2; axis++) {
        const double scale = grid->inverse_cell[axis], origin = grid->origin[axis];
        hats[axis] = hats_of_cell(mpm_floor(mpm_shape_cells((home[axis] - origin) * scale)),
                                  mpm_shape_cells((place[axis] - origin) * scale));
    }
    stencil->count = 0;
    for (int row = 0; row < 2; row++)
        for (int column = 0; column < 2; column++)
            stencil->node[stencil->count++] = (struct mpm_stencil_node){
                .node = (hats[1].first + row) * grid->columns + (hats[0].first + column),
                .s = hats[0].n[column] * hats[1].n[row],
            };
}

static void evaluate(const struct mpm_shape_grid *grid, const struct mpm_shape_domain *domain,
                     struct mpm_stencil *stencil)
{
    double coordinate[2];
    for (int axis = 0; axis < 2; axis++)
        coordinate[axis] = mpm_shape_cells((domain->position[axis] - grid->origin[axis]) *
                                           grid->inverse_cell[axis]);
    const struct hats x = hats_at(coordinate[0]), y = hats_at(coordinate[1]);
    const double hoop = grid->axisymmetric ? 1.0 / domain->position[0] : 0.0;
    const double slope[2] = {-1.0, 1.0};
    stencil->count = 0;
    for (int row = 0; row < 2; row++)
        for (int column = 0; column < 2; column++) {
            const double s = x.n[column] * y.n[row];
            stencil->node[stencil->count++] = (struct mpm_stencil_node){
                .node = (y.first + row) * grid->columns + (x.first + column),
                .s = s,
                .g = {slope[column] * grid->inverse_cell[0] * y.n[row],
                      slope[row] * grid->inverse_cell[1] * x.n[column]},
                .t = s * hoop,
            };
        }
}

static void reach(const struct mpm_shape_grid *grid, const struct mpm_shape_domain *domain,
                  double distance[2])
{
    (void)grid;
    (void)domain;
    distance[0] = distance[1] = 0.0;
}

const struct mpm_shape_family mpm_shape_classic = {
    .name = "classic",
    .point = true,
    .nodes_past_end = 2,
    .lone_node = true,
    .evaluate = evaluate,
    .continue_to = continue_to,
    .reach = reach,
};
