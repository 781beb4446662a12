/* Several numbers at a time, in the vector types of gcc and clang, and the functions that jets
 * need: as many as a register has of the instructions that a file is compiled for. Only sums,
 * products, quotients and square roots: the same bits from every compiler and machine.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_EXACT_LANES_H
#define VERIFICATION_EXACT_LANES_H

#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>

#ifdef __AVX2__
enum { LANES = 4 };
#define LANES_ALL(value)                                                                           \
    {                                                                                              \
        (value), (value), (value), (value)                                                         \
    }
#else
enum { LANES = 2 };
#define LANES_ALL(value)                                                                           \
    {                                                                                              \
        (value), (value)                                                                           \
    }
#endif
typedef double lanes __attribute__((vector_size(LANES * sizeof(double))));
typedef int64_t lanes_mask __attribute__((vector_size(LANES * sizeof(int64_t))));
#define LANES_INLINE static inline __attribute__((always_inline))

LANES_INLINE lanes lanes_splat(double value)
{
    return (lanes)LANES_ALL(value);
}

/* mask ? a : b; masks come from comparisons */
LANES_INLINE lanes lanes_select(lanes_mask mask, lanes a, lanes b)
{
    return (lanes)((mask & (lanes_mask)a) | (~mask & (lanes_mask)b));
}

LANES_INLINE lanes lanes_root(lanes x)
{
    for (int k = 0; k < LANES; k++)
        x[k] = sqrt(x[k]);
    return x;
}

/* sin and cos of |x| < 1e5 to 2e-16: less a multiple of pi/2, itself in pieces of 33 bits whose
 * products with the multiple are exact, then Taylor series, which leave 5e-17 on [0, pi/4]. */
LANES_INLINE void lanes_sin_cos(lanes x, lanes *sine, lanes *cosine)
{
    /* tables of vectors: compilers make none of the numbers of a table */
    static const double round = 0x1.8p+52; /* adding it leaves an integer in the last bits */
    static const lanes odd[] = {LANES_ALL(-1.0 / 6),
                                LANES_ALL(1.0 / 120),
                                LANES_ALL(-1.0 / 5040),
                                LANES_ALL(1.0 / 362880),
                                LANES_ALL(-1.0 / 39916800),
                                LANES_ALL(1.0 / 6227020800),
                                LANES_ALL(-1.0 / 1307674368000)};
    static const lanes even[] = {LANES_ALL(-1.0 / 2),           LANES_ALL(1.0 / 24),
                                 LANES_ALL(-1.0 / 720),         LANES_ALL(1.0 / 40320),
                                 LANES_ALL(-1.0 / 3628800),     LANES_ALL(1.0 / 479001600),
                                 LANES_ALL(-1.0 / 87178291200), LANES_ALL(1.0 / 20922789888000)};
    const lanes shifted = x * 0.63661977236758134 + round, turns = shifted - round;
    const lanes r =
        ((x - turns * 0x1.921fb544p+0) - turns * 0x1.0b4611a6p-34) - turns * 0x1.3198a2e037073p-69;
    const lanes z = r * r;
    lanes s = odd[6], c = even[7] * z + even[6];
    for (int k = 5; k >= 0; k--) {
        s = s * z + odd[k];
        c = c * z + even[k];
    }
    s = r + r * z * s;
    c = 1.0 + z * c;
    const lanes_mask quadrant = (lanes_mask)shifted;
    const lanes_mask swap = -(quadrant & 1);
    const lanes_mask minus_sine = (quadrant & 2) << 62, minus_cosine = ((quadrant + 1) & 2) << 62;
    *sine = (lanes)((lanes_mask)lanes_select(swap, c, s) ^ minus_sine);
    *cosine = (lanes)((lanes_mask)lanes_select(swap, s, c) ^ minus_cosine);
}

LANES_INLINE bool lanes_any(lanes_mask mask)
{
    int64_t any = 0;
    for (int k = 0; k < LANES; k++)
        any |= mask[k];
    return any != 0;
}

/* x^(-1/3) of normal x > 0, to 4e-16. The bits of a double are nearly its logarithm: minus a third
 * of them is a guess y to 4 %, and with e = 1 - x y^3 the series of (1 - e)^(-1/3) to e^3 leaves
 * e^4, twice. */
LANES_INLINE lanes lanes_inverse_cube_root(lanes x)
{
    static const double one = 1.0;
    int64_t bits_of_one;
    memcpy(&bits_of_one, &one, sizeof one);
    /* of no overflow, whatever the bits of x: a body turned inside out has x < 0 */
    const lanes_mask guess = bits_of_one + bits_of_one / 3 - (lanes_mask)x / 3;
    lanes y = (lanes)guess * 0.96; /* it was 0 to 8 % too large */
    for (int k = 0; k < 2; k++) {
        const lanes e = 1.0 - x * (y * y * y);
        y += y * e * (1.0 / 3 + e * (2.0 / 9 + e * (14.0 / 81)));
    }
    return y;
}

#endif
