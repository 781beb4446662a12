/* The commands of mpm-verify.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_CLI_COMMANDS_H
#define VERIFICATION_CLI_COMMANDS_H

#include "verification/programs/programs.h"

#include <limits.h>
#include <stdio.h>

#define PROGRAM      "mpm-verify"
#define NO_CATALOGUE "no verification/catalogue here: name one with --catalogue DIR"

enum { JOBS_DEFAULT = INT_MIN /* not given */ };

/* What the commands see of the world; tests bring their own. */
struct suite_world {
    FILE *out, *err;
    bool terminal; /* out is one */
    struct program_table programs;
};

/* Runs the command of the arguments. Returns the exit status: 0 done and every check
 * holds, 1 a check does not hold, 2 bad usage or a bad catalogue, 4 the environment
 * failed (a file that cannot be written, gnuplot missing), 128 + n interrupted by signal n. */
int suite_command(int argc, char **argv, const struct suite_world *world);

/* ------------------------------------------- shared by the files of commands */

struct command_options {
    char *case_globs, *variant_globs, *tags; /* joined by commas where several are given */
    char *tier, *only, *kernels, *output, *catalogue, *change;
    char *name; /* of a solver */
    char *baseline, *api, *mutants, **headroom, **history;
    char *launcher, *costs;
    char *refine, *timeout, **vary, **settings, **measures; /* of a study */
    int jobs;
    bool resume, status, verbose, names, tasks;
    char **rest; /* the arguments beside the options */
};

struct command {
    struct command_options options;
    int argc;
    char **argv; /* as given to the program */
    const struct suite_world *world;
    bool checks_failed;
    int signal_number; /* of MPM_INTERRUPTED */
};

enum mpm_status command_run(struct command *command, struct mpm_error *error);
enum mpm_status command_tasks(struct command *command, struct mpm_error *error);
enum mpm_status command_task(struct command *command, struct mpm_error *error);
enum mpm_status command_collect(struct command *command, struct mpm_error *error);
enum mpm_status command_study(struct command *command, struct mpm_error *error);
enum mpm_status command_list(struct command *command, struct mpm_error *error);
enum mpm_status command_explain(struct command *command, struct mpm_error *error);
enum mpm_status command_headroom(struct command *command, struct mpm_error *error);
enum mpm_status command_export(struct command *command, struct mpm_error *error);
enum mpm_status command_score(struct command *command, struct mpm_error *error);

/* As command_run, command_tasks, for the catalogue, the output and so on in `given`. */
enum mpm_status command_run_given(struct command *command, const struct command_options *given,
                                  struct mpm_error *error);
enum mpm_status command_tasks_given(struct command *command, const struct command_options *given,
                                    struct mpm_error *error);
/* Writes and prints the tables of a study, if the run in `output` is of the study's catalogue. */
enum mpm_status command_study_tables(struct command *command, const char *output,
                                     const char *catalogue, struct mpm_error *error);

struct catalogue;

/* Reads the catalogue that the options name, or the suite's own. */
enum mpm_status command_catalogue(const struct command *command, struct catalogue **catalogue,
                                  struct mpm_error *error);

#endif
