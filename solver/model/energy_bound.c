/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "model/energy_bound.h"

#include <math.h>

/* With J^(-2/3) <= (2/J + 1)/3, the means of 1/J, 1/J and 1, and
 *   ln J >= (J - 1/J)/2 up to J = 1, 2 (J - 1)/(J + 1) from there on,
 * both of third order in J - 1. */
static double bound_neo_hookean(const struct mpm_material *m, double *const f[MPM_GRADIENT_SIZE],
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

/* W itself, from tr V = |(F_xx + F_yy, F_xy - F_yx)| + F_zz and |V|^2 = tr B. */
static double bound_linear_elastic(const struct mpm_material *m, double *const f[MPM_GRADIENT_SIZE],
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

double mpm_energy_bound(const struct mpm_material *material,
                        double *const deformation[MPM_GRADIENT_SIZE], const double *mass,
                        size_t begin, size_t end)
{
    if (material->law == &mpm_neo_hookean)
        return bound_neo_hookean(material, deformation, mass, begin, end);
    if (material->law == &mpm_linear_elastic)
        return bound_linear_elastic(material, deformation, mass, begin, end);
    return HUGE_VAL;
}
