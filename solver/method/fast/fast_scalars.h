/* Fast kernels: scalars that are conducted, in nodal arrays of single numbers. Compare
 * transport_passes.c, which does the same one particle at a time.
 *
 * Weights stay in vectors of four particles. What the nodes of a row have comes from memory as one
 * row for each particle, and is turned into a vector for each node; sums go back in the same way.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_FAST_SCALARS_H
#define MPM_METHOD_FAST_SCALARS_H

#include "method/fast/fast_block.h"
#include "method/fast/fast_patches.h"

/* What four particles give to nodes: with S and with G. */
struct fast_gift {
    mpm_vector value, flow[2];
};

/* ------------------------------------------------------------- product stencils */

/* Where the nodes of four particles begin. Mostly, as particles are sorted, they are the same: then
 * they are read once, and what the four give is summed up before it is added. */
struct fast_place_of_four {
    double *place[MPM_VECTOR_SIZE];
    bool together;
};

MPM_INLINE struct fast_place_of_four
place_of_four(double *array, const int64_t first[MPM_VECTOR_SIZE], bool together)
{
    return (struct fast_place_of_four){
        {array + first[0], array + first[1], array + first[2], array + first[3]}, together};
}

MPM_INLINE void load_row(const struct fast_place_of_four *from, int64_t offset, int nodes,
                         mpm_vector value[4])
{
    if (!from->together) {
        mpm_load_columns(from->place, offset, nodes, value);
        return;
    }
#pragma GCC unroll 4
    for (int i = 0; i < nodes; i++)
        value[i] = mpm_splat(from->place[0][offset + i]);
}

MPM_INLINE void add_to_row(const struct fast_place_of_four *to, int64_t offset, int nodes,
                           const mpm_vector value[4])
{
    if (to->together)
        mpm_add_sums(to->place[0] + offset, nodes, value);
    else
        mpm_add_columns(to->place, offset, nodes, value);
}

/* sum_j w_j v_ij for each i */
MPM_INLINE void sum_rows(const struct fast_place_of_four *from, int nodes, int64_t stride,
                         const mpm_vector *const weights[2], int sets,
                         mpm_vector sum[2][MPM_LINE_NODES])
{
#pragma GCC unroll 4
    for (int j = 0; j < nodes; j++) {
        mpm_vector value[4];
        load_row(from, j * stride, nodes, value);
#pragma GCC unroll 4
        for (int set = 0; set < sets; set++)
#pragma GCC unroll 4
            for (int i = 0; i < nodes; i++) {
                const mpm_vector part = weights[set][j] * value[i];
                sum[set][i] = j == 0 ? part : sum[set][i] + part;
            }
    }
}

MPM_INLINE mpm_vector dot(const mpm_vector *a, const mpm_vector *b, int count)
{
    mpm_vector sum = a[0] * b[0];
#pragma GCC unroll 4
    for (int i = 1; i < count; i++)
        sum += a[i] * b[i];
    return sum;
}

MPM_INLINE mpm_vector lines_number(const struct fast_lines *lines, int nodes, int64_t stride,
                                   const struct fast_place_of_four *from)
{
    const mpm_vector *const weights[2] = {lines->sy, NULL};
    mpm_vector sum[2][MPM_LINE_NODES];
    sum_rows(from, nodes, stride, weights, 1, sum);
    return dot(lines->sx, sum[0], nodes);
}

MPM_INLINE void lines_slope(const struct fast_lines *lines, int nodes, int64_t stride,
                            const struct fast_place_of_four *from, mpm_vector gradient[2])
{
    const mpm_vector *const weights[2] = {lines->sy, lines->dy};
    mpm_vector sum[2][MPM_LINE_NODES];
    sum_rows(from, nodes, stride, weights, 2, sum);
    gradient[0] = dot(lines->dx, sum[0], nodes);
    gradient[1] = dot(lines->sx, sum[1], nodes);
}

MPM_INLINE void lines_add_number(const struct fast_lines *lines, int nodes, int64_t stride,
                                 const struct fast_place_of_four *to, mpm_vector number)
{
    mpm_vector along[MPM_LINE_NODES];
#pragma GCC unroll 4
    for (int i = 0; i < nodes; i++)
        along[i] = lines->sx[i] * number;
#pragma GCC unroll 4
    for (int j = 0; j < nodes; j++) {
        mpm_vector add[4];
#pragma GCC unroll 4
        for (int i = 0; i < nodes; i++)
            add[i] = lines->sy[j] * along[i];
        add_to_row(to, j * stride, nodes, add);
    }
}

