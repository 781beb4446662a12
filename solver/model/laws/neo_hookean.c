/* Compressible neo-Hookean solid, N&G (64):
 *   W = K/2 [ (J^2 - 1)/2 - ln J ] + G/2 ( J^(-2/3) tr B - 3 ).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "model/material.h"

#include <math.h>

/* tau = K/2 (J^2 - 1) I + G J^(-2/3) dev B; radial compression gives N&G (66), (67). */
static void stress(const struct mpm_material *m, const double f[MPM_GRADIENT_SIZE],
                   double tau[MPM_SYMMETRIC_SIZE], double *wave_speed_squared)
{
    const double j = mpm_determinant(f);
    const double root = mpm_inverse_cube_root(j);
    const double shear = m->shear * (root * root);
    double b[MPM_SYMMETRIC_SIZE];
    mpm_left_cauchy_green(f, b);
    const double trace = b[MPM_SYM_XX] + b[MPM_SYM_YY] + b[MPM_SYM_ZZ];
    const double pressure = 0.5 * m->bulk * ((j - 1.0) * (j + 1.0));
    const double mean = pressure - shear * (trace * (1.0 / 3.0));
    tau[MPM_SYM_XX] = mean + shear * b[MPM_SYM_XX];
    tau[MPM_SYM_YY] = mean + shear * b[MPM_SYM_YY];
    tau[MPM_SYM_ZZ] = mean + shear * b[MPM_SYM_ZZ];
    tau[MPM_SYM_XY] = shear * b[MPM_SYM_XY];

    /* Along a principal direction of stretch l: the longitudinal wave has rho_0 c^2 =
     * l^2 W_ll = K/2 (J^2 + 1) + G J^(-2/3) (5/9 tr B - l^2 / 3), the shear waves have
     * G J^(-2/3) l^2. The former is fastest along the smaller stretch, the latter along
     * the larger one. */
    double principal[2];
    mpm_plane_eigenvalues(b, principal);
    const double longitudinal =
        0.5 * m->bulk * (j * j + 1.0) + shear * (5.0 / 9.0 * trace - 1.0 / 3.0 * principal[0]);
    const double transverse = shear * principal[1];
    *wave_speed_squared = longitudinal > transverse ? longitudinal : transverse;
}

static double energy(const struct mpm_material *m, const double f[MPM_GRADIENT_SIZE],
                     const double *state)
{
    (void)state;
    const double j = mpm_determinant(f);
    const double root = mpm_inverse_cube_root(j);
    double b[MPM_SYMMETRIC_SIZE];
    mpm_left_cauchy_green(f, b);
    const double trace = b[MPM_SYM_XX] + b[MPM_SYM_YY] + b[MPM_SYM_ZZ];
    const double volumetric = 0.5 * (j - 1.0) * (j + 1.0) - log(j);
    return 0.5 * m->bulk * volumetric + 0.5 * m->shear * (root * root * trace - 3.0);
}

/* At small strains at most 1 + G/(3 K) times the energy. With J^(-2/3) <= (2/J + 1)/3, the means of
 * 1/J, 1/J and 1, and ln J >= (J - 1/J)/2 up to J = 1, 2 (J - 1)/(J + 1) from there on, both of
 * third order in J - 1. */
static double energy_bound(const struct mpm_material *m, double *const f[MPM_GRADIENT_SIZE],
                           const double *mass, size_t begin, size_t end)
{
    const double *const xx = f[MPM_XX], *const xy = f[MPM_XY], *const yx = f[MPM_YX];
    const double *const yy = f[MPM_YY], *const zz = f[MPM_ZZ];
    double volumetric = 0.0, deviatoric = 0.0;
    for (size_t p = begin; p < end; p++) {
        const double j = (xx[p] * yy[p] - xy[p] * yx[p]) * zz[p];
        const double trace =
            xx[p] * xx[p] + xy[p] * xy[p] + yx[p] * yx[p] + yy[p] * yy[p] + zz[p] * zz[p];
        const double square = j * j - 1.0;
        const double inverse = 1.0 / j;
        const double logarithm = j < 1.0 ? 0.5 * square * inverse : 2.0 * (j - 1.0) / (j + 1.0);
        volumetric += mass[p] * (0.5 * square - logarithm);
        deviatoric += mass[p] * ((2.0 * inverse + 1.0) * (1.0 / 3.0) * trace - 3.0);
    }
    return 0.5 * (m->bulk * volumetric + m->shear * deviatoric);
}

/* Newton on tau_zz(x) = 0 in x = F_zz. tau_zz / x^(-2/3) grows with x, and the start
 * from the last value is close, so that a few steps reach round-off. */
static double thickness_stretch(const struct mpm_material *m, const double f[MPM_GRADIENT_SIZE])
{
    const double area = f[MPM_XX] * f[MPM_YY] - f[MPM_XY] * f[MPM_YX];
    double b[MPM_SYMMETRIC_SIZE];
    mpm_left_cauchy_green(f, b);
    const double plane = b[MPM_SYM_XX] + b[MPM_SYM_YY];
    double x = f[MPM_ZZ];
    for (int k = 0; k < 50; k++) {
        const double j = area * x;
        const double root = mpm_inverse_cube_root(j);
        const double shear = m->shear * (root * root);
        const double deviator = (2.0 * x * x - plane) / 3.0;
        const double tau = 0.5 * m->bulk * ((j - 1.0) * (j + 1.0)) + shear * deviator;
        const double slope =
            m->bulk * j * area + shear * (4.0 / 3.0 * x - 2.0 / 3.0 * deviator / x);
        double next = x - tau / slope;
        if (!(next > 0.1 * x)) /* never leave x > 0, where the law lives */
            next = 0.1 * x;
        const bool done = fabs(next - x) <= 4e-16 * x;
        x = next;
        if (done)
            break;
    }
    return x;
}

static const struct mpm_law_parameter parameters[] = {{.which = MPM_PARAMETER_BULK},
                                                      {.which = MPM_PARAMETER_SHEAR}};

const struct mpm_material_law mpm_neo_hookean = {
    .name = "neo_hookean",
    .description = "W = K/2 [(J^2 - 1)/2 - ln J] + G/2 (J^(-2/3) tr B - 3), N&G (64)",
    .parameters = parameters,
    .parameter_count = sizeof parameters / sizeof *parameters,
    .stress = stress,
    .energy = energy,
    .energy_bound = energy_bound,
    .thickness_stretch = thickness_stretch,
};
