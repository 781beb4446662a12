/* Vectors of four doubles: the compiler's own vector types, so that every processor with
 * or without such registers gives the same bits. Loads and stores need no alignment.
 *
 * Everything is forced inline: a vector never crosses a call, whose convention would
 * depend on the instructions that a file is compiled for.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_BASE_SIMD_H
#define MPM_BASE_SIMD_H

#include <stdbool.h>
#include <stdint.h>
#include <string.h>

/* Compilers warn of that convention even where nothing is called. */
#ifdef __GNUC__
#pragma GCC diagnostic ignored "-Wpsabi"
#endif

enum { MPM_VECTOR_SIZE = 4 };

typedef double mpm_vector __attribute__((vector_size(32)));
typedef double mpm_half_vector __attribute__((vector_size(16), may_alias));
typedef double mpm_loose_half __attribute__((vector_size(16), may_alias, aligned(8)));
typedef int64_t mpm_mask __attribute__((vector_size(32))); /* all bits of a lane, or none */
typedef uint64_t mpm_bits __attribute__((vector_size(32)));
typedef int64_t mpm_half_mask __attribute__((vector_size(16)));

#define MPM_INLINE static inline __attribute__((always_inline))

/* The contrary: one copy, called. Vectors go by address. gcc would copy it for constants. */
#ifdef __clang__
#define MPM_SEPARATE static __attribute__((unused, noinline))
#else
#define MPM_SEPARATE static __attribute__((unused, noinline, noclone))
#endif

MPM_INLINE mpm_vector mpm_load(const double *from)
{
    mpm_vector v;
    memcpy(&v, from, sizeof v);
    return v;
}

MPM_INLINE void mpm_store(double *to, mpm_vector v)
{
    memcpy(to, &v, sizeof v);
}

#if defined __SSE2__ && !defined __AVX__
/* Two numbers in one register. gcc would store them one by one, and whoever loads both
 * would wait for that. */
MPM_INLINE mpm_half_vector mpm_pair(double a, double b)
{
    mpm_half_vector pair = {a, b};
    __asm__("" : "+x"(pair));
    return pair;
}
#else
MPM_INLINE mpm_half_vector mpm_pair(double a, double b)
{
    return (mpm_half_vector){a, b};
}
#endif

MPM_INLINE mpm_vector mpm_join(mpm_half_vector low, mpm_half_vector high)
{
    return (mpm_vector){low[0], low[1], high[0], high[1]};
}

/* from[0] from[1] from[0] from[1] */
MPM_INLINE mpm_vector mpm_load_pair(const double *from)
{
#if defined __AVX__ && !defined __clang__ /* gcc would load first, and permute then */
    return __builtin_ia32_vbroadcastf128_pd256((const mpm_half_vector *)(const void *)from);
#else
    mpm_half_vector v;
    memcpy(&v, from, sizeof v);
#ifdef __AVX__
    return __builtin_shufflevector(v, v, 0, 1, 0, 1);
#else
    return mpm_join(v, v);
#endif
#endif
}

MPM_INLINE mpm_vector mpm_splat(double x)
{
#ifdef __AVX__
    return (mpm_vector){x, x, x, x};
#else
    return mpm_join(mpm_pair(x, x), mpm_pair(x, x));
#endif
}

/* s v. Where registers are short, gcc would write the four copies of s one by one. */
MPM_INLINE mpm_vector mpm_scale(double s, mpm_vector v)
{
#ifdef __AVX__
    return s * v;
#else
    const mpm_half_vector low = {v[0], v[1]}, high = {v[2], v[3]};
    return mpm_join(s * low, s * high);
#endif
}

MPM_INLINE mpm_vector mpm_select(mpm_mask mask, mpm_vector yes, mpm_vector no)
{
    return (mpm_vector)((mask & (mpm_mask)yes) | (~mask & (mpm_mask)no));
}

