/* Tensors of the plane plus the third direction: deformation gradients have the
 * components xx xy yx yy zz (in axisymmetry rr rz zr zz tt), symmetric tensors
 * xx yy zz xy. Plain arithmetic and square roots only, so that every compiler
 * gives the same bits.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_BASE_TENSOR_H
#define MPM_BASE_TENSOR_H

#include <math.h>
#include <stdint.h>
#include <string.h>

enum { MPM_XX, MPM_XY, MPM_YX, MPM_YY, MPM_ZZ, MPM_GRADIENT_SIZE };
enum { MPM_SYM_XX, MPM_SYM_YY, MPM_SYM_ZZ, MPM_SYM_XY, MPM_SYMMETRIC_SIZE };

static inline double mpm_determinant(const double f[MPM_GRADIENT_SIZE])
{
    return (f[MPM_XX] * f[MPM_YY] - f[MPM_XY] * f[MPM_YX]) * f[MPM_ZZ];
}

/* Left Cauchy-Green tensor B = F F^T. */
static inline void mpm_left_cauchy_green(const double f[MPM_GRADIENT_SIZE],
                                         double b[MPM_SYMMETRIC_SIZE])
{
    b[MPM_SYM_XX] = f[MPM_XX] * f[MPM_XX] + f[MPM_XY] * f[MPM_XY];
    b[MPM_SYM_YY] = f[MPM_YX] * f[MPM_YX] + f[MPM_YY] * f[MPM_YY];
    b[MPM_SYM_ZZ] = f[MPM_ZZ] * f[MPM_ZZ];
    b[MPM_SYM_XY] = f[MPM_XX] * f[MPM_YX] + f[MPM_XY] * f[MPM_YY];
}

/* dF = exp(h) cut after `terms` terms beyond the unit tensor, N&G (9): the powers
 * of the plane part come from Cayley-Hamilton, h^2 = tr(h) h - det(h) I. */
static inline void mpm_deformation_increment(const double h[MPM_GRADIENT_SIZE], int terms,
                                             double df[MPM_GRADIENT_SIZE])
{
    const double trace = h[MPM_XX] + h[MPM_YY];
    const double determinant = h[MPM_XX] * h[MPM_YY] - h[MPM_XY] * h[MPM_YX];
    double of_h = 1.0, of_unit = 0.0, out = h[MPM_ZZ]; /* h^k / k! = of_h h + of_unit I */
    double sum_h = 1.0, sum_unit = 0.0, sum_out = out;
    for (int k = 2; k <= terms; k++) {
        const double next = (trace * of_h + of_unit) / k;
        of_unit = -determinant * of_h / k;
        of_h = next;
        out = out * h[MPM_ZZ] / k;
        sum_h += of_h;
        sum_unit += of_unit;
        sum_out += out;
    }
    df[MPM_XX] = 1.0 + (sum_h * h[MPM_XX] + sum_unit);
    df[MPM_XY] = sum_h * h[MPM_XY];
    df[MPM_YX] = sum_h * h[MPM_YX];
    df[MPM_YY] = 1.0 + (sum_h * h[MPM_YY] + sum_unit);
    df[MPM_ZZ] = 1.0 + sum_out;
}

/* F := dF F */
static inline void mpm_deformation_compose(const double df[MPM_GRADIENT_SIZE],
                                           double f[MPM_GRADIENT_SIZE])
{
    const double xx = df[MPM_XX] * f[MPM_XX] + df[MPM_XY] * f[MPM_YX];
    const double xy = df[MPM_XX] * f[MPM_XY] + df[MPM_XY] * f[MPM_YY];
    const double yx = df[MPM_YX] * f[MPM_XX] + df[MPM_YY] * f[MPM_YX];
    const double yy = df[MPM_YX] * f[MPM_XY] + df[MPM_YY] * f[MPM_YY];
    f[MPM_XX] = xx;
    f[MPM_XY] = xy;
    f[MPM_YX] = yx;
    f[MPM_YY] = yy;
    f[MPM_ZZ] = df[MPM_ZZ] * f[MPM_ZZ];
}

/* Eigenvalues of the plane part of a symmetric tensor, smaller first. */
static inline void mpm_plane_eigenvalues(const double b[MPM_SYMMETRIC_SIZE], double value[2])
{
    const double mean = 0.5 * (b[MPM_SYM_XX] + b[MPM_SYM_YY]);
    const double half = 0.5 * (b[MPM_SYM_XX] - b[MPM_SYM_YY]);
    const double radius = sqrt(half * half + b[MPM_SYM_XY] * b[MPM_SYM_XY]);
    value[0] = mean - radius;
    value[1] = mean + radius;
}

/* x^(-1/3) for normal x > 0: a guess from the exponent bits, then Halley steps, each
 * tripling the digits. To 2 units in the last place; no library call, so the same
 * bits everywhere. */
static inline double mpm_inverse_cube_root(double x)
{
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    bits = UINT64_C(0x553ef0ff289dd796) - bits / 3;
    double y;
    memcpy(&y, &bits, sizeof y);
    for (int k = 0; k < 2; k++) {
        const double e = 1.0 - x * y * y * y;
        y += y * e * (1.0 / 3.0 + e * (2.0 / 9.0));
    }
    /* the last step of Newton removes what the products above have rounded away */
    return y + y * (1.0 - x * y * y * y) * (1.0 / 3.0);
}

#endif
