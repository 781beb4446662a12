/* S2: sums of the shape functions over the nodes, and their planar limit.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/measures/orders.h"
#include "verification/measures/shapes/shape_identities.h"
#include "verification/measures/shapes/shape_lines.h"
#include "verification/measures/shapes/shape_samples.h"
#include "verification/programs/shapes/program_shape_kind.h"

#include <math.h>

static const char *const QUANTITY[SHAPE_IDENTITY_COUNT] = {
    [SHAPE_SUM_S] = "sum_s",   [SHAPE_SUM_XS] = "sum_xs", [SHAPE_SUM_G] = "sum_g",
    [SHAPE_SUM_XG] = "sum_xg", [SHAPE_SUM_RG] = "sum_rg", [SHAPE_SUM_T] = "sum_t",
    [SHAPE_SUM_RT] = "sum_rt",
};

static bool is_axisymmetric_only(size_t identity)
{
    return identity == SHAPE_SUM_RG || identity == SHAPE_SUM_T || identity == SHAPE_SUM_RT;
}

static void report_identities(struct measurement *measurement, struct shape_sampler *sampler,
                              const struct mpm_shape_query *kind, size_t samples)
{
    struct shape_residuals residuals = {0};
    for (size_t region = 0; region < SHAPE_REGION_FAR_ANYWHERE; region++) {
        for (size_t i = 0; i < samples; i++) {
            struct mpm_shape_query query;
            shape_sampler_draw(sampler, kind, (enum shape_region)region, &query);
            shape_residuals_add(&residuals, &query);
        }
    }
    for (size_t i = 0; i < SHAPE_IDENTITY_COUNT; i++) {
        if (kind->geometry == MPM_AXISYMMETRIC || !is_axisymmetric_only(i)) {
            measurement_report(measurement, QUANTITY[i], residuals.residual[i]);
        }
    }
    measurement_note(measurement, "%.0f samples", (double)residuals.samples);
    measurement_work(measurement, residuals.samples);
}

/* ------------------------------------------------------------- planar limit */

enum { LEVELS = 7, FIRST_NODE = 1000 }; /* to 10^9, by ten */
static const double LIMIT_SIZE = 0.5;   /* l_p */

struct limit_level {
    double radius; /* in cells */
    double s;      /* |S_r - planar| inside a cell */
    double g;      /* cell |G_r - planar| over a node */
};

static void limit_levels(const struct mpm_shape_query *kind, struct limit_level levels[LEVELS])
{
    const struct shape_line radial = {kind->shape, kind->geometry, kind->axis, LIMIT_SIZE, false};
    const struct shape_line planar = {kind->shape, MPM_PLANE_STRAIN, kind->axis, LIMIT_SIZE, false};
    int64_t node = FIRST_NODE;
    for (size_t i = 0; i < LEVELS; i++, node *= 10) {
        const double on = (double)node, inside = on + 0.5;
        const double s = shape_line_at(&radial, node, inside).s;
        const double g = shape_line_at(&radial, node, on).ds;
        levels[i].radius = inside;
        levels[i].s = fabs(s - shape_line_at(&planar, node, inside).s);
        levels[i].g = 2 * fabs(g - shape_line_at(&planar, node, on).ds);
    }
}

static enum mpm_status report_limit(struct measurement *measurement,
                                    const struct mpm_shape_query *kind, struct mpm_error *error)
{
    struct limit_level levels[LEVELS];
    limit_levels(kind, levels);
    double h[LEVELS], difference[LEVELS], rows[LEVELS * 3];
    for (size_t i = 0; i < LEVELS; i++) {
        h[i] = 1 / levels[i].radius;
        difference[i] = levels[i].s;
        rows[3 * i] = levels[i].radius;
        rows[3 * i + 1] = levels[i].s;
        rows[3 * i + 2] = levels[i].g;
    }
    measurement_report(measurement, "limit_order_fitted", order_fitted(LEVELS, h, difference));
    measurement_report(measurement, "limit_order_last", order_last(LEVELS, h, difference));
    measurement_report(measurement, "limit_constant_s", levels[0].s * levels[0].radius);
    if (kind->shape == MPM_UGIMP) {
        measurement_report(measurement, "limit_constant_g", levels[0].g * (levels[0].radius - 0.5));
    }
    return measurement_series(measurement, "limit", "r/cell S_difference G_difference", 3, LEVELS,
                              rows, error);
}

static enum mpm_status run(struct measurement *measurement, struct mpm_error *error)
{
    struct mpm_shape_query kind;
    unsigned samples, seed;
    TRY(shape_kind_read(measurement, &kind, error));
    TRY(measurement_count(measurement, "samples_per_region", 1, SHAPE_COUNT_MAX, &samples, error));
    TRY(measurement_count(measurement, "seed", 1, SHAPE_COUNT_MAX, &seed, error));
    struct shape_sampler *sampler = shape_sampler_create(seed);
    if (sampler == NULL) {
        return failure_set(error, MPM_ENVIRONMENT_FAILED, "out of memory: random numbers");
    }
    report_identities(measurement, sampler, &kind, samples);
    shape_sampler_free(sampler);
    const bool has_domain = kind.shape == MPM_UGIMP || kind.shape == MPM_CPDI;
    if (!has_domain || kind.geometry != MPM_AXISYMMETRIC || kind.axis == MPM_PLANAR) {
        return MPM_OK; /* functions that do not depend on the weight: no limit */
    }
    return report_limit(measurement, &kind, error);
}

const struct measure_program program_shape_identities = {
    "shape_identities", "sums of the shape functions over the nodes, and their planar limit", run};