/* a < b and a <= b by lanes. Registers of half the size have to be named: gcc takes
 * comparisons of longer vectors lane by lane, where it does all else in halves. */
#ifdef __AVX__
#define MPM_COMPARE(a, b, operator) return (a) operator(b)
#else
#define MPM_COMPARE(a, b, operator)                                                                \
    const mpm_half_vector a0 = {(a)[0], (a)[1]}, a1 = {(a)[2], (a)[3]};                            \
    const mpm_half_vector b0 = {(b)[0], (b)[1]}, b1 = {(b)[2], (b)[3]};                            \
    const mpm_half_mask low = a0 operator b0, high = a1 operator b1;                               \
    return (mpm_mask)                                                                              \
    {                                                                                              \
        low[0], low[1], high[0], high[1]                                                           \
    }
#endif

MPM_INLINE mpm_mask mpm_less(mpm_vector a, mpm_vector b)
{
    MPM_COMPARE(a, b, <);
}

MPM_INLINE mpm_mask mpm_at_most(mpm_vector a, mpm_vector b)
{
    MPM_COMPARE(a, b, <=);
}

MPM_INLINE mpm_vector mpm_absolute(mpm_vector x)
{
    const mpm_mask sign = {INT64_MIN, INT64_MIN, INT64_MIN, INT64_MIN};
    return (mpm_vector)((mpm_mask)x & ~sign);
}

/* The smaller and the larger; b where one is not a number. The instruction does just that,
 * but gcc does not find it. */
MPM_INLINE mpm_vector mpm_smaller(mpm_vector a, mpm_vector b)
{
#ifdef __AVX__
    return __builtin_ia32_minpd256(a, b);
#else
    return mpm_select(mpm_less(a, b), a, b);
#endif
}

MPM_INLINE mpm_vector mpm_larger(mpm_vector a, mpm_vector b)
{
#ifdef __AVX__
    return __builtin_ia32_maxpd256(a, b);
#else
    return mpm_select(mpm_less(b, a), a, b);
#endif
}

MPM_INLINE bool mpm_any(mpm_mask mask)
{
#ifdef __AVX__
    return __builtin_ia32_movmskpd256((mpm_vector)mask) != 0;
#else
    return (mask[0] | mask[1] | mask[2] | mask[3]) != 0;
#endif
}

MPM_INLINE mpm_vector mpm_square_root(mpm_vector x)
{
    mpm_vector root = x;
    for (int lane = 0; lane < MPM_VECTOR_SIZE; lane++)
        root[lane] = __builtin_sqrt(x[lane]);
    return root;
}

/* What *p holds is read from memory from here on: a lane that is loaded into all places of
 * a vector costs nothing, one that is picked from a register does. */
MPM_INLINE void mpm_keep_in_memory(void *p)
{
    __asm__ volatile("" : : "r"(p) : "memory");
}

/* Nearest integer, for |x| < 2^51: the sum leaves no digits after the point. */
static const double MPM_ROUNDING = 0x1.8p52;

MPM_INLINE mpm_vector mpm_nearest(mpm_vector x)
{
    return (x + MPM_ROUNDING) - MPM_ROUNDING;
}

/* The largest integer not above x, from the nearest one. */
MPM_INLINE mpm_vector mpm_down_to_integer(mpm_vector x, mpm_vector nearest)
{
    return nearest - mpm_select(mpm_less(x, nearest), mpm_splat(1.0), mpm_splat(0.0));
}

/* A whole number as an integer: its bits are the low end of the sum. */
MPM_INLINE mpm_mask mpm_to_integer(mpm_vector whole)
{
    const mpm_vector zero = mpm_splat(MPM_ROUNDING);
    return (mpm_mask)(whole + MPM_ROUNDING) - (mpm_mask)zero;
}

/* Two lanes of a vector and the same ones of another, in the order of the names. */
#define MPM_MIX(a, i, b, j, c, k, d, l) mpm_join(mpm_pair((a)[i], (b)[j]), mpm_pair((c)[k], (d)[l]))

