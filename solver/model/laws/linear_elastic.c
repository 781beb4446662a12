/* Isotropic linear elasticity with finite rotation: Hooke's law between the stretch
 * U - I and its conjugate, turned by the rotation R of F = R U:
 *   W = G |U - I|^2 + lambda/2 tr(U - I)^2,
 *   tau = R [ 2 G (U - I) + lambda tr(U - I) I ] U R^T.
 * A rigid rotation leaves no stress; at small strain it is Hooke's law. W is an exact
 * potential, so that energy can be conserved. Meant for small strains: W stays finite
 * as J -> 0.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "model/material.h"

#include <math.h>

/* Left stretch V = R U R^T of the plane part: V = sqrt(B) by Cayley-Hamilton,
 * V = (B + det(F) I) / tr V with tr V^2 = tr B + 2 det F. */
static double left_stretch(const double f[MPM_GRADIENT_SIZE], double v[MPM_SYMMETRIC_SIZE])
{
    double b[MPM_SYMMETRIC_SIZE];
    mpm_left_cauchy_green(f, b);
    const double determinant = f[MPM_XX] * f[MPM_YY] - f[MPM_XY] * f[MPM_YX];
    /* tr V = | (F_xx + F_yy, F_xy - F_yx) |, free of cancellation */
    const double sum = f[MPM_XX] + f[MPM_YY], difference = f[MPM_XY] - f[MPM_YX];
    const double trace = sqrt(sum * sum + difference * difference);
    v[MPM_SYM_XX] = (b[MPM_SYM_XX] + determinant) / trace;
    v[MPM_SYM_YY] = (b[MPM_SYM_YY] + determinant) / trace;
    v[MPM_SYM_XY] = b[MPM_SYM_XY] / trace;
    v[MPM_SYM_ZZ] = f[MPM_ZZ];
    return trace;
}

static void stress(const struct mpm_material *m, const double f[MPM_GRADIENT_SIZE],
                   double tau[MPM_SYMMETRIC_SIZE], double *wave_speed_squared)
{
    double v[MPM_SYMMETRIC_SIZE];
    (void)left_stretch(f, v);
    const double exx = v[MPM_SYM_XX] - 1.0, eyy = v[MPM_SYM_YY] - 1.0, ezz = v[MPM_SYM_ZZ] - 1.0;
    const double exy = v[MPM_SYM_XY];
    const double volumetric = m->lame * (exx + eyy + ezz);
    const double sxx = 2.0 * m->shear * exx + volumetric, syy = 2.0 * m->shear * eyy + volumetric;
    const double szz = 2.0 * m->shear * ezz + volumetric, sxy = 2.0 * m->shear * exy;
    /* the rotated Biot stress and V have the same principal axes: their product is
     * symmetric */
    tau[MPM_SYM_XX] = sxx * v[MPM_SYM_XX] + sxy * v[MPM_SYM_XY];
    tau[MPM_SYM_YY] = sxy * v[MPM_SYM_XY] + syy * v[MPM_SYM_YY];
    tau[MPM_SYM_XY] = sxx * v[MPM_SYM_XY] + sxy * v[MPM_SYM_YY];
    tau[MPM_SYM_ZZ] = szz * v[MPM_SYM_ZZ];

    /* rho_0 c^2 = l^2 W_ll = (lambda + 2 G) l^2 along the principal stretch l */
    double principal[2];
    mpm_plane_eigenvalues(v, principal);
    *wave_speed_squared = (m->lame + 2.0 * m->shear) * (principal[1] * principal[1]);
}

static double energy(const struct mpm_material *m, const double f[MPM_GRADIENT_SIZE],
                     const double *state)
{
    (void)state;
    double v[MPM_SYMMETRIC_SIZE];
    (void)left_stretch(f, v);
    const double exx = v[MPM_SYM_XX] - 1.0, eyy = v[MPM_SYM_YY] - 1.0, ezz = v[MPM_SYM_ZZ] - 1.0;
    const double exy = v[MPM_SYM_XY];
    const double trace = exx + eyy + ezz;
    return m->shear * (exx * exx + eyy * eyy + ezz * ezz + 2.0 * exy * exy) +
           0.5 * m->lame * trace * trace;
}

/* W itself, from tr V = |(F_xx + F_yy, F_xy - F_yx)| + F_zz and |V|^2 = tr B. */
static double energy_bound(const struct mpm_material *m, double *const f[MPM_GRADIENT_SIZE],
                           const double *mass, size_t begin, size_t end)
{
    const double *const xx = f[MPM_XX], *const xy = f[MPM_XY], *const yx = f[MPM_YX];
    const double *const yy = f[MPM_YY], *const zz = f[MPM_ZZ];
    double square_sum = 0.0, trace_sum = 0.0;
    for (size_t p = begin; p < end; p++) {
        const double sum = xx[p] + yy[p], difference = xy[p] - yx[p];
        const double stretch = sqrt(sum * sum + difference * difference) + zz[p];
        const double square =
            xx[p] * xx[p] + xy[p] * xy[p] + yx[p] * yx[p] + yy[p] * yy[p] + zz[p] * zz[p];
        const double trace = stretch - 3.0;
        square_sum += mass[p] * (square - 2.0 * stretch + 3.0);
        trace_sum += mass[p] * (trace * trace);
    }
    return m->shear * square_sum + 0.5 * m->lame * trace_sum;
}

/* 2 G e_zz + lambda (e_xx + e_yy + e_zz) = 0 */
static double thickness_stretch(const struct mpm_material *m, const double f[MPM_GRADIENT_SIZE])
{
    double v[MPM_SYMMETRIC_SIZE];
    const double trace = left_stretch(f, v);
    return 1.0 - m->lame / (m->lame + 2.0 * m->shear) * (trace - 2.0);
}

static const struct mpm_law_parameter parameters[] = {{.which = MPM_PARAMETER_BULK},
                                                      {.which = MPM_PARAMETER_SHEAR}};

const struct mpm_material_law mpm_linear_elastic = {
    .name = "linear_elastic",
    .description = "W = G |U - I|^2 + lambda/2 tr(U - I)^2, Hooke's law turned by the rotation",
    .parameters = parameters,
    .parameter_count = sizeof parameters / sizeof *parameters,
    .stress = stress,
    .energy = energy,
    .energy_bound = energy_bound,
    .thickness_stretch = thickness_stretch,
};
