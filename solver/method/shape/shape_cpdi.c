/* CPDI: chi_p is 1 on the particle's parallelogram with domain vectors d1, d2, and N_i is
 * replaced inside it by its interpolation between the four corners (N&G (30)-(39)).
 *
 * Corners go counter clockwise from the lower left, N&G Fig. 4. The weights below are
 * N&G (35), (37), (39) written with the corner signs (a, b): corner = centre + a d1 +
 * b d2; without the r terms they are the planar ones.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/shape/shape.h"

#include <math.h>

enum { CORNERS = 4 };
static const double sign1[CORNERS] = {-1.0, 1.0, 1.0, -1.0};
static const double sign2[CORNERS] = {-1.0, -1.0, 1.0, 1.0};

struct weights {
    double s[CORNERS];
    double g[CORNERS][2];
    double t;
};

static struct weights corner_weights(const double d[4], double third_over_r, double inverse_r)
{
    struct weights w;
    const double area = 4.0 * (d[0] * d[3] - d[2] * d[1]);
    const double inverse_area = 1.0 / area;
    const double beta = (d[0] * d[1] - d[2] * d[3]) * third_over_r;
    for (int c = 0; c < CORNERS; c++) {
        const double a = sign1[c], b = sign2[c];
        const double radial = (a * d[0] + b * d[2]) * third_over_r;
        w.s[c] = 0.25 * (1.0 + radial);
        w.g[c][0] = inverse_area * ((a * d[3] - b * d[1]) - a * b * beta);
        w.g[c][1] = inverse_area * (b * d[0] - a * d[2]) * (1.0 + radial);
    }
    w.t = 0.25 * inverse_r;
    return w;
}

/* The hat functions at a corner: the cell it is in and the weights of its nodes. */
struct corner {
    int64_t column, row;
    double n[2][2]; /* [axis][node] */
};

static struct corner corner_at(const struct mpm_shape_grid *grid, const double position[2])
{
    struct corner corner = {0};
    int64_t *const first[2] = {&corner.column, &corner.row};
    for (int axis = 0; axis < 2; axis++) {
        const double coordinate =
            mpm_shape_cells((position[axis] - grid->origin[axis]) * grid->inverse_cell[axis]);
        *first[axis] = mpm_floor(coordinate);
        corner.n[axis][1] = coordinate - (double)*first[axis];
        corner.n[axis][0] = 1.0 - corner.n[axis][1];
    }
    return corner;
}

/* The nodes around the corners' cells, if they are no more than a stencil holds: a block of
 * entries that corners add to by place. */
struct block {
    int64_t column, row, columns, rows;
};

static bool block_of(const struct corner corners[CORNERS], struct block *block)
{
    int64_t last_column = corners[0].column, last_row = corners[0].row;
    block->column = last_column;
    block->row = last_row;
    for (int c = 1; c < CORNERS; c++) {
        block->column = corners[c].column < block->column ? corners[c].column : block->column;
        block->row = corners[c].row < block->row ? corners[c].row : block->row;
        last_column = corners[c].column > last_column ? corners[c].column : last_column;
        last_row = corners[c].row > last_row ? corners[c].row : last_row;
    }
    block->columns = last_column - block->column + 2;
    block->rows = last_row - block->row + 2;
    return block->columns <= MPM_STENCIL_MAX && block->rows <= MPM_STENCIL_MAX &&
           block->columns * block->rows <= MPM_STENCIL_MAX;
}

static inline void add(struct mpm_stencil_node *entry, double n, const struct weights *w,
                       int corner)
{
    entry->s += n * w->s[corner];
    entry->g[0] += n * w->g[corner][0];
    entry->g[1] += n * w->g[corner][1];
    entry->t += n * w->t;
}

