/* The command `mpm`: the only part of the solver that prints, reads arguments and
 * chooses an exit status.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_CLI_CLI_H
#define MPM_CLI_CLI_H

#include "mpm.h"

#include <glib.h>

/* A command gets its own name in argv[0] and returns an exit status. */
struct cli_command {
    const char *name;
    const char *operands; /* "SCENE" or "" */
    const char *summary;
    int (*run)(const struct cli_command *command, int argc, char **argv);
};

int cli_run(const struct cli_command *command, int argc, char **argv);
int cli_check(const struct cli_command *command, int argc, char **argv);
int cli_info(const struct cli_command *command, int argc, char **argv);
int cli_schema(const struct cli_command *command, int argc, char **argv);

/* Prints "mpm: ..." as one line on stderr; returns `status`. */
int cli_fail(enum mpm_status status, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Reads the options of a command in place and the scene that follows them. */
struct cli_arguments {
    const struct cli_command *command;
    const GOptionEntry *options;               /* ends with {NULL}; NULL for none */
    const char *description;                   /* end of the help text; may be NULL */
    struct mpm_simulation_options *simulation; /* of --kernels, --simd, --threads; NULL: none */
};

enum cli_outcome { CLI_GO_ON, CLI_HELP_SHOWN, CLI_BAD_USAGE };

/* Whatever is wrong has been reported when CLI_BAD_USAGE comes back. `scene` is NULL
 * for a command without operands; otherwise *scene is to be freed with g_free. */
enum cli_outcome cli_arguments_read(const struct cli_arguments *arguments, int argc, char **argv,
                                    char **scene);

/* Reads the scene with its --set texts (a list that ends with NULL, or NULL) and
 * reports what is wrong; the exit status is returned. */
int cli_scene_read(const char *path, char *const *settings, struct mpm_scene **scene);

#endif
