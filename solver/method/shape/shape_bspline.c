/* Quadratic and cubic B-splines of point particles: S = phi_i(x_p), G = grad phi_i and, in
 * axisymmetry, T = phi_i / r_p, as for the classic functions.
 *
 * Inside the grid phi_i is the product of the centred uniform B-splines of x and y. At an
 * edge it is adapted (Steffen, Kirby, Berzins 2008): the function of the node beyond is
 * folded onto the two nodes inside by linear extrapolation,
 *
 *     phi~_0 = phi_0 + 2 phi_-1,   phi~_1 = phi_1 - phi_-1,
 *
 * which keeps sum phi = 1, sum x_i phi_i = x and phi >= 0, and leaves one weight on the
 * edge. The polynomials below have this worked out, so that no weight is left of a
 * difference. A grid of one cell is folded from both sides; what is left is the hat.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/shape/shape.h"

enum { LINE_NODES = 4 };

/* Weights of the nodes along one axis; gradients per cell. */
struct line {
    int64_t first;
    int count;
    double to_knot; /* from `home` to the nearest place where its polynomials end, in cells */
    double s[LINE_NODES], ds[LINE_NODES];
};

/* Knots lie half way between nodes; the functions are those of the span that `home` is in. At an
 * edge the function is the hat for half a cell. */
static struct line quadratic_line(double home, double coordinate, int64_t low, int64_t high)
{
    const double place = 0.5 * mpm_shape_cells(2.0 * coordinate);
    const int64_t node = mpm_floor(0.5 * mpm_shape_cells(2.0 * home) + 0.5);
    const double d = place - (double)node, from = 0.5 - d, to = 0.5 + d;
    const double to_knot = 0.5 - fabs(0.5 * mpm_shape_cells(2.0 * home) - (double)node);
    if (node == low)
        return (struct line){
            .first = node, .count = 2, .to_knot = to_knot, .s = {1.0 - d, d}, .ds = {-1.0, 1.0}};
    if (node == high)
        return (struct line){.first = node - 1,
                             .count = 2,
                             .to_knot = to_knot,
                             .s = {-d, 1.0 + d},
                             .ds = {-1.0, 1.0}};
    return (struct line){
        .first = node - 1,
        .count = 3,
        .to_knot = to_knot,
        .s = {0.5 * from * from, 0.75 - d * d, 0.5 * to * to},
        .ds = {-from, -2.0 * d, to},
    };
}

/* Knots are the nodes. In a cell at the edge u or 1 - u replaces the cubic. */
static struct line cubic_line(double home, double coordinate, int64_t low, int64_t high)
{
    const double place = mpm_shape_cells(coordinate);
    const int64_t floor = mpm_floor(mpm_shape_cells(home));
    const int64_t cell = floor < high ? floor : high - 1; /* the last node ends the last cell */
    const double u = place - (double)cell, v = 1.0 - u;
    const double past = mpm_shape_cells(home) - (double)cell, left = 1.0 - past;
    const double uu = u * u, vv = v * v, u_end = uu * u / 6.0, v_end = vv * v / 6.0;
    if (cell == low && cell == high - 1)
        return (struct line){
            .first = cell, .count = 2, .to_knot = 1.0, .s = {v, u}, .ds = {-1.0, 1.0}};
    if (cell == low)
        return (struct line){.first = cell,
                             .count = 3,
                             .to_knot = left,
                             .s = {v + u_end, u * (1.0 - uu / 3.0), u_end},
                             .ds = {0.5 * uu - 1.0, 1.0 - uu, 0.5 * uu}};
    if (cell == high - 1)
        return (struct line){.first = cell - 1,
                             .count = 3,
                             .to_knot = past,
                             .s = {v_end, v * (1.0 - vv / 3.0), u + v_end},
                             .ds = {-0.5 * vv, vv - 1.0, 1.0 - 0.5 * vv}};
    return (struct line){
        .first = cell - 1,
        .count = LINE_NODES,
        .to_knot = fmin(past, left),
        .s = {v_end, (4.0 - 3.0 * uu * (2.0 - u)) / 6.0, (4.0 - 3.0 * vv * (2.0 - v)) / 6.0, u_end},
        .ds = {-0.5 * vv, -u * (2.0 - 1.5 * u), v * (2.0 - 1.5 * v), 0.5 * uu},
    };
}

/* Nodes on which a knot or an edge leaves nothing are no part of the stencil. */
static void fill(const struct mpm_shape_grid *grid, double hoop, const struct line *x,
                 const struct line *y, struct mpm_stencil *stencil)
{
    stencil->count = 0;
    for (int row = 0; row < y->count; row++)
        for (int column = 0; column < x->count; column++) {
            const double s = x->s[column] * y->s[row];
            const double gx = x->ds[column] * grid->inverse_cell[0] * y->s[row];
            const double gy = x->s[column] * (y->ds[row] * grid->inverse_cell[1]);
            if (s == 0.0 && gx == 0.0 && gy == 0.0)
                continue;
            stencil->node[stencil->count++] = (struct mpm_stencil_node){
                .node = (y->first + row) * grid->columns + (x->first + column),
                .s = s,
                .g = {gx, gy},
                .t = s * hoop,
            };
        }
}

