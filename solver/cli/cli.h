/* The command `mpm`: the only part of the solver that prints, reads arguments and
 * chooses an exit status.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_CLI_CLI_H
#define MPM_CLI_CLI_H

#include "mpm_commands.h"

#include <glib.h>

/* A command line, read. What a command does not take is NULL or false. */
struct cli_arguments {
    char *output, *kernels, *simd, *threads, *filter;
    char *field, *snapshot, *format;
    char **settings; /* texts of --set; ends with NULL, or is NULL */
    char **operands;
    bool overwrite, resume, quiet, json, list, names;
};

struct command {
    struct cli_arguments arguments;
    const char *scene; /* the operand of run and check */
    struct mpm_simulation_options simulation;
    int signal_number; /* of MPM_INTERRUPTED */
};

enum mpm_status cli_run(struct command *command, struct mpm_error *error);
enum mpm_status cli_check(struct command *command, struct mpm_error *error);
enum mpm_status cli_info(struct command *command, struct mpm_error *error);
enum mpm_status cli_schema(struct command *command, struct mpm_error *error);
enum mpm_status cli_new(struct command *command, struct mpm_error *error);
enum mpm_status cli_plot(struct command *command, struct mpm_error *error);

/* What --kernels, --simd and --threads mean, and the operand; `name`: of the command. */
enum mpm_status cli_take_simulation(struct command *command, const char *name,
                                    struct mpm_error *error);

/* Reads the scene with its --set texts. */
enum mpm_status cli_scene_read(const struct command *command, struct mpm_scene **scene,
                               struct mpm_error *error);

#endif
