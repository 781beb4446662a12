/* S1: shape functions against adaptive quadrature of their definitions.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/measures/fields.h"
#include "verification/measures/shapes/shape_comparison.h"
#include "verification/measures/shapes/shape_samples.h"
#include "verification/programs/shapes/program_shape_kind.h"

#include <math.h>

/* S, G_x, G_y, T and the quadrature's estimate of each region, for the picture. */
enum { COLUMNS = 6 };

/* A tenth of the criterion of max_error, 1e-12: a reference that is worse judges nothing. */
static const double REFERENCE_GOOD = 1e-13;

static enum mpm_status compare_region(struct shape_sampler *sampler,
                                      struct shape_quadrature *quadrature,
                                      const struct mpm_shape_query *kind, enum shape_region region,
                                      size_t samples, struct shape_comparison *comparison,
                                      struct mpm_error *error)
{
    for (size_t i = 0; i < samples; i++) {
        struct mpm_shape_query query;
        shape_sampler_draw(sampler, kind, region, &query);
        if (!shape_comparison_add(comparison, quadrature, &query)) {
            return failure_set(error, MPM_RUN_FAILED,
                               "no reference for sample %zu of region %d: particle at %.17g, "
                               "%.17g on cells of %.17g by %.17g: GSL did not converge",
                               i, (int)region, query.position[0], query.position[1], query.cell[0],
                               query.cell[1]);
        }
    }
    return MPM_OK;
}

static void report(struct measurement *measurement,
                   const struct shape_comparison comparisons[SHAPE_REGION_COUNT], bool has_t)
{
    double error = 0, estimate = 0;
    size_t samples = 0, outside = 0, strays = 0;
    for (size_t region = 0; region < SHAPE_REGION_COUNT; region++) {
        const struct shape_comparison *comparison = &comparisons[region];
        estimate = field_larger(estimate, shape_comparison_estimate(comparison));
        outside += comparison->nodes_outside;
        strays += comparison->strays;
        samples += comparison->samples;
        if (region != SHAPE_REGION_FAR_ANYWHERE) {
            error = field_larger(error, shape_comparison_error(comparison));
        }
    }
    if (estimate <= REFERENCE_GOOD)
        measurement_report(measurement, "max_error", error);
    else
        measurement_inconclusive(measurement, "max_error",
                                 "the reference knows its values to %g only; allowed: %g", estimate,
                                 REFERENCE_GOOD);
    measurement_report(measurement, "least_error",
                       shape_comparison_least(&comparisons[SHAPE_REGION_NEAR], has_t));
    measurement_report(measurement, "far_error",
                       shape_comparison_error(&comparisons[SHAPE_REGION_FAR_ANYWHERE]));
    measurement_note(measurement, "%.0f samples; the quadrature bounds its error by %.2g",
                     (double)samples, estimate);
    measurement_report(measurement, "absent_fraction", 1 - (double)strays / (double)outside);
    measurement_work(measurement, samples);
}

static enum mpm_status measure_with(struct measurement *measurement, struct shape_sampler *sampler,
                                    struct shape_quadrature *quadrature, struct mpm_error *error)
{
    struct mpm_shape_query kind;
    unsigned samples;
    TRY(shape_kind_read(measurement, &kind, error));
    TRY(measurement_count(measurement, "samples_per_region", 1, SHAPE_COUNT_MAX, &samples, error));
    struct shape_comparison comparisons[SHAPE_REGION_COUNT] = {{.samples = 0}};
    double rows[SHAPE_REGION_COUNT * COLUMNS];
    for (size_t region = 0; region < SHAPE_REGION_COUNT; region++) {
        TRY(compare_region(sampler, quadrature, &kind, (enum shape_region)region, samples,
                           &comparisons[region], error));
        double *row = &rows[region * COLUMNS];
        row[0] = (double)region;
        for (size_t i = 0; i < SHAPE_VALUES; i++) {
            row[1 + i] = comparisons[region].error[i];
        }
        row[5] = shape_comparison_estimate(&comparisons[region]);
    }
    report(measurement, comparisons, kind.geometry == MPM_AXISYMMETRIC);
    return measurement_series(measurement, "errors", "region S Gx Gy T estimate", COLUMNS,
                              SHAPE_REGION_COUNT, rows, error);
}

static enum mpm_status run(struct measurement *measurement, struct mpm_error *error)
{
    unsigned seed;
    TRY(measurement_count(measurement, "seed", 1, SHAPE_COUNT_MAX, &seed, error));
    struct shape_sampler *sampler = shape_sampler_create(seed);
    struct shape_quadrature *quadrature = shape_quadrature_create();
    enum mpm_status status;
    if (sampler == NULL || quadrature == NULL) {
        status = failure_set(error, MPM_ENVIRONMENT_FAILED, "out of memory: quadrature");
    } else {
        status = measure_with(measurement, sampler, quadrature, error);
    }
    shape_quadrature_free(quadrature);
    shape_sampler_free(sampler);
    return status;
}

const struct measure_program program_shape_quadrature = {
    "shape_quadrature", "shape functions against adaptive quadrature of their definitions", run};
