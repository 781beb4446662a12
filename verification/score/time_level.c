/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/score/time_level.h"

#include "verification/common/failure.h"

#include <math.h>

enum { TIMES = 4 }; /* of the reference, for a cubic polynomial */

static const double REACH = 0.25; /* of the time between two instants */

static const struct level {
    enum score_column time, first, last; /* of the columns whose values are of that time */
} levels[] = {
    {SCORE_POSITION_TIME, SCORE_DISPLACEMENT_X, SCORE_DISPLACEMENT_Y},
    {SCORE_VELOCITY_TIME, SCORE_VELOCITY_X, SCORE_VELOCITY_Y},
    {SCORE_STRESS_TIME, SCORE_STRESS_XX, SCORE_RELATIVE_VOLUME},
};

/* The column of the time that a column's values are of; SCORE_TIME for that of the row. */
static enum score_column level_of(enum score_column column)
{
    for (size_t k = 0; k < G_N_ELEMENTS(levels); k++)
        if (column >= levels[k].first && column <= levels[k].last)
            return levels[k].time;
    return SCORE_TIME;
}

/* Whether the levels of results mean anything: not at rest. */
static bool has_level(const struct bundle *bundle, const struct score_table *results,
                      enum score_column level)
{
    return level != SCORE_TIME && !bundle->rest && score_table_has(results, level);
}

double time_level_reference(const struct bundle *bundle, const struct lattice_weights *weights,
                            enum score_column column, const struct score_table *results, size_t row,
                            size_t instant)
{
    const enum score_column level = level_of(column);
    if (!has_level(bundle, results, level))
        return lattice_value(&bundle->lattice, weights, bundle_reference(bundle, column, instant));
    const double interval = bundle->end / (double)bundle->instants;
    const double at = score_table_value(results, level, row) / interval; /* in instants */
    const size_t count = bundle->instants + 1 < TIMES ? bundle->instants + 1 : TIMES;
    const double middle = fmax(floor(at) - 1.0, 0.0);
    const size_t first = (size_t)fmin(middle, (double)(bundle->instants + 1 - count));
    double value = 0.0;
    for (size_t k = first; k < first + count; k++) {
        double weight = 1.0;
        for (size_t j = first; j < first + count; j++)
            if (j != k)
                weight *= (at - (double)j) / ((double)k - (double)j);
        value +=
            weight * lattice_value(&bundle->lattice, weights, bundle_reference(bundle, column, k));
    }
    return value;
}

enum mpm_status time_level_check(const struct bundle *bundle, const struct score_table *results,
                                 size_t row, size_t instant, struct mpm_error *error)
{
    const double nominal = bundle_time(bundle, instant);
    const double reach = REACH * bundle->end / (double)bundle->instants;
    for (size_t k = 0; k < G_N_ELEMENTS(levels); k++) {
        if (!has_level(bundle, results, levels[k].time))
            continue;
        const char *name = score_column_name(levels[k].time, bundle->format.geometry);
        const double time = score_table_value(results, levels[k].time, row);
        if (bundle->lattice.linear)
            return failure_set(error, MPM_BAD_INPUT,
                               "the results have %s, but this reference jumps and is not known "
                               "between its instants: leave the column out, the criteria allow "
                               "for half a step",
                               name);
        if (!(fabs(time - nominal) <= reach))
            return failure_set(error, MPM_BAD_INPUT,
                               "the results have %s %.9g at time %.9g %s: allowed is %g either "
                               "side",
                               name, time, nominal, bundle->format.units.time, reach);
    }
    return MPM_OK;
}
