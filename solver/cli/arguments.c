/* What the commands have in common: options, the scene, messages.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/cli.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

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

static int bad_usage(const struct cli_command *command, const char *problem, const char *value)
{
    return cli_fail(MPM_BAD_INPUT, "%s: %s%s; see 'mpm %s --help'", command->name, problem, value,
                    command->name);
}

enum { THREADS_MAX = 1024 };

static int bad_threads(const struct cli_command *command, const char *where, const char *text)
{
    return cli_fail(MPM_BAD_INPUT,
                    "%s: %s: '%s' is not a whole number from 1 to %d; see 'mpm %s --help'",
                    command->name, where, text, THREADS_MAX, command->name);
}

static bool read_threads(const char *text, guint64 *threads)
{
    return g_ascii_string_to_unsigned(text, 10, 1, THREADS_MAX, threads, NULL);
}

/* OMP_NUM_THREADS may be a list: the first number of it. Without it all processors. */
static int default_threads(const struct cli_command *command, guint64 *threads)
{
    const char *text = g_getenv("OMP_NUM_THREADS");
    *threads = MIN((guint64)g_get_num_processors(), (guint64)THREADS_MAX);
    if (text == NULL)
        return MPM_OK;
    char **list = g_strsplit(text, ",", 2);
    const bool read = list[0] != NULL && read_threads(g_strstrip(list[0]), threads);
    g_strfreev(list);
    return read ? MPM_OK : bad_threads(command, "OMP_NUM_THREADS", text);
}

/* What is a text on the command line and has to be looked at; NULL where not given. */
struct texts {
    char *kernels, *simd, *threads, **operands;
};

static int take_simulation(const struct cli_command *command, const struct texts *given,
                           struct mpm_simulation_options *simulation)
{
    struct mpm_error error = {.status = MPM_OK};
    guint64 threads = 1;
    int status = MPM_OK;
    if (given->kernels != NULL &&
        mpm_kernels_find(given->kernels, &simulation->kernels, &error) != MPM_OK)
        return bad_usage(command, "--kernels: ", error.message);
    if (given->simd != NULL && mpm_simd_find(given->simd, &simulation->simd, &error) != MPM_OK)
        return bad_usage(command, "--simd: ", error.message);
    if (given->threads != NULL && !read_threads(given->threads, &threads))
        return bad_threads(command, "--threads", given->threads);
    if (given->threads == NULL && g_strv_contains(command->options, "threads"))
        status = default_threads(command, &threads);
    simulation->threads = (int)threads;
    return status;
}

/* Takes exactly the operands that the command has. */
static int take_scene(const struct cli_command *command, char **operands, char **scene)
{
    const guint count = operands != NULL ? g_strv_length(operands) : 0;
    const guint wanted = command->operands[0] != '\0' ? 1 : 0;
    if (count < wanted && command->operands[0] != '[')
        return bad_usage(command, "a scene file is missing", "");
    if (count > wanted)
        return bad_usage(command, "unexpected argument ", operands[wanted]);
    *scene = count > 0 ? g_strdup(operands[0]) : NULL;
    return MPM_OK;
}

static GOptionContext *describe(const struct cli_command *command, const GOptionEntry *options)
{
    GOptionContext *context = g_option_context_new(command->operands);
    g_option_context_set_help_enabled(context, FALSE); /* GLib's own would exit */
    g_option_context_set_summary(context, command->summary);
    g_option_context_set_description(context, command->description);
    for (; options->long_name != NULL; options++) {
        const GOptionEntry one[] = {*options, {.long_name = NULL}};
        if (g_strv_contains(command->options, options->long_name) ||
            strcmp(options->long_name, "help") == 0 ||
            strcmp(options->long_name, G_OPTION_REMAINING) == 0)
            g_option_context_add_main_entries(context, one, NULL);
    }
    return context;
}

static int run(const struct cli_command *command, const struct texts *given,
               struct cli_arguments *arguments)
{
    int status = take_simulation(command, given, &arguments->simulation);
    if (status == MPM_OK)
        status = take_scene(command, given->operands, &arguments->scene);
    return status == MPM_OK ? command->run(arguments) : status;
}

