/* Fast kernels: CPDI stencils of four particles at once. As long as the four corners of each
 * parallelogram keep within two cells along both axes, their weights are summed up first, for
 * a block of three by three nodes, so that a node is visited once for a particle and not once
 * for a corner: nodes that corners share would wait for each other. Domains that have grown
 * further take fast_corners.h. Which of both is a matter of the four particles alone, hence
 * the same with every level of SIMD and any number of threads.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_FAST_CPDI_H
#define MPM_METHOD_FAST_CPDI_H

#include "method/fast/fast_corners.h"

enum { MPM_BLOCK_EDGE = 3, MPM_BLOCK_NODES = MPM_BLOCK_EDGE * MPM_BLOCK_EDGE };

/* Weights of a block's nodes, row by row; only what the pass asks for. */
struct fast_nodes {
    int64_t first[MPM_VECTOR_SIZE]; /* node at lower left */
    bool together;                  /* of all four; where scalars are exchanged */
    double s[MPM_BLOCK_NODES][MPM_VECTOR_SIZE];
    double t[MPM_BLOCK_NODES][MPM_VECTOR_SIZE];
    mpm_vector g[MPM_BLOCK_NODES][2]; /* to spread forces with, */
    double pairs[MPM_BLOCK_NODES][8]; /* and to take gradients with: see fast_pair */
};

struct fast_cpdi {
    bool near; /* which of both */
    union {
        struct fast_nodes nodes;
        struct fast_corners corners;
    };
};

/* The last pass only reads: corners do that as fast, one after the other. */
MPM_INLINE bool takes_corners(const struct fast_spec *spec)
{
    return spec->finish;
}

/* Far domains are rare: not every kernel gets a copy of what they need. */
MPM_SEPARATE void far_evaluate(const struct fast_spec *spec, const struct fast_constants *k,
                               const mpm_vector position[2], const mpm_vector edge[4],
                               struct fast_corners *corners)
{
    fast_corners_evaluate(spec, k, position, edge, corners);
}

MPM_SEPARATE void far_spread(const struct fast_spec *spec, const struct fast_constants *k,
                             const struct fast_corners *corners, const struct fast_load *load)
{
    fast_corners_spread(spec, k, corners, load);
}

MPM_SEPARATE void far_spread_values(const struct fast_constants *k,
                                    const struct fast_corners *corners, void *array,
                                    const mpm_vector values[4])
{
    fast_corners_spread_values(k, corners, array, values);
}

MPM_SEPARATE void far_gather(const struct fast_constants *k, const struct fast_corners *corners,
                             const void *array, bool wants_hoop, mpm_vector value[4],
                             mpm_vector hoop[4])
{
    fast_corners_gather(k, corners, array, wants_hoop, value, hoop);
}

MPM_SEPARATE void far_gradient(const struct fast_spec *spec, const struct fast_constants *k,
                               const struct fast_corners *corners,
                               mpm_vector gradient[MPM_GRADIENT_SIZE])
{
    fast_corners_gradient(spec, k, corners, gradient);
}

/* ------------------------------------------------------------------ weights
 *
 * A weight is a sum over the corners, with the hat functions P_c there. That of the corner
 * (a, b) is linear in a, b and a b, see shape_cpdi.c. So four sums over P_c are all that
 * nodes differ in: sum P, sum a b P, P_0 - P_2 and P_1 - P_3, of which sum a P is the second
 * less the first, and -sum b P both together. */
struct corner_sums {
    mpm_vector all, crossed, even, odd;
};

/* What multiplies them in S and G. */
struct corner_factors {
    mpm_vector s_even, s_odd;
    mpm_vector g_even[2], g_odd[2], g_crossed[2];
    mpm_vector t;
};

MPM_INLINE struct corner_factors corner_factors(const struct fast_spec *spec, const mpm_vector d[4],
                                                mpm_vector inverse_r)
{
    const mpm_vector inverse_area = 1.0 / (4.0 * (d[0] * d[3] - d[2] * d[1]));
    struct corner_factors factors = {
        .g_even = {(d[1] - d[3]) * inverse_area, (d[2] - d[0]) * inverse_area},
        .g_odd = {(d[1] + d[3]) * inverse_area, -(d[0] + d[2]) * inverse_area},
    };
    if (spec->axisymmetric) {
        const mpm_vector third_over_r = inverse_r * (1.0 / 3.0), quarter = 0.25 * third_over_r;
        const mpm_vector crossed = third_over_r * inverse_area;
        factors.s_even = -quarter * (d[0] + d[2]);
        factors.s_odd = quarter * (d[0] - d[2]);
        factors.g_crossed[0] = (d[2] * d[3] - d[0] * d[1]) * crossed;
        factors.g_crossed[1] = (d[0] * d[0] - d[2] * d[2]) * crossed;
        factors.t = 0.25 * inverse_r;
    }
    return factors;
}