static void fill_block(const struct mpm_shape_grid *grid, const struct block *block,
                       const struct corner corners[CORNERS], const struct weights *w,
                       struct mpm_stencil *stencil)
{
    stencil->count = 0;
    for (int64_t row = 0; row < block->rows; row++)
        for (int64_t column = 0; column < block->columns; column++)
            stencil->node[stencil->count++] = (struct mpm_stencil_node){
                .node = (block->row + row) * grid->columns + (block->column + column)};
    for (int c = 0; c < CORNERS; c++) {
        const struct corner *const corner = &corners[c];
        struct mpm_stencil_node *const first =
            &stencil->node[(corner->row - block->row) * block->columns +
                           (corner->column - block->column)];
        for (int row = 0; row < 2; row++)
            for (int column = 0; column < 2; column++)
                add(first + row * block->columns + column, corner->n[0][column] * corner->n[1][row],
                    w, c);
    }
}

/* A domain that spans many cells: its corners' nodes, found one by one. */
static void fill_far(const struct mpm_shape_grid *grid, const struct corner corners[CORNERS],
                     const struct weights *w, struct mpm_stencil *stencil)
{
    stencil->count = 0;
    for (int c = 0; c < CORNERS; c++)
        for (int k = 0; k < 4; k++) {
            const int64_t node =
                (corners[c].row + k / 2) * grid->columns + corners[c].column + k % 2;
            int place = 0;
            while (place < stencil->count && stencil->node[place].node != node)
                place++;
            if (place == stencil->count)
                stencil->node[stencil->count++] = (struct mpm_stencil_node){.node = node};
            add(&stencil->node[place], corners[c].n[0][k % 2] * corners[c].n[1][k / 2], w, c);
        }
}

/* Nodes beside the domain, and those at which a corner lies on the far side of its cell,
 * have received no weight: every hat function there was an exact zero. */
static void drop_untouched(struct mpm_stencil *stencil)
{
    int kept = 0;
    for (int k = 0; k < stencil->count; k++) {
        const struct mpm_stencil_node *const entry = &stencil->node[k];
        if (entry->s != 0.0 || entry->g[0] != 0.0 || entry->g[1] != 0.0 || entry->t != 0.0)
            stencil->node[kept++] = *entry;
    }
    stencil->count = kept;
}

static void evaluate(const struct mpm_shape_grid *grid, const struct mpm_shape_domain *domain,
                     struct mpm_stencil *stencil)
{
    double d[4] = {domain->edge[0], domain->edge[1], domain->edge[2], domain->edge[3]};
    double inverse_r = 0.0, third_over_r = 0.0;
    if (grid->axisymmetric) {
        const double r = domain->position[0];
        inverse_r = 1.0 / r;
        third_over_r = grid->radial ? inverse_r / 3.0 : 0.0;
        if (grid->truncated)
            mpm_shape_shrink_to_axis(r, d);
    }
    const struct weights w = corner_weights(d, third_over_r, inverse_r);
    struct corner corners[CORNERS];
    for (int c = 0; c < CORNERS; c++) {
        const double position[2] = {domain->position[0] + sign1[c] * d[0] + sign2[c] * d[2],
                                    domain->position[1] + sign1[c] * d[1] + sign2[c] * d[3]};
        corners[c] = corner_at(grid, position);
    }
    struct block block;
    if (block_of(corners, &block))
        fill_block(grid, &block, corners, &w, stencil);
    else
        fill_far(grid, corners, &w, stencil);
    drop_untouched(stencil);
}

static void reach(const struct mpm_shape_grid *grid, const struct mpm_shape_domain *domain,
                  double distance[2])
{
    (void)grid;
    distance[0] = fabs(domain->edge[0]) + fabs(domain->edge[2]);
    distance[1] = fabs(domain->edge[1]) + fabs(domain->edge[3]);
}

const struct mpm_shape_family mpm_shape_cpdi = {
    .name = "cpdi",
    .convected = true,
    .nodes_past_end = 2,
    .evaluate = evaluate,
    .reach = reach,
};
