/* Fast kernels: stencils that are products of lines, S_ip = s(x) s(y), of classic MPM, uGIMP
 * and B-splines, for four particles at once. The lines of a family always have the same
 * number of nodes; those beyond the domain's edge have exact zeros.
 *
 * Nodal data are vectors too: what particles spread is (p_x, f_x, p_y, f_y), what they read
 * (a_x, a_y, v_x, v_y) and (v_x, v_x, v_y, v_y). So a weight is stored beside its slope,
 * and a pair of them meets both axes in one product.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_FAST_LINES_H
#define MPM_METHOD_FAST_LINES_H

#include "base/simd.h"
#include "method/fast/fast_affine.h"
#include "method/fast/fast_constants.h"

/* Weights along one axis, by node; gradients per length. */
struct fast_line {
    mpm_vector first; /* the first node */
    mpm_vector s[MPM_LINE_NODES], d[MPM_LINE_NODES];
    mpm_vector t[MPM_LINE_NODES]; /* radial lines only */
};

/* In memory, to be read lane by lane. */
struct fast_lines {
    int64_t node[MPM_VECTOR_SIZE]; /* first of each particle */
    double x[MPM_LINE_NODES][8];   /* pairs (slope, weight), see fast_pair */
    double y[MPM_LINE_NODES][8];   /* pairs (weight, slope) */
    double t[MPM_LINE_NODES][MPM_VECTOR_SIZE];
    mpm_vector sx[MPM_LINE_NODES]; /* the weights of x once more, by particles */
    /* and the others, where scalars are exchanged */
    mpm_vector dx[MPM_LINE_NODES], sy[MPM_LINE_NODES], dy[MPM_LINE_NODES];
    bool together;               /* all four have the same nodes; there */
    struct fast_moments moments; /* of APIC */
};

/* The place of a lane's pair, see mpm_store_pairs. */
static const int fast_pair[MPM_VECTOR_SIZE] = {0, 4, 2, 6};

/* ------------------------------------------------------------ along one axis */

/* See shape_ugimp.c: the parts [from, middle] of a cell and [0, rest] of the next one, and
 * what they give the three nodes. */
MPM_INLINE void add_parts(struct fast_line *line, mpm_vector from, mpm_vector middle,
                          mpm_vector rest, mpm_vector norm, double inverse_cell)
{
    const mpm_vector length = (middle - from) * norm, next = rest * norm;
    const mpm_vector mean = 0.5 * (from + middle), next_mean = 0.5 * rest;
    const mpm_vector slope = length * inverse_cell, next_slope = next * inverse_cell;
    line->s[0] = length * (1.0 - mean);
    line->s[1] = length * mean + next * (1.0 - next_mean);
    line->s[2] = next * next_mean;
    line->d[0] = -slope;
    line->d[1] = slope - next_slope;
    line->d[2] = next_slope;
}

/* What one part gives both nodes of its cell. */
struct radial_part {
    mpm_vector first, second, weight;
    mpm_vector t_first, t_second;
};

MPM_INLINE struct radial_part radial_part(mpm_vector from, mpm_vector to, mpm_vector norm,
                                          mpm_vector r)
{
    const mpm_vector length = (to - from) * norm;
    const mpm_vector mean = 0.5 * (from + to);
    const mpm_vector square = (from * from + from * to + to * to) * (1.0 / 3.0);
    return (struct radial_part){
        .first = length * (r * (1.0 - mean) + (mean - square)),
        .second = length * (r * mean + square),
        .weight = length * (r + mean),
        .t_first = length * (1.0 - mean),
        .t_second = length * mean,
    };
}

