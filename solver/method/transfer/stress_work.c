/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/transfer/stress_work.h"

/* tau : (dF F^-1) */
static double work_rate(const double tau[MPM_SYMMETRIC_SIZE], const double df[MPM_GRADIENT_SIZE],
                        const double f[MPM_GRADIENT_SIZE])
{
    const double area = f[MPM_XX] * f[MPM_YY] - f[MPM_XY] * f[MPM_YX];
    const double xx = df[MPM_XX] * f[MPM_YY] - df[MPM_XY] * f[MPM_YX];
    const double xy = df[MPM_XY] * f[MPM_XX] - df[MPM_XX] * f[MPM_XY];
    const double yx = df[MPM_YX] * f[MPM_YY] - df[MPM_YY] * f[MPM_YX];
    const double yy = df[MPM_YY] * f[MPM_XX] - df[MPM_YX] * f[MPM_XY];
    return (tau[MPM_SYM_XX] * xx + tau[MPM_SYM_YY] * yy + tau[MPM_SYM_XY] * (xy + yx)) / area +
           tau[MPM_SYM_ZZ] * df[MPM_ZZ] / f[MPM_ZZ];
}

double mpm_stress_work(const double old_stress[MPM_SYMMETRIC_SIZE],
                       const double stress[MPM_SYMMETRIC_SIZE], const struct mpm_law_step *step)
{
    double df[MPM_GRADIENT_SIZE];
    for (int k = 0; k < MPM_GRADIENT_SIZE; k++)
        df[k] = step->f[k] - step->old_f[k];
    return 0.5 * (work_rate(old_stress, df, step->old_f) + work_rate(stress, df, step->f));
}
