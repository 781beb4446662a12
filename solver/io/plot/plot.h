/* Pictures of a folder of results, by gnuplot: particles with their domains, and the history.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_IO_PLOT_H
#define MPM_IO_PLOT_H

#include "mpm.h"

struct mpm_plot_options {
    const char *folder;   /* of the results */
    const char *output;   /* folder for the pictures, made if it is not there */
    const char *field;    /* "von_mises", "temperature", "stress.xx" */
    const char *snapshot; /* its number; NULL: the last one */
    const char *format;   /* "svg" or "png" */
};

enum { MPM_PLOT_PARTICLES, MPM_PLOT_HISTORY, MPM_PLOT_COUNT };

/* Draws one picture of the particles of a snapshot and one of the history; their paths go to
 * `pictures` (g_free), as they are done. MPM_BAD_INPUT: no results there, no such snapshot, field
 * or format, a file that is not what `mpm run` writes. MPM_ENVIRONMENT_FAILED: gnuplot is missing
 * or fails, a folder that cannot be written. */
enum mpm_status mpm_plot(const struct mpm_plot_options *options, char *pictures[MPM_PLOT_COUNT],
                         struct mpm_error *error);

/* A line for each field that can be drawn: those of snapshots, and what is computed from them;
 * g_free. */
char *mpm_plot_fields(void);

/* The names of fields as `field` has them, a line each, for shells: those that the snapshot of the
 * folder has, or all if `folder` is NULL; g_free. MPM_BAD_INPUT: no such snapshot. */
enum mpm_status mpm_plot_names(const struct mpm_plot_options *options, char **names,
                               struct mpm_error *error);

#endif
