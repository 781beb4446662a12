/* mpm-verify compare: two runs of the suite against each other.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_CLI_COMPARE_H
#define VERIFICATION_CLI_COMPARE_H

#include "verification/common/failure.h"

#include <stdbool.h>
#include <stdio.h>

/* Prints what changed from the run in `before` to that in `after`: statuses, checks that
 * appeared or vanished, values by more than the relative `change`, margins, and times beyond
 * noise. *worse: a status got worse, a red check appeared, a check vanished although the same
 * was selected, or a margin shrank by more than RUN_CHANGE_MARGIN; time never counts.
 * MPM_BAD_INPUT: a folder without results. */
enum mpm_status suite_compare(const char *before, const char *after, double change, FILE *out,
                              bool *worse, struct mpm_error *error);

#endif
