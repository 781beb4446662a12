/* Changes between two runs.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/measures/comparison/run_change.h"

#include <gsl/gsl_statistics_double.h>
#include <math.h>

static int badness(enum verdict_status status)
{
    if (verdict_is_red(status))
        return 3;
    return status == VERDICT_SKIP ? 2 : status == VERDICT_EXPECTED_FAIL ? 1 : 0;
}

enum run_change run_change_status(enum verdict_status before, enum verdict_status after)
{
    const int one = badness(before), other = badness(after);
    if (one != other)
        return other > one ? RUN_WORSE : RUN_BETTER;
    return before == after ? RUN_SAME : RUN_OTHER;
}

double run_change_relative(double before, double after)
{
    if (!isfinite(before) || !isfinite(after))
        return isfinite(before) || isfinite(after) ? HUGE_VAL : 0.0;
    const double larger = fmax(fabs(before), fabs(after));
    return larger > 0.0 ? fabs(after - before) / larger : 0.0;
}

enum run_change run_change_margin(double before, double after)
{
    if (!isfinite(before) || !isfinite(after) || fabs(after - before) <= RUN_CHANGE_MARGIN)
        return RUN_SAME;
    return after < before ? RUN_WORSE : RUN_BETTER;
}

struct run_noise run_change_noise(const double *before, const double *after, size_t count,
                                  double *work)
{
    /* deviation of a normal distribution over the median of absolute deviations */
    static const double normal = 1.4826, deviations = 3.0, least = 1.5;
    if (count < 5)
        return (struct run_noise){1.0, 2.0};
    for (size_t i = 0; i < count; i++)
        work[i] = log(after[i] / before[i]);
    const double middle = gsl_stats_median(work, 1, count);
    for (size_t i = 0; i < count; i++)
        work[i] = fabs(log(after[i] / before[i]) - middle);
    return (struct run_noise){
        exp(middle), fmax(least, exp(deviations * normal * gsl_stats_median(work, 1, count)))};
}

enum run_change run_change_time(const struct run_noise *noise, double before, double after)
{
    const double ratio = after / before / noise->middle;
    if (ratio > noise->factor)
        return RUN_WORSE;
    return ratio < 1.0 / noise->factor ? RUN_BETTER : RUN_SAME;
}
