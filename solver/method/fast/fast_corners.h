/* Fast kernels: CPDI stencils corner by corner, see fast_cpdi.h for when: sums over the four
 * corners of a parallelogram of the hat functions there, for four particles at once. A corner
 * spreads to the four nodes of its cell by itself, however far the corners are apart. Weights
 * as in shape_cpdi.c, nodal vectors as in fast_lines.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_FAST_CORNERS_H
#define MPM_METHOD_FAST_CORNERS_H

#include "method/fast/fast_lines.h"

enum { MPM_CORNERS = 4 };

struct fast_corners {
    int64_t node[MPM_CORNERS][MPM_VECTOR_SIZE]; /* lower left of the corner's cell */
    double x[MPM_CORNERS][8];                   /* pairs of hat functions there, see fast_pair */
    double y[MPM_CORNERS][8];
    mpm_vector s[MPM_CORNERS];    /* S of the corner; planar: 1/4 */
    mpm_vector g[MPM_CORNERS][2]; /* G of the corner */
    mpm_vector t;                 /* T of every corner */
};

/* Corners go counter clockwise: (-,-) (+,-) (+,+) (-,+). */
static const double fast_sign1[MPM_CORNERS] = {-1.0, 1.0, 1.0, -1.0};
static const double fast_sign2[MPM_CORNERS] = {-1.0, -1.0, 1.0, 1.0};

/* Half edges that would pass r = 0 shrink until the domain touches it. */
MPM_INLINE void shrink_to_axis_vector(mpm_vector r, mpm_vector d[4])
{
    const mpm_vector extent = mpm_absolute(d[0]) + mpm_absolute(d[2]);
    const mpm_vector scale = mpm_select(mpm_at_most(extent, r), mpm_splat(1.0), r / extent);
    for (int k = 0; k < 4; k++)
        d[k] *= scale;
}

MPM_INLINE void corner_weights_vector(const struct fast_spec *spec, const mpm_vector d[4],
                                      mpm_vector inverse_r, struct fast_corners *corners)
{
    const mpm_vector inverse_area = 1.0 / (4.0 * (d[0] * d[3] - d[2] * d[1]));
    const mpm_vector third_over_r = inverse_r * (1.0 / 3.0);
    const mpm_vector beta = (d[0] * d[1] - d[2] * d[3]) * third_over_r;
#pragma GCC unroll 4
    for (int c = 0; c < MPM_CORNERS; c++) {
        const double a = fast_sign1[c], b = fast_sign2[c];
        corners->g[c][0] = a * d[3] - b * d[1];
        corners->g[c][1] = b * d[0] - a * d[2];
        corners->s[c] = mpm_splat(0.25);
        if (spec->axisymmetric) {
            const mpm_vector radial = 1.0 + (a * d[0] + b * d[2]) * third_over_r;
            corners->s[c] *= radial;
            corners->g[c][0] -= a * b * beta;
            corners->g[c][1] *= radial;
        }
        corners->g[c][0] *= inverse_area;
        corners->g[c][1] *= inverse_area;
    }
    corners->t = 0.25 * inverse_r;
}

MPM_INLINE void fast_corners_evaluate(const struct fast_spec *spec, const struct fast_constants *k,
                                      const mpm_vector position[2], const mpm_vector edge[4],
                                      struct fast_corners *corners)
{
    mpm_vector d[4] = {edge[0], edge[1], edge[2], edge[3]};
    mpm_vector inverse_r = mpm_splat(0.0);
    if (spec->axisymmetric) {
        inverse_r = 1.0 / position[0];
        if (k->truncated)
            shrink_to_axis_vector(position[0], d);
    }
    corner_weights_vector(spec, d, inverse_r, corners);
#pragma GCC unroll 4
    for (int c = 0; c < MPM_CORNERS; c++) {
        mpm_vector first[2], place[2];
        for (int axis = 0; axis < 2; axis++) {
            const mpm_vector x =
                position[axis] + fast_sign1[c] * d[axis] + fast_sign2[c] * d[2 + axis];
            place[axis] = fast_cells((x - k->origin[axis]) * k->inverse_cell[axis], &first[axis]);
            place[axis] -= first[axis];
        }
        const mpm_mask node = mpm_to_integer(first[1] * k->columns + first[0]) + k->node_zero;
        memcpy(corners->node[c], &node, sizeof node);
        mpm_store_pairs(1.0 - place[0], place[0], corners->x[c]);
        mpm_store_pairs(1.0 - place[1], place[1], corners->y[c]);
    }
}

/* ------------------------------------------------------------------ scatter */

/* Adds a corner's vector to the four nodes of its cell; x and y are pairs of weights. */
MPM_INLINE void spread_corner(double *row, int64_t stride, const double x[2], const double y[2],
                              mpm_vector value)
{
    for (int j = 0; j < 2; j++) {
        double *const node = row + 4 * j * stride;
        const mpm_vector part = mpm_scale(y[j], value);
        mpm_store(node, mpm_load(node) + mpm_scale(x[0], part));
        mpm_store(node + 4, mpm_load(node + 4) + mpm_scale(x[1], part));
    }
}

