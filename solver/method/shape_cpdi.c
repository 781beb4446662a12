/* CPDI: chi_p is 1 on the particle's parallelogram with half edges d1, d2, and N_i is
 * replaced inside it by its interpolation between the four corners (N&G (30)-(39)).
 *
 * Corners go counter clockwise from the lower left, N&G Fig. 4. The weights below are
 * N&G (35), (37), (39) written with the corner signs (a, b): corner = centre + a d1 +
 * b d2; without the r terms they are the planar ones.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/shape.h"

#include <math.h>

enum { CORNERS = 4 };
static const double sign1[CORNERS] = {-1.0, 1.0, 1.0, -1.0};
static const double sign2[CORNERS] = {-1.0, -1.0, 1.0, 1.0};

struct weights {
    double s[CORNERS];
    double g[CORNERS][2];
    double t;
};

/* The smallest corner radius is r - (|d1r| + |d2r|): if it is negative, both half
 * edges shrink until the domain touches the axis. */
static void shrink_to_axis(double r, double d[4])
{
    const double extent = fabs(d[0]) + fabs(d[2]);
    if (extent <= r)
        return;
    const double scale = r / extent;
    for (int k = 0; k < 4; k++)
        d[k] *= scale;
}

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

static void add(struct mpm_stencil *stencil, int64_t node, double n, const struct weights *w,
                int corner)
{
    int k = 0;
    while (k < stencil->count && stencil->node[k].node != node)
        k++;
    if (k == stencil->count)
        stencil->node[stencil->count++] = (struct mpm_stencil_node){.node = node};
    struct mpm_stencil_node *const entry = &stencil->node[k];
    entry->s += n * w->s[corner];
    entry->g[0] += n * w->g[corner][0];
    entry->g[1] += n * w->g[corner][1];
    entry->t += n * w->t;
}

/* Adds the hat functions at one corner; nodes without weight stay out. */
static void add_corner(const struct mpm_shape_grid *grid, const double position[2],
                       const struct weights *w, int corner, struct mpm_stencil *stencil)
{
    int64_t first[2];
    double n[2][2];
    for (int axis = 0; axis < 2; axis++) {
        const double coordinate =
            mpm_shape_cells((position[axis] - grid->origin[axis]) * grid->inverse_cell[axis]);
        first[axis] = mpm_floor(coordinate);
        n[axis][1] = coordinate - (double)first[axis];
        n[axis][0] = 1.0 - n[axis][1];
    }
    for (int row = 0; row < 2; row++)
        for (int column = 0; column < 2; column++) {
            const double value = n[0][column] * n[1][row];
            if (value > 0.0)
                add(stencil, (first[1] + row) * grid->columns + (first[0] + column), value, w,
                    corner);
        }
}

static void evaluate(const struct mpm_shape_grid *grid, const struct mpm_shape_domain *domain,
                     struct mpm_stencil *stencil)
{
    double d[4] = {domain->edge[0], domain->edge[1], domain->edge[2], domain->edge[3]};
    double inverse_r = 0.0;
    if (grid->axisymmetric) {
        const double r = domain->position[0];
        inverse_r = 1.0 / r;
        if (grid->truncated)
            shrink_to_axis(r, d);
    }
    const struct weights w = corner_weights(d, inverse_r / 3.0, inverse_r);
    stencil->count = 0;
    for (int c = 0; c < CORNERS; c++) {
        const double corner[2] = {domain->position[0] + sign1[c] * d[0] + sign2[c] * d[2],
                                  domain->position[1] + sign1[c] * d[1] + sign2[c] * d[3]};
        add_corner(grid, corner, &w, c, stencil);
    }
}

static void reach(const struct mpm_shape_domain *domain, double distance[2])
{
    distance[0] = fabs(domain->edge[0]) + fabs(domain->edge[2]);
    distance[1] = fabs(domain->edge[1]) + fabs(domain->edge[3]);
}

const struct mpm_shape_family mpm_shape_cpdi = {
    .name = "cpdi",
    .convected = true,
    .evaluate = evaluate,
    .reach = reach,
};
