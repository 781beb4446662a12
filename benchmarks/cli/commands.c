/* The commands of mpm-bench: arguments and exit statuses.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "benchmarks/cli/commands.h"

#include "benchmarks/budget/budget_command.h"
#include "benchmarks/cli/compare.h"
#include "benchmarks/cli/run.h"
#include "benchmarks/common/bench.h"
#include "benchmarks/report/report.h"
#include "verification/common/command_line.h"
#include "verification/common/failure.h"
#include "verification/common/resources.h"

#include "mpm_commands.h"

#include <glib.h>
#include <stddef.h>
#include <string.h>

#define PROGRAM "mpm-bench"

/* ---------------------------------------------------------------- arguments */

struct options {
    char *tier, *output, *kernels, *simd;
    bool update, functions, names;
    char **groups, **rest; /* rest: the arguments beside the options */
};

struct command {
    struct options options;
    int argc;
    char **argv; /* as given to the program */
    const struct bench_world *world;
    int verdict; /* exit status of a command that was done */
};

/* Which options a command takes; bits of `takes` in the table of commands. */
enum { TAKES_RUN = 1, TAKES_BUDGET = 2, TAKES_LIST = 4 };

/* The place of `text`, one of `count` names; the first one if NULL. */
static size_t place_of(const char *text, const char *const *names, size_t count)
{
    size_t place = 0;
    while (text != NULL && place + 1 < count && strcmp(text, names[place]) != 0)
        place++;
    return place;
}

/* ----------------------------------------------------------------- commands */

static enum mpm_status command_list(struct command *command, struct mpm_error *error)
{
    size_t count;
    const struct bench_group *groups = bench_groups(&count);
    (void)error;
    for (size_t i = 0; i < count; i++)
        if (command->options.names)
            fprintf(command->world->out, "%s\n", groups[i].name);
        else
            fprintf(command->world->out, "%-12s %s\n", groups[i].name, groups[i].description);
    return MPM_OK;
}

static enum mpm_status command_run(struct command *command, struct mpm_error *error)
{
    static const char *const tiers[] = {"standard", "quick"};
    static const char *const kernels[] = {"auto", "reference", "fast"};
    const char *simd[MPM_SIMD_COUNT];
    const struct options *options = &command->options;
    for (int i = 0; i < MPM_SIMD_COUNT; i++)
        simd[i] = mpm_simd_name((enum mpm_simd)i);
    char *text = command_line_typed(PROGRAM, command->argc, command->argv);
    struct bench_console console = {.out = command->world->out,
                                    .terminal = command->world->terminal};
    const struct bench_run run = {
        .executable = command->argv[0],
        .command = text,
        .output = options->output,
        .groups = options->groups,
        .tier =
            place_of(options->tier, tiers, G_N_ELEMENTS(tiers)) == 0 ? BENCH_STANDARD : BENCH_QUICK,
        .simulation = {.threads = 1,
                       .kernels = (enum mpm_kernels)place_of(options->kernels, kernels,
                                                             G_N_ELEMENTS(kernels)),
                       .simd = (enum mpm_simd)place_of(options->simd, simd, G_N_ELEMENTS(simd))},
    };
    const enum mpm_status status = bench_run(&run, &console, error);
    g_free(text);
    return status;
}

static enum mpm_status command_report(struct command *command, struct mpm_error *error)
{
    return bench_report_write(command->options.rest[0], error);
}

static enum mpm_status command_compare(struct command *command, struct mpm_error *error)
{
    return bench_compare(command->options.rest[0], command->options.rest[1], command->world->out,
                         error);
}

enum { BUDGET_IS_EXCEEDED = 1 };

static enum mpm_status command_budget(struct command *command, struct mpm_error *error)
{
    char *program = resources_program(command->argv[0], "mpm");
    char *benchmarks = resources_benchmarks(command->argv[0]);
    char *catalogue = resources_catalogue(command->argv[0]);
    const struct budget_places places = {program, benchmarks, catalogue};
    const struct budget_options options = {&places, command->options.update,
                                           command->options.functions, command->world->out};
    bool exceeded = false;
    const enum mpm_status status =
        benchmarks == NULL || catalogue == NULL
            ? failure_set(error, MPM_ENVIRONMENT_FAILED,
                          "the scenes are found neither in benchmarks/ and "
                          "verification/catalogue/ nor beside the program")
            : budget_command(&options, &exceeded, error);
    command->verdict = exceeded ? BUDGET_IS_EXCEEDED : 0;
    g_free(program);
    g_free(benchmarks);
    g_free(catalogue);
    return status;
}

/* -------------------------------------------------------------------- table */

static const struct mpm_command_entry commands[] = {
    {"list", TAKES_LIST, "", "the groups of benchmarks", NULL, command_list, NULL},
    {"run", TAKES_RUN, "", "measure, and write results and report", NULL, command_run, NULL},
    {"report", 0, "DIR", "render the report of DIR again from its result lines", NULL,
     command_report, NULL},
    {"compare", 0, "DIR_A DIR_B", "what differs between two runs, beyond noise and 5 %", NULL,
     command_compare, NULL},
    {"budget", TAKES_BUDGET, "",
     "instructions, branches and bytes of some small runs against the stored ones", NULL,
     command_budget, NULL},
};

#define OPTION(who, key, member, form, what, text)                                                 \
    {                                                                                              \
        .takes = (who), .name = (key), .kind = MPM_OPTION_##form,                                  \
        .offset = offsetof(struct options, member), .value = (what), .help = (text)                \
    }

static const struct mpm_option option_table[] = {
    {.takes = TAKES_RUN,
     .name = "group",
     .kind = MPM_OPTION_LIST,
     .offset = offsetof(struct options, groups),
     .value = "NAME",
     .help = "only that group",
     .names = "list --names"},
    OPTION(TAKES_LIST, "names", names, FLAG, NULL, "print the names of the groups alone"),
    OPTION(TAKES_RUN, "tier", tier, TEXT, "quick|standard",
           "how long to measure; standard, 9 to 14 minutes on two processors, unless given"),
    OPTION(TAKES_RUN, "output", output, TEXT, "DIR",
           "folder of results and report; build/reports/bench in the repository and bench-report "
           "elsewhere unless given"),
    OPTION(TAKES_RUN, "kernels", kernels, TEXT, "auto|reference|fast", "kernels of the solver"),
    OPTION(TAKES_RUN, "simd", simd, TEXT, "auto|baseline|x86-64-v3",
           "instructions of the fast kernels"),
    OPTION(TAKES_BUDGET, "functions", functions, FLAG, NULL,
           "name the costliest functions of each run"),
    OPTION(TAKES_BUDGET, "update", update, FLAG, NULL,
           "store the figures instead of comparing with them"),
};

int bench_command(int argc, char **argv, const struct bench_world *world)
{
    struct command command = {.argc = argc, .argv = argv, .world = world};
    const struct mpm_command_line line = {
        .program = PROGRAM,
        .about = "Speed, memory and scaling of the solver on this machine.",
        .notes = "Exit status: 0 done; 1 a budget is exceeded; 2 bad usage or bad input; 3 a run "
                 "failed; 4 the environment failed.",
        .commands = commands,
        .command_count = G_N_ELEMENTS(commands),
        .options = option_table,
        .option_count = G_N_ELEMENTS(option_table),
        .values = &command.options,
        .rest = &command.options.rest,
        .out = world->out,
        .err = world->err,
    };
    const enum mpm_status status = mpm_command_line_run(&line, argc, argv, &command);
    mpm_command_line_clear(&line);
    return status == MPM_OK ? command.verdict : (int)status;
}
