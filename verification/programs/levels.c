/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/programs/levels.h"

#include "verification/measures/orders.h"

#include <glib.h>
#include <math.h>

enum { COLUMNS = 2 };

enum mpm_status levels_read(const struct measurement *measurement, struct levels *levels,
                            struct mpm_error *error)
{
    *levels = (struct levels){0};
    for (char name[] = "level_1"; levels->count < LEVELS_MAX; levels->count++) {
        name[sizeof name - 2] = (char)('1' + levels->count);
        if (!measurement_has(measurement, name))
            break;
        TRY(measurement_text(measurement, name, &levels->setting[levels->count], error));
    }
    return MPM_OK;
}

size_t levels_runs(const struct levels *levels)
{
    return levels->count == 0 ? 1 : levels->count;
}

void levels_report_value(struct measurement *measurement, const char *name, const char *suffix,
                         double value)
{
    char *const quantity = g_strconcat(name, suffix, NULL);
    if (isnan(value))
        measurement_inconclusive(measurement, quantity,
                                 "a run did not come to its end, or these errors do not define it");
    else
        measurement_report(measurement, quantity, value);
    g_free(quantity);
}

/* NaN if an error is missing: no class reports that. */
static double class_of(size_t count, const double *h, const double *error)
{
    for (size_t k = 0; k < count; k++)
        if (isnan(error[k]))
            return (double)NAN;
    return (double)order_classify(count, h, error);
}

void levels_report_orders(struct measurement *measurement, size_t count, const char *suffix,
                          const double *error)
{
    double h[LEVELS_MAX] = {0.0};
    for (size_t k = 0; k < count; k++)
        h[k] = ldexp(1.0, -(int)k);
    const struct order_fit fit = order_fit(count, h, error);
    levels_report_value(measurement, "order_last", suffix, order_last(count, h, error));
    levels_report_value(measurement, "order_fitted", suffix, fit.order);
    levels_report_value(measurement, "order_width", suffix, fit.half_width);
    levels_report_value(measurement, "order_class", suffix, class_of(count, h, error));
}

enum mpm_status levels_report(struct measurement *measurement, const struct levels *levels,
                              const char *suffix, const double error[LEVELS_MAX],
                              struct mpm_error *failure)
{
    double rows[COLUMNS * LEVELS_MAX];
    for (size_t k = 0; k < levels->count; k++) {
        rows[COLUMNS * k] = ldexp(1.0, -(int)k);
        rows[COLUMNS * k + 1] = error[k];
    }
    levels_report_orders(measurement, levels->count, suffix, error);
    char *const series = g_strconcat("levels", suffix, NULL);
    const enum mpm_status status = measurement_series(measurement, series, "cell_over_first error",
                                                      COLUMNS, levels->count, rows, failure);
    g_free(series);
    return status;
}