int cli_command_run(const struct cli_command *command, int argc, char **argv)
{
    struct cli_arguments read = {.scene = NULL};
    struct texts given = {.kernels = NULL};
    gboolean help = FALSE;
    const GOptionEntry options[] = {
        {"output", 'o', 0, G_OPTION_ARG_FILENAME, &read.output,
         "Folder for the results; of new: the file to write", "DIR"},
        {"overwrite", 0, 0, G_OPTION_ARG_NONE, &read.overwrite,
         "Replace the results that DIR holds", NULL},
        {"resume", 0, 0, G_OPTION_ARG_NONE, &read.resume, "Go on from the checkpoint in DIR", NULL},
        {"set", 0, 0, G_OPTION_ARG_FILENAME_ARRAY, &read.settings,
         "Set a value of the scene; the last one wins", "PATH=VALUE"},
        {"quiet", 'q', 0, G_OPTION_ARG_NONE, &read.quiet, "Print nothing but errors", NULL},
        {"json", 0, 0, G_OPTION_ARG_NONE, &read.json, "Print the keys as JSON, for programs", NULL},
        {"list", 0, 0, G_OPTION_ARG_NONE, &read.list, "List what there is to choose from", NULL},
        {"field", 0, 0, G_OPTION_ARG_FILENAME, &read.field,
         "What to draw (von_mises): a field, or one component of it, as stress.xx", "FIELD"},
        {"snapshot", 0, 0, G_OPTION_ARG_FILENAME, &read.snapshot,
         "Number of the snapshot to draw (the last one)", "N"},
        {"format", 0, 0, G_OPTION_ARG_FILENAME, &read.format, "svg (the default) or png", "FORMAT"},
        {"kernels", 0, 0, G_OPTION_ARG_FILENAME, &given.kernels,
         "auto (the default: fast wherever the scene allows), reference or fast", "KERNELS"},
        {"simd", 0, 0, G_OPTION_ARG_FILENAME, &given.simd,
         "Instructions of the fast kernels: auto (the default: the widest of this machine), "
         "baseline or x86-64-v3",
         "LEVEL"},
        {"threads", 0, 0, G_OPTION_ARG_FILENAME, &given.threads,
         "Compute with at most so many threads (OMP_NUM_THREADS, or all processors)", "N"},
        {"help", 'h', 0, G_OPTION_ARG_NONE, &help, "Show this help", NULL},
        {G_OPTION_REMAINING, 0, 0, G_OPTION_ARG_FILENAME_ARRAY, &given.operands, NULL, NULL},
        {.long_name = NULL},
    };
    char *program = g_strdup_printf("mpm %s", command->name);
    g_set_prgname(program);
    GOptionContext *context = describe(command, options);
    GError *failure = NULL;
    int status = MPM_OK;
    if (!g_option_context_parse(context, &argc, &argv, &failure)) {
        status = bad_usage(command, failure->message, "");
    } else if (help) {
        char *text = g_option_context_get_help(context, TRUE, NULL);
        (void)fputs(text, stdout);
        g_free(text);
    } else {
        status = run(command, &given, &read);
    }
    g_clear_error(&failure);
    g_option_context_free(context);
    char *const texts[] = {read.scene,    read.output, read.field,    read.snapshot, read.format,
                           given.kernels, given.simd,  given.threads, program};
    for (size_t i = 0; i < G_N_ELEMENTS(texts); i++)
        g_free(texts[i]);
    g_strfreev(read.settings);
    g_strfreev(given.operands);
    return status;
}

int cli_scene_read(const struct cli_arguments *arguments, struct mpm_scene **scene)
{
    const char *const *settings = (const char *const *)arguments->settings;
    size_t count = 0;
    while (settings != NULL && settings[count] != NULL)
        count++;
    struct mpm_error error = {.status = MPM_OK};
    const enum mpm_status status = mpm_scene_read(arguments->scene, settings, count, scene, &error);
    return status == MPM_OK ? MPM_OK : cli_fail(status, "%s", error.message);
}