/* Masses of two neighbours: half a vector. */
MPM_INLINE void spread_corner_mass(double *row, int64_t stride, const double x[2],
                                   const double y[2], double mass)
{
    mpm_half_vector weights;
    memcpy(&weights, x, sizeof weights);
    weights = mass * weights;
    for (int j = 0; j < 2; j++) {
        mpm_half_vector sum;
        memcpy(&sum, row + j * stride, sizeof sum);
        sum += y[j] * weights;
        memcpy(row + j * stride, &sum, sizeof sum);
    }
}

MPM_INLINE void fast_corners_spread(const struct fast_spec *spec, const struct fast_constants *k,
                                    const struct fast_corners *corners,
                                    const struct fast_load *load)
{
    const mpm_vector *const p = load->momentum, *const f = load->stress;
#pragma GCC unroll 4
    for (int c = 0; c < MPM_CORNERS; c++) {
        const mpm_vector *const g = corners->g[c];
        mpm_vector value[4] = {{0}};
        double mass[MPM_VECTOR_SIZE];
        if (spec->momentum) {
            value[0] = p[0] * corners->s[c];
            value[2] = p[1] * corners->s[c];
            mpm_store(mass, load->mass * corners->s[c]);
        }
        value[1] = f[MPM_SYM_XX] * g[0] + f[MPM_SYM_XY] * g[1];
        value[3] = f[MPM_SYM_XY] * g[0] + f[MPM_SYM_YY] * g[1];
        if (spec->axisymmetric)
            value[1] += f[MPM_SYM_ZZ] * corners->t;
        mpm_transpose(value);
#pragma GCC unroll 4
        for (int lane = 0; lane < MPM_VECTOR_SIZE; lane++) {
            const int64_t node = corners->node[c][lane];
            const double *const x = &corners->x[c][fast_pair[lane]];
            const double *const y = &corners->y[c][fast_pair[lane]];
            spread_corner(fast_row(k->sum, node, 0, k), k->stride, x, y, value[lane]);
            if (spec->momentum)
                spread_corner_mass(k->mass + node, k->stride, x, y, mass[lane]);
        }
    }
}

MPM_INLINE void fast_corners_spread_values(const struct fast_constants *k,
                                           const struct fast_corners *corners, void *array,
                                           const mpm_vector values[4])
{
#pragma GCC unroll 4
    for (int c = 0; c < MPM_CORNERS; c++) {
        mpm_vector value[4];
        for (int i = 0; i < 4; i++)
            value[i] = values[i] * corners->s[c];
        mpm_transpose(value);
#pragma GCC unroll 4
        for (int lane = 0; lane < MPM_VECTOR_SIZE; lane++)
            spread_corner(fast_row(array, corners->node[c][lane], 0, k), k->stride,
                          &corners->x[c][fast_pair[lane]], &corners->y[c][fast_pair[lane]],
                          value[lane]);
    }
}

/* ------------------------------------------------------------------- gather */

MPM_INLINE mpm_vector gather_corner(const double *row, int64_t stride, const double x[2],
                                    const double y[2])
{
    const double *const upper = row + 4 * stride;
    const mpm_vector low = mpm_scale(x[0], mpm_load(row)) + mpm_scale(x[1], mpm_load(row + 4));
    const mpm_vector high = mpm_scale(x[0], mpm_load(upper)) + mpm_scale(x[1], mpm_load(upper + 4));
    return mpm_scale(y[0], low) + mpm_scale(y[1], high);
}

MPM_INLINE void gather_corners(const struct fast_constants *k, const struct fast_corners *corners,
                               int c, const double *array, mpm_vector value[4])
{
#pragma GCC unroll 4
    for (int lane = 0; lane < MPM_VECTOR_SIZE; lane++)
        value[lane] =
            gather_corner(array + 4 * corners->node[c][lane], k->stride,
                          &corners->x[c][fast_pair[lane]], &corners->y[c][fast_pair[lane]]);
    mpm_transpose(value);
}

MPM_INLINE void fast_corners_gather(const struct fast_constants *k,
                                    const struct fast_corners *corners, const void *array,
                                    bool wants_hoop, mpm_vector sum[4], mpm_vector hoop[4])
{
    for (int i = 0; i < 4; i++)
        sum[i] = hoop[i] = mpm_splat(0.0);
#pragma GCC unroll 4
    for (int c = 0; c < MPM_CORNERS; c++) {
        mpm_vector value[4];
        gather_corners(k, corners, c, array, value);
        for (int i = 0; i < 4; i++) {
            sum[i] += corners->s[c] * value[i];
            if (wants_hoop)
                hoop[i] += corners->t * value[i];
        }
    }
}

MPM_INLINE void fast_corners_gradient(const struct fast_spec *spec, const struct fast_constants *k,
                                      const struct fast_corners *corners,
                                      mpm_vector gradient[MPM_GRADIENT_SIZE])
{
    for (int i = 0; i < MPM_GRADIENT_SIZE; i++)
        gradient[i] = mpm_splat(0.0);
#pragma GCC unroll 4
    for (int c = 0; c < MPM_CORNERS; c++) {
        mpm_vector v[4];
        gather_corners(k, corners, c, (const double *)k->gradient, v);
        gradient[MPM_XX] += v[0] * corners->g[c][0];
        gradient[MPM_XY] += v[0] * corners->g[c][1];
        gradient[MPM_YX] += v[2] * corners->g[c][0];
        gradient[MPM_YY] += v[2] * corners->g[c][1];
        if (spec->axisymmetric)
            gradient[MPM_ZZ] += v[0] * corners->t;
    }
}

#endif
