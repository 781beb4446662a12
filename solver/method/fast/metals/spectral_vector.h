/* Functions of symmetric tensors, of four particles at once: the vector twins of base/spectral.h,
 * to the same bits. Equations and their limits stand there.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_FAST_SPECTRAL_VECTOR_H
#define MPM_METHOD_FAST_SPECTRAL_VECTOR_H

#include "base/exponential_vector.h"
#include "base/spectral.h"
#include "method/fast/fast_stress.h"

MPM_INLINE mpm_vector plane_half_vector(const mpm_vector a[MPM_SYMMETRIC_SIZE])
{
    mpm_vector value[2];
    plane_eigenvalues_vector(a, value);
    return 0.5 * (value[1] - value[0]);
}

MPM_INLINE void compose_vector(const mpm_vector a[MPM_SYMMETRIC_SIZE], mpm_vector mean,
                               mpm_vector factor, mpm_vector out[MPM_SYMMETRIC_SIZE])
{
    const mpm_vector half = 0.5 * (a[MPM_SYM_XX] - a[MPM_SYM_YY]), shear = a[MPM_SYM_XY];
    out[MPM_SYM_XX] = mean + factor * half;
    out[MPM_SYM_YY] = mean - factor * half;
    out[MPM_SYM_XY] = factor * shear;
}

MPM_INLINE void symmetric_logarithm_vector(const mpm_vector a[MPM_SYMMETRIC_SIZE],
                                           mpm_vector out[MPM_SYMMETRIC_SIZE])
{
    const mpm_vector mean = 0.5 * (a[MPM_SYM_XX] + a[MPM_SYM_YY]), half = plane_half_vector(a);
    const mpm_vector ratio = half / mean;
    const mpm_vector determinant = a[MPM_SYM_XX] * a[MPM_SYM_YY] - a[MPM_SYM_XY] * a[MPM_SYM_XY];
    const mpm_mask small = mpm_less(ratio, mpm_splat(MPM_SPECTRAL_SERIES));
    mpm_vector factor = (1.0 + ratio * ratio * (1.0 / 3.0)) / mean;
    if (mpm_any(~small)) {
        const mpm_vector high = mean + half;
        const mpm_vector whole = 0.5 * mpm_logarithm_vector(high / (determinant / high)) / half;
        factor = mpm_select(small, factor, whole);
    }
    const mpm_vector zz = mpm_logarithm_vector(a[MPM_SYM_ZZ]);
    compose_vector(a, 0.5 * mpm_logarithm_vector(determinant), factor, out);
    out[MPM_SYM_ZZ] = zz;
}

MPM_INLINE void symmetric_exponential_vector(const mpm_vector a[MPM_SYMMETRIC_SIZE],
                                             mpm_vector out[MPM_SYMMETRIC_SIZE])
{
    const mpm_vector mean = 0.5 * (a[MPM_SYM_XX] + a[MPM_SYM_YY]), d = plane_half_vector(a);
    const mpm_vector scale = mpm_exponential_vector(mean), up = mpm_exponential_vector(d);
    const mpm_vector down = 1.0 / up;
    const mpm_vector factor = mpm_select(mpm_less(d, mpm_splat(MPM_SPECTRAL_SERIES)),
                                         1.0 + d * d * (1.0 / 6.0), 0.5 * (up - down) / d);
    const mpm_vector zz = mpm_exponential_vector(a[MPM_SYM_ZZ]);
    compose_vector(a, scale * (0.5 * (up + down)), scale * factor, out);
    out[MPM_SYM_ZZ] = zz;
}

MPM_INLINE void symmetric_product_vector(const mpm_vector a[MPM_SYMMETRIC_SIZE],
                                         const mpm_vector x[MPM_SYMMETRIC_SIZE],
                                         mpm_vector out[MPM_SYMMETRIC_SIZE])
{
    out[MPM_SYM_XX] = a[MPM_SYM_XX] * x[MPM_SYM_XX] + a[MPM_SYM_XY] * x[MPM_SYM_XY];
    out[MPM_SYM_YY] = a[MPM_SYM_XY] * x[MPM_SYM_XY] + a[MPM_SYM_YY] * x[MPM_SYM_YY];
    out[MPM_SYM_XY] = a[MPM_SYM_XX] * x[MPM_SYM_XY] + a[MPM_SYM_XY] * x[MPM_SYM_YY];
    out[MPM_SYM_ZZ] = a[MPM_SYM_ZZ] * x[MPM_SYM_ZZ];
}

MPM_INLINE void symmetric_deviate_vector(mpm_vector a[MPM_SYMMETRIC_SIZE])
{
    const mpm_vector mean = (a[MPM_SYM_XX] + a[MPM_SYM_YY] + a[MPM_SYM_ZZ]) * (1.0 / 3.0);
    a[MPM_SYM_XX] -= mean;
    a[MPM_SYM_YY] -= mean;
    a[MPM_SYM_ZZ] -= mean;
}

MPM_INLINE mpm_vector symmetric_norm_vector(const mpm_vector a[MPM_SYMMETRIC_SIZE])
{
    return mpm_square_root(a[MPM_SYM_XX] * a[MPM_SYM_XX] + a[MPM_SYM_YY] * a[MPM_SYM_YY] +
                           a[MPM_SYM_ZZ] * a[MPM_SYM_ZZ] + 2.0 * (a[MPM_SYM_XY] * a[MPM_SYM_XY]));
}

#endif