MPM_INLINE void lines_give(const struct fast_lines *lines, int nodes, int64_t stride,
                           const struct fast_place_of_four *to, const struct fast_gift *gift)
{
    mpm_vector across[MPM_LINE_NODES], along[MPM_LINE_NODES];
#pragma GCC unroll 4
    for (int i = 0; i < nodes; i++) {
        across[i] = lines->dx[i] * gift->flow[0] + lines->sx[i] * gift->value;
        along[i] = lines->sx[i] * gift->flow[1];
    }
#pragma GCC unroll 4
    for (int j = 0; j < nodes; j++) {
        mpm_vector add[4];
#pragma GCC unroll 4
        for (int i = 0; i < nodes; i++)
            add[i] = lines->sy[j] * across[i] + lines->dy[j] * along[i];
        add_to_row(to, j * stride, nodes, add);
    }
}

/* ------------------------------------------------------------------ CPDI, near */

MPM_INLINE mpm_vector near_number(const struct fast_nodes *nodes, int64_t stride,
                                  const struct fast_place_of_four *from)
{
    mpm_vector sum = mpm_splat(0.0);
#pragma GCC unroll 4
    for (int j = 0; j < MPM_BLOCK_EDGE; j++) {
        mpm_vector value[4];
        load_row(from, j * stride, MPM_BLOCK_EDGE, value);
#pragma GCC unroll 4
        for (int i = 0; i < MPM_BLOCK_EDGE; i++)
            sum += mpm_load(nodes->s[MPM_BLOCK_EDGE * j + i]) * value[i];
    }
    return sum;
}

MPM_INLINE void near_slope(const struct fast_nodes *nodes, int64_t stride,
                           const struct fast_place_of_four *from, mpm_vector gradient[2])
{
    gradient[0] = gradient[1] = mpm_splat(0.0);
#pragma GCC unroll 4
    for (int j = 0; j < MPM_BLOCK_EDGE; j++) {
        mpm_vector value[4];
        load_row(from, j * stride, MPM_BLOCK_EDGE, value);
#pragma GCC unroll 4
        for (int i = 0; i < MPM_BLOCK_EDGE; i++)
            for (int axis = 0; axis < 2; axis++)
                gradient[axis] += nodes->g[MPM_BLOCK_EDGE * j + i][axis] * value[i];
    }
}

MPM_INLINE void near_add_number(const struct fast_nodes *nodes, int64_t stride,
                                const struct fast_place_of_four *to, mpm_vector number)
{
#pragma GCC unroll 4
    for (int j = 0; j < MPM_BLOCK_EDGE; j++) {
        mpm_vector add[4];
#pragma GCC unroll 4
        for (int i = 0; i < MPM_BLOCK_EDGE; i++)
            add[i] = mpm_load(nodes->s[MPM_BLOCK_EDGE * j + i]) * number;
        add_to_row(to, j * stride, MPM_BLOCK_EDGE, add);
    }
}

MPM_INLINE void near_give(const struct fast_nodes *nodes, int64_t stride,
                          const struct fast_place_of_four *to, const struct fast_gift *gift)
{
#pragma GCC unroll 4
    for (int j = 0; j < MPM_BLOCK_EDGE; j++) {
        mpm_vector add[4];
#pragma GCC unroll 4
        for (int i = 0; i < MPM_BLOCK_EDGE; i++) {
            const int n = MPM_BLOCK_EDGE * j + i;
            add[i] = nodes->g[n][0] * gift->flow[0] + nodes->g[n][1] * gift->flow[1] +
                     mpm_load(nodes->s[n]) * gift->value;
        }
        add_to_row(to, j * stride, MPM_BLOCK_EDGE, add);
    }
}

/* ------------------------------------------------------------ CPDI, by corners */

/* The hat functions' sum at corner c of each particle. */
MPM_INLINE mpm_vector number_at_corner(const struct fast_constants *k,
                                       const struct fast_corners *corners, int c,
                                       const double *array)
{
    mpm_vector value = mpm_splat(0.0);
#pragma GCC unroll 4
    for (int lane = 0; lane < MPM_VECTOR_SIZE; lane++) {
        const double *const row = array + corners->node[c][lane], *const upper = row + k->stride;
        const double *const x = &corners->x[c][fast_pair[lane]];
        const double *const y = &corners->y[c][fast_pair[lane]];
        value[lane] =
            y[0] * (x[0] * row[0] + x[1] * row[1]) + y[1] * (x[0] * upper[0] + x[1] * upper[1]);
    }
    return value;
}

