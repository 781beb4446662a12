/* The options and operands of one command, read by GLib.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/status.h"
#include "mpm_commands.h"
#include "mpm_words.h"

#include <glib.h>
#include <string.h>

struct reading {
    const struct mpm_command_line *line;
    const struct mpm_command_entry *entry;
    bool *given; /* by option of the table */
    bool help;
};

static bool takes(const struct mpm_command_entry *entry, const struct mpm_option *option)
{
    return (option->takes & entry->takes) != 0;
}

static const struct mpm_option *find_option(const struct reading *reading, const char *name)
{
    for (size_t i = 0; i < reading->line->option_count; i++) {
        const struct mpm_option *const option = &reading->line->options[i];
        if (takes(reading->entry, option) &&
            (g_str_has_prefix(name, "--") ? strcmp(name + 2, option->name) == 0
                                          : option->letter != 0 && name[1] == option->letter))
            return option;
    }
    return NULL;
}

/* ------------------------------------------------------------------- values */

static void append(char ***list, const char *text)
{
    const size_t count = *list != NULL ? g_strv_length(*list) : 0;
    *list = g_renew(char *, *list, count + 2);
    (*list)[count] = g_strdup(text);
    (*list)[count + 1] = NULL;
}

static void join(char **text, const char *more)
{
    char *const joined = *text != NULL ? g_strconcat(*text, ",", more, NULL) : g_strdup(more);
    g_free(*text);
    *text = joined;
}

static gboolean read_integer(const char *name, const char *text, int *value, GError **failure)
{
    gint64 number = 0;
    if (!g_ascii_string_to_signed(text, 10, G_MININT + 1, G_MAXINT, &number, NULL))
        g_set_error(failure, G_OPTION_ERROR, G_OPTION_ERROR_BAD_VALUE,
                    "%s: '%s' is not a whole number", name, text);
    *value = (int)number;
    return *failure == NULL;
}

/* Where the option's value is named "a|b": one of these. */
static gboolean check_choice(const struct mpm_option *option, const char *text, GError **failure)
{
    if (option->value == NULL || strchr(option->value, '|') == NULL)
        return TRUE;
    char **const names = g_strsplit(option->value, "|", -1);
    const bool allowed = g_strv_contains((const char *const *)names, text);
    struct mpm_nearest nearest = {.word = text};
    for (size_t i = 0; names[i] != NULL; i++)
        mpm_nearest_offer(&nearest, names[i]);
    if (!allowed) {
        char hint[MPM_HINT_SIZE], *const list = g_strjoinv(", ", names);
        g_set_error(failure, G_OPTION_ERROR, G_OPTION_ERROR_BAD_VALUE, "--%s \"%s\"; allowed: %s%s",
                    option->name, text, list, mpm_nearest_hint(&nearest, hint));
        g_free(list);
    }
    g_strfreev(names);
    return allowed;
}

static gboolean store(const struct mpm_option *option, const char *name, const char *text,
                      void *value, GError **failure)
{
    switch (option->kind) {
    case MPM_OPTION_FLAG:
        *(bool *)value = true;
        break;
    case MPM_OPTION_TEXT:
        *(char **)value = g_strdup(text);
        break;
    case MPM_OPTION_INTEGER:
        return read_integer(name, text, value, failure);
    case MPM_OPTION_LIST:
        append(value, text);
        break;
    case MPM_OPTION_JOINED:
        join(value, text);
        break;
    }
    return TRUE;
}

static bool may_repeat(const struct mpm_option *option)
{
    return option->kind == MPM_OPTION_LIST || option->kind == MPM_OPTION_JOINED;
}

/* Of GLib, for each option and operand as it comes. */
static gboolean take(const char *name, const char *text, void *data, GError **failure)
{
    struct reading *const reading = data;
    if (name[0] == '\0') {
        append(reading->line->rest, text);
        return TRUE;
    }
    const struct mpm_option *const option = find_option(reading, name);
    if (option == NULL) {
        reading->help = true;
        return TRUE;
    }
    bool *const given = &reading->given[option - reading->line->options];
    if (*given && !may_repeat(option)) {
        g_set_error(failure, G_OPTION_ERROR, G_OPTION_ERROR_BAD_VALUE,
                    "--%s is given twice; allowed: once", option->name);
        return FALSE;
    }
    *given = true;
    if (option->value != NULL && text[0] == '\0' && strchr(option->value, '|') == NULL) {
        g_set_error(failure, G_OPTION_ERROR, G_OPTION_ERROR_BAD_VALUE, "--%s: %s is empty",
                    option->name, option->value);
        return FALSE;
    }
    return check_choice(option, text, failure) &&
           store(option, name, text, (char *)reading->line->values + option->offset, failure);
}

