/* A measurement on several grids: the settings of each, the order of an error over them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_SUITE_LEVELS_H
#define VERIFICATION_SUITE_LEVELS_H

#include "verification/suite/programs.h"

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

/* Reports order_last and order_fitted of error[0 .. count - 1] > 0, with `suffix` ("_1")
 * behind each name, and writes the errors over the relative size of the cells as the series
 * levels<suffix>. */
enum mpm_status levels_report(struct measurement *measurement, const struct levels *levels,
                              const char *suffix, const double error[LEVELS_MAX],
                              struct mpm_error *failure);

#endif
