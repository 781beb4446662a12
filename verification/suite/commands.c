/* The commands of mpm-verify: arguments and exit statuses.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/suite/commands.h"

#include "verification/suite/machine.h"
#include "verification/suite/report.h"
#include "verification/suite/resources.h"
#include "verification/suite/run.h"

#include <glib.h>
#include <limits.h>
#include <string.h>

enum { CHECKS_FAILED = 1, JOBS_MAX = 1024, JOBS_DEFAULT = INT_MIN /* not given */ };

#define NO_CATALOGUE "no verification/catalogue here: name one with --catalogue DIR"

static const char usage[] =
    "usage: mpm-verify COMMAND\n"
    "\n"
    "  list [--tag T]                         the cases, their variants and checks\n"
    "  run [--tier ci|full] [--case GLOB] [--variant GLOB] [--kernels auto|reference|fast]\n"
    "      [--jobs N] [--output DIR]          run, judge, and write results and reports\n"
    "  explain CHECK [--output DIR]           what CASE[/CHECK[/VARIANT]] (globs) states, its "
    "band\n"
    "                                         and why, last values, the command to reproduce it\n"
    "  report DIR                             render the reports of DIR again from its result "
    "lines\n"
    "  help, --help, --version\n"
    "\n"
    "All but report take --catalogue DIR. --tier is ci unless given; --kernels auto, which is\n"
    "fast wherever a scene allows; --jobs the number of processors; --output\n"
    "build/reports/verify in the repository and verify-report elsewhere.\n"
    "Exit status: 0 every check holds (or shows its known weakness); 1 one does not; 2 bad usage\n"
    "or a bad catalogue; 4 the environment failed.\n";

/* ----------------------------------------------------------------- arguments */

static void options_clear(struct command_options *options)
{
    g_free(options->tier);
    g_free(options->case_glob);
    g_free(options->variant_glob);
    g_free(options->kernels);
    g_free(options->output);
    g_free(options->catalogue);
    g_free(options->tag);
    g_strfreev(options->rest);
}

/* Which options a command takes; bits of `takes` in the table of commands. */
enum { TAKES_SELECTION = 1, TAKES_OUTPUT = 2, TAKES_CATALOGUE = 4, TAKES_TAG = 8 };

static enum mpm_status parse(int argc, char **argv, unsigned takes, struct command_options *options,
                             struct mpm_error *error)
{
    const struct {
        unsigned takes;
        GOptionEntry entry;
    } all[] = {
        {TAKES_SELECTION, {"tier", 0, 0, G_OPTION_ARG_STRING, &options->tier, NULL, NULL}},
        {TAKES_SELECTION, {"case", 0, 0, G_OPTION_ARG_STRING, &options->case_glob, NULL, NULL}},
        {TAKES_SELECTION,
         {"variant", 0, 0, G_OPTION_ARG_STRING, &options->variant_glob, NULL, NULL}},
        {TAKES_SELECTION, {"kernels", 0, 0, G_OPTION_ARG_STRING, &options->kernels, NULL, NULL}},
        {TAKES_SELECTION, {"jobs", 0, 0, G_OPTION_ARG_INT, &options->jobs, NULL, NULL}},
        {TAKES_OUTPUT, {"output", 0, 0, G_OPTION_ARG_FILENAME, &options->output, NULL, NULL}},
        {TAKES_CATALOGUE,
         {"catalogue", 0, 0, G_OPTION_ARG_FILENAME, &options->catalogue, NULL, NULL}},
        {TAKES_TAG, {"tag", 0, 0, G_OPTION_ARG_STRING, &options->tag, NULL, NULL}},
        {~0U, {G_OPTION_REMAINING, 0, 0, G_OPTION_ARG_FILENAME_ARRAY, &options->rest, NULL, NULL}},
    };
    GOptionEntry entries[G_N_ELEMENTS(all) + 1];
    size_t count = 0;
    for (size_t i = 0; i < G_N_ELEMENTS(all); i++)
        if ((all[i].takes & takes) != 0 || all[i].takes == ~0U)
            entries[count++] = all[i].entry;
    memset(&entries[count], 0, sizeof entries[count]);