/* Of the other passes: one takes gradients and spreads forces, */
MPM_INLINE bool wants_gradient_weights(const struct fast_spec *spec)
{
    return spec->force && !spec->momentum && !spec->alone;
}

/* the others spread momentum. */
MPM_INLINE bool wants_value_weights(const struct fast_spec *spec)
{
    return spec->momentum || !spec->force || spec->scalars;
}

MPM_INLINE void set_node(const struct fast_spec *spec, const struct corner_factors *factors,
                         const struct corner_sums *sums, int n, struct fast_nodes *nodes)
{
    if (wants_value_weights(spec)) {
        mpm_vector s = 0.25 * sums->all;
        if (spec->axisymmetric)
            s += factors->s_even * sums->even + factors->s_odd * sums->odd;
        mpm_store(nodes->s[n], s);
    }
    if (spec->axisymmetric && !spec->alone)
        mpm_store(nodes->t[n], factors->t * sums->all);
    if (!spec->force && !spec->conducts)
        return;
    mpm_vector g[2];
    for (int axis = 0; axis < 2; axis++) {
        g[axis] = factors->g_even[axis] * sums->even + factors->g_odd[axis] * sums->odd;
        if (spec->axisymmetric)
            g[axis] += factors->g_crossed[axis] * sums->crossed;
        nodes->g[n][axis] = g[axis];
    }
    if (wants_gradient_weights(spec))
        mpm_store_pairs(g[0], g[1], nodes->pairs[n]);
}

/* Hat functions of a line's nodes at a place, counted in cells from the first one: up to 2. All
 * to the last digit: close to r = 0 little is divided by little. */
MPM_INLINE void hats_at(mpm_vector place, mpm_vector hats[MPM_BLOCK_EDGE])
{
    const mpm_vector from_middle = place - 1.0;
    hats[1] = mpm_smaller(place, 2.0 - place);
    hats[2] = mpm_larger(from_middle, mpm_splat(0.0));
    hats[0] = hats[2] - from_middle;
}

MPM_INLINE void set_nodes(const struct fast_spec *spec, const struct corner_factors *factors,
                          mpm_vector hats[2][MPM_CORNERS][MPM_BLOCK_EDGE], struct fast_nodes *nodes)
{
    for (int j = 0; j < MPM_BLOCK_EDGE; j++)
        for (int i = 0; i < MPM_BLOCK_EDGE; i++) {
            mpm_vector p[MPM_CORNERS];
            for (int c = 0; c < MPM_CORNERS; c++)
                p[c] = hats[0][c][i] * hats[1][c][j];
            const mpm_vector even = p[0] + p[2], odd = p[1] + p[3];
            const struct corner_sums sums = {even + odd, even - odd, p[0] - p[2], p[1] - p[3]};
            set_node(spec, factors, &sums, MPM_BLOCK_EDGE * j + i, nodes);
        }
}

/* Places of the corners along an axis, in cells from the first node; false: some are more than
 * two cells from it. */
MPM_INLINE bool corner_places(const struct fast_constants *k, int axis, mpm_vector position,
                              const mpm_vector d[4], mpm_vector place[MPM_CORNERS],
                              mpm_vector *first)
{
    mpm_vector low = mpm_splat(0.0), high = low;
    for (int c = 0; c < MPM_CORNERS; c++) {
        const mpm_vector x = position + fast_sign1[c] * d[axis] + fast_sign2[c] * d[2 + axis];
        place[c] = fast_snap((x - k->origin[axis]) * k->inverse_cell[axis]);
        low = c == 0 ? place[c] : mpm_smaller(place[c], low);
        high = c == 0 ? place[c] : mpm_larger(place[c], high);
    }
    *first = mpm_down_to_integer(low, mpm_nearest(low));
    for (int c = 0; c < MPM_CORNERS; c++)
        place[c] -= *first;
    return !mpm_any(~mpm_at_most(high - *first, mpm_splat(2.0)));
}

