/* Fast kernels: what APIC adds to stencils that are products of lines. Compare affine.c.
 *
 * The weights of a line sum up to 1, so that y_p and D_p = diag(d_x, d_y) follow from each line
 * alone: with the distances a_i = x_i - y_p along an axis and m_i = s_i a_i, d = sum m_i a_i. What
 * the particle gives to and takes from a node is then
 *
 *   S C (x_i - y_p) = m_i(x) s_j(y) C_x + s_i(x) m_j(y) C_y,   B = (sum m s v, sum s m v).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_FAST_AFFINE_H
#define MPM_METHOD_FAST_AFFINE_H

#include "method/fast/fast_constants.h"

enum { MPM_LINE_NODES = 4 }; /* at most */

/* Of four particles, in memory, to be read lane by lane. */
struct fast_moments {
    double x[MPM_LINE_NODES][MPM_VECTOR_SIZE], y[MPM_LINE_NODES][MPM_VECTOR_SIZE]; /* m_i */
    mpm_vector second[2];                                                          /* d */
};

/* m_i of the weights of a line; d */
MPM_INLINE mpm_vector fast_line_moments(const mpm_vector s[MPM_LINE_NODES], int nodes, double cell,
                                        double moment[MPM_LINE_NODES][MPM_VECTOR_SIZE])
{
    mpm_vector mean = s[1], second = mpm_splat(0.0);
    for (int i = 2; i < nodes; i++)
        mean += (double)i * s[i];
    for (int i = 0; i < nodes; i++) {
        const mpm_vector away = ((double)i - mean) * cell, product = s[i] * away;
        mpm_store(moment[i], product);
        second += product * away;
    }
    return second;
}

/* A column of C_p: that of B_p over d, or 0 where no node is at a distance along the axis; of
 * classic functions it is stored itself. */
MPM_INLINE mpm_vector column_of(const struct fast_spec *spec, const double *kept, mpm_vector second)
{
    const mpm_vector zero = mpm_splat(0.0), along = mpm_load(kept);
    if (spec->shape == MPM_CLASSIC)
        return along;
    return mpm_select(mpm_less(zero, second), along / second, zero);
}

/* m_p C_p: xx, xy, yx, yy */
MPM_INLINE void fast_affine_momentum(const struct fast_spec *spec,
                                     const struct mpm_particles *particles, size_t p,
                                     const struct fast_moments *moments, mpm_vector mass,
                                     mpm_vector affine[4])
{
    for (int k = 0; k < 4; k++)
        affine[k] = mass * column_of(spec, particles->affine[k] + p, moments->second[k % 2]);
}

/* By particles, what goes with m_i of either axis: columns of m_p C_p, in the places of momentum
 * in a nodal vector. */
struct fast_turn {
    mpm_vector along_x[MPM_VECTOR_SIZE], along_y[MPM_VECTOR_SIZE];
};

/* twice: nodal vectors are (p_x, p_x, p_y, p_y), else (p_x, -, p_y, -). */
MPM_INLINE struct fast_turn fast_turn_of(const mpm_vector affine[4], bool twice)
{
    const mpm_vector zero = mpm_splat(0.0);
    struct fast_turn turn = {{affine[0], zero, affine[2], zero},
                             {affine[1], zero, affine[3], zero}};
    if (twice) {
        turn.along_x[1] = affine[0];
        turn.along_x[3] = affine[2];
        turn.along_y[1] = affine[1];
        turn.along_y[3] = affine[3];
    }
    mpm_transpose(turn.along_x);
    mpm_transpose(turn.along_y);
    return turn;
}

/* Keeps B_p, or C_p of classic functions: its columns are in the places of v in nodal vectors. */
MPM_INLINE void fast_affine_keep(const struct mpm_particles *particles, size_t p,
                                 mpm_vector columns[2][4])
{
    for (int k = 0; k < 4; k++)
        mpm_store(particles->affine[k] + p, columns[k % 2][2 + k / 2]);
}

#endif
