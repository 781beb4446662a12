/* Commands by a table.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/status.h"
#include "io/commands/completion.h"
#include "io/commands/help.h"
#include "mpm_commands.h"
#include "mpm_words.h"

#include <glib.h>
#include <string.h>

size_t mpm_operands_count(const struct mpm_command_entry *entry)
{
    size_t count = entry->operands[0] != '\0';
    for (const char *c = entry->operands; *c != '\0'; c++)
        count += *c == ' ';
    return count;
}

static enum mpm_status check_operands(const struct mpm_command_line *line,
                                      const struct mpm_command_entry *entry,
                                      struct mpm_error *error)
{
    char **const rest = *line->rest;
    const size_t given = rest == NULL ? 0 : g_strv_length(rest);
    const size_t most = mpm_operands_count(entry);
    size_t sound = 0;
    while (sound < given && rest[sound][0] != '\0')
        sound++;
    if (given > most)
        return mpm_error_set(error, MPM_BAD_INPUT,
                             "%s: unexpected argument \"%s\"; see '%s %s --help'", entry->name,
                             rest[most], line->program, entry->name);
    if (sound == given && (given == most || entry->operands[0] == '['))
        return MPM_OK;
    char **const names = g_strsplit(entry->operands, " ", -1);
    const char *const name = names[sound] + (names[sound][0] == '[');
    const enum mpm_status status =
        mpm_error_set(error, MPM_BAD_INPUT, "%s: %.*s is %s; see '%s %s --help'", entry->name,
                      (int)strcspn(name, "]"), name, sound < given ? "empty" : "missing",
                      line->program, entry->name);
    g_strfreev(names);
    return status;
}

static void print_error(const struct mpm_command_line *line, const struct mpm_error *error)
{
    if (error->message[0] != '\0')
        (void)fprintf(line->err, "%s: %s\n", line->program, error->message);
}

static enum mpm_status dispatch(const struct mpm_command_line *line,
                                const struct mpm_command_entry *entry, int argc, char **argv,
                                struct command *command)
{
    struct mpm_error error = {.status = MPM_OK};
    bool help = false;
    enum mpm_status status = mpm_options_read(line, entry, argc - 1, argv + 1, &help, &error);
    if (status == MPM_OK && help) {
        mpm_help_command(line, entry);
        return MPM_OK;
    }
    if (status == MPM_OK)
        status = check_operands(line, entry, &error);
    if (status == MPM_OK)
        status = entry->run(command, &error);
    if (status != MPM_OK)
        print_error(line, &error);
    return status;
}

static const struct mpm_command_entry *find_command(const struct mpm_command_line *line,
                                                    const char *name)
{
    for (size_t i = 0; name != NULL && i < line->command_count; i++)
        if (strcmp(name, line->commands[i].name) == 0)
            return &line->commands[i];
    return NULL;
}

static enum mpm_status refuse_command(const struct mpm_command_line *line, const char *name)
{
    struct mpm_error error = {.status = MPM_OK};
    GString *const names = g_string_new(NULL);
    for (size_t i = 0; i < line->command_count; i++)
        g_string_append_printf(names, "%s, ", line->commands[i].name);
    for (size_t i = 0; i < MPM_HELP_OWN_COUNT; i++)
        g_string_append_printf(names, "%s%s", i > 0 ? ", " : "", mpm_help_own[i].name);
    struct mpm_nearest nearest = {.word = name};
    for (size_t i = 0; name != NULL && i < line->command_count; i++)
        mpm_nearest_offer(&nearest, line->commands[i].name);
    for (size_t i = 0; name != NULL && i < MPM_HELP_OWN_COUNT; i++)
        mpm_nearest_offer(&nearest, mpm_help_own[i].name);
    char hint[MPM_HINT_SIZE];
    if (name == NULL)
        (void)mpm_error_set(&error, MPM_BAD_INPUT, "a command is missing: %s; see '%s --help'",
                            names->str, line->program);
    else
        (void)mpm_error_set(&error, MPM_BAD_INPUT,
                            "unknown command \"%s\"; allowed: %s%s; see '%s --help'", name,
                            names->str, mpm_nearest_hint(&nearest, hint), line->program);
    g_string_free(names, TRUE);
    print_error(line, &error);
    return MPM_BAD_INPUT;
}

static bool is_help(const char *word)
{
    return g_strcmp0(word, "--help") == 0 || g_strcmp0(word, "-h") == 0;
}

/* `help`, `help COMMAND`. */
static enum mpm_status run_help(const struct mpm_command_line *line, const char *name)
{
    const struct mpm_command_entry *const entry = find_command(line, name);
    for (size_t i = 0; i < MPM_HELP_OWN_COUNT; i++)
        if (g_strcmp0(is_help(name) ? "help" : name, mpm_help_own[i].name) == 0) {
            mpm_help_own_command(line, &mpm_help_own[i]);
            return MPM_OK;
        }
    if (name != NULL && entry == NULL)
        return refuse_command(line, name);
    if (entry != NULL)
        mpm_help_command(line, entry);
    else
        mpm_help_program(line);
    return MPM_OK;
}

static enum mpm_status run_completion(const struct mpm_command_line *line, const char *shell)
{
    struct mpm_error error = {.status = MPM_OK};
    if (is_help(shell))
        return run_help(line, "completion");
    if (mpm_completion_print(line, shell))
        return MPM_OK;
    (void)mpm_error_set(&error, MPM_BAD_INPUT, "completion %s: allowed: %s",
                        shell == NULL ? "without a shell" : shell, mpm_completion_shells);
    print_error(line, &error);
    return MPM_BAD_INPUT;
}

static enum mpm_status run_version(const struct mpm_command_line *line, const char *nothing)
{
    (void)nothing;
    (void)fprintf(line->out, "%s %s (%s)\n", line->program, mpm_build_info()->version,
                  mpm_build_info()->revision);
    return MPM_OK;
}

static enum mpm_status run_list(const struct mpm_command_line *line, const char *nothing)
{
    (void)nothing;
    mpm_help_program(line);
    return MPM_OK;
}

/* What each program has of its own accord, with so many words at most. */
static const struct own {
    const char *name;
    int words;
    enum mpm_status (*run)(const struct mpm_command_line *line, const char *word);
} own[] = {
    {"help", 1, run_help}, {"completion", 1, run_completion}, {"--help", 0, run_list},
    {"-h", 0, run_list},   {"--version", 0, run_version},
};

static enum mpm_status run_own(const struct mpm_command_line *line, const struct own *command,
                               int count, char **words)
{
    struct mpm_error error = {.status = MPM_OK};
    if (count <= command->words)
        return command->run(line, count > 0 ? words[0] : NULL);
    (void)mpm_error_set(&error, MPM_BAD_INPUT, "%s: unexpected argument \"%s\"; see '%s --help'",
                        command->name, words[command->words], line->program);
    print_error(line, &error);
    return MPM_BAD_INPUT;
}

enum mpm_status mpm_command_line_run(const struct mpm_command_line *line, int argc, char **argv,
                                     struct command *command)
{
    const char *const name = argc > 1 ? argv[1] : NULL;
    for (size_t i = 0; i < G_N_ELEMENTS(own); i++)
        if (g_strcmp0(name, own[i].name) == 0)
            return run_own(line, &own[i], argc - 2, argv + 2);
    const struct mpm_command_entry *const entry = find_command(line, name);
    return entry != NULL ? dispatch(line, entry, argc, argv, command) : refuse_command(line, name);
}