/* ------------------------------------------------------------------- reading */

static enum mpm_status refuse_option(const struct reading *reading, const char *problem,
                                     const char *option, const char *hint, struct mpm_error *error)
{
    return mpm_error_set(error, MPM_BAD_INPUT, "%s: %s %s%s; see '%s %s --help'",
                         reading->entry->name, problem, option, hint, reading->line->program,
                         reading->entry->name);
}

static enum mpm_status refuse_unknown(const struct reading *reading, const char *given,
                                      const char *name, struct mpm_error *error)
{
    struct mpm_nearest nearest = {.word = name + strspn(name, "-")};
    for (size_t i = 0; i < reading->line->option_count; i++)
        if (takes(reading->entry, &reading->line->options[i]))
            mpm_nearest_offer(&nearest, reading->line->options[i].name);
    char *const hint =
        nearest.best != NULL ? g_strdup_printf("; did you mean --%s?", nearest.best) : g_strdup("");
    const enum mpm_status status = refuse_option(reading, "unknown option", given, hint, error);
    g_free(hint);
    return status;
}

static enum mpm_status refuse_missing(const struct reading *reading,
                                      const struct mpm_option *option, struct mpm_error *error)
{
    return mpm_error_set(error, MPM_BAD_INPUT, "%s: --%s: %s is missing; see '%s %s --help'",
                         reading->entry->name, option->name, option->value, reading->line->program,
                         reading->entry->name);
}

/* An option by its name, with or without "=VALUE". *awaits: its value is the next word. */
static enum mpm_status check_long(const struct reading *reading, const char *word, bool *awaits,
                                  struct mpm_error *error)
{
    char *const name = g_strndup(word, strcspn(word, "="));
    const struct mpm_option *const option = find_option(reading, name);
    const bool with_value = strchr(word, '=') != NULL, is_help = strcmp(name, "--help") == 0;
    enum mpm_status status = MPM_OK;
    if (option == NULL && !is_help)
        status = refuse_unknown(reading, word, name, error);
    else if ((option == NULL || option->value == NULL) && with_value)
        status = refuse_option(reading, "no value is allowed:", word, "", error);
    *awaits = option != NULL && option->value != NULL && !with_value;
    g_free(name);
    return status;
}

/* Letters: flags, each a word of its own afterwards, and at the end one with its value, which may
 * be attached: -qoDIR is -q -o DIR, and so is -qo=DIR. */
static enum mpm_status split_letters(const struct reading *reading, const char *word,
                                     GPtrArray *words, bool *awaits, struct mpm_error *error)
{
    for (const char *letter = word + 1; *letter != '\0'; letter++) {
        char *const name = g_strdup_printf("-%c", *letter);
        const struct mpm_option *const option = find_option(reading, name);
        g_ptr_array_add(words, name);
        if (option == NULL && *letter != 'h')
            return refuse_unknown(reading, word, word, error);
        if (option != NULL && option->value != NULL) {
            *awaits = letter[1] == '\0';
            if (!*awaits)
                g_ptr_array_add(words, g_strdup(letter + 1 + (letter[1] == '=')));
            return MPM_OK;
        }
        if (letter[1] == '=')
            return refuse_option(reading, "no value is allowed:", word, "", error);
    }
    return MPM_OK;
}

/* The words for GLib, with the letters apart. What it has no words for, or words of the locale, is
 * refused here: an option that there is not, a flag with a value, an option at the end without
 * one. */
static enum mpm_status split_options(const struct reading *reading, int argc, char **argv,
                                     GPtrArray *words, struct mpm_error *error)
{
    bool options = true, awaits = false;
    enum mpm_status status = MPM_OK;
    for (int i = 0; status == MPM_OK && i < argc; i++) {
        const bool is_value = awaits;
        awaits = false;
        options = options && (is_value || strcmp(argv[i], "--") != 0);
        if (i == 0 || is_value || !options || argv[i][0] != '-' || argv[i][1] == '\0') {
            g_ptr_array_add(words, g_strdup(argv[i]));
        } else if (argv[i][1] == '-') {
            g_ptr_array_add(words, g_strdup(argv[i]));
            status = check_long(reading, argv[i], &awaits, error);
        } else {
            status = split_letters(reading, argv[i], words, &awaits, error);
        }
        if (status == MPM_OK && awaits && i + 1 == argc)
            status =
                refuse_missing(reading, find_option(reading, words->pdata[words->len - 1]), error);
    }
    return status;
}

