/* Fast kernels: stress update of four particles, the vector twins of base/tensor.h and of
 * the laws in model/. Equations and their sources stand there.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_FAST_STRESS_H
#define MPM_METHOD_FAST_STRESS_H

#include "base/simd.h"
#include "model/material.h"

MPM_INLINE void left_cauchy_green_vector(const mpm_vector f[MPM_GRADIENT_SIZE],
                                         mpm_vector b[MPM_SYMMETRIC_SIZE])
{
    b[MPM_SYM_XX] = f[MPM_XX] * f[MPM_XX] + f[MPM_XY] * f[MPM_XY];
    b[MPM_SYM_YY] = f[MPM_YX] * f[MPM_YX] + f[MPM_YY] * f[MPM_YY];
    b[MPM_SYM_ZZ] = f[MPM_ZZ] * f[MPM_ZZ];
    b[MPM_SYM_XY] = f[MPM_XX] * f[MPM_YX] + f[MPM_XY] * f[MPM_YY];
}

MPM_INLINE void plane_eigenvalues_vector(const mpm_vector b[MPM_SYMMETRIC_SIZE],
                                         mpm_vector value[2])
{
    const mpm_vector mean = 0.5 * (b[MPM_SYM_XX] + b[MPM_SYM_YY]);
    const mpm_vector half = 0.5 * (b[MPM_SYM_XX] - b[MPM_SYM_YY]);
    const mpm_vector radius = mpm_square_root(half * half + b[MPM_SYM_XY] * b[MPM_SYM_XY]);
    value[0] = mean - radius;
    value[1] = mean + radius;
}

/* F := dF F with dF = exp(h) cut after `terms` terms, see mpm_deformation_increment. */
MPM_INLINE void deform_vector(const mpm_vector h[MPM_GRADIENT_SIZE], int terms, bool out_of_plane,
                              mpm_vector f[MPM_GRADIENT_SIZE])
{
    const mpm_vector trace = h[MPM_XX] + h[MPM_YY];
    const mpm_vector determinant = h[MPM_XX] * h[MPM_YY] - h[MPM_XY] * h[MPM_YX];
    mpm_vector of_h = mpm_splat(1.0), of_unit = mpm_splat(0.0), out = h[MPM_ZZ];
    mpm_vector sum_h = of_h, sum_unit = of_unit, sum_out = out;
    for (int k = 2; k <= terms; k++) {
        const double part = 1.0 / k;
        const mpm_vector next = (trace * of_h + of_unit) * part;
        of_unit = -determinant * of_h * part;
        of_h = next;
        sum_h += of_h;
        sum_unit += of_unit;
        if (out_of_plane) {
            out = out * h[MPM_ZZ] * part;
            sum_out += out;
        }
    }
    const mpm_vector xx = 1.0 + (sum_h * h[MPM_XX] + sum_unit), xy = sum_h * h[MPM_XY];
    const mpm_vector yy = 1.0 + (sum_h * h[MPM_YY] + sum_unit), yx = sum_h * h[MPM_YX];
    const mpm_vector old[4] = {f[MPM_XX], f[MPM_XY], f[MPM_YX], f[MPM_YY]};
    f[MPM_XX] = xx * old[0] + xy * old[2];
    f[MPM_XY] = xx * old[1] + xy * old[3];
    f[MPM_YX] = yx * old[0] + yy * old[2];
    f[MPM_YY] = yx * old[1] + yy * old[3];
    if (out_of_plane)
        f[MPM_ZZ] = (1.0 + sum_out) * f[MPM_ZZ];
}

/* ------------------------------------------------------------- neo-Hookean */

MPM_INLINE void neo_hookean_stress_vector(const struct mpm_material *m,
                                          const mpm_vector f[MPM_GRADIENT_SIZE],
                                          mpm_vector tau[MPM_SYMMETRIC_SIZE],
                                          mpm_vector *wave_speed_squared)
{
    const mpm_vector j = determinant_vector(f);
    const mpm_vector root = mpm_inverse_cube_root_vector(j);
    const mpm_vector shear = m->shear * (root * root);
    mpm_vector b[MPM_SYMMETRIC_SIZE], principal[2];
    left_cauchy_green_vector(f, b);
    const mpm_vector trace = b[MPM_SYM_XX] + b[MPM_SYM_YY] + b[MPM_SYM_ZZ];
    const mpm_vector pressure = 0.5 * m->bulk * ((j - 1.0) * (j + 1.0));
    const mpm_vector mean = pressure - shear * (trace * (1.0 / 3.0));
    tau[MPM_SYM_XX] = mean + shear * b[MPM_SYM_XX];
    tau[MPM_SYM_YY] = mean + shear * b[MPM_SYM_YY];
    tau[MPM_SYM_ZZ] = mean + shear * b[MPM_SYM_ZZ];
    tau[MPM_SYM_XY] = shear * b[MPM_SYM_XY];
    plane_eigenvalues_vector(b, principal);
    const mpm_vector longitudinal =
        0.5 * m->bulk * (j * j + 1.0) + shear * (5.0 / 9.0 * trace - 1.0 / 3.0 * principal[0]);
    *wave_speed_squared = mpm_larger(longitudinal, shear * principal[1]);
}

