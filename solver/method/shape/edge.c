/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/shape/edge.h"

/* The edge's middle is centre + a d1 + b d2, and it runs along c d1 + d d2. */
static const struct {
    double a, b, c, d;
} layout[MPM_EDGE_COUNT] = {
    [MPM_EDGE_BOTTOM] = {.b = -1.0, .c = 1.0},
    [MPM_EDGE_RIGHT] = {.a = 1.0, .d = 1.0},
    [MPM_EDGE_TOP] = {.b = 1.0, .c = -1.0},
    [MPM_EDGE_LEFT] = {.a = -1.0, .d = -1.0},
};

/* N&G after (48): a domain past r = 0 gets the part with r > 0, r' = d' = (r + d)/2. */
static void cut_at_axis(double *r, double *half)
{
    if (*r - *half >= 0.0)
        return;
    *r = 0.5 * (*r + *half);
    *half = *r;
}

struct mpm_edge_line mpm_edge_find(const struct mpm_shape_family *family,
                                   const struct mpm_shape_grid *grid,
                                   const struct mpm_shape_domain *domain, enum mpm_edge edge)
{
    const bool carried = mpm_shape_edges_deform(family);
    const bool ends_at_axis = grid->axisymmetric && (grid->truncated || family->point);
    double centre[2] = {domain->position[0], domain->position[1]};
    double d[4] = {domain->half_size[0], 0.0, 0.0, domain->half_size[1]};
    for (int k = 0; carried && k < 4; k++)
        d[k] = domain->edge[k];
    if (ends_at_axis && carried)
        mpm_shape_shrink_to_axis(centre[0], d);
    else if (ends_at_axis)
        cut_at_axis(&centre[0], &d[0]);
    struct mpm_edge_line line;
    for (int axis = 0; axis < 2; axis++) {
        line.middle[axis] = centre[axis] + layout[edge].a * d[axis] + layout[edge].b * d[2 + axis];
        line.half[axis] = layout[edge].c * d[axis] + layout[edge].d * d[2 + axis];
    }
    return line;
}

static double half_length(const struct mpm_edge_line *line)
{
    return sqrt(line->half[0] * line->half[0] + line->half[1] * line->half[1]);
}

double mpm_edge_area(const struct mpm_shape_grid *grid, const struct mpm_edge_line *line,
                     double depth)
{
    return 2.0 * half_length(line) * (grid->axisymmetric ? line->middle[0] : depth);
}

/* ---------------------------------------------------------------- the nodes */

static void add(struct mpm_edge_weights *weights, int64_t node, double w)
{
    int k = 0;
    if (w == 0.0)
        return;
    while (k < weights->count && weights->entry[k].node != node)
        k++;
    if (k == weights->count) {
        weights->entry[k].node = node;
        weights->entry[k].w = 0.0;
        weights->count++;
    }
    weights->entry[k].w += w;
}

void mpm_edge_weights_add(struct mpm_edge_weights *weights, const struct mpm_stencil *stencil,
                          double area)
{
    for (int k = 0; k < stencil->count; k++)
        add(weights, stencil->node[k].node, area * stencil->node[k].s);
}

/* N&G (41)-(44), (50)-(53): the weight of a corner is the integral of its linear function. */
static void integrate_interpolated(const struct mpm_shape_grid *grid,
                                   const struct mpm_edge_line *line, double depth,
                                   struct mpm_edge_weights *weights)
{
    const double length = half_length(line);
    for (int end = -1; end <= 1; end += 2) {
        const double place[2] = {line->middle[0] + end * line->half[0],
                                 line->middle[1] + end * line->half[1]};
        const double mean =
            grid->axisymmetric ? line->middle[0] + end * line->half[0] / 3.0 : depth;
        struct mpm_stencil corner;
        mpm_shape_classic.continue_to(grid, place, place, &corner);
        mpm_edge_weights_add(weights, &corner, length * mean);
    }
}

/* One point for an edge, as the particle is one for its volume: a uniform stress is in balance only
 * if both are taken alike along the edge. */
static void take_middle(const struct mpm_shape_family *family, const struct mpm_shape_grid *grid,
                        const double home[2], const struct mpm_edge_line *line, double depth,
                        struct mpm_edge_weights *weights)
{
    struct mpm_stencil middle;
    family->continue_to(grid, home, line->middle, &middle);
    mpm_edge_weights_add(weights, &middle, mpm_edge_area(grid, line, depth));
}

void mpm_edge_integrate(const struct mpm_shape_family *family, const struct mpm_shape_grid *grid,
                        const struct mpm_shape_domain *domain, enum mpm_edge edge, double depth,
                        struct mpm_edge_weights *weights)
{
    const struct mpm_edge_line line = mpm_edge_find(family, grid, domain, edge);
    weights->count = 0;
    if (family->point)
        take_middle(family, grid, domain->position, &line, depth, weights);
    else
        integrate_interpolated(grid, &line, depth, weights);
}
