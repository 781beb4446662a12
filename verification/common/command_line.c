/* The command line that mpm-verify and mpm-bench share.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/common/command_line.h"

#include "verification/common/failure.h"

#include <string.h>

static enum mpm_status parse(const struct command_line *line, unsigned takes, int argc, char **argv,
                             struct mpm_error *error)
{
    GOptionEntry *entries = g_new0(GOptionEntry, line->option_count + 2); /* zero ends them */
    size_t count = 0;
    for (size_t i = 0; i < line->option_count; i++)
        if ((line->options[i].takes & takes) != 0)
            entries[count++] = line->options[i].entry;
    entries[count] = (GOptionEntry){G_OPTION_REMAINING, 0,    0,   G_OPTION_ARG_FILENAME_ARRAY,
                                    line->rest,         NULL, NULL};

    GOptionContext *context = g_option_context_new(NULL);
    GError *failure = NULL;
    g_option_context_set_help_enabled(context, FALSE);
    g_option_context_add_main_entries(context, entries, NULL);
    enum mpm_status status = MPM_OK;
    if (!g_option_context_parse(context, &argc, &argv, &failure)) {
        status =
            failure_set(error, MPM_BAD_INPUT, "%s; see %s help", failure->message, line->program);
        g_error_free(failure);
    }
    g_option_context_free(context);
    g_free(entries);
    return status;
}

static enum mpm_status expect_rest(const struct command_line *line,
                                   const struct command_entry *entry, struct mpm_error *error)
{
    char **const rest = *line->rest;
    const size_t given = rest == NULL ? 0 : g_strv_length(rest);
    if (given == entry->rest)
        return MPM_OK;
    if (given > entry->rest)
        return failure_set(error, MPM_BAD_INPUT, "\"%s\": unexpected argument; see %s help",
                           rest[entry->rest], line->program);
    return failure_set(error, MPM_BAD_INPUT, "%s is missing; see %s help", entry->rest_name,
                       line->program);
}

static enum mpm_status dispatch(const struct command_line *line, const struct command_entry *entry,
                                int argc, char **argv, struct command *command)
{
    /* the parser reorders its copy; the originals stay the caller's */
    char **arguments = g_memdup2(argv + 1, sizeof(char *) * (size_t)argc);
    struct mpm_error error = {.status = MPM_OK};
    enum mpm_status status = parse(line, entry->takes, argc - 1, arguments, &error);
    if (status == MPM_OK)
        status = expect_rest(line, entry, &error);
    if (status == MPM_OK)
        status = entry->run(command, &error);
    if (status != MPM_OK)
        fprintf(line->err, "%s: %s\n", line->program, error.message);
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

enum mpm_status command_line_run(const struct command_line *line, int argc, char **argv,
                                 struct command *command)
{
    const char *const name = argc > 1 ? argv[1] : NULL;
    if (asks(argc, argv, "--help") || g_strcmp0(name, "help") == 0) {
        fputs(line->usage, line->out);
        return MPM_OK;
    }
    if (g_strcmp0(name, "--version") == 0) {
        fprintf(line->out, "%s %s (%s)\n", line->program, mpm_build_info()->version,
                mpm_build_info()->revision);
        return MPM_OK;
    }
    for (size_t i = 0; i < line->command_count; i++)
        if (g_strcmp0(name, line->commands[i].name) == 0)
            return dispatch(line, &line->commands[i], argc, argv, command);
    fprintf(line->err, "%s: %s%s\n%s", line->program,
            name == NULL ? "no command" : "unknown command ", name == NULL ? "" : name,
            line->usage);
    return MPM_BAD_INPUT;
}

char *command_line_typed(const char *program, int argc, char **argv)
{
    GString *text = g_string_new(program);
    for (int i = 1; i < argc; i++) {
        char *quoted = g_shell_quote(argv[i]);
        const bool plain = strpbrk(argv[i], " \t\n*?[]'\"\\$`;&|<>(){}~#!") == NULL;
        g_string_append_printf(text, " %s", plain ? argv[i] : quoted);
        g_free(quoted);
    }
    return g_string_free(text, FALSE);
}
