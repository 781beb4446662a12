/* The commands of mpm-verify: arguments and exit statuses.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/cli/commands.h"

#include "verification/cases/catalogue.h"
#include "verification/cli/compare.h"
#include "verification/common/command_line.h"
#include "verification/common/failure.h"
#include "verification/common/resources.h"
#include "verification/common/rows.h"
#include "verification/report/report.h"
#include "verification/report/report_stored.h"

#include <glib.h>
#include <math.h>

enum { CHECKS_FAILED = 1 };

static const char usage[] =
    "usage: " PROGRAM " COMMAND\n"
    "\n"
    "  list [--tag T]                         the cases, their variants and checks\n"
    "  run [--tier ci|full] [--case GLOB] [--variant GLOB] [--only FILE] [--baseline DIR]\n"
    "      [--kernels auto|reference|fast] [--jobs N] [--output DIR] [--resume]\n"
    "      [--launcher local|slurm] [--costs DIR] [--status]\n"
    "                                         run, judge, and write results and reports; --only: "
    "those\n"
    "                                         of the file's lines CASE/VARIANT; --baseline: what\n"
    "                                         changed since that run, in the report; --resume: "
    "goes\n"
    "                                         on with the run in DIR: runs only what is missing "
    "or\n"
    "                                         whose binary, case or scene has changed; "
    "--launcher:\n"
    "                                         on Slurm, with time and memory by the costs of the "
    "run in\n"
    "                                         --costs DIR; --status: how far the run in DIR is\n"
    "  tasks [selection] [--output DIR] [--resume]\n"
    "                                         begins a run for any other engine: prints a command "
    "line\n"
    "                                         for each program that has no result\n"
    "  task DIR CASE/VARIANT                  such a line: runs it, and keeps its result in DIR\n"
    "  collect DIR                            the report of the results in DIR; runs nothing\n"
    "  study SCENE|STUDY [--refine N,N,...] [--vary PATH=V,...]... [--set PATH=V]... [--resume]\n"
    "      [--measure QUANTITY[:TAKE[@TIME or @X,Y]][=REFERENCE]]... [--timeout S] [--kernels K]\n"
    "      [--jobs N] [--output DIR] [--launcher local|slurm] [--costs DIR] [--tasks]\n"
    "                                         a convergence study of your scene: tables, orders "
    "and\n"
    "                                         pictures (docs/tutorial-study.md)\n"
    "  explain CHECK [--output DIR]           what CASE[/CHECK[/VARIANT]] (globs) states, its "
    "band\n"
    "                                         and why, last values, the command to reproduce it\n"
    "  report DIR [--baseline DIR]            render the reports of DIR again from its result "
    "lines;\n"
    "      [--mutants FILE]                   stores there, and shows, what changed since a "
    "baseline,\n"
    "      [--headroom NAME=DIR]...           a run of mutants, the values of other builds' runs,\n"
    "      [--history DIR]...                 the course of each value over earlier runs and\n"
    "                                         benchmarks, oldest first\n"
    "  headroom DIR                           whether every check of DIR is within 1.5 to 100 "
    "times\n"
    "                                         its deviation from its band's end, over the builds "
    "stored\n"
    "                                         there, or states why not\n"
    "  compare DIR DIR [--change X]           what changed from the first run to the second: "
    "statuses,\n"
    "                                         checks, values by more than X (relative, 0.001 "
    "unless\n"
    "                                         given), margins, times beyond noise\n"
    "  export --output DIR [--case GLOB]      bundles for other solvers: problem, reference, "
    "criteria\n"
    "  score BUNDLE RESULTS [--name SOLVER] [--output DIR]\n"
    "                                         judges another solver's results (CSV, HDF5, VTK) "
    "against\n"
    "                                         a bundle, and writes the same report\n"
    "  help, --help, --version\n"
    "\n"
    "list, run, tasks, explain, report and export take --catalogue DIR. --tier is ci unless "
    "given;\n"
    "--kernels is auto, fast wherever a scene allows; --jobs the number of processors; --output\n"
    "build/reports/verify in the repository and verify-report elsewhere (score: "
    "build/reports/score\n"
    "and score-report; study: mpm-study).\n"
    "Exit status: 0 every check holds (or shows its known weakness); 1 one does not; 2 bad usage\n"
    "or a bad catalogue; 4 the environment failed; 128 + n ended by signal n. headroom: 1 a band "
    "or its reason is at fault, "
    "or\n"
    "a value is missing. compare: 0 nothing got worse; 1 a status did,\n"
    "a check failed that is new or vanished from the same selection, or a margin shrank by more\n"
    "than 0.1. Time is shown, never judged: mpm-bench compares speed.\n";

/* ----------------------------------------------------------------- arguments */