MPM_INLINE void add_radial_parts(struct fast_line *line, mpm_vector from, mpm_vector middle,
                                 mpm_vector rest, mpm_vector norm, mpm_vector r,
                                 double inverse_cell)
{
    const struct radial_part here = radial_part(from, middle, norm, r);
    const struct radial_part next = radial_part(mpm_splat(0.0), rest, norm, r + 1.0);
    const mpm_vector slope = here.weight * inverse_cell, next_slope = next.weight * inverse_cell;
    line->s[0] = here.first;
    line->s[1] = here.second + next.first;
    line->s[2] = next.second;
    line->d[0] = -slope;
    line->d[1] = slope - next_slope;
    line->d[2] = next_slope;
    line->t[0] = here.t_first * inverse_cell;
    line->t[1] = (here.t_second + next.t_first) * inverse_cell;
    line->t[2] = next.t_second * inverse_cell;
}

/* A domain within one cell has an empty part in the next one: weights are products with an
 * exact zero. */
MPM_INLINE struct fast_line fast_line_ugimp(const struct fast_constants *k, int axis, bool radial,
                                            mpm_vector position)
{
    const mpm_vector zero = mpm_splat(0.0), one = mpm_splat(1.0);
    const mpm_vector centre = position - k->origin[axis];
    struct fast_line line;
    mpm_vector low = fast_cells((centre - k->half[axis]) * k->inverse_cell[axis], &line.first);
    const mpm_vector high = fast_snap((centre + k->half[axis]) * k->inverse_cell[axis]);
    if (radial) {
        low = mpm_larger(low, mpm_splat(k->cut));
        line.first = mpm_larger(line.first, mpm_splat(k->cut_cell));
    }
    const mpm_vector from = low - line.first, to = high - line.first;
    const mpm_vector middle = mpm_smaller(to, one), rest = mpm_larger(to - 1.0, zero);
    if (radial) {
        const mpm_vector norm = 1.0 / ((high - low) * (0.5 * (low + high) - k->axis));
        add_radial_parts(&line, from, middle, rest, norm, line.first - k->axis,
                         k->inverse_cell[axis]);
    } else {
        add_parts(&line, from, middle, rest, 1.0 / (high - low), k->inverse_cell[axis]);
    }
    return line;
}

/* Functions of points: T = S / r_p. */
MPM_INLINE void set_point_hoop(struct fast_line *line, int nodes, mpm_vector position)
{
    const mpm_vector hoop = 1.0 / position;
    for (int i = 0; i < nodes; i++)
        line->t[i] = line->s[i] * hoop;
}

/* See shape_bspline.c. */
MPM_INLINE struct fast_line fast_line_bspline2(const struct fast_constants *k, int axis,
                                               mpm_vector position)
{
    const mpm_vector zero = mpm_splat(0.0), one = mpm_splat(1.0);
    const mpm_vector cells = (position - k->origin[axis]) * k->inverse_cell[axis];
    const mpm_vector place = 0.5 * fast_snap(2.0 * cells), shifted = place + 0.5;
    const mpm_vector node = mpm_down_to_integer(shifted, mpm_nearest(shifted));
    const mpm_vector d = place - node, from = 0.5 - d, to = 0.5 + d;
    const mpm_mask low = mpm_at_most(node, mpm_splat(k->edge_low[axis]));
    const mpm_mask high = mpm_at_most(mpm_splat(k->edge_high[axis]), node);
    const mpm_mask edge = low | high;
    struct fast_line line = {.first = node - 1.0};
    line.s[0] = mpm_select(edge, mpm_larger(-d, zero), 0.5 * from * from);
    line.s[1] = mpm_select(edge, 1.0 - mpm_absolute(d), 0.75 - d * d);
    line.s[2] = mpm_select(edge, mpm_larger(d, zero), 0.5 * to * to);
    line.d[0] = mpm_select(edge, mpm_select(high, -one, zero), -from);
    line.d[1] = mpm_select(edge, mpm_select(low, -one, one), -2.0 * d);
    line.d[2] = mpm_select(edge, mpm_select(low, one, zero), to);
    return line;
}

