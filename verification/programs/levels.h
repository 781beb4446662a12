/* A measurement on several levels: the settings of each, and what its errors do over them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_PROGRAMS_LEVELS_H
#define VERIFICATION_PROGRAMS_LEVELS_H

#include "verification/programs/programs.h"

enum { LEVELS_MAX = 8 };

/* Settings for the scene, the parameters level_1, level_2, ...: each halves the cells. */
struct levels {
    size_t count;
    const char *setting[LEVELS_MAX];
};

/* None, count = 0, where the variant gives no level_1. */
enum mpm_status levels_read(const struct measurement *measurement, struct levels *levels,
                            struct mpm_error *error);

/* How many runs that is: one on the scene's own grid if there are no levels. */
size_t levels_runs(const struct levels *levels);

/* Reports, with `suffix` ("_1") behind each name, of error[0 .. count - 1] on levels whose h
 * halves (NaN: its run did not come to its end): order_last; order_fitted; order_width, half of the
 * fitted order's interval of 95 % confidence (orders.h); order_class, the number of enum
 * order_class. */
void levels_report_orders(struct measurement *measurement, size_t count, const char *suffix,
                          const double *error);

/* The same of the measurement's levels; writes the errors over the relative size of the cells as
 * the series levels<suffix>. */
enum mpm_status levels_report(struct measurement *measurement, const struct levels *levels,
                              const char *suffix, const double error[LEVELS_MAX],
                              struct mpm_error *failure);

/* Reports `value` as the quantity <name><suffix>; inconclusive if it is NaN, which means a
 * run that did not come to its end. */
void levels_report_value(struct measurement *measurement, const char *name, const char *suffix,
                         double value);

#endif