MPM_INLINE void add_at_corner(const struct fast_constants *k, const struct fast_corners *corners,
                              int c, double *array, mpm_vector number)
{
#pragma GCC unroll 4
    for (int lane = 0; lane < MPM_VECTOR_SIZE; lane++)
        spread_corner_mass(array + corners->node[c][lane], k->stride,
                           &corners->x[c][fast_pair[lane]], &corners->y[c][fast_pair[lane]],
                           number[lane]);
}

MPM_SEPARATE void corners_number(const struct fast_constants *k, const struct fast_corners *corners,
                                 const double *array, mpm_vector *number)
{
    *number = mpm_splat(0.0);
    for (int c = 0; c < MPM_CORNERS; c++)
        *number += corners->s[c] * number_at_corner(k, corners, c, array);
}

MPM_SEPARATE void corners_slope(const struct fast_constants *k, const struct fast_corners *corners,
                                const double *array, mpm_vector gradient[2])
{
    gradient[0] = gradient[1] = mpm_splat(0.0);
    for (int c = 0; c < MPM_CORNERS; c++) {
        const mpm_vector value = number_at_corner(k, corners, c, array);
        for (int axis = 0; axis < 2; axis++)
            gradient[axis] += corners->g[c][axis] * value;
    }
}

MPM_SEPARATE void corners_add_number(const struct fast_constants *k,
                                     const struct fast_corners *corners, double *array,
                                     const mpm_vector *number)
{
    for (int c = 0; c < MPM_CORNERS; c++)
        add_at_corner(k, corners, c, array, corners->s[c] * *number);
}

MPM_SEPARATE void corners_give(const struct fast_constants *k, const struct fast_corners *corners,
                               double *array, const struct fast_gift *gift)
{
    for (int c = 0; c < MPM_CORNERS; c++)
        add_at_corner(k, corners, c, array,
                      corners->g[c][0] * gift->flow[0] + corners->g[c][1] * gift->flow[1] +
                          corners->s[c] * gift->value);
}

/* ----------------------------------------------------------- either stencil */

/* Corner by corner, and not in a block of nodes */
MPM_INLINE bool by_corners(const struct fast_spec *spec, const union fast_stencil *stencil)
{
    return spec->shape == MPM_CPDI && (takes_corners(spec) || !stencil->cpdi.near);
}

/* Nodes of four particles that are not by corners; `together` is known when this is compiled. */
MPM_INLINE struct fast_place_of_four nodes_of_four(const struct fast_spec *spec,
                                                   const union fast_stencil *stencil, double *array,
                                                   bool together)
{
    return place_of_four(
        array, spec->shape == MPM_CPDI ? stencil->cpdi.nodes.first : stencil->lines.node, together);
}

MPM_INLINE bool are_together(const struct fast_spec *spec, const union fast_stencil *stencil)
{
    return spec->shape == MPM_CPDI ? stencil->cpdi.nodes.together : stencil->lines.together;
}

MPM_INLINE mpm_vector number_at(const struct fast_spec *spec, const struct fast_constants *k,
                                const union fast_stencil *stencil, double *array, bool together)
{
    const struct fast_place_of_four from = nodes_of_four(spec, stencil, array, together);
    return spec->shape == MPM_CPDI
               ? near_number(&stencil->cpdi.nodes, k->stride, &from)
               : lines_number(&stencil->lines, line_nodes(spec), k->stride, &from);
}

/* sum S of an array */
MPM_INLINE mpm_vector gather_number(const struct fast_spec *spec, const struct fast_constants *k,
                                    const union fast_stencil *stencil, double *array)
{
    mpm_vector number;
    if (by_corners(spec, stencil))
        corners_number(k, &stencil->cpdi.corners, array, &number);
    else if (are_together(spec, stencil))
        number = number_at(spec, k, stencil, array, true);
    else
        number = number_at(spec, k, stencil, array, false);
    return number;
}