MPM_INLINE struct fast_line fast_line_bspline3(const struct fast_constants *k, int axis,
                                               mpm_vector position)
{
    const mpm_vector zero = mpm_splat(0.0), end = mpm_splat(k->edge_high[axis] - 1.0);
    mpm_vector cell;
    const mpm_vector place =
        fast_cells((position - k->origin[axis]) * k->inverse_cell[axis], &cell);
    cell = mpm_smaller(cell, end);
    const mpm_vector u = place - cell, v = 1.0 - u, uu = u * u, vv = v * v;
    const mpm_mask low = mpm_at_most(cell, mpm_splat(k->edge_low[axis]));
    const mpm_mask high = mpm_at_most(end, cell);
    const mpm_vector s_inner[2] = {(4.0 - 3.0 * uu * (2.0 - u)) * (1.0 / 6.0),
                                   (4.0 - 3.0 * vv * (2.0 - v)) * (1.0 / 6.0)};
    struct fast_line line = {.first = cell - 1.0};
    line.s[0] = mpm_select(low, zero, vv * v * (1.0 / 6.0));
    line.s[3] = mpm_select(high, zero, uu * u * (1.0 / 6.0));
    line.s[1] =
        mpm_select(low, v + line.s[3], mpm_select(high, v * (1.0 - vv * (1.0 / 3.0)), s_inner[0]));
    line.s[2] =
        mpm_select(high, u + line.s[0], mpm_select(low, u * (1.0 - uu * (1.0 / 3.0)), s_inner[1]));
    line.d[0] = mpm_select(low, zero, -0.5 * vv);
    line.d[3] = mpm_select(high, zero, 0.5 * uu);
    line.d[1] = mpm_select(low, line.d[3] - 1.0, mpm_select(high, vv - 1.0, -u * (2.0 - 1.5 * u)));
    line.d[2] = mpm_select(high, line.d[0] + 1.0, mpm_select(low, 1.0 - uu, v * (2.0 - 1.5 * v)));
    return line;
}

MPM_INLINE struct fast_line fast_line_classic(const struct fast_constants *k, int axis,
                                              mpm_vector position)
{
    struct fast_line line = {.first = mpm_splat(0.0)};
    const mpm_vector place =
        fast_cells((position - k->origin[axis]) * k->inverse_cell[axis], &line.first);
    line.s[1] = place - line.first;
    line.s[0] = 1.0 - line.s[1];
    line.d[0] = mpm_splat(-k->inverse_cell[axis]);
    line.d[1] = mpm_splat(k->inverse_cell[axis]);
    return line;
}

/* ----------------------------------------------------------------- stencils */

/* Nodes a line, known when the kernel is compiled. */
MPM_INLINE int line_nodes(const struct fast_spec *spec)
{
    return spec->shape == MPM_CLASSIC ? 2 : spec->shape == MPM_BSPLINE3 ? 4 : 3;
}

MPM_INLINE struct fast_line fast_line_of(const struct fast_spec *spec,
                                         const struct fast_constants *k, int axis,
                                         mpm_vector position)
{
    const bool radial = spec->axisymmetric && axis == 0;
    const int nodes = line_nodes(spec);
    if (spec->shape == MPM_UGIMP)
        return fast_line_ugimp(k, axis, radial, position);
    struct fast_line line = spec->shape == MPM_CLASSIC    ? fast_line_classic(k, axis, position)
                            : spec->shape == MPM_BSPLINE2 ? fast_line_bspline2(k, axis, position)
                                                          : fast_line_bspline3(k, axis, position);
    if (spec->shape != MPM_CLASSIC)
        for (int i = 0; i < nodes; i++)
            line.d[i] *= k->inverse_cell[axis];
    if (radial)
        set_point_hoop(&line, nodes, position);
    return line;
}

