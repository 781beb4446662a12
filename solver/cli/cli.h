/* The command `mpm`: the only part of the solver that prints, reads arguments and
 * chooses an exit status.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_CLI_CLI_H
#define MPM_CLI_CLI_H

#include "mpm.h"

#include <glib.h>

/* A command line, read. What a command does not take is NULL or FALSE. */
struct cli_arguments {
    char *scene, *output; /* the operand, whatever it is: a scene, a kind, a folder */
    char *field, *snapshot, *format;
    char **settings; /* texts of --set; ends with NULL, or is NULL */
    struct mpm_simulation_options simulation;
    gboolean overwrite, resume, quiet, json, list;
};

struct cli_command {
    const char *name;
    const char *operands;       /* "SCENE", "" or, where it may be missing, "[KIND]" */
    const char *const *options; /* names of those that it takes; ends with NULL */
    const char *summary;
    const char *description;                     /* end of the help text; may be NULL */
    int (*run)(struct cli_arguments *arguments); /* returns an exit status */
};

int cli_run(struct cli_arguments *arguments);
int cli_check(struct cli_arguments *arguments);
int cli_info(struct cli_arguments *arguments);
int cli_schema(struct cli_arguments *arguments);
int cli_new(struct cli_arguments *arguments);
int cli_plot(struct cli_arguments *arguments);

/* Prints "mpm: ..." as one line on stderr; returns `status`. */
int cli_fail(enum mpm_status status, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Reads what follows a command's name, argv[0], and runs it; prints its help with --help. Returns
 * the exit status; whatever is wrong has been reported. */
int cli_command_run(const struct cli_command *command, int argc, char **argv);

/* Reads the scene with its --set texts and reports what is wrong; the exit status is returned. */
int cli_scene_read(const struct cli_arguments *arguments, struct mpm_scene **scene);

#endif
