/* How far a run is: a bar on a terminal, a line at each tenth elsewhere.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_CLI_PROGRESS_H
#define MPM_CLI_PROGRESS_H

#include "mpm.h"

#include <glib.h>

struct cli_progress {
    bool quiet, terminal;
    bool line_open;          /* a bar is on the terminal's line */
    gint64 start, next_draw; /* microseconds */
    int tenths;              /* reported so far */
    double first;            /* what was done of the run before: above 0 if it was resumed */
    /* as of the last step */
    uint64_t step;
    size_t particles;
    double seconds; /* spent stepping */
};

/* `quiet` counts steps and prints nothing. Output goes to stderr. */
void cli_progress_start(struct cli_progress *progress, bool quiet);

/* For struct mpm_run_options: `progress` is a struct cli_progress. */
void cli_progress_step(void *progress, double fraction, const struct mpm_simulation *simulation);

/* The same: prints a warning on a line of its own. */
void cli_progress_warn(void *progress, const char *warning);

/* Ends the terminal's line, so that what follows starts on one of its own. */
void cli_progress_end(struct cli_progress *progress);

#endif
