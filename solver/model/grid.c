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

void mpm_grid_layout(struct mpm_grid *grid, bool smooths, bool sums_contact,
                     struct mpm_arena *arena)
{
    /* vectors over the nodes of a row read, and add nothing to, a few places past the last */
    const size_t nodes = (size_t)mpm_grid_nodes(grid) + MPM_ROW_PADDING;
    grid->mass = MPM_TAKE(arena, double, nodes);
    grid->sum = mpm_arena_take(arena, nodes, sizeof *grid->sum);
    grid->start = mpm_arena_take(arena, nodes, sizeof *grid->start);
    grid->motion = MPM_TAKE(arena, struct mpm_node_motion, nodes);
    grid->gradient = mpm_arena_take(arena, nodes, sizeof *grid->gradient);
    grid->smoothed = smooths ? MPM_TAKE(arena, struct mpm_node_motion, nodes) : NULL;
    grid->contact_force =
        sums_contact ? mpm_arena_take(arena, nodes, sizeof *grid->contact_force) : NULL;
}