MPM_INLINE void fast_cpdi_evaluate(const struct fast_spec *spec, const struct fast_constants *k,
                                   const mpm_vector position[2], const mpm_vector edge[4],
                                   struct fast_cpdi *cpdi)
{
    mpm_vector d[4] = {edge[0], edge[1], edge[2], edge[3]}, inverse_r = mpm_splat(0.0);
    mpm_vector first[2], hats[2][MPM_CORNERS][MPM_BLOCK_EDGE];
    if (takes_corners(spec)) {
        fast_corners_evaluate(spec, k, position, edge, &cpdi->corners);
        return;
    }
    if (spec->axisymmetric) {
        inverse_r = 1.0 / position[0];
        if (k->truncated)
            shrink_to_axis_vector(position[0], d);
    }
    cpdi->near = true;
    for (int axis = 0; axis < 2; axis++) {
        mpm_vector place[MPM_CORNERS];
        if (!corner_places(k, axis, position[axis], d, place, &first[axis]))
            cpdi->near = false;
        for (int c = 0; c < MPM_CORNERS; c++)
            hats_at(place[c], hats[axis][c]);
    }
    if (!cpdi->near) {
        far_evaluate(spec, k, position, edge, &cpdi->corners);
        return;
    }
    const mpm_mask node = mpm_to_integer(first[1] * k->columns + first[0]) + k->node_zero;
    memcpy(cpdi->nodes.first, &node, sizeof node);
    if (spec->scalars)
        cpdi->nodes.together = mpm_is_uniform(node);
    const struct corner_factors factors = corner_factors(spec, d, inverse_r);
    set_nodes(spec, &factors, hats, &cpdi->nodes);
}

/* ------------------------------------------------------------------ scatter */

/* Four particles' (p_x, f_x, p_y, f_y) for node n. */
MPM_INLINE void node_loads(const struct fast_spec *spec, const struct fast_nodes *nodes, int n,
                           const struct fast_load *load, mpm_vector value[4])
{
    const mpm_vector *const p = load->momentum, *const f = load->stress, *const g = nodes->g[n];
    value[0] = value[2] = mpm_splat(0.0);
    if (spec->momentum) {
        value[0] = mpm_load(nodes->s[n]) * p[0];
        value[2] = mpm_load(nodes->s[n]) * p[1];
    }
    value[1] = f[MPM_SYM_XX] * g[0] + f[MPM_SYM_XY] * g[1];
    value[3] = f[MPM_SYM_XY] * g[0] + f[MPM_SYM_YY] * g[1];
    if (spec->axisymmetric)
        value[1] += f[MPM_SYM_ZZ] * mpm_load(nodes->t[n]);
    mpm_transpose(value);
}

/* Masses of a row of nodes are neighbours: one vector. */
MPM_INLINE void row_masses(const struct fast_nodes *nodes, int j, mpm_vector mass,
                           mpm_vector value[4])
{
    for (int i = 0; i < MPM_BLOCK_EDGE; i++)
        value[i] = mass * mpm_load(nodes->s[MPM_BLOCK_EDGE * j + i]);
    value[3] = mpm_splat(0.0);
    mpm_transpose(value);
}

/* All vectors first, then particle by particle: the next one mostly adds to the same nodes, which
 * takes as long as its vectors have to be waited for. */
MPM_INLINE void fast_cpdi_spread(const struct fast_spec *spec, const struct fast_constants *k,
                                 const struct fast_cpdi *cpdi, const struct fast_load *load)
{
    const struct fast_nodes *const nodes = &cpdi->nodes;
    const int64_t stride = k->stride;
    double *const sums = (double *)k->sum, *const masses = k->mass;
    mpm_vector value[MPM_BLOCK_NODES][4], mass[MPM_BLOCK_EDGE][4];
    if (!cpdi->near) {
        far_spread(spec, k, &cpdi->corners, load);
        return;
    }
#pragma GCC unroll 9
    for (int n = 0; n < MPM_BLOCK_NODES; n++)
        node_loads(spec, nodes, n, load, value[n]);
    if (spec->momentum) {
#pragma GCC unroll 3
        for (int j = 0; j < MPM_BLOCK_EDGE; j++)
            row_masses(nodes, j, load->mass, mass[j]);
    }
    mpm_keep_in_memory(value);
#pragma GCC unroll 4
    for (int lane = 0; lane < MPM_VECTOR_SIZE; lane++) {
        double *sum = sums + 4 * nodes->first[lane], *row = masses + nodes->first[lane];
#pragma GCC unroll 3
        for (int j = 0; j < MPM_BLOCK_EDGE; j++, sum += 4 * stride, row += stride) {
            for (int i = 0; i < MPM_BLOCK_EDGE; i++)
                mpm_store(sum + 4 * i, mpm_load(sum + 4 * i) + value[MPM_BLOCK_EDGE * j + i][lane]);
            if (spec->momentum)
                mpm_store(row, mpm_load(row) + mass[j][lane]);
        }
    }
}

