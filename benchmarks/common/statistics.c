/* Statistics of repeated measurements, on GSL.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "benchmarks/common/statistics.h"

#include <glib.h>
#include <gsl/gsl_rng.h>
#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics_double.h>
#include <stdbool.h>

enum { RESAMPLES = 2000, SEED = 20150107 };

double bench_median(const double *values, size_t count)
{
    double *sorted = g_memdup2(values, count * sizeof *values);
    gsl_sort(sorted, 1, count);
    const double median = gsl_stats_median_from_sorted_data(sorted, 1, count);
    g_free(sorted);
    return median;
}

static double resampled_median(const gsl_rng *generator, const double *values, size_t count,
                               double *room)
{
    for (size_t i = 0; i < count; i++)
        room[i] = values[gsl_rng_uniform_int(generator, count)];
    gsl_sort(room, 1, count);
    return gsl_stats_median_from_sorted_data(room, 1, count);
}

/* Percentiles of the medians of resamples; divided by those of `against` if not NULL. */
static struct bench_interval bootstrap(const double *values, size_t count, const double *against,
                                       size_t against_count)
{
    gsl_rng *generator = gsl_rng_alloc(gsl_rng_mt19937);
    double *medians = g_new(double, RESAMPLES), *room = g_new(double, MAX(count, against_count));
    gsl_rng_set(generator, SEED);
    for (size_t i = 0; i < RESAMPLES; i++) {
        medians[i] = resampled_median(generator, values, count, room);
        if (against != NULL)
            medians[i] /= resampled_median(generator, against, against_count, room);
    }
    gsl_sort(medians, 1, RESAMPLES);
    struct bench_interval interval = {
        .median = bench_median(values, count),
        .low = gsl_stats_quantile_from_sorted_data(medians, 1, RESAMPLES, 0.025),
        .high = gsl_stats_quantile_from_sorted_data(medians, 1, RESAMPLES, 0.975),
    };
    if (against != NULL)
        interval.median /= bench_median(against, against_count);
    g_free(medians);
    g_free(room);
    gsl_rng_free(generator);
    return interval;
}

struct bench_interval bench_interval_of(const double *values, size_t count)
{
    return bootstrap(values, count, NULL, 0);
}

struct bench_interval bench_ratio_paired(const double *values, const double *against, size_t count)
{
    double *ratios = g_new(double, count);
    for (size_t i = 0; i < count; i++)
        ratios[i] = values[i] / against[i];
    const struct bench_interval interval = bench_interval_of(ratios, count);
    g_free(ratios);
    return interval;
}

struct bench_interval bench_ratio_unpaired(const double *values, size_t count,
                                           const double *against, size_t against_count)
{
    return bootstrap(values, count, against, against_count);
}

enum bench_verdict bench_verdict_of(struct bench_interval ratio, size_t rounds,
                                    enum bench_sense sense)
{
    const bool larger = ratio.low > 1 && ratio.median > 1 + BENCH_LEAST_DIFFERENCE;
    const bool smaller = ratio.high < 1 && ratio.median < 1 / (1 + BENCH_LEAST_DIFFERENCE);
    if (rounds < BENCH_ROUNDS_MIN || (!larger && !smaller))
        return BENCH_NOT_RESOLVED;
    return larger == (sense == BENCH_RATE) ? BENCH_FASTER : BENCH_SLOWER;
}

const char *bench_verdict_name(enum bench_verdict verdict)
{
    static const char *const names[] = {
        [BENCH_NOT_RESOLVED] = "not resolved",
        [BENCH_FASTER] = "faster",
        [BENCH_SLOWER] = "slower",
    };
    return names[verdict];
}