/* Pairs (a, b) of each lane, in the order of lanes 0 2 1 3, which interleaving leaves. */
MPM_INLINE void mpm_store_pairs(mpm_vector a, mpm_vector b, double pairs[8])
{
#ifdef __AVX__
    mpm_store(pairs, __builtin_shufflevector(a, b, 0, 4, 2, 6));
    mpm_store(pairs + 4, __builtin_shufflevector(a, b, 1, 5, 3, 7));
#else
    mpm_store(pairs, MPM_MIX(a, 0, b, 0, a, 2, b, 2));
    mpm_store(pairs + 4, MPM_MIX(a, 1, b, 1, a, 3, b, 3));
#endif
}

/* Rows become columns. */
MPM_INLINE void mpm_transpose(mpm_vector v[4])
{
#ifdef __AVX__
    const mpm_vector a = __builtin_shufflevector(v[0], v[1], 0, 4, 2, 6);
    const mpm_vector b = __builtin_shufflevector(v[0], v[1], 1, 5, 3, 7);
    const mpm_vector c = __builtin_shufflevector(v[2], v[3], 0, 4, 2, 6);
    const mpm_vector d = __builtin_shufflevector(v[2], v[3], 1, 5, 3, 7);
    v[0] = __builtin_shufflevector(a, c, 0, 1, 4, 5);
    v[1] = __builtin_shufflevector(b, d, 0, 1, 4, 5);
    v[2] = __builtin_shufflevector(a, c, 2, 3, 6, 7);
    v[3] = __builtin_shufflevector(b, d, 2, 3, 6, 7);
#else
    const mpm_vector a = v[0], b = v[1], c = v[2], d = v[3];
    v[0] = MPM_MIX(a, 0, b, 0, c, 0, d, 0);
    v[1] = MPM_MIX(a, 1, b, 1, c, 1, d, 1);
    v[2] = MPM_MIX(a, 2, b, 2, c, 2, d, 2);
    v[3] = MPM_MIX(a, 3, b, 3, c, 3, d, 3);
#endif
}

MPM_INLINE mpm_half_vector mpm_load_half(const double *from)
{
    mpm_half_vector v;
    memcpy(&v, from, sizeof v);
    return v;
}

/* Two numbers from each place. */
MPM_INLINE mpm_vector mpm_load_halves(const double *low, const double *high)
{
#if defined __AVX__ && !defined __clang__ /* gcc would load number by number */
    const mpm_loose_half *const a = (const void *)low, *const b = (const void *)high;
    return __builtin_ia32_vinsertf128_pd256(__builtin_ia32_pd256_pd(*a), *b, 1);
#else
    return mpm_join(mpm_load_half(low), mpm_load_half(high));
#endif
}

/* Lanes 0 and 2 of two vectors in turn; lanes 1 and 3. */
#ifdef __AVX__
#define MPM_EVEN(a, b) __builtin_shufflevector(a, b, 0, 4, 2, 6)
#define MPM_ODD(a, b)  __builtin_shufflevector(a, b, 1, 5, 3, 7)
#else
#define MPM_EVEN(a, b) MPM_MIX(a, 0, b, 0, a, 2, b, 2)
#define MPM_ODD(a, b)  MPM_MIX(a, 1, b, 1, a, 3, b, 3)
#endif

/* Number i of each of four rows, in column[i]: two, three or four columns. Of three, each row is
 * read up to a fourth number. */
MPM_INLINE void mpm_load_columns(double *const row[MPM_VECTOR_SIZE], int64_t offset, int columns,
                                 mpm_vector column[4])
{
#pragma GCC unroll 4
    for (int i = 0; i < columns; i += 2) {
        const mpm_vector a = mpm_load_halves(row[0] + offset + i, row[2] + offset + i);
        const mpm_vector b = mpm_load_halves(row[1] + offset + i, row[3] + offset + i);
        column[i] = MPM_EVEN(a, b);
        if (i + 1 < columns)
            column[i + 1] = MPM_ODD(a, b);
    }
}