MPM_INLINE void fast_lines_evaluate(const struct fast_spec *spec, const struct fast_constants *k,
                                    const mpm_vector position[2], struct fast_lines *lines)
{
    const struct fast_line x = fast_line_of(spec, k, 0, position[0]);
    const struct fast_line y = fast_line_of(spec, k, 1, position[1]);
    const mpm_mask node = mpm_to_integer(y.first * k->columns + x.first) + k->node_zero;
    memcpy(lines->node, &node, sizeof node);
    if (spec->scalars)
        lines->together = mpm_is_uniform(node);
    for (int i = 0; i < line_nodes(spec); i++) {
        lines->sx[i] = x.s[i];
        if (spec->scalars)
            lines->sy[i] = y.s[i];
        if (spec->conducts) {
            lines->dx[i] = x.d[i];
            lines->dy[i] = y.d[i];
        }
        if (spec->alone)
            continue;
        mpm_store_pairs(x.d[i], x.s[i], lines->x[i]);
        mpm_store_pairs(y.s[i], y.d[i], lines->y[i]);
        if (spec->axisymmetric)
            mpm_store(lines->t[i], x.t[i]);
    }
    if (spec->affine) {
        struct fast_moments *const moments = &lines->moments;
        const int nodes = line_nodes(spec);
        moments->second[0] = fast_line_moments(x.s, nodes, k->cell[0], moments->x);
        moments->second[1] = fast_line_moments(y.s, nodes, k->cell[1], moments->y);
    }
}

/* ------------------------------------------------------------------ scatter */

/* For one particle: sums += sx E_j + sy D_i with E_j = (sy, dy, sy, dy) (p_x, -xy, p_y, -yy)
 * and D_i = dx (0, -xx, 0, -xy) + t (0, -zz, 0, 0), stresses times mass; with APIC E_j has m_j
 * affine_y too, and D_i m_i affine_x. */
MPM_INLINE void spread_lane(const struct fast_spec *spec, const struct fast_constants *k,
                            const struct fast_lines *lines, int lane, mpm_vector along_y,
                            mpm_vector along_x, mpm_vector hoop, const struct fast_turn *turn)
{
    const int nodes = line_nodes(spec), pair = fast_pair[lane];
    mpm_vector d[MPM_LINE_NODES];
    for (int i = 0; i < nodes; i++) {
        d[i] = mpm_scale(lines->x[i][pair], along_x);
        if (spec->axisymmetric)
            d[i] += mpm_scale(lines->t[i][lane], hoop);
        if (spec->affine && spec->momentum)
            d[i] += mpm_scale(lines->moments.x[i][lane], turn->along_x[lane]);
    }
    for (int j = 0; j < nodes; j++) {
        double *const row = fast_row(k->sum, lines->node[lane], j, k);
        mpm_vector e = mpm_load_pair(&lines->y[j][pair]) * along_y;
        if (spec->affine && spec->momentum)
            e += mpm_scale(lines->moments.y[j][lane], turn->along_y[lane]);
        for (int i = 0; i < nodes; i++) {
            const mpm_vector add =
                mpm_scale(lines->x[i][pair + 1], e) + mpm_scale(lines->y[j][pair], d[i]);
            mpm_store(row + 4 * i, mpm_load(row + 4 * i) + add);
        }
    }
}

/* Masses of a row of nodes are neighbours: one vector. */
MPM_INLINE void spread_mass_lane(const struct fast_spec *spec, const struct fast_constants *k,
                                 const struct fast_lines *lines, int lane, mpm_vector along_x)
{
    for (int j = 0; j < line_nodes(spec); j++) {
        double *const row = k->mass + lines->node[lane] + j * k->stride;
        mpm_store(row, mpm_load(row) + lines->y[j][fast_pair[lane]] * along_x);
    }
}

