/* The command line that mpm-verify and mpm-bench share: a table of commands, each with the options
 * that it takes.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_COMMON_COMMAND_LINE_H
#define VERIFICATION_COMMON_COMMAND_LINE_H

#include "mpm.h"

#include <glib.h>
#include <stdio.h>

struct command; /* each program's own: its options, and what its commands work on */

struct command_entry {
    const char *name;
    unsigned takes;        /* bits: which options */
    size_t rest;           /* how many arguments there are beside them */
    const char *rest_name; /* the first of these, as in the message that it is missing */
    enum mpm_status (*run)(struct command *command, struct mpm_error *error);
};

struct command_option {
    unsigned takes; /* the bit of the commands that take it */
    GOptionEntry entry;
};

struct command_line {
    const char *program, *usage;
    const struct command_entry *commands;
    size_t command_count;
    const struct command_option *options;
    size_t option_count;
    char ***rest;    /* where the arguments beside the options go; g_strfreev */
    FILE *out, *err; /* help and version; messages */
};

/* Runs the command that the arguments name, or prints help or the version; prints on `err` what
 * went wrong. MPM_BAD_INPUT: no such command, an option that it does not take, too few or too many
 * arguments; nothing was run. Else what the command comes to. */
enum mpm_status command_line_run(const struct command_line *line, int argc, char **argv,
                                 struct command *command);

/* The command as typed, quoted for the shell, under the program's own name; g_free. */
char *command_line_typed(const char *program, int argc, char **argv);

#endif
