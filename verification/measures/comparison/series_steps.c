/* Steps in a series of numbers.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/measures/comparison/series_steps.h"

#include "verification/measures/comparison/run_change.h"

#include <gsl/gsl_statistics_double.h>
#include <math.h>

/* The next finite number after `place`; `count` if there is none. */
static size_t next_finite(const double *values, size_t count, size_t place)
{
    while (place < count && !isfinite(values[place]))
        place++;
    return place;
}

double series_noise(const double *values, size_t count, double *work)
{
    size_t changes = 0;
    for (size_t from = next_finite(values, count, 0); from < count;) {
        const size_t to = next_finite(values, count, from + 1);
        if (to < count)
            work[changes++] = run_change_relative(values[from], values[to]);
        from = to;
    }
    return changes < SERIES_CHANGES ? 0 : gsl_stats_median(work, 1, changes);
}

size_t series_steps(const double *values, size_t count, double noise, double least,
                    struct series_step *steps)
{
    size_t found = 0;
    for (size_t from = next_finite(values, count, 0); from < count;) {
        const size_t to = next_finite(values, count, from + 1);
        const double change = to < count ? run_change_relative(values[from], values[to]) : 0;
        if (change > fmax(SERIES_NOISES * noise, least))
            steps[found++] = (struct series_step){from, to, change};
        from = to;
    }
    return found;
}