    GOptionContext *context = g_option_context_new(NULL);
    GError *failure = NULL;
    g_option_context_set_help_enabled(context, FALSE);
    g_option_context_add_main_entries(context, entries, NULL);
    enum mpm_status status = MPM_OK;
    if (!g_option_context_parse(context, &argc, &argv, &failure)) {
        status = failure_set(error, MPM_BAD_INPUT, "%s; see mpm-verify help", failure->message);
        g_error_free(failure);
    }
    g_option_context_free(context);
    return status;
}

static enum mpm_status expect_rest(const struct command_options *options, size_t count,
                                   const char *what, struct mpm_error *error)
{
    const size_t given = options->rest == NULL ? 0 : g_strv_length(options->rest);
    if (given == count)
        return MPM_OK;
    if (given > count)
        return failure_set(error, MPM_BAD_INPUT, "\"%s\": unexpected argument; see mpm-verify help",
                           options->rest[count]);
    return failure_set(error, MPM_BAD_INPUT, "%s is missing; see mpm-verify help", what);
}

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

/* ----------------------------------------------------------------------- run */

static enum mpm_status read_tier(const char *text, enum tier *tier, struct mpm_error *error)
{
    *tier = TIER_CI;
    if (text == NULL || strcmp(text, tier_name(TIER_CI)) == 0)
        return MPM_OK;
    *tier = TIER_FULL;
    if (strcmp(text, tier_name(TIER_FULL)) == 0)
        return MPM_OK;
    return failure_set(error, MPM_BAD_INPUT, "--tier \"%s\": allowed are ci and full", text);
}

static enum mpm_status read_kernels(const char *text, enum mpm_kernels *kernels,
                                    struct mpm_error *error)
{
    struct mpm_error cause;
    *kernels = MPM_KERNELS_AUTO;
    if (text == NULL || mpm_kernels_find(text, kernels, &cause) == MPM_OK)
        return MPM_OK;
    return failure_set(error, MPM_BAD_INPUT, "--kernels: %s", cause.message);
}

/* The command as typed, quoted for the shell. */
static char *typed(int argc, char **argv)
{
    GString *text = g_string_new("mpm-verify");
    for (int i = 1; i < argc; i++) {
        char *quoted = strpbrk(argv[i], " \t\n*?[]'\"\\$`;&|<>(){}~#!") == NULL
                           ? g_strdup(argv[i])
                           : g_shell_quote(argv[i]);
        g_string_append_printf(text, " %s", quoted);
        g_free(quoted);
    }
    return g_string_free(text, FALSE);
}

static enum mpm_status run_with(struct run_options *run, struct command *command,
                                struct mpm_error *error)
{
    const struct command_options *options = &command->options;
    struct console console = {.out = command->world->out, .terminal = command->world->terminal};
    struct record_counts counts;
    TRY(read_tier(options->tier, &run->selection.tier, error));
    TRY(read_kernels(options->kernels, &run->kernels, error));
    if (options->jobs != JOBS_DEFAULT && (options->jobs < 1 || options->jobs > JOBS_MAX))
        return failure_set(error, MPM_BAD_INPUT, "--jobs %d: allowed are 1 to %d", options->jobs,
                           JOBS_MAX);
    run->jobs = options->jobs == JOBS_DEFAULT ? machine_processor_count() : (unsigned)options->jobs;
    if (run->catalogue == NULL)
        return failure_set(error, MPM_BAD_INPUT, NO_CATALOGUE);
    if (run->reports == NULL)
        return failure_set(
            error, MPM_ENVIRONMENT_FAILED,
            "the report's style is found neither in reports/ nor beside the program");
    const enum mpm_status status =
        suite_run(run, command->world->programs, &console, &counts, error);
    command->checks_failed = counts.failed > 0;
    return status;
}

