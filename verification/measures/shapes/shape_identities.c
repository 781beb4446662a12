/* Sums over the nodes; see shape_identities.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/measures/shapes/shape_identities.h"
#include "verification/measures/fields.h"

#include <math.h>

/* Domain vectors as placed: rows d1, d2. */
static void domain_vectors(const struct mpm_shape_query *query, double d[2][2])
{
    const double *f = query->deformation_gradient; /* xx xy yx yy */
    const bool convected = query->shape == MPM_CPDI;
    for (size_t k = 0; k < 2; k++) {
        const double along = convected ? f[2 * k] : (k == 0 ? 1 : 0);
        const double across = convected ? f[2 * k + 1] : (k == 1 ? 1 : 0);
        const bool point = !convected && query->shape != MPM_UGIMP;
        d[0][k] = point ? 0 : along * query->half_size[0];
        d[1][k] = point ? 0 : across * query->half_size[1];
    }
}

struct shape_moments shape_moments_of(const struct mpm_shape_query *query)
{
    struct shape_moments moments = {.magnification = 1};
    if (query->geometry != MPM_AXISYMMETRIC) {
        return moments;
    }
    double d[2][2];
    domain_vectors(query, d);
    double centre = query->position[0];
    double reach = fabs(d[0][0]) + fabs(d[1][0]);
    const bool cut = query->axis == MPM_TRUNCATED && reach > centre;
    if (cut && query->shape == MPM_UGIMP) { /* [0, r_p + half] */
        centre = d[0][0] = reach = (centre + reach) / 2;
    } else if (cut) { /* shrunk to touch the axis */
        for (size_t i = 0; i < 4; i++) {
            d[i / 2][i % 2] *= query->position[0] / reach;
        }
        reach = query->position[0];
    }
    moments.radius = centre;
    for (size_t k = 0; k < 2; k++) { /* <rho^2> = <zeta^2> = 1/3 */
        moments.offset[k] = (d[0][0] * d[0][k] + d[1][0] * d[1][k]) / (3 * centre);
    }
    moments.offset[0] += centre - query->position[0];
    if (reach > centre) {
        moments.magnification = (centre * centre + reach * reach) / (2 * reach * centre);
    }
    return moments;
}

struct sums {
    double s, t, r_t, r_g;
    double g[2], x_s[2], x_g[2][2]; /* x in cells from the particle, G times the cell */
};

static struct sums stencil_sums(const struct mpm_shape_query *query)
{
    struct mpm_stencil_entry entries[MPM_STENCIL_MAX];
    const size_t count = mpm_shape_evaluate(query, entries);
    struct sums sums = {0};
    for (size_t i = 0; i < count; i++) {
        const struct mpm_stencil_entry *entry = &entries[i];
        const double node[2] = {
            query->origin[0] + (double)entry->column * query->cell[0],
            query->origin[1] + (double)entry->row * query->cell[1],
        };
        sums.s += entry->s;
        sums.t += entry->t;
        sums.r_t += node[0] * entry->t;
        sums.r_g += node[0] * entry->g[0];
        for (size_t k = 0; k < 2; k++) {
            const double distance = (node[k] - query->position[k]) / query->cell[k];
            sums.g[k] += entry->g[k] * query->cell[k];
            sums.x_s[k] += distance * entry->s;
            for (size_t l = 0; l < 2; l++) {
                sums.x_g[k][l] += distance * entry->g[l] * query->cell[l];
            }
        }
    }
    return sums;
}

void shape_residuals_add(struct shape_residuals *residuals, const struct mpm_shape_query *query)
{
    const struct shape_moments moments = shape_moments_of(query);
    const struct sums sums = stencil_sums(query);
    double residual[SHAPE_IDENTITY_COUNT] = {[SHAPE_SUM_S] = fabs(sums.s - 1)};
    for (size_t k = 0; k < 2; k++) {
        const double position = fabs(sums.x_s[k] - moments.offset[k] / query->cell[k]);
        residual[SHAPE_SUM_XS] = field_larger(residual[SHAPE_SUM_XS], position);
        residual[SHAPE_SUM_G] = field_larger(residual[SHAPE_SUM_G], fabs(sums.g[k]));
        for (size_t l = 0; l < 2; l++) {
            const double moment = fabs(sums.x_g[k][l] - (k == l ? 1 : 0));
            residual[SHAPE_SUM_XG] = field_larger(residual[SHAPE_SUM_XG], moment);
        }
    }
    if (query->geometry == MPM_AXISYMMETRIC) {
        residual[SHAPE_SUM_RG] = fabs(sums.r_g - 1) / fmax(1, query->position[0] / query->cell[0]);
        residual[SHAPE_SUM_T] = fabs(moments.radius * sums.t - 1);
        residual[SHAPE_SUM_RT] = fabs(sums.r_t - 1);
    }
    for (size_t i = 0; i < SHAPE_IDENTITY_COUNT; i++) {
        residuals->residual[i] =
            field_larger(residuals->residual[i], residual[i] / moments.magnification);
    }
    residuals->samples++;
}