/* Adds number i of column[i] to each of four rows, one row after the other, number by number: rows
 * may overlap, and whoever loads a vector that was stored in pieces waits until these are there. */
MPM_INLINE void mpm_add_columns(double *const row[MPM_VECTOR_SIZE], int64_t offset, int columns,
                                const mpm_vector column[4])
{
    double number[4][MPM_VECTOR_SIZE];
#pragma GCC unroll 4
    for (int i = 0; i < columns; i++)
        mpm_store(number[i], column[i]);
    __asm__("" : "+m"(number)); /* loaded from there: lanes are not picked from registers */
#pragma GCC unroll 4
    for (int lane = 0; lane < MPM_VECTOR_SIZE; lane++)
#pragma GCC unroll 4
        for (int i = 0; i < columns; i++)
            row[lane][offset + i] += number[i][lane];
}

/* Adds the sum of column[i] to number i of one row; of three columns, zero to a fourth one. */
MPM_INLINE void mpm_add_sums(double *row, int columns, const mpm_vector column[4])
{
    const mpm_vector zero = mpm_splat(0.0);
    const mpm_vector third = columns > 2 ? column[2] : zero,
                     fourth = columns > 3 ? column[3] : zero;
    const mpm_vector a = MPM_EVEN(column[0], column[1]) + MPM_ODD(column[0], column[1]);
    const mpm_vector b = MPM_EVEN(third, fourth) + MPM_ODD(third, fourth);
    const mpm_half_vector sum = (mpm_half_vector){a[0], a[1]} + (mpm_half_vector){a[2], a[3]};
    const mpm_half_vector rest = (mpm_half_vector){b[0], b[1]} + (mpm_half_vector){b[2], b[3]};
    if (columns > 2) {
        mpm_store(row, mpm_load(row) + mpm_join(sum, rest));
    } else {
        const mpm_half_vector both = mpm_load_half(row) + sum;
        memcpy(row, &both, sizeof both);
    }
}

/* Are all lanes the same? */
MPM_INLINE bool mpm_is_uniform(mpm_mask a)
{
    return !mpm_any(a != (mpm_mask){a[0], a[0], a[0], a[0]});
}

MPM_INLINE double mpm_largest_lane(mpm_vector v)
{
    const double a = v[0] > v[1] ? v[0] : v[1], b = v[2] > v[3] ? v[2] : v[3];
    return a > b ? a : b;
}

MPM_INLINE double mpm_smallest_lane(mpm_vector v)
{
    return -mpm_largest_lane(-v);
}

MPM_INLINE double mpm_sum_of_lanes(mpm_vector v)
{
    return (v[0] + v[1]) + (v[2] + v[3]);
}

/* x^(-1/3) for normal x > 0, as mpm_inverse_cube_root; the first guess takes a third of
 * the upper half of the bits, as there is no integer division by lanes. */
MPM_INLINE mpm_vector mpm_inverse_cube_root_vector(mpm_vector x)
{
    const mpm_bits upper = (mpm_bits)x >> 32; /* unsigned: any bits may come */
    const mpm_vector number = (mpm_vector)(upper | (mpm_bits)mpm_splat(0x1p52)) - 0x1p52;
    const mpm_vector third = number * (1.0 / 3.0) + 0x1p52;
    const mpm_bits bits = ((mpm_bits)third - (mpm_bits)mpm_splat(0x1p52)) << 32;
    mpm_vector y = (mpm_vector)(UINT64_C(0x553ef0ff289dd796) - bits);
    for (int k = 0; k < 2; k++) {
        const mpm_vector e = 1.0 - x * y * y * y;
        y += y * e * (1.0 / 3.0 + e * (2.0 / 9.0));
    }
    return y + y * (1.0 - x * y * y * y) * (1.0 / 3.0);
}

#endif