/* Newton, particle by particle as long as each one needs. */
MPM_INLINE mpm_vector neo_hookean_thickness_vector(const struct mpm_material *m,
                                                   const mpm_vector f[MPM_GRADIENT_SIZE])
{
    const mpm_vector area = f[MPM_XX] * f[MPM_YY] - f[MPM_XY] * f[MPM_YX];
    mpm_vector b[MPM_SYMMETRIC_SIZE];
    left_cauchy_green_vector(f, b);
    const mpm_vector plane = b[MPM_SYM_XX] + b[MPM_SYM_YY];
    mpm_vector x = f[MPM_ZZ];
    mpm_mask moving = {-1, -1, -1, -1};
    for (int k = 0; k < 50 && mpm_any(moving); k++) {
        const mpm_vector j = area * x;
        const mpm_vector root = mpm_inverse_cube_root_vector(j);
        const mpm_vector shear = m->shear * (root * root);
        const mpm_vector deviator = (2.0 * x * x - plane) * (1.0 / 3.0);
        const mpm_vector tau = 0.5 * m->bulk * ((j - 1.0) * (j + 1.0)) + shear * deviator;
        const mpm_vector slope =
            m->bulk * j * area + shear * (4.0 / 3.0 * x - 2.0 / 3.0 * deviator / x);
        const mpm_vector next = mpm_larger(x - tau / slope, 0.1 * x);
        const mpm_mask far = mpm_less(4e-16 * x, mpm_absolute(next - x));
        x = mpm_select(moving, next, x);
        moving &= far;
    }
    return x;
}

/* ---------------------------------------------------------- linear elastic */

MPM_INLINE mpm_vector left_stretch_vector(const mpm_vector f[MPM_GRADIENT_SIZE],
                                          mpm_vector v[MPM_SYMMETRIC_SIZE])
{
    mpm_vector b[MPM_SYMMETRIC_SIZE];
    left_cauchy_green_vector(f, b);
    const mpm_vector determinant = f[MPM_XX] * f[MPM_YY] - f[MPM_XY] * f[MPM_YX];
    const mpm_vector sum = f[MPM_XX] + f[MPM_YY], difference = f[MPM_XY] - f[MPM_YX];
    const mpm_vector trace = mpm_square_root(sum * sum + difference * difference);
    const mpm_vector inverse = 1.0 / trace;
    v[MPM_SYM_XX] = (b[MPM_SYM_XX] + determinant) * inverse;
    v[MPM_SYM_YY] = (b[MPM_SYM_YY] + determinant) * inverse;
    v[MPM_SYM_XY] = b[MPM_SYM_XY] * inverse;
    v[MPM_SYM_ZZ] = f[MPM_ZZ];
    return trace;
}

MPM_INLINE void linear_elastic_stress_vector(const struct mpm_material *m,
                                             const mpm_vector f[MPM_GRADIENT_SIZE],
                                             mpm_vector tau[MPM_SYMMETRIC_SIZE],
                                             mpm_vector *wave_speed_squared)
{
    mpm_vector v[MPM_SYMMETRIC_SIZE], principal[2];
    (void)left_stretch_vector(f, v);
    const mpm_vector exx = v[MPM_SYM_XX] - 1.0, eyy = v[MPM_SYM_YY] - 1.0;
    const mpm_vector ezz = v[MPM_SYM_ZZ] - 1.0, exy = v[MPM_SYM_XY];
    const mpm_vector volumetric = m->lame * (exx + eyy + ezz);
    const mpm_vector sxx = 2.0 * m->shear * exx + volumetric;
    const mpm_vector syy = 2.0 * m->shear * eyy + volumetric;
    const mpm_vector szz = 2.0 * m->shear * ezz + volumetric, sxy = 2.0 * m->shear * exy;
    tau[MPM_SYM_XX] = sxx * v[MPM_SYM_XX] + sxy * v[MPM_SYM_XY];
    tau[MPM_SYM_YY] = sxy * v[MPM_SYM_XY] + syy * v[MPM_SYM_YY];
    tau[MPM_SYM_XY] = sxx * v[MPM_SYM_XY] + sxy * v[MPM_SYM_YY];
    tau[MPM_SYM_ZZ] = szz * v[MPM_SYM_ZZ];
    plane_eigenvalues_vector(v, principal);
    *wave_speed_squared = (m->lame + 2.0 * m->shear) * (principal[1] * principal[1]);
}

MPM_INLINE mpm_vector linear_elastic_thickness_vector(const struct mpm_material *m,
                                                      const mpm_vector f[MPM_GRADIENT_SIZE])
{
    mpm_vector v[MPM_SYMMETRIC_SIZE];
    const mpm_vector trace = left_stretch_vector(f, v);
    return 1.0 - m->lame / (m->lame + 2.0 * m->shear) * (trace - 2.0);
}

/* The laws of F alone that have these equations on vectors. */
#define MPM_VECTOR_LAWS(LAW)                                                                       \
    LAW(neo_hookean)                                                                               \
    LAW(linear_elastic)

#endif