static void options_clear(struct command_options *options)
{
    g_free(options->tier);
    g_free(options->case_glob);
    g_free(options->variant_glob);
    g_free(options->only);
    g_free(options->kernels);
    g_free(options->output);
    g_free(options->catalogue);
    g_free(options->tag);
    g_free(options->change);
    g_free(options->name);
    g_free(options->baseline);
    g_free(options->launcher);
    g_free(options->costs);
    g_free(options->mutants);
    g_free(options->refine);
    g_free(options->timeout);
    g_strfreev(options->vary);
    g_strfreev(options->settings);
    g_strfreev(options->measures);
    g_strfreev(options->headroom);
    g_strfreev(options->history);
    g_strfreev(options->rest);
}

/* Which options a command takes; bits of `takes` in the table of commands. */
enum {
    TAKES_SELECTION = 1,
    TAKES_OUTPUT = 2,
    TAKES_CATALOGUE = 4,
    TAKES_TAG = 8,
    TAKES_CHANGE = 16,
    TAKES_CASE = 32,
    TAKES_NAME = 64,
    TAKES_BASELINE = 128,
    TAKES_ADDITIONS = 256,
    TAKES_RESUME = 512,
    TAKES_LAUNCHER = 1024,
    TAKES_STUDY = 2048,
    TAKES_STATUS = 4096
};

enum mpm_status command_catalogue(const struct command *command, struct catalogue **catalogue,
                                  struct mpm_error *error)
{
    char *folder = command->options.catalogue != NULL ? g_strdup(command->options.catalogue)
                                                      : resources_catalogue(command->argv[0]);
    const enum mpm_status status =
        folder == NULL ? failure_set(error, MPM_BAD_INPUT, NO_CATALOGUE)
                       : catalogue_read(folder, command->world->programs, catalogue, error);
    g_free(folder);
    return status;
}

/* ------------------------------------------------------------ report, compare */

static enum mpm_status command_report(struct command *command, struct mpm_error *error)
{
    const char *folder = command->options.rest[0];
    const struct report_additions additions = {
        .baseline = command->options.baseline,
        .mutants = command->options.mutants,
        .headroom = (const char *const *)command->options.headroom,
        .history = (const char *const *)command->options.history,
    };
    TRY(report_check(folder, error)); /* before anything is written there */
    TRY(report_store(folder, &additions, error));
    char *reports = resources_reports(command->argv[0]);
    char *catalogue = command->options.catalogue != NULL ? g_strdup(command->options.catalogue)
                                                         : resources_catalogue(command->argv[0]);
    const struct report_sources sources = {.reports = reports, .catalogue = catalogue};
    const enum mpm_status status = report_status(report_render(folder, folder, &sources, error));
    g_free(catalogue);
    g_free(reports);
    if (status == MPM_OK)
        fprintf(command->world->out, "report: %s/index.html\n", folder);
    return status;
}

static enum mpm_status command_compare(struct command *command, struct mpm_error *error)
{
    const struct command_options *options = &command->options;
    double change = 1e-3;
    if (options->change != NULL &&
        (!row_number(options->change, &change) || !(change >= 0) || !isfinite(change)))
        return failure_set(error, MPM_BAD_INPUT,
                           "--change \"%s\": allowed is a number of at least 0", options->change);
    return suite_compare(options->rest[0], options->rest[1], change, command->world->out,
                         &command->checks_failed, error);
}

/* --------------------------------------------------------------------- table */

static const struct command_entry commands[] = {
    {"list", TAKES_TAG | TAKES_CATALOGUE, 0, "", command_list},
    {"run",
     TAKES_SELECTION | TAKES_OUTPUT | TAKES_CATALOGUE | TAKES_BASELINE | TAKES_RESUME |
         TAKES_LAUNCHER | TAKES_STATUS,
     0, "", command_run},
    {"tasks", TAKES_SELECTION | TAKES_OUTPUT | TAKES_CATALOGUE | TAKES_BASELINE | TAKES_RESUME, 0,
     "", command_tasks},
    {"task", 0, 2, "task: DIR or CASE/VARIANT", command_task},
    {"collect", 0, 1, "collect: the folder DIR", command_collect},
    {"study", TAKES_STUDY | TAKES_OUTPUT | TAKES_RESUME | TAKES_LAUNCHER, 1,
     "study: SCENE or STUDY", command_study},
    {"explain", TAKES_OUTPUT | TAKES_CATALOGUE, 1, "explain: CHECK", command_explain},
    {"report", TAKES_BASELINE | TAKES_ADDITIONS | TAKES_CATALOGUE, 1, "report: the folder DIR",
     command_report},
    {"headroom", 0, 1, "headroom: the folder DIR", command_headroom},
    {"compare", TAKES_CHANGE, 2, "compare: a folder DIR", command_compare},
    {"export", TAKES_CASE | TAKES_OUTPUT | TAKES_CATALOGUE, 0, "", command_export},
    {"score", TAKES_NAME | TAKES_OUTPUT, 2, "score: BUNDLE or RESULTS", command_score},
};

