/* Uniform GIMP: chi_p is 1 on an undeformed rectangle that moves with the particle.
 *
 * The integrals N&G (17), (23) and Appendix (68), (69) are taken cell by cell over the
 * part of the domain in each cell, where N_i is linear. The sums are the piecewise
 * formulas N&G (19)-(21), (24)-(26), (27)-(29) for l_p <= 1 and any spacing; every term
 * is positive where the weight is, so nothing cancels, and a node beyond the domain's
 * edge gets no term at all. Truncation at r = 0 is a shorter interval of integration.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/shape/shape.h"

/* Weights of the nodes along one axis; gradients per cell. A domain of up to one cell
 * (l_p <= 1) lies in one cell or in two. */
struct line {
    int64_t first;
    int count;
    double s[3];
    double ds[3];
    double t[3]; /* radial: mean of N_i over mean of r, r in cells */
};

/* The part [from, to] of a cell, 0 <= from < to <= 1, between the nodes k and k + 1:
 * integrals of N_i and of its slope, times `norm`. */
static inline void add_part(struct line *line, int k, double from, double to, double norm)
{
    const double length = (to - from) * norm;
    const double mean = 0.5 * (from + to);
    line->s[k] += length * (1.0 - mean);
    line->ds[k] -= length;
    line->s[k + 1] = length * mean;
    line->ds[k + 1] = length;
}

/* The same with weight r; the node k is at radius r, in cells. */
static inline void add_radial_part(struct line *line, int k, double from, double to, double norm,
                                   double r)
{
    const double length = (to - from) * norm;
    const double mean = 0.5 * (from + to);                           /* of u = r' - r */
    const double square = (from * from + from * to + to * to) / 3.0; /* mean of u^2 */
    const double weight = length * (r + mean);
    line->s[k] += length * (r * (1.0 - mean) + (mean - square));
    line->ds[k] -= weight;
    line->t[k] += length * (1.0 - mean);
    line->s[k + 1] = length * (r * mean + square);
    line->ds[k + 1] = weight;
    line->t[k + 1] = length * mean;
}

static inline struct line planar_line(double low, double high)
{
    const int64_t cell = mpm_floor(low);
    const double from = low - (double)cell, to = high - (double)cell;
    const double norm = 1.0 / (high - low);
    struct line line = {.first = cell, .count = 2};
    if (to <= 1.0) {
        add_part(&line, 0, from, to, norm);
    } else {
        line.count = 3;
        add_part(&line, 0, from, 1.0, norm);
        add_part(&line, 1, 0.0, to - 1.0, norm);
    }
    return line;
}

/* Normalised by the integral of r over the domain, r_mean times width; `axis` is the
 * place of r = 0 in cells. */
static inline struct line radial_line(double low, double high, double axis, double r_mean)
{
    const int64_t cell = mpm_floor(low);
    const double from = low - (double)cell, to = high - (double)cell;
    const double norm = 1.0 / ((high - low) * r_mean);
    const double r = (double)cell - axis;
    struct line line = {.first = cell, .count = 2};
    if (to <= 1.0) {
        add_radial_part(&line, 0, from, to, norm, r);
    } else {
        line.count = 3;
        add_radial_part(&line, 0, from, 1.0, norm, r);
        add_radial_part(&line, 1, 0.0, to - 1.0, norm, r + 1.0);
    }
    return line;
}

/* The planar functions in axisymmetry: T = S / r_p, r_p in cells. */
static inline struct line planar_line_with_hoop(double low, double high, double r_p)
{
    struct line line = planar_line(low, high);
    for (int k = 0; k < line.count; k++)
        line.t[k] = line.s[k] / r_p;
    return line;
}

static struct line first_line(const struct mpm_shape_grid *grid, double position, double low,
                              double high)
{
    if (!grid->axisymmetric)
        return planar_line(low, high);
    if (!grid->radial)
        return planar_line_with_hoop(low, high, position * grid->inverse_cell[0]);
    const double axis = mpm_shape_cells(-grid->origin[0] * grid->inverse_cell[0]);
    if (grid->truncated && low < axis)
        low = axis;
    return radial_line(low, high, axis, 0.5 * (low + high) - axis);
}

static void evaluate(const struct mpm_shape_grid *grid, const struct mpm_shape_domain *domain,
                     struct mpm_stencil *stencil)
{
    double low[2], high[2];
    for (int axis = 0; axis < 2; axis++) {
        const double centre = domain->position[axis] - grid->origin[axis];
        low[axis] = mpm_shape_cells((centre - domain->half_size[axis]) * grid->inverse_cell[axis]);
        high[axis] = mpm_shape_cells((centre + domain->half_size[axis]) * grid->inverse_cell[axis]);
    }
    const struct line x = first_line(grid, domain->position[0], low[0], high[0]);
    const struct line y = planar_line(low[1], high[1]);
    stencil->count = 0;
    for (int row = 0; row < y.count; row++)
        for (int column = 0; column < x.count; column++)
            stencil->node[stencil->count++] = (struct mpm_stencil_node){
                .node = (y.first + row) * grid->columns + (x.first + column),
                .s = x.s[column] * y.s[row],
                .g = {x.ds[column] * grid->inverse_cell[0] * y.s[row],
                      x.s[column] * (y.ds[row] * grid->inverse_cell[1])},
                .t = x.t[column] * grid->inverse_cell[0] * y.s[row],
            };
}

static void reach(const struct mpm_shape_grid *grid, const struct mpm_shape_domain *domain,
                  double distance[2])
{
    (void)grid;
    distance[0] = domain->half_size[0];
    distance[1] = domain->half_size[1];
}

const struct mpm_shape_family mpm_shape_ugimp = {
    .name = "ugimp",
    .nodes_past_end = 2,
    .evaluate = evaluate,
    .reach = reach,
};
