/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "model/grid.h"

struct mpm_grid mpm_grid_describe(const struct mpm_scene *scene)
{
    struct mpm_grid grid = {0};
    for (int axis = 0; axis < 2; axis++) {
        grid.origin[axis] = scene->origin[axis];
        grid.cell[axis] = scene->cell[axis];
        grid.inverse_cell[axis] = 1.0 / scene->cell[axis];
        grid.cells[axis] = scene->cells[axis];
    }
    grid.columns = grid.cells[0] + 1 + 2 * MPM_GHOST_ROWS;
    grid.rows = grid.cells[1] + 1 + 2 * MPM_GHOST_ROWS;
    return grid;
}

void mpm_grid_layout(struct mpm_grid *grid, struct mpm_arena *arena)
{
    grid->nodes = MPM_TAKE(arena, struct mpm_node, (size_t)(grid->columns * grid->rows));
}
