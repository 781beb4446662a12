/* What the commands have in common: options, the scene, messages.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/cli.h"

#include <stdarg.h>
#include <stdio.h>

int cli_fail(enum mpm_status status, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    char *message = g_strdup_vprintf(format, arguments);
    va_end(arguments);
    g_strdelimit(message, "\n\r", ' '); /* one line, whatever an argument holds */
    (void)fprintf(stderr, "mpm: %s\n", message);
    g_free(message);
    return (int)status;
}

static enum cli_outcome bad_usage(const struct cli_command *command, const char *problem,
                                  const char *value)
{
    (void)cli_fail(MPM_BAD_INPUT, "%s: %s%s; see 'mpm %s --help'", command->name, problem, value,
                   command->name);
    return CLI_BAD_USAGE;
}

/* Takes exactly the operands that the command has. */
static enum cli_outcome take_scene(const struct cli_command *command, char **operands, char **scene)
{
    const guint count = operands != NULL ? g_strv_length(operands) : 0;
    const guint wanted = scene != NULL ? 1 : 0;
    if (count < wanted)
        return bad_usage(command, "a scene file is missing", "");
    if (count > wanted)
        return bad_usage(command, "unexpected argument ", operands[wanted]);
    if (scene != NULL)
        *scene = g_strdup(operands[0]);
    return CLI_GO_ON;
}

enum { THREADS_MAX = 1024 };

/* --kernels, --simd and --threads as given; NULL where not. */
struct simulation_texts {
    char *kernels, *simd, *threads;
};

static void add_simulation_options(GOptionContext *context, struct simulation_texts *given)
{
    const GOptionEntry options[] = {
        {"kernels", 0, 0, G_OPTION_ARG_FILENAME, &given->kernels,
         "auto (the default: fast wherever the scene allows), reference or fast", "KERNELS"},
        {"simd", 0, 0, G_OPTION_ARG_FILENAME, &given->simd,
         "Instructions of the fast kernels: auto (the default: the widest of this machine), "
         "baseline or x86-64-v3",
         "LEVEL"},
        {"threads", 0, 0, G_OPTION_ARG_FILENAME, &given->threads,
         "Compute with at most so many threads (OMP_NUM_THREADS, or all processors)", "N"},
        {NULL, 0, 0, G_OPTION_ARG_NONE, NULL, NULL, NULL},
    };
    g_option_context_add_main_entries(context, options, NULL);
}

/* OMP_NUM_THREADS may be a list: the first number of it. All processors if that is no whole number
 * from 1 on. */
static int default_threads(void)
{
    const char *text = g_getenv("OMP_NUM_THREADS");
    char **list = g_strsplit(text != NULL ? text : "", ",", 2);
    guint64 number = 0;
    if (list[0] == NULL ||
        !g_ascii_string_to_unsigned(g_strstrip(list[0]), 10, 1, G_MAXUINT64, &number, NULL))
        number = g_get_num_processors();
    g_strfreev(list);
    return (int)MIN(number, (guint64)THREADS_MAX);
}

static enum cli_outcome take_threads(const struct cli_command *command, const char *text,
                                     struct mpm_simulation_options *simulation)
{
    guint64 number = 0;
    simulation->threads = default_threads();
    if (text == NULL)
        return CLI_GO_ON;
    if (!g_ascii_string_to_unsigned(text, 10, 1, THREADS_MAX, &number, NULL)) {
        (void)cli_fail(
            MPM_BAD_INPUT,
            "%s: --threads: '%s' is not a whole number from 1 to %d; see 'mpm %s --help'",
            command->name, text, THREADS_MAX, command->name);
        return CLI_BAD_USAGE;
    }
    simulation->threads = (int)number;
    return CLI_GO_ON;
}

static enum cli_outcome take_simulation(const struct cli_command *command,
                                        const struct simulation_texts *given,
                                        struct mpm_simulation_options *simulation)
{
    struct mpm_error error = {.status = MPM_OK};
    if (simulation == NULL)
        return CLI_GO_ON;
    if (given->kernels != NULL &&
        mpm_kernels_find(given->kernels, &simulation->kernels, &error) != MPM_OK)
        return bad_usage(command, "--kernels: ", error.message);
    if (given->simd != NULL && mpm_simd_find(given->simd, &simulation->simd, &error) != MPM_OK)
        return bad_usage(command, "--simd: ", error.message);
    return take_threads(command, given->threads, simulation);
}

static GOptionContext *describe(const struct cli_arguments *arguments, const GOptionEntry *common,
                                struct simulation_texts *simulation)
{
    GOptionContext *context = g_option_context_new(arguments->command->operands);
    g_option_context_set_help_enabled(context, FALSE); /* GLib's own would exit */
    g_option_context_set_summary(context, arguments->command->summary);
    g_option_context_set_description(context, arguments->description);
    if (arguments->options != NULL)
        g_option_context_add_main_entries(context, arguments->options, NULL);
    if (arguments->simulation != NULL)
        add_simulation_options(context, simulation);
    g_option_context_add_main_entries(context, common, NULL);
    return context;
}

enum cli_outcome cli_arguments_read(const struct cli_arguments *arguments, int argc, char **argv,
                                    char **scene)
{
    const struct cli_command *command = arguments->command;
    struct simulation_texts simulation = {NULL, NULL, NULL};
    gboolean help = FALSE;
    char **operands = NULL;
    const GOptionEntry common[] = {
        {"help", 'h', 0, G_OPTION_ARG_NONE, &help, "Show this help", NULL},
        {G_OPTION_REMAINING, 0, 0, G_OPTION_ARG_FILENAME_ARRAY, &operands, NULL, NULL},
        {NULL, 0, 0, G_OPTION_ARG_NONE, NULL, NULL, NULL},
    };
    char *program = g_strdup_printf("mpm %s", command->name);
    g_set_prgname(program);
    GOptionContext *context = describe(arguments, common, &simulation);

    GError *failure = NULL;
    enum cli_outcome outcome = CLI_HELP_SHOWN;
    if (!g_option_context_parse(context, &argc, &argv, &failure)) {
        outcome = bad_usage(command, failure->message, "");
    } else if (help) {
        char *text = g_option_context_get_help(context, TRUE, NULL);
        (void)fputs(text, stdout);
        g_free(text);
    } else {
        outcome = take_simulation(command, &simulation, arguments->simulation);
        if (outcome == CLI_GO_ON)
            outcome = take_scene(command, operands, scene);
    }
    g_clear_error(&failure);
    g_strfreev(operands);
    g_free(simulation.kernels);
    g_free(simulation.simd);
    g_free(simulation.threads);
    g_option_context_free(context);
    g_free(program);
    return outcome;
}

int cli_scene_read(const char *path, char *const *settings, struct mpm_scene **scene)
{
    size_t count = 0;
    while (settings != NULL && settings[count] != NULL)
        count++;
    struct mpm_error error = {.status = MPM_OK};
    const enum mpm_status status =
        mpm_scene_read(path, (const char *const *)settings, count, scene, &error);
    return status == MPM_OK ? MPM_OK : cli_fail(status, "%s", error.message);
}