int suite_command(int argc, char **argv, const struct suite_world *world)
{
    struct command command = {
        .argc = argc, .argv = argv, .world = world, .options = {.jobs = JOBS_DEFAULT}};
    struct command_options *const given = &command.options;
    const struct command_option options[] = {
        {TAKES_SELECTION, {"tier", 0, 0, G_OPTION_ARG_STRING, &given->tier, NULL, NULL}},
        {TAKES_SELECTION | TAKES_CASE,
         {"case", 0, 0, G_OPTION_ARG_STRING, &given->case_glob, NULL, NULL}},
        {TAKES_SELECTION, {"variant", 0, 0, G_OPTION_ARG_STRING, &given->variant_glob, NULL, NULL}},
        {TAKES_SELECTION, {"only", 0, 0, G_OPTION_ARG_FILENAME, &given->only, NULL, NULL}},
        {TAKES_SELECTION | TAKES_STUDY,
         {"kernels", 0, 0, G_OPTION_ARG_STRING, &given->kernels, NULL, NULL}},
        {TAKES_SELECTION | TAKES_STUDY, {"jobs", 0, 0, G_OPTION_ARG_INT, &given->jobs, NULL, NULL}},
        {TAKES_LAUNCHER, {"launcher", 0, 0, G_OPTION_ARG_STRING, &given->launcher, NULL, NULL}},
        {TAKES_LAUNCHER, {"costs", 0, 0, G_OPTION_ARG_FILENAME, &given->costs, NULL, NULL}},
        {TAKES_STATUS, {"status", 0, 0, G_OPTION_ARG_NONE, &given->status, NULL, NULL}},
        {TAKES_STUDY, {"tasks", 0, 0, G_OPTION_ARG_NONE, &given->tasks, NULL, NULL}},
        {TAKES_STUDY, {"refine", 0, 0, G_OPTION_ARG_STRING, &given->refine, NULL, NULL}},
        {TAKES_STUDY, {"timeout", 0, 0, G_OPTION_ARG_STRING, &given->timeout, NULL, NULL}},
        {TAKES_STUDY, {"vary", 0, 0, G_OPTION_ARG_STRING_ARRAY, &given->vary, NULL, NULL}},
        {TAKES_STUDY, {"set", 0, 0, G_OPTION_ARG_STRING_ARRAY, &given->settings, NULL, NULL}},
        {TAKES_STUDY, {"measure", 0, 0, G_OPTION_ARG_STRING_ARRAY, &given->measures, NULL, NULL}},
        {TAKES_RESUME, {"resume", 0, 0, G_OPTION_ARG_NONE, &given->resume, NULL, NULL}},
        {TAKES_OUTPUT, {"output", 0, 0, G_OPTION_ARG_FILENAME, &given->output, NULL, NULL}},
        {TAKES_CATALOGUE,
         {"catalogue", 0, 0, G_OPTION_ARG_FILENAME, &given->catalogue, NULL, NULL}},
        {TAKES_TAG, {"tag", 0, 0, G_OPTION_ARG_STRING, &given->tag, NULL, NULL}},
        {TAKES_BASELINE, {"baseline", 0, 0, G_OPTION_ARG_FILENAME, &given->baseline, NULL, NULL}},
        {TAKES_ADDITIONS, {"mutants", 0, 0, G_OPTION_ARG_FILENAME, &given->mutants, NULL, NULL}},
        {TAKES_ADDITIONS,
         {"headroom", 0, 0, G_OPTION_ARG_FILENAME_ARRAY, &given->headroom, NULL, NULL}},
        {TAKES_ADDITIONS,
         {"history", 0, 0, G_OPTION_ARG_FILENAME_ARRAY, &given->history, NULL, NULL}},
        {TAKES_CHANGE, {"change", 0, 0, G_OPTION_ARG_STRING, &given->change, NULL, NULL}},
        {TAKES_NAME, {"name", 0, 0, G_OPTION_ARG_STRING, &given->name, NULL, NULL}},
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
    if (status == MPM_INTERRUPTED)
        return (int)status + command.signal_number;
    /* results that could not be written or drawn come before their verdict */
    return status == MPM_OK && command.checks_failed ? CHECKS_FAILED : (int)status;
}