MPM_INLINE void fast_lines_spread(const struct fast_spec *spec, const struct fast_constants *k,
                                  const struct fast_lines *lines, const struct fast_load *load)
{
    const mpm_vector zero = mpm_splat(0.0);
    const mpm_vector *const p = load->momentum, *const f = load->stress;
    mpm_vector along_y[4] = {p[0], f[MPM_SYM_XY], p[1], f[MPM_SYM_YY]};
    mpm_vector along_x[4] = {zero, f[MPM_SYM_XX], zero, f[MPM_SYM_XY]};
    mpm_vector hoop[4] = {zero, f[MPM_SYM_ZZ], zero, zero};
    mpm_vector mass[4] = {zero, zero, zero, zero};
    for (int i = 0; i < line_nodes(spec); i++)
        mass[i] = load->mass * lines->sx[i];
    struct fast_turn turn;
    if (spec->affine && spec->momentum)
        turn = fast_turn_of(load->affine, false);
    mpm_transpose(along_y);
    mpm_transpose(along_x);
    if (spec->axisymmetric)
        mpm_transpose(hoop);
    if (spec->momentum)
        mpm_transpose(mass);
#pragma GCC unroll 4
    for (int lane = 0; lane < MPM_VECTOR_SIZE; lane++) {
        spread_lane(spec, k, lines, lane, along_y[lane], along_x[lane], hoop[lane], &turn);
        if (spec->momentum)
            spread_mass_lane(spec, k, lines, lane, mass[lane]);
    }
}

/* Adds s times a particle's vector to those of the nodes; with `turn` (or NULL) that of APIC. */
MPM_INLINE void spread_value_lane(const struct fast_spec *spec, const struct fast_constants *k,
                                  const struct fast_lines *lines, int lane, void *array,
                                  mpm_vector value, const struct fast_turn *turn)
{
    const int nodes = line_nodes(spec), pair = fast_pair[lane];
    for (int j = 0; j < nodes; j++) {
        double *const row = fast_row(array, lines->node[lane], j, k);
        mpm_vector part = mpm_scale(lines->y[j][pair], value);
        if (turn != NULL)
            part += mpm_scale(lines->moments.y[j][lane], turn->along_y[lane]);
        for (int i = 0; i < nodes; i++) {
            mpm_vector add = mpm_scale(lines->x[i][pair + 1], part);
            if (turn != NULL)
                add +=
                    mpm_scale(lines->y[j][pair] * lines->moments.x[i][lane], turn->along_x[lane]);
            mpm_store(row + 4 * i, mpm_load(row + 4 * i) + add);
        }
    }
}

MPM_INLINE void fast_lines_spread_values(const struct fast_spec *spec,
                                         const struct fast_constants *k,
                                         const struct fast_lines *lines, void *array,
                                         const mpm_vector values[4], const struct fast_turn *turn)
{
    mpm_vector value[4] = {values[0], values[1], values[2], values[3]};
    mpm_transpose(value);
#pragma GCC unroll 4
    for (int lane = 0; lane < MPM_VECTOR_SIZE; lane++)
        spread_value_lane(spec, k, lines, lane, array, value[lane], turn);
}

/* ------------------------------------------------------------------- gather */

/* What a row of nodes, `along` = sum_i s_i of it, adds to the columns of B_p; of classic functions
 * slopes take the place of m_i. */
MPM_INLINE void add_to_columns(const struct fast_spec *spec, const struct fast_lines *lines,
                               int lane, int j, const double *row, mpm_vector along,
                               mpm_vector columns[2])
{
    const bool slopes = spec->shape == MPM_CLASSIC;
    const int pair = fast_pair[lane];
    mpm_vector part = mpm_splat(0.0);
    for (int i = 0; i < line_nodes(spec); i++)
        part += mpm_scale(slopes ? lines->x[i][pair] : lines->moments.x[i][lane],
                          mpm_load(row + 4 * i));
    part = mpm_scale(lines->y[j][pair], part);
    along = mpm_scale(slopes ? lines->y[j][pair + 1] : lines->moments.y[j][lane], along);
    columns[0] = j == 0 ? part : columns[0] + part;
    columns[1] = j == 0 ? along : columns[1] + along;
}

/* sum S of an array's nodal vectors; *hoop: sum T of the same, if asked for; columns: of B_p, or
 * NULL */