typedef struct line line_function(double home, double coordinate, int64_t low, int64_t high);

static inline double in_cells(const struct mpm_shape_grid *grid, int axis, double position)
{
    return (position - grid->origin[axis]) * grid->inverse_cell[axis];
}

static void evaluate_with(line_function *line_of, const struct mpm_shape_grid *grid,
                          const struct mpm_shape_domain *domain, struct mpm_stencil *stencil)
{
    struct line line[2];
    for (int axis = 0; axis < 2; axis++) {
        const double here = in_cells(grid, axis, domain->position[axis]);
        line[axis] = line_of(here, here, grid->edge_low[axis], grid->edge_high[axis]);
    }
    fill(grid, grid->axisymmetric ? 1.0 / domain->position[0] : 0.0, &line[0], &line[1], stencil);
}

/* The weights at `place` of the polynomials of `home`, along one axis: S + S' d + the even terms of
 * d + the odd ones. S and S' of `home` are continuous over a knot, and so is S'' of cubic splines.
 * The terms that jump there (quadratic: even, cubic: odd) fade out by r (2 - r) where r, the
 * distance of `home` to the knot over d, is below 1. So the weights vary continuously with `home`,
 * vanish where S and S' do, and have their sum and first moment, whatever is left of the last term.
 * Quadratic splines with one particle a cell, d = 1/2: an edge between two particles has the same
 * weights from both sides, and w(d) - w(-d) = 2 d S', so that a uniform stress is in balance
 * wherever the particles are. */
static struct line continued(line_function *line_of, bool even_jumps, double home, double place,
                             int64_t low, int64_t high)
{
    const double d = place - home;
    const struct line here = line_of(home, home, low, high);
    const struct line behind = line_of(home, home - d, low, high);
    struct line line = line_of(home, place, low, high);
    const double r = here.to_knot < fabs(d) ? here.to_knot / fabs(d) : 1.0;
    const double kept = r * (2.0 - r);
    for (int k = 0; k < line.count; k++) {
        const double even = 0.5 * (line.s[k] + behind.s[k]) - here.s[k];
        const double odd = 0.5 * (line.s[k] - behind.s[k]) - d * here.ds[k];
        line.s[k] -= (1.0 - kept) * (even_jumps ? even : odd);
    }
    return line;
}

static void continue_with(line_function *line_of, bool even_jumps,
                          const struct mpm_shape_grid *grid, const double home[2],
                          const double place[2], struct mpm_stencil *stencil)
{
    struct line line[2];
    for (int axis = 0; axis < 2; axis++)
        line[axis] = continued(line_of, even_jumps, in_cells(grid, axis, home[axis]),
                               in_cells(grid, axis, place[axis]), grid->edge_low[axis],
                               grid->edge_high[axis]);
    fill(grid, 0.0, &line[0], &line[1], stencil);
}

static void evaluate_quadratic(const struct mpm_shape_grid *grid,
                               const struct mpm_shape_domain *domain, struct mpm_stencil *stencil)
{
    evaluate_with(quadratic_line, grid, domain, stencil);
}

static void evaluate_cubic(const struct mpm_shape_grid *grid, const struct mpm_shape_domain *domain,
                           struct mpm_stencil *stencil)
{
    evaluate_with(cubic_line, grid, domain, stencil);
}

static void continue_quadratic(const struct mpm_shape_grid *grid, const double home[2],
                               const double place[2], struct mpm_stencil *stencil)
{
    continue_with(quadratic_line, true, grid, home, place, stencil);
}

static void continue_cubic(const struct mpm_shape_grid *grid, const double home[2],
                           const double place[2], struct mpm_stencil *stencil)
{
    continue_with(cubic_line, false, grid, home, place, stencil);
}

/* A node's support, less the cell around which boxes of nodes are drawn. */
static void reach_quadratic(const struct mpm_shape_grid *grid,
                            const struct mpm_shape_domain *domain, double distance[2])
{
    (void)domain;
    for (int axis = 0; axis < 2; axis++)
        distance[axis] = 0.5 / grid->inverse_cell[axis];
}

static void reach_cubic(const struct mpm_shape_grid *grid, const struct mpm_shape_domain *domain,
                        double distance[2])
{
    (void)domain;
    for (int axis = 0; axis < 2; axis++)
        distance[axis] = 1.0 / grid->inverse_cell[axis];
}

const struct mpm_shape_family mpm_shape_bspline2 = {
    .name = "bspline2",
    .point = true,
    .past_next = 1.0 / 48.0,
    .nodes_past_end = 1,
    .evaluate = evaluate_quadratic,
    .continue_to = continue_quadratic,
    .reach = reach_quadratic,
};

const struct mpm_shape_family mpm_shape_bspline3 = {
    .name = "bspline3",
    .point = true,
    .past_next = 1.0 / 24.0,
    .nodes_past_end = 1,
    .evaluate = evaluate_cubic,
    .continue_to = continue_cubic,
    .reach = reach_cubic,
};