MPM_INLINE void fast_cpdi_spread_values(const struct fast_constants *k,
                                        const struct fast_cpdi *cpdi, void *array,
                                        const mpm_vector values[4])
{
    const struct fast_nodes *const nodes = &cpdi->nodes;
    const int64_t distance = 4 * k->stride;
    mpm_vector value[4] = {values[0], values[1], values[2], values[3]};
    if (!cpdi->near) {
        far_spread_values(k, &cpdi->corners, array, values);
        return;
    }
    mpm_transpose(value);
#pragma GCC unroll 4
    for (int lane = 0; lane < MPM_VECTOR_SIZE; lane++) {
        double *node = (double *)array + 4 * nodes->first[lane];
#pragma GCC unroll 3
        for (int j = 0; j < MPM_BLOCK_EDGE; j++, node += distance)
            for (int i = 0; i < MPM_BLOCK_EDGE; i++) {
                const double s = nodes->s[MPM_BLOCK_EDGE * j + i][lane];
                mpm_store(node + 4 * i, mpm_load(node + 4 * i) + mpm_scale(s, value[lane]));
            }
    }
}

/* ------------------------------------------------------------------- gather */

/* sum w of an array's nodal vectors, with the weights S or T of four particles */
MPM_INLINE void gather_nodes(const struct fast_constants *k, const struct fast_nodes *nodes,
                             const double weights[MPM_BLOCK_NODES][MPM_VECTOR_SIZE],
                             const double *array, mpm_vector sum[4])
{
    const int64_t distance = 4 * k->stride;
#pragma GCC unroll 4
    for (int lane = 0; lane < MPM_VECTOR_SIZE; lane++) {
        const double *node = array + 4 * nodes->first[lane];
#pragma GCC unroll 3
        for (int j = 0; j < MPM_BLOCK_EDGE; j++, node += distance)
            for (int i = 0; i < MPM_BLOCK_EDGE; i++) {
                const int n = MPM_BLOCK_EDGE * j + i;
                const mpm_vector part = mpm_scale(weights[n][lane], mpm_load(node + 4 * i));
                sum[lane] = n == 0 ? part : sum[lane] + part;
            }
    }
    mpm_transpose(sum);
}

MPM_INLINE void fast_cpdi_gather(const struct fast_spec *spec, const struct fast_constants *k,
                                 const struct fast_cpdi *cpdi, const void *array, bool wants_hoop,
                                 mpm_vector value[4], mpm_vector hoop[4])
{
    if (takes_corners(spec)) {
        fast_corners_gather(k, &cpdi->corners, array, wants_hoop, value, hoop);
        return;
    }
    if (!cpdi->near) {
        far_gather(k, &cpdi->corners, array, wants_hoop, value, hoop);
        return;
    }
    gather_nodes(k, &cpdi->nodes, cpdi->nodes.s, array, value);
    if (wants_hoop)
        gather_nodes(k, &cpdi->nodes, cpdi->nodes.t, array, hoop);
}

/* grad v of one particle: (xx, xy, yx, yy); *hoop: sum T v_x */
MPM_INLINE mpm_vector gradient_of_nodes(const struct fast_spec *spec,
                                        const struct fast_nodes *nodes, int lane, const double *row,
                                        int64_t distance, double *hoop)
{
    mpm_vector sum = mpm_splat(0.0);
    *hoop = 0.0;
#pragma GCC unroll 3
    for (int j = 0; j < MPM_BLOCK_EDGE; j++, row += distance)
        for (int i = 0; i < MPM_BLOCK_EDGE; i++) {
            const int n = MPM_BLOCK_EDGE * j + i;
            const mpm_vector part =
                mpm_load_pair(&nodes->pairs[n][fast_pair[lane]]) * mpm_load(row + 4 * i);
            sum = n == 0 ? part : sum + part;
            if (spec->axisymmetric)
                *hoop += nodes->t[n][lane] * row[4 * i];
        }
    return sum;
}

MPM_INLINE void fast_cpdi_gradient(const struct fast_spec *spec, const struct fast_constants *k,
                                   const struct fast_cpdi *cpdi,
                                   mpm_vector gradient[MPM_GRADIENT_SIZE])
{
    const int64_t distance = 4 * k->stride;
    double hoop[MPM_VECTOR_SIZE];
    if (takes_corners(spec)) {
        fast_corners_gradient(spec, k, &cpdi->corners, gradient);
        return;
    }
    if (!cpdi->near) {
        far_gradient(spec, k, &cpdi->corners, gradient);
        return;
    }
    double *const array = (double *)k->gradient;
#pragma GCC unroll 4
    for (int lane = 0; lane < MPM_VECTOR_SIZE; lane++)
        gradient[lane] = gradient_of_nodes(
            spec, &cpdi->nodes, lane, array + 4 * cpdi->nodes.first[lane], distance, &hoop[lane]);
    mpm_transpose(gradient);
    gradient[MPM_ZZ] = (mpm_vector){hoop[0], hoop[1], hoop[2], hoop[3]};
}

#endif
