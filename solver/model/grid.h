/* The background grid: a regular lattice of nodes with ghost rows around the cells of
 * the scene, and what a node holds during one step.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_MODEL_GRID_H
#define MPM_MODEL_GRID_H

#include "base/arena.h"
#include "model/scene.h"

enum { MPM_GHOST_ROWS = 2, MPM_ROW_PADDING = 4 };

/* What particles spread along one axis: sum of m_p v_p S_ip, and internal and body forces. While
 * there are no forces yet (USF, USAVG), fast kernels spread masses with the momenta, beside that
 * along the first axis; from the velocities at the start on, mpm_grid.mass has them, and the place
 * is that of the force, zero. */
struct mpm_node_sum {
    double momentum;
    union {
        double force;
        double mass;
    };
};

/* What they read back: along both axes. */
struct mpm_node_motion {
    double acceleration[2]; /* of the step, conditions included */
    double end[2];          /* velocity at the end of the step */
};

struct mpm_grid {
    double origin[2]; /* of the first cell: node (0, 0) */
    double cell[2];
    double inverse_cell[2];
    int64_t cells[2];
    int64_t columns, rows; /* of nodes, ghost rows included */
    int64_t field_rows;    /* as long: room for additional velocity fields, see method/fields */
    /* Per node, one array for what one pass uses; valid within one step only, and where
     * particles reach. A node without mass has no motion: all zero. */
    double *mass;
    struct mpm_node_sum (*sum)[2];
    double (*start)[2]; /* velocity at the start of the step */
    struct mpm_node_motion *motion;
    /* The velocity whose gradient updates the stress, before that the re-extrapolated
     * momentum; each component twice, to meet both parts of a gradient. */
    double (*gradient)[2][2];
    /* For XPIC and FMPM, else NULL: a velocity in the place of the acceleration, and at its
     * `end` the one that it began as; see method/transfer/smoothing.h. */
    struct mpm_node_motion *smoothed;
    /* For scenes with time.rest and contact, else NULL: force that contact gives in task 4. */
    double (*contact_force)[2];
};

/* Sets sizes from the scene; allocates nothing. */
struct mpm_grid mpm_grid_describe(const struct mpm_scene *scene);
/* Takes the nodes' arrays from the arena. */
void mpm_grid_layout(struct mpm_grid *grid, bool smooths, bool sums_contact,
                     struct mpm_arena *arena);

/* Nodes that there is room for, additional fields included. */
static inline int64_t mpm_grid_nodes(const struct mpm_grid *grid)
{
    return grid->columns * (grid->rows + grid->field_rows);
}

/* The coordinate at which the cells end along an axis. */
static inline double mpm_grid_end(const struct mpm_grid *grid, int axis)
{
    return grid->origin[axis] + (double)grid->cells[axis] * grid->cell[axis];
}

/* Index of node (column, row), counted from the first cell's corner; ghosts are
 * negative or beyond cells. */
static inline int64_t mpm_grid_index(const struct mpm_grid *grid, int64_t column, int64_t row)
{
    return (row + MPM_GHOST_ROWS) * grid->columns + (column + MPM_GHOST_ROWS);
}

static inline bool mpm_grid_is_ghost(const struct mpm_grid *grid, int64_t index)
{
    const int64_t row = index / grid->columns - MPM_GHOST_ROWS;
    const int64_t column = index % grid->columns - MPM_GHOST_ROWS;
    return column < 0 || row < 0 || column > grid->cells[0] || row > grid->cells[1];
}

/* Position of the node with that index. */
static inline void mpm_grid_position(const struct mpm_grid *grid, int64_t index, double position[2])
{
    const int64_t row = index / grid->columns, column = index % grid->columns;
    position[0] = grid->origin[0] + grid->cell[0] * (double)(column - MPM_GHOST_ROWS);
    position[1] = grid->origin[1] + grid->cell[1] * (double)(row - MPM_GHOST_ROWS);
}

/* Along an axis, from the line of nodes with that number to a place. */
static inline double mpm_grid_way(const struct mpm_grid *grid, int axis, int64_t line, double place)
{
    return place - (grid->origin[axis] + grid->cell[axis] * (double)(line - MPM_GHOST_ROWS));
}

/* As mpm_grid_position; for a ghost node the place of the edge node whose condition it continues.
 */
static inline void mpm_grid_edge_position(const struct mpm_grid *grid, int64_t index,
                                          double position[2])
{
    int64_t row = index / grid->columns, column = index % grid->columns;
    const int64_t last_row = MPM_GHOST_ROWS + grid->cells[1];
    const int64_t last_column = MPM_GHOST_ROWS + grid->cells[0];
    row = row < MPM_GHOST_ROWS ? MPM_GHOST_ROWS : row > last_row ? last_row : row;
    column = column < MPM_GHOST_ROWS ? MPM_GHOST_ROWS : column > last_column ? last_column : column;
    mpm_grid_position(grid, row * grid->columns + column, position);
}

#endif
