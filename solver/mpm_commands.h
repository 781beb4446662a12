/* The command line of the programs: tables of commands and options, from which come the reader,
 * its messages, the help of a program and of each command, and the completion of shells.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_COMMANDS_H
#define MPM_COMMANDS_H

#include "mpm.h"

#include <stdio.h>

struct command; /* each program's own: its options, and what its commands work on */

enum mpm_option_kind {
    MPM_OPTION_FLAG,    /* bool: without a value */
    MPM_OPTION_TEXT,    /* char *: given once */
    MPM_OPTION_INTEGER, /* int: given once */
    MPM_OPTION_LIST,    /* char **, NULL at the end: what is given, in order */
    MPM_OPTION_JOINED,  /* char *: what is given, joined by commas */
};

struct mpm_option {
    unsigned takes; /* bits: the commands that take it */
    const char *name;
    char letter; /* its short form, or 0 */
    enum mpm_option_kind kind;
    size_t offset;     /* of its value in the options of the program */
    const char *value; /* in help: "DIR", "ci|full"; NULL for a flag */
    const char *help;
    /* A command of the program that prints what the value may be, or NULL. With " DIR" at its end
     * it is given the first folder of the command line, or nothing where there is none. */
    const char *names;
};

/* What completion offers for a value, and for an operand, is read off its name: the choices of
 * "a|b", folders for DIR and BUNDLE, files for FILE, SCENE and RESULTS; or `names` prints it. */
struct mpm_command_entry {
    const char *name;
    unsigned takes;          /* bits: its options */
    const char *operands;    /* "DIR CASE/VARIANT", each required; "[DIR]" may be left out; or "" */
    const char *summary;     /* one line */
    const char *description; /* end of its help, or NULL */
    enum mpm_status (*run)(struct command *command, struct mpm_error *error);
    const char *names; /* as those of an option, for the first operand; or NULL */
};

struct mpm_command_line {
    const char *program, *about, *notes; /* notes: end of the program's help */
    const struct mpm_command_entry *commands;
    size_t command_count;
    const struct mpm_option *options;
    size_t option_count;
    void *values;    /* the struct that the options go to */
    char ***rest;    /* where the operands go */
    FILE *out, *err; /* help, version and completion; messages */
};

/* Runs the command that the arguments name, or prints help, the version, or a completion; prints on
 * `err` what went wrong, unless the message is empty. MPM_BAD_INPUT: no such command, an option
 * that it does not take or that is given twice and is no list, too few or too many operands;
 * nothing was run. Else what the command comes to. */
enum mpm_status mpm_command_line_run(const struct mpm_command_line *line, int argc, char **argv,
                                     struct command *command);

/* Frees the values of all options and the operands. */
void mpm_command_line_clear(const struct mpm_command_line *line);

/* ------------------------------------------- shared by the parts of the reader */

/* Puts the options of a command and its operands where they go; *help: its help is asked for. */
enum mpm_status mpm_options_read(const struct mpm_command_line *line,
                                 const struct mpm_command_entry *entry, int argc, char **argv,
                                 bool *help, struct mpm_error *error);

size_t mpm_operands_count(const struct mpm_command_entry *entry);

#endif
