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

#include <glib.h>
#include <string.h>

#define PROGRAM "mpm-bench"

static const char usage[] =
    "usage: " PROGRAM " COMMAND\n"
    "\n"
    "  list                            the groups of benchmarks\n"
    "  run [--group NAME]... [--tier quick|standard] [--output DIR]\n"
    "      [--kernels auto|reference|fast] [--simd auto|baseline|x86-64-v3]\n"
    "                                  measure, and write results and report\n"
    "  report DIR                      render the report of DIR again from its result lines\n"
    "  compare DIR_A DIR_B             what differs between two runs, beyond noise and 5 %\n"
    "  budget [--functions] [--update] instructions, branches and bytes of some small runs "
    "against\n"
    "                                  the stored ones; --functions names the costliest "
    "functions,\n"
    "                                  --update stores the figures instead\n"
    "  help, --help, --version\n"
    "\n"
    "--tier is standard unless given: all groups take about 9 minutes on two processors, and "
    "under\n"
    "10.\n"
    "--output is build/reports/bench in the repository and bench-report elsewhere.\n"
    "Exit status: 0 done; 1 a budget is exceeded; 2 bad usage or bad input; 3 a run failed;\n"
    "4 the environment failed.\n";

/* ---------------------------------------------------------------- arguments */

struct options {
    char *tier, *output, *kernels, *simd;
    gboolean update, functions;
    char **groups, **rest; /* rest: the arguments beside the options */
};

struct command {
    struct options options;
    int argc;
    char **argv; /* as given to the program */
    const struct bench_world *world;
    int verdict; /* exit status of a command that was done */
};

static void options_clear(struct options *options)
{
    g_free(options->tier);
    g_free(options->output);
    g_free(options->kernels);
    g_free(options->simd);
    g_strfreev(options->groups);
    g_strfreev(options->rest);
}

/* Which options a command takes; bits of `takes` in the table of commands. */
enum { TAKES_RUN = 1, TAKES_BUDGET = 2 };

/* The place of `text` in a list of names; the first one if NULL. */
static enum mpm_status choose(const char *option, const char *text, const char *const *names,
                              size_t count, size_t *choice, struct mpm_error *error)
{
    GString *allowed = g_string_new(NULL);
    for (*choice = 0; *choice < count; ++*choice) {
        if (text == NULL || strcmp(text, names[*choice]) == 0)
            break;
        g_string_append_printf(allowed, "%s%s", *choice == 0 ? "" : ", ", names[*choice]);
    }
    const enum mpm_status status =
        *choice < count ? MPM_OK
                        : failure_set(error, MPM_BAD_INPUT, "--%s \"%s\": allowed are %s", option,
                                      text, allowed->str);
    g_string_free(allowed, TRUE);
    return status;
}

/* ----------------------------------------------------------------- commands */

static enum mpm_status command_list(struct command *command, struct mpm_error *error)
{
    size_t count;
    const struct bench_group *groups = bench_groups(&count);
    (void)error;
    for (size_t i = 0; i < count; i++)
        fprintf(command->world->out, "%-12s %s\n", groups[i].name, groups[i].description);
    return MPM_OK;
}

static enum mpm_status command_run(struct command *command, struct mpm_error *error)
{
    static const char *const tiers[] = {"standard", "quick"};
    static const char *const kernels[] = {"auto", "reference", "fast"};
    const char *simd[MPM_SIMD_COUNT];
    const struct options *options = &command->options;
    size_t tier, kernel, instructions;
    for (int i = 0; i < MPM_SIMD_COUNT; i++)
        simd[i] = mpm_simd_name((enum mpm_simd)i);
    TRY(choose("tier", options->tier, tiers, G_N_ELEMENTS(tiers), &tier, error));
    TRY(choose("kernels", options->kernels, kernels, G_N_ELEMENTS(kernels), &kernel, error));
    TRY(choose("simd", options->simd, simd, G_N_ELEMENTS(simd), &instructions, error));
    char *text = command_line_typed(PROGRAM, command->argc, command->argv);
    struct bench_console console = {.out = command->world->out,
                                    .terminal = command->world->terminal};
    const struct bench_run run = {
        .executable = command->argv[0],
        .command = text,
        .output = options->output,
        .groups = options->groups,
        .tier = tier == 0 ? BENCH_STANDARD : BENCH_QUICK,
        .simulation = {.threads = 1,
                       .kernels = (enum mpm_kernels)kernel,
                       .simd = (enum mpm_simd)instructions},
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

static const struct command_entry commands[] = {
    {"list", 0, 0, "", command_list},
    {"run", TAKES_RUN, 0, "", command_run},
    {"report", 0, 1, "report: the folder DIR", command_report},
    {"compare", 0, 2, "compare: a folder", command_compare},
    {"budget", TAKES_BUDGET, 0, "", command_budget},
};

int bench_command(int argc, char **argv, const struct bench_world *world)
{
    struct command command = {.argc = argc, .argv = argv, .world = world};
    struct options *const given = &command.options;
    const struct command_option options[] = {
        {TAKES_RUN, {"group", 0, 0, G_OPTION_ARG_STRING_ARRAY, &given->groups, NULL, NULL}},
        {TAKES_RUN, {"tier", 0, 0, G_OPTION_ARG_STRING, &given->tier, NULL, NULL}},
        {TAKES_RUN, {"output", 0, 0, G_OPTION_ARG_FILENAME, &given->output, NULL, NULL}},
        {TAKES_RUN, {"kernels", 0, 0, G_OPTION_ARG_STRING, &given->kernels, NULL, NULL}},
        {TAKES_RUN, {"simd", 0, 0, G_OPTION_ARG_STRING, &given->simd, NULL, NULL}},
        {TAKES_BUDGET, {"functions", 0, 0, G_OPTION_ARG_NONE, &given->functions, NULL, NULL}},
        {TAKES_BUDGET, {"update", 0, 0, G_OPTION_ARG_NONE, &given->update, NULL, NULL}},
    };
    const struct command_line line = {
        .program = PROGRAM,
        .usage = usage,
        .commands = commands,
        .command_count = G_N_ELEMENTS(commands),
        .options = options,
        .option_count = G_N_ELEMENTS(options),
        .rest = &given->rest,
        .out = world->out,
        .err = world->err,
    };
    const enum mpm_status status = command_line_run(&line, argc, argv, &command);
    options_clear(given);
    return status == MPM_OK ? command.verdict : (int)status;
}
