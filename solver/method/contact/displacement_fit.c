/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/contact/displacement_fit.h"

static const double LAMBDA = 1e-6;
/* The same over the square of the way from the middle of the particles to the place: where they lie
 * close together, far from it, their round-off and noise must not be magnified. */
static const double LAMBDA_AWAY = 0.1;

void mpm_displacement_add(struct mpm_displacement_sums *sums,
                          const struct mpm_displacement_sample *sample)
{
    const double w = sample->weight, *const x = sample->x;
    sums->weight += w;
    for (int i = 0; i < 2; i++) {
        sums->x[i] += w * x[i];
        sums->u[i] += w * sample->u[i];
        sums->v[i] += w * sample->v[i];
        for (int j = 0; j < 2; j++) {
            sums->ux[2 * i + j] += w * sample->u[i] * x[j];
            sums->vx[2 * i + j] += w * sample->v[i] * x[j];
            sums->h[2 * i + j] += w * sample->h[2 * i + j];
        }
    }
    sums->xx[0] += w * x[0] * x[0];
    sums->xx[1] += w * x[0] * x[1];
    sums->xx[2] += w * x[1] * x[1];
}

void mpm_displacement_fold(struct mpm_displacement_sums *sums,
                           const struct mpm_displacement_sums *mirrored, int axis)
{
    const double sign[2] = {axis == 0 ? -1.0 : 1.0, axis == 1 ? -1.0 : 1.0};
    sums->weight += mirrored->weight;
    for (int i = 0; i < 2; i++) {
        sums->x[i] += sign[i] * mirrored->x[i];
        sums->u[i] += sign[i] * mirrored->u[i];
        sums->v[i] += sign[i] * mirrored->v[i];
        for (int j = 0; j < 2; j++) {
            sums->ux[2 * i + j] += sign[i] * sign[j] * mirrored->ux[2 * i + j];
            sums->vx[2 * i + j] += sign[i] * sign[j] * mirrored->vx[2 * i + j];
            sums->h[2 * i + j] += sign[i] * sign[j] * mirrored->h[2 * i + j];
        }
    }
    sums->xx[0] += mirrored->xx[0];
    sums->xx[1] -= mirrored->xx[1];
    sums->xx[2] += mirrored->xx[2];
}

void mpm_displacement_put_on_plane(struct mpm_displacement_sums *sums, int axis)
{
    sums->x[axis] = sums->u[axis] = sums->v[axis] = sums->xx[1] = 0.0;
    for (int k = 1; k < 3; k++)
        sums->ux[k] = sums->vx[k] = sums->h[k] = 0.0;
}

/* (I - H)^-1 of the mean H. */
static void find_deformation(const struct mpm_displacement_sums *sums, double f[4])
{
    const double w = sums->weight, *const h = sums->h;
    const double xx = 1.0 - h[0] / w, xy = -h[1] / w, yx = -h[2] / w, yy = 1.0 - h[3] / w;
    const double determinant = xx * yy - xy * yx;
    f[0] = yy / determinant;
    f[1] = -xy / determinant;
    f[2] = -yx / determinant;
    f[3] = xx / determinant;
}

struct mpm_displacement_fit mpm_displacement_fit(const struct mpm_displacement_sums *sums,
                                                 double unit, const double x[2])
{
    const double w = sums->weight;
    struct mpm_displacement_fit fit = {{0.0, 0.0}, {0.0, 0.0}, {1.0, 0.0, 0.0, 1.0}};
    if (w == 0.0)
        return fit;
    find_deformation(sums, fit.f);
    const double mean[2] = {sums->x[0] / w, sums->x[1] / w};
    const double away[2] = {x[0] - mean[0], x[1] - mean[1]};
    const double lambda =
        LAMBDA * unit * unit + LAMBDA_AWAY * (away[0] * away[0] + away[1] * away[1]);
    const double xx = sums->xx[0] / w - mean[0] * mean[0] + lambda;
    const double xy = sums->xx[1] / w - mean[0] * mean[1];
    const double yy = sums->xx[2] / w - mean[1] * mean[1] + lambda;
    const double determinant = xx * yy - xy * xy; /* at least lambda^2, but for round-off */
    const double weight[2] = {(yy * away[0] - xy * away[1]) / determinant,
                              (xx * away[1] - xy * away[0]) / determinant};
    for (int i = 0; i < 2; i++) {
        const double u = sums->u[i] / w, v = sums->v[i] / w;
        fit.u[i] = u;
        fit.v[i] = v;
        for (int j = 0; j < 2; j++) {
            fit.u[i] +=
                weight[j] * ((sums->ux[2 * i + j] + lambda * sums->h[2 * i + j]) / w - u * mean[j]);
            fit.v[i] += weight[j] * (sums->vx[2 * i + j] / w - v * mean[j]);
        }
    }
    return fit;
}

void mpm_displacement_jump(const struct mpm_displacement_fit *first,
                           const struct mpm_displacement_fit *second, double jump[2])
{
    const double by[2] = {second->u[0] - first->u[0], second->u[1] - first->u[1]};
    for (int i = 0; i < 2; i++)
        jump[i] = 0.5 * ((first->f[2 * i] + second->f[2 * i]) * by[0] +
                         (first->f[2 * i + 1] + second->f[2 * i + 1]) * by[1]);
}