static enum mpm_status command_run(struct command *command, struct mpm_error *error)
{
    const struct command_options *options = &command->options;
    char *catalogue = options->catalogue != NULL ? g_strdup(options->catalogue)
                                                 : resources_catalogue(command->argv[0]);
    char *reports = resources_reports(command->argv[0]);
    char *typed_text = typed(command->argc, command->argv);
    char *output = options->output != NULL ? g_strdup(options->output) : resources_output();
    struct run_options run = {
        .catalogue = catalogue,
        .reports = reports,
        .output = output,
        .command = typed_text,
        .selection = {.case_glob = options->case_glob, .variant_glob = options->variant_glob},
    };
    const enum mpm_status status = run_with(&run, command, error);
    g_free(catalogue);
    g_free(reports);
    g_free(output);
    g_free(typed_text);
    return status;
}

static enum mpm_status command_report(struct command *command, struct mpm_error *error)
{
    const char *folder = command->options.rest[0];
    char *reports = resources_reports(command->argv[0]);
    const enum mpm_status status = report_render(folder, reports, error);
    g_free(reports);
    if (status == MPM_OK)
        fprintf(command->world->out, "report: %s/index.html\n", folder);
    return status;
}

/* ------------------------------------------------------------------ dispatch */

static const struct {
    const char *name;
    unsigned takes;
    size_t rest;
    const char *rest_name;
    enum mpm_status (*run)(struct command *command, struct mpm_error *error);
} commands[] = {
    {"list", TAKES_TAG | TAKES_CATALOGUE, 0, "", command_list},
    {"run", TAKES_SELECTION | TAKES_OUTPUT | TAKES_CATALOGUE, 0, "", command_run},
    {"explain", TAKES_OUTPUT | TAKES_CATALOGUE, 1, "explain: CHECK", command_explain},
    {"report", 0, 1, "report: the folder DIR", command_report},
};

static enum mpm_status dispatch(size_t which, struct command *command, struct mpm_error *error)
{
    /* the parser reorders its copy; the originals stay the caller's */
    char **arguments = g_memdup2(command->argv + 1, sizeof(char *) * (size_t)command->argc);
    command->options.jobs = JOBS_DEFAULT;
    enum mpm_status status =
        parse(command->argc - 1, arguments, commands[which].takes, &command->options, error);
    if (status == MPM_OK)
        status =
            expect_rest(&command->options, commands[which].rest, commands[which].rest_name, error);
    if (status == MPM_OK)
        status = commands[which].run(command, error);
    options_clear(&command->options);
    g_free(arguments);
    return status;
}

static bool asks(int argc, char **argv, const char *word)
{
    for (int i = 1; i < argc; i++)
        if (strcmp(argv[i], word) == 0)
            return true;
    return false;
}

int suite_command(int argc, char **argv, const struct suite_world *world)
{
    if (asks(argc, argv, "--help") || (argc > 1 && strcmp(argv[1], "help") == 0)) {
        fputs(usage, world->out);
        return 0;
    }
    if (argc > 1 && strcmp(argv[1], "--version") == 0) {
        fprintf(world->out, "mpm-verify %s (%s)\n", mpm_build_info()->version,
                mpm_build_info()->revision);
        return 0;
    }
    size_t which = 0;
    while (argc > 1 && which < G_N_ELEMENTS(commands) && strcmp(argv[1], commands[which].name) != 0)
        which++;
    if (argc < 2 || which == G_N_ELEMENTS(commands)) {
        fprintf(world->err, "mpm-verify: %s%s\n%s", argc < 2 ? "no command" : "unknown command ",
                argc < 2 ? "" : argv[1], usage);
        return MPM_BAD_INPUT;
    }
    struct mpm_error error = {.status = MPM_OK};
    struct command command = {.argc = argc, .argv = argv, .world = world};
    const enum mpm_status status = dispatch(which, &command, &error);
    if (status != MPM_OK)
        fprintf(world->err, "mpm-verify: %s\n", error.message);
    /* results that could not be written or drawn come before what they would say */
    return status == MPM_OK && command.checks_failed ? CHECKS_FAILED : (int)status;
}
