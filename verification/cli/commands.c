/* The commands of mpm-verify: arguments and exit statuses.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/cli/commands.h"

#include "verification/cases/catalogue.h"
#include "verification/cli/compare.h"
#include "verification/common/failure.h"
#include "verification/common/resources.h"
#include "verification/common/rows.h"
#include "verification/report/report.h"
#include "verification/report/report_stored.h"

#include "mpm_commands.h"
#include "mpm_file.h"

#include <glib.h>
#include <math.h>
#include <stddef.h>

enum { CHECKS_FAILED = 1 };

/* Which options a command takes; bits of `takes` in the table of commands. */
enum {
    TAKES_SELECTION = 1,
    TAKES_OUTPUT = 2,
    TAKES_CATALOGUE = 4,
    TAKES_TAG = 8,
    TAKES_CHANGE = 16,
    TAKES_CASE = 32,
    TAKES_NAME = 64,
    TAKES_BESIDE = 128,
    TAKES_ADDITIONS = 256,
    TAKES_RESUME = 512,
    TAKES_LAUNCHER = 1024,
    TAKES_LAST_RUN = 2048,
    TAKES_VERBOSE = 4096,
    TAKES_STUDY = 8192,
    TAKES_STATUS = 16384
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
        .api = command->options.api,
    };
    if (command->options.catalogue != NULL && !mpm_path_is_folder(command->options.catalogue))
        return failure_set(error, MPM_BAD_INPUT, "--catalogue %s: no such folder of a catalogue",
                           command->options.catalogue);
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

static const struct mpm_command_entry commands[] = {
    {"list", TAKES_TAG | TAKES_CATALOGUE, "", "the cases, their variants and checks", NULL,
     command_list, NULL},
    {"run",
     TAKES_SELECTION | TAKES_OUTPUT | TAKES_CATALOGUE | TAKES_BESIDE | TAKES_RESUME |
         TAKES_LAUNCHER | TAKES_STATUS | TAKES_VERBOSE,
     "", "run, judge, and write results and reports", NULL, command_run, NULL},
    {"tasks", TAKES_SELECTION | TAKES_OUTPUT | TAKES_CATALOGUE | TAKES_BESIDE | TAKES_RESUME, "",
     "begin a run for any other engine: print a command line for each program that has no result",
     NULL, command_tasks, NULL},
    {"task", 0, "DIR CASE/VARIANT",
     "such a line: run its program, and keep the result in the folder DIR",
     "Exit status: 0 the result is there; else the task is to be run again.", command_task, NULL},
    {"collect", TAKES_VERBOSE, "DIR", "write the report of the results in DIR; run nothing", NULL,
     command_collect, NULL},
    {"study", TAKES_STUDY | TAKES_RESUME | TAKES_LAUNCHER | TAKES_VERBOSE, "SCENE",
     "a convergence study of your scene: tables, orders and pictures",
     "SCENE is a scene, or the file of a study (docs/tutorial-study.md). With --resume and no "
     "other option of the study, a scene goes on with the study in the output folder.",
     command_study, NULL},
    {"explain", TAKES_LAST_RUN | TAKES_CATALOGUE, "CHECK",
     "what a check states, its band and why, last values, the command to reproduce it",
     "CHECK is CASE[/CHECK[/VARIANT]], with globs. Of a CASE alone all is printed.",
     command_explain, "list --names"},
    {"report", TAKES_BESIDE | TAKES_ADDITIONS | TAKES_CATALOGUE, "DIR",
     "render the reports of DIR again from its result lines",
     "What --baseline, --mutants, --headroom, --history and --api name is stored in DIR, and in "
     "each report of it from then on.",
     command_report, NULL},
    {"headroom", 0, "DIR",
     "whether every check of DIR is within 1.5 to 100 times its deviation from its band's end, "
     "over the builds stored there, or states why not",
     "Exit status: 1 a band or its reason is at fault, or a value is missing.", command_headroom,
     NULL},
    {"compare", TAKES_CHANGE, "DIR DIR",
     "what changed from the first run to the second: statuses, checks, values, margins, times "
     "beyond noise",
     "Exit status: 0 nothing got worse; 1 a status did, a check failed that is new or vanished "
     "from the same selection, or a margin shrank by more than 0.1. Time is shown, never judged: "
     "mpm-bench compares speed.",
     command_compare, NULL},
    {"export", TAKES_CASE | TAKES_OUTPUT | TAKES_CATALOGUE, "",
     "write bundles for other solvers: problem, reference, criteria", "--output is required.",
     command_export, NULL},
    {"score", TAKES_NAME | TAKES_OUTPUT, "BUNDLE RESULTS",
     "judge another solver's results (CSV, HDF5, VTK) against a bundle, and write the same report",
     NULL, command_score, NULL},
};

/* ------------------------------------------------------------------- options */

#define OPTION(who, key, member, form, what, text)                                                 \
    {                                                                                              \
        .takes = (who), .name = (key), .kind = MPM_OPTION_##form,                                  \
        .offset = offsetof(struct command_options, member), .value = (what), .help = (text)        \
    }