MPM_INLINE void slope_at(const struct fast_spec *spec, const struct fast_constants *k,
                         const union fast_stencil *stencil, double *array, bool together,
                         mpm_vector gradient[2])
{
    const struct fast_place_of_four from = nodes_of_four(spec, stencil, array, together);
    if (spec->shape == MPM_CPDI)
        near_slope(&stencil->cpdi.nodes, k->stride, &from, gradient);
    else
        lines_slope(&stencil->lines, line_nodes(spec), k->stride, &from, gradient);
}

/* sum G of an array */
MPM_INLINE void gather_slope(const struct fast_spec *spec, const struct fast_constants *k,
                             const union fast_stencil *stencil, double *array,
                             mpm_vector gradient[2])
{
    if (by_corners(spec, stencil))
        corners_slope(k, &stencil->cpdi.corners, array, gradient);
    else if (are_together(spec, stencil))
        slope_at(spec, k, stencil, array, true, gradient);
    else
        slope_at(spec, k, stencil, array, false, gradient);
}

MPM_INLINE void add_number_at(const struct fast_spec *spec, const struct fast_constants *k,
                              const union fast_stencil *stencil, double *array, bool together,
                              mpm_vector number)
{
    const struct fast_place_of_four to = nodes_of_four(spec, stencil, array, together);
    if (spec->shape == MPM_CPDI)
        near_add_number(&stencil->cpdi.nodes, k->stride, &to, number);
    else
        lines_add_number(&stencil->lines, line_nodes(spec), k->stride, &to, number);
}

/* An array's numbers += S number */
MPM_INLINE void spread_number(const struct fast_spec *spec, const struct fast_constants *k,
                              const union fast_stencil *stencil, double *array, mpm_vector number)
{
    if (by_corners(spec, stencil))
        corners_add_number(k, &stencil->cpdi.corners, array, &number);
    else if (are_together(spec, stencil))
        add_number_at(spec, k, stencil, array, true, number);
    else
        add_number_at(spec, k, stencil, array, false, number);
}

MPM_INLINE void give_at(const struct fast_spec *spec, const struct fast_constants *k,
                        const union fast_stencil *stencil, double *array, bool together,
                        const struct fast_gift *gift)
{
    const struct fast_place_of_four to = nodes_of_four(spec, stencil, array, together);
    if (spec->shape == MPM_CPDI)
        near_give(&stencil->cpdi.nodes, k->stride, &to, gift);
    else
        lines_give(&stencil->lines, line_nodes(spec), k->stride, &to, gift);
}

/* An array's numbers += G . flow + S value */
MPM_INLINE void spread_gift(const struct fast_spec *spec, const struct fast_constants *k,
                            const union fast_stencil *stencil, double *array,
                            const struct fast_gift *gift)
{
    if (by_corners(spec, stencil))
        corners_give(k, &stencil->cpdi.corners, array, gift);
    else if (are_together(spec, stencil))
        give_at(spec, k, stencil, array, true, gift);
    else
        give_at(spec, k, stencil, array, false, gift);
}

/* ------------------------------------------------- what a block of particles does */

MPM_INLINE double *numbers_of(const struct fast_block *block)
{
    return mpm_particle_array(block->particles, block->k->scalar.field, 0);
}

MPM_INLINE mpm_vector capacity_vector(const struct fast_block *block, size_t p)
{
    return mpm_load(block->particles->mass + p) * block->k->scalar.weight;
}

/* Content; capacity, where it does not follow from masses (mpm_transport_prepare) */
MPM_INLINE void spread_scalar(const struct fast_spec *spec, const struct fast_block *block,
                              const union fast_stencil stencil[MPM_BLOCK_VECTORS])
{
    const struct fast_scalar *const scalar = &block->k->scalar;
    const double *const numbers = numbers_of(block);
    FOR_VECTORS(block, p, v)
    {
        const mpm_vector capacity = capacity_vector(block, p);
        spread_number(spec, block->k, &stencil[v], scalar->nodes[FAST_CONTENT],
                      capacity * mpm_load(numbers + p));
        if (!scalar->follows_mass)
            spread_number(spec, block->k, &stencil[v], scalar->nodes[FAST_CAPACITY], capacity);
    }
}

/* K a, xx yy xy */
MPM_INLINE void multiply(const double k[3], const mpm_vector a[2], mpm_vector product[2])
{
    product[0] = k[0] * a[0] + k[2] * a[1];
    product[1] = k[2] * a[0] + k[1] * a[1];
}