MPM_INLINE mpm_vector value_lane(const struct fast_spec *spec, const struct fast_constants *k,
                                 const struct fast_lines *lines, int lane, const void *array,
                                 bool wants_hoop, mpm_vector *hoop, mpm_vector columns[2])
{
    const int nodes = line_nodes(spec), pair = fast_pair[lane];
    mpm_vector sum = mpm_splat(0.0), hoop_sum = mpm_splat(0.0);
    for (int j = 0; j < nodes; j++) {
        const double *const row = fast_row(array, lines->node[lane], j, k);
        mpm_vector part = mpm_scale(lines->x[0][pair + 1], mpm_load(row));
        for (int i = 1; i < nodes; i++)
            part += mpm_scale(lines->x[i][pair + 1], mpm_load(row + 4 * i));
        if (columns != NULL)
            add_to_columns(spec, lines, lane, j, row, part, columns);
        part = mpm_scale(lines->y[j][pair], part);
        sum = j == 0 ? part : sum + part;
        if (wants_hoop) {
            mpm_vector hoop_part = mpm_scale(lines->t[0][lane], mpm_load(row));
            for (int i = 1; i < nodes; i++)
                hoop_part += mpm_scale(lines->t[i][lane], mpm_load(row + 4 * i));
            hoop_part = mpm_scale(lines->y[j][pair], hoop_part);
            hoop_sum = j == 0 ? hoop_part : hoop_sum + hoop_part;
        }
    }
    *hoop = hoop_sum;
    return sum;
}

/* grad v: (xx, xy, yx, yy); *hoop: sum T v_x */
MPM_INLINE mpm_vector gradient_lane(const struct fast_spec *spec, const struct fast_constants *k,
                                    const struct fast_lines *lines, int lane, double *hoop)
{
    const int nodes = line_nodes(spec), pair = fast_pair[lane];
    mpm_vector sum = mpm_splat(0.0);
    double hoop_sum = 0.0;
    for (int j = 0; j < nodes; j++) {
        const double *const row = fast_row(k->gradient, lines->node[lane], j, k);
        mpm_vector part = mpm_load_pair(&lines->x[0][pair]) * mpm_load(row);
        for (int i = 1; i < nodes; i++)
            part += mpm_load_pair(&lines->x[i][pair]) * mpm_load(row + 4 * i);
        part *= mpm_load_pair(&lines->y[j][pair]);
        sum = j == 0 ? part : sum + part;
        if (spec->axisymmetric) {
            double hoop_part = lines->t[0][lane] * row[0];
            for (int i = 1; i < nodes; i++)
                hoop_part += lines->t[i][lane] * row[4 * i];
            hoop_sum += lines->y[j][pair] * hoop_part;
        }
    }
    *hoop = hoop_sum;
    return sum;
}

MPM_INLINE void fast_lines_gather(const struct fast_spec *spec, const struct fast_constants *k,
                                  const struct fast_lines *lines, const void *array,
                                  bool wants_hoop, mpm_vector value[4], mpm_vector hoop[4],
                                  mpm_vector (*columns)[4])
{
#pragma GCC unroll 4
    for (int lane = 0; lane < MPM_VECTOR_SIZE; lane++) {
        mpm_vector column[2] = {mpm_splat(0.0), mpm_splat(0.0)};
        value[lane] = value_lane(spec, k, lines, lane, array, wants_hoop, &hoop[lane],
                                 columns == NULL ? NULL : column);
        for (int axis = 0; columns != NULL && axis < 2; axis++)
            columns[axis][lane] = column[axis];
    }
    mpm_transpose(value);
    if (wants_hoop)
        mpm_transpose(hoop);
    for (int axis = 0; columns != NULL && axis < 2; axis++)
        mpm_transpose(columns[axis]);
}

MPM_INLINE void fast_lines_gradient(const struct fast_spec *spec, const struct fast_constants *k,
                                    const struct fast_lines *lines,
                                    mpm_vector gradient[MPM_GRADIENT_SIZE])
{
    double hoop[MPM_VECTOR_SIZE];
#pragma GCC unroll 4
    for (int lane = 0; lane < MPM_VECTOR_SIZE; lane++)
        gradient[lane] = gradient_lane(spec, k, lines, lane, &hoop[lane]);
    mpm_transpose(gradient);
    gradient[MPM_ZZ] = (mpm_vector){hoop[0], hoop[1], hoop[2], hoop[3]};
}

#endif
