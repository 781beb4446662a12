/* One-dimensional shape functions taken out of the solver's two-dimensional stencil.
 *
 * The factors along z add up to one over the rows of the grid, so the sum over a column's
 * rows is the factor along r: S_r and dS_r of N&G (16), (22).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_MEASURES_SHAPE_LINES_H
#define VERIFICATION_MEASURES_SHAPE_LINES_H

#include "mpm.h"

/* A family on square cells of edge one, node 0 at r = 0. */
struct shape_line {
    enum mpm_shape shape;
    enum mpm_geometry geometry;
    enum mpm_axis axis;
    double size; /* l_p: the domain's width in cells, from above 0 to 1 */
    bool edge;   /* is node 0 the grid's edge, onto which B-splines fold? */
};

struct shape_line_value {
    double s;  /* S_r, N&G (17) */
    double ds; /* dS_r = (cell/2) G_r, N&G (23) */
    double t;  /* T_r = cell T: (27) without S_z; 0 in planar geometry */
};

/* The values of node `node` (r_i = node) for a particle at r = `radius` in cells, F = I;
 * zero where the stencil has no such node. */
struct shape_line_value shape_line_at(const struct shape_line *line, int64_t node, double radius);

#endif