/* GLib requires a pointer to an object. */
static void *taker(void)
{
    const GOptionArgFunc function = take;
    void *pointer = NULL;
    memcpy(&pointer, &function, sizeof pointer);
    return pointer;
}

/* The table in GLib's form, with --help and the operands; zero ends it. */
static GOptionEntry *entries_of(const struct reading *reading)
{
    const struct mpm_command_line *const line = reading->line;
    GOptionEntry *const entries = g_new0(GOptionEntry, line->option_count + 3);
    size_t count = 0;
    for (size_t i = 0; i < line->option_count; i++) {
        const struct mpm_option *const option = &line->options[i];
        if (!takes(reading->entry, option))
            continue;
        entries[count++] = (GOptionEntry){
            .long_name = option->name,
            .short_name = option->letter,
            .flags =
                option->kind == MPM_OPTION_FLAG ? G_OPTION_FLAG_NO_ARG : G_OPTION_FLAG_FILENAME,
            .arg = G_OPTION_ARG_CALLBACK,
            .arg_data = taker(),
        };
    }
    entries[count++] = (GOptionEntry){.long_name = "help",
                                      .short_name = 'h',
                                      .flags = G_OPTION_FLAG_NO_ARG,
                                      .arg = G_OPTION_ARG_CALLBACK,
                                      .arg_data = taker()};
    entries[count] = (GOptionEntry){.long_name = G_OPTION_REMAINING,
                                    .flags = G_OPTION_FLAG_FILENAME,
                                    .arg = G_OPTION_ARG_CALLBACK,
                                    .arg_data = taker()};
    return entries;
}

static enum mpm_status parse(struct reading *reading, int argc, char **argv,
                             struct mpm_error *error)
{
    /* GLib reorders its copy; the originals stay the caller's */
    char **const all = g_memdup2(argv, sizeof(char *) * ((size_t)argc + 1));
    char **arguments = all;
    GOptionEntry *const entries = entries_of(reading);
    GOptionGroup *const group = g_option_group_new("main", "", "", reading, NULL);
    GOptionContext *const context = g_option_context_new(NULL);
    GError *failure = NULL;
    g_option_group_add_entries(group, entries);
    g_option_context_set_help_enabled(context, FALSE); /* GLib's own would exit */
    g_option_context_set_main_group(context, group);
    enum mpm_status status = MPM_OK;
    if (!g_option_context_parse(context, &argc, &arguments, &failure))
        status =
            mpm_error_set(error, MPM_BAD_INPUT, "%s: %s; see '%s %s --help'", reading->entry->name,
                          failure->message, reading->line->program, reading->entry->name);
    g_clear_error(&failure);
    g_option_context_free(context);
    g_free(entries);
    g_free(all);
    return status;
}

enum mpm_status mpm_options_read(const struct mpm_command_line *line,
                                 const struct mpm_command_entry *entry, int argc, char **argv,
                                 bool *help, struct mpm_error *error)
{
    struct reading reading = {
        .line = line, .entry = entry, .given = g_new0(bool, line->option_count)};
    GPtrArray *const words = g_ptr_array_new_with_free_func(g_free);
    enum mpm_status status = split_options(&reading, argc, argv, words, error);
    const int count = (int)words->len;
    g_ptr_array_add(words, NULL);
    if (status == MPM_OK)
        status = parse(&reading, count, (char **)words->pdata, error);
    *help = reading.help;
    g_ptr_array_unref(words);
    g_free(reading.given);
    return status;
}

void mpm_command_line_clear(const struct mpm_command_line *line)
{
    for (size_t i = 0; i < line->option_count; i++) {
        const struct mpm_option *const option = &line->options[i];
        void *const value = (char *)line->values + option->offset;
        /* two options, each of other commands, may share a value */
        if (option->kind == MPM_OPTION_LIST)
            g_clear_pointer((char ***)value, g_strfreev);
        else if (option->kind == MPM_OPTION_TEXT || option->kind == MPM_OPTION_JOINED)
            g_clear_pointer((char **)value, g_free);
    }
    g_strfreev(*line->rest);
}
