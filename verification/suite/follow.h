/* Following a simulation whose end may be the measurement.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_SUITE_FOLLOW_H
#define VERIFICATION_SUITE_FOLLOW_H

#include "verification/suite/programs.h"

/* Advances to `time`, landing on it. A run that its guard ends (MPM_RUN_FAILED) is a result:
 * *alive becomes false, and the guard's message is noted under the variant. Every other
 * failure is passed on. */
enum mpm_status follow_to(struct measurement *measurement, struct mpm_simulation *simulation,
                          double time, bool *alive, struct mpm_error *error);

/* Adds what was run so far to the particle-steps of the variant: once, at the end. */
void follow_count_work(struct measurement *measurement, const struct mpm_simulation *simulation);

#endif
