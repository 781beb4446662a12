/* exponential.h for four numbers at once, to the same bits.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_BASE_EXPONENTIAL_VECTOR_H
#define MPM_BASE_EXPONENTIAL_VECTOR_H

#include "base/exponential_terms.h"
#include "base/simd.h"

#include <float.h>
#include <math.h>

/* Sum of c[k] x^k, even and odd powers side by side. */
MPM_INLINE mpm_vector mpm_polynomial_vector(const double *c, int terms, mpm_vector x)
{
    const mpm_vector square = x * x;
    const int top = (terms - 1) / 2 * 2; /* even */
    mpm_vector even = mpm_splat(c[top]), odd = mpm_splat(top + 1 < terms ? c[top + 1] : 0.0);
#pragma GCC unroll 8
    for (int k = top - 2; k >= 0; k -= 2) {
        even = even * square + c[k];
        odd = odd * square + c[k + 1];
    }
    return even + odd * x;
}

/* exp(x); of x that are not from -700 to 700 no number. */
MPM_INLINE mpm_vector mpm_exponential_vector(mpm_vector x)
{
    const mpm_vector zero = mpm_splat(MPM_ROUNDING);
    const mpm_vector n = mpm_nearest(x * MPM_PER_LN2);
    const mpm_vector y = (x - n * MPM_LN2_HIGH) - n * MPM_LN2_LOW;
    const mpm_vector rest = mpm_polynomial_vector(mpm_inverse_factorial + 2, MPM_EXP_TERMS - 2, y);
    const mpm_vector sum = 1.0 + (y + y * y * rest);
    const mpm_bits exponent = (mpm_bits)(n + MPM_ROUNDING) - (mpm_bits)zero + (uint64_t)MPM_BIAS;
    const mpm_vector value = sum * (mpm_vector)(exponent << (uint64_t)MPM_FRACTION_BITS);
    return mpm_select(mpm_at_most(mpm_absolute(x), mpm_splat(MPM_EXP_LARGEST)), value,
                      mpm_splat((double)NAN));
}

/* ln x; of x that are no normal numbers above 0 no number. */
MPM_INLINE mpm_vector mpm_logarithm_vector(mpm_vector x)
{
    const mpm_bits half = (mpm_bits)mpm_splat(MPM_ROOT_HALF);
    const uint64_t bias = MPM_BIAS, shift = MPM_FRACTION_BITS;
    const mpm_bits biased = ((mpm_bits)x - half + (bias << shift)) >> shift;
    const mpm_vector exponent =
        (mpm_vector)(biased | (mpm_bits)mpm_splat(0x1p52)) - (0x1p52 + MPM_BIAS);
    const mpm_vector y = (mpm_vector)((mpm_bits)x - ((biased - bias) << shift));
    const mpm_vector s = (y - 1.0) / (y + 1.0), square = s * s;
    const mpm_vector sum = mpm_polynomial_vector(mpm_inverse_odd + 1, MPM_LOG_TERMS - 1, square);
    const mpm_vector value =
        exponent * MPM_LN2_HIGH + (exponent * MPM_LN2_LOW + (2.0 * s + 2.0 * s * square * sum));
    return mpm_select(mpm_at_most(mpm_splat(DBL_MIN), x) & mpm_at_most(x, mpm_splat(DBL_MAX)),
                      value, mpm_splat((double)NAN));
}

#endif