static const struct mpm_option options[] = {
    OPTION(TAKES_TAG, "tag", tags, JOINED, "T", "only cases with that tag"),
    OPTION(TAKES_TAG, "names", names, FLAG, NULL, "print the names of the cases alone"),
    OPTION(TAKES_SELECTION, "tier", tier, TEXT, "ci|full", "the size of the run; ci unless given"),
    {.takes = TAKES_SELECTION | TAKES_CASE,
     .name = "case",
     .kind = MPM_OPTION_JOINED,
     .offset = offsetof(struct command_options, case_globs),
     .value = "GLOB",
     .help = "only cases whose names match; GLOB,GLOB for several",
     .names = "list --names"},
    OPTION(TAKES_SELECTION, "variant", variant_globs, JOINED, "GLOB",
           "only variants whose names match; GLOB,GLOB for several"),
    OPTION(TAKES_SELECTION, "only", only, TEXT, "FILE",
           "only the variants of FILE, a line CASE/VARIANT each"),
    OPTION(TAKES_SELECTION | TAKES_STUDY, "kernels", kernels, TEXT, "auto|reference|fast",
           "auto, fast wherever a scene allows, unless given"),
    OPTION(TAKES_SELECTION | TAKES_STUDY, "jobs", jobs, INTEGER, "N",
           "processes at a time; the number of processors unless given"),
    OPTION(TAKES_RESUME, "resume", resume, FLAG, NULL,
           "go on with the run in the output folder: only what is missing there or whose binary, "
           "case or scene has changed"),
    OPTION(TAKES_LAUNCHER, "launcher", launcher, TEXT, "local|slurm",
           "where the programs run; local unless given"),
    OPTION(TAKES_LAUNCHER, "costs", costs, TEXT, "DIR",
           "folder of an earlier run: time and memory asked of Slurm follow from it"),
    OPTION(TAKES_STATUS, "status", status, FLAG, NULL,
           "print how far the run in the output folder is, and run nothing"),
    {.takes = TAKES_VERBOSE,
     .name = "verbose",
     .letter = 'v',
     .kind = MPM_OPTION_FLAG,
     .offset = offsetof(struct command_options, verbose),
     .help = "print a line for each check, not for each case"},
    OPTION(TAKES_BESIDE, "baseline", baseline, TEXT, "DIR",
           "folder of an earlier run: what changed since then, in the report"),
    OPTION(TAKES_BESIDE, "api", api, TEXT, "DIR",
           "pages of the library's headers (make docs; build/docs/html), for the report"),
    OPTION(TAKES_ADDITIONS, "mutants", mutants, TEXT, "FILE",
           "mutants.json of a run of planted bugs, for a page of the report"),
    OPTION(TAKES_ADDITIONS, "headroom", headroom, LIST, "NAME=DIR",
           "results of another build, for a page of the report"),
    OPTION(TAKES_ADDITIONS, "history", history, LIST, "DIR",
           "earlier run, or benchmarks, oldest first: the course of each value"),
    OPTION(TAKES_STUDY, "refine", refine, TEXT, "N,N,...", "refinements of the grid"),
    OPTION(TAKES_STUDY, "vary", vary, LIST, "PATH=V,...", "values of a setting of the scene"),
    OPTION(TAKES_STUDY, "set", settings, LIST, "PATH=V", "set a value of the scene in all runs"),
    OPTION(TAKES_STUDY, "measure", measures, LIST, "QUANTITY[:TAKE[@TIME]][=REFERENCE]",
           "what is measured, at a time, or at a place by @X,Y"),
    OPTION(TAKES_STUDY, "timeout", timeout, TEXT, "S", "the seconds that one run may take"),
    OPTION(TAKES_STUDY, "tasks", tasks, FLAG, NULL,
           "print a command line for each run, for any other engine; run nothing"),
    OPTION(TAKES_STUDY, "output", output, TEXT, "DIR",
           "folder of the study; mpm-study unless given"),
    OPTION(TAKES_CHANGE, "change", change, TEXT, "X",
           "relative change of a value that counts; 0.001 unless given"),
    OPTION(TAKES_NAME, "name", name, TEXT, "SOLVER",
           "name of the scored solver in the report; that of the results unless given"),
    OPTION(TAKES_OUTPUT, "output", output, TEXT, "DIR",
           "folder of results and report; build/reports/verify in the repository and verify-report "
           "elsewhere unless given, of score build/reports/score and score-report"),
    OPTION(TAKES_LAST_RUN, "output", output, TEXT, "DIR",
           "folder of the run whose values are shown; that of the last run unless given"),
    OPTION(TAKES_CATALOGUE, "catalogue", catalogue, TEXT, "DIR",
           "the catalogue; the suite's own unless given"),
};

int suite_command(int argc, char **argv, const struct suite_world *world)
{
    struct command command = {
        .argc = argc, .argv = argv, .world = world, .options = {.jobs = JOBS_DEFAULT}};
    const struct mpm_command_line line = {
        .program = PROGRAM,
        .about = "The suite that verifies the Material Point Method: cases, checks, reports.",
        .notes = "Exit status: 0 every check holds (or shows its known weakness); 1 one does not; "
                 "2 bad usage or a bad catalogue; 4 the environment failed; 128 + n ended by "
                 "signal n.",
        .commands = commands,
        .command_count = G_N_ELEMENTS(commands),
        .options = options,
        .option_count = G_N_ELEMENTS(options),
        .values = &command.options,
        .rest = &command.options.rest,
        .out = world->out,
        .err = world->err,
    };
    const enum mpm_status status = mpm_command_line_run(&line, argc, argv, &command);
    mpm_command_line_clear(&line);
    if (status == MPM_INTERRUPTED)
        return (int)status + command.signal_number;
    /* results that could not be written or drawn come before their verdict */
    return status == MPM_OK && command.checks_failed ? CHECKS_FAILED : (int)status;
}