/* k grad v, k turned by R of F = R U */
MPM_INLINE void turned_flow(const double k[3], const mpm_vector f[MPM_GRADIENT_SIZE],
                            const mpm_vector gradient[2], mpm_vector flow[2])
{
    const mpm_vector sum = f[MPM_XX] + f[MPM_YY], difference = f[MPM_YX] - f[MPM_XY];
    const mpm_vector inverse = 1.0 / mpm_square_root(sum * sum + difference * difference);
    const mpm_vector cosine = sum * inverse, sine = difference * inverse;
    const mpm_vector along[2] = {cosine * gradient[0] + sine * gradient[1],
                                 cosine * gradient[1] - sine * gradient[0]};
    mpm_vector turned[2];
    multiply(k, along, turned);
    flow[0] = cosine * turned[0] - sine * turned[1];
    flow[1] = sine * turned[0] + cosine * turned[1];
}

/* Flow and source of four particles, with their F. */
MPM_INLINE void conduct_vector(const struct fast_spec *spec, const struct fast_block *block,
                               size_t p, const union fast_stencil *stencil, bool has_source)
{
    const struct fast_scalar *const scalar = &block->k->scalar;
    const struct mpm_particles *const particles = block->particles;
    struct fast_gift gift; /* set part by part: zeros of all of it are a loop */
    mpm_vector f[MPM_GRADIENT_SIZE], gradient[2], j = mpm_splat(1.0);
    if (!spec->undeformed) {
        load_deformation(particles, p, f);
        j = determinant_vector(f);
    }
    const mpm_vector volume = mpm_load(particles->mass + p) * j;
    gather_slope(spec, block->k, stencil, scalar->nodes[FAST_VALUE], gradient);
    for (int axis = 0; axis < 2; axis++)
        gift.flow[axis] = scalar->conduction.k[0] * gradient[axis];
    if (scalar->conduction.turns && spec->undeformed)
        multiply(scalar->conduction.k, gradient, gift.flow);
    else if (scalar->conduction.turns)
        turned_flow(scalar->conduction.k, f, gradient, gift.flow);
    for (int axis = 0; axis < 2; axis++)
        gift.flow[axis] *= -volume;
    gift.value = has_source ? volume * (scalar->inverse_density * mpm_load(particles->source + p))
                            : mpm_splat(0.0);
    spread_gift(spec, block->k, stencil, scalar->nodes[FAST_INFLOW], &gift);
    block->sums->diffusivity =
        mpm_larger(j * scalar->conduction.diffusivity, block->sums->diffusivity);
}

MPM_INLINE void conduct_scalar(const struct fast_spec *spec, const struct fast_block *block,
                               const union fast_stencil stencil[MPM_BLOCK_VECTORS])
{
    if (block->k->scalar.inverse_density == 0.0)
        FOR_VECTORS(block, p, v)
    conduct_vector(spec, block, p, &stencil[v], false);
    else FOR_VECTORS(block, p, v) conduct_vector(spec, block, p, &stencil[v], true);
}

/* Values of particles; content of the new ones, where spec->spreads. */
MPM_INLINE void update_scalar(const struct fast_spec *spec, const struct fast_block *block,
                              const union fast_stencil stencil[MPM_BLOCK_VECTORS])
{
    const struct fast_constants *const k = block->k;
    const double kept = k->scalar.kept, part = k->scalar.part;
    double *const numbers = numbers_of(block);
    FOR_VECTORS(block, p, v)
    {
        const mpm_vector result = gather_number(spec, k, &stencil[v], k->scalar.nodes[FAST_RESULT]);
        const mpm_vector number = kept * mpm_load(numbers + p) + part * result;
        mpm_store(numbers + p, number);
        if (spec->spreads)
            spread_number(spec, k, &stencil[v], k->scalar.nodes[FAST_CONTENT],
                          capacity_vector(block, p) * number);
    }
}

/* What the nodes have at the particles, back to the nodes. */
MPM_INLINE void filter_scalar(const struct fast_spec *spec, const struct fast_block *block,
                              const union fast_stencil stencil[MPM_BLOCK_VECTORS])
{
    const struct fast_constants *const k = block->k;
    FOR_VECTORS(block, p, v)
    {
        const mpm_vector number = gather_number(spec, k, &stencil[v], k->scalar.nodes[FAST_VALUE]);
        spread_number(spec, k, &stencil[v], k->scalar.nodes[FAST_RESULT],
                      capacity_vector(block, p) * number);
    }
}

#endif
