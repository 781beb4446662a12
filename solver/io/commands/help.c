/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/commands/help.h"

#include "mpm_words.h"

#include <glib.h>

/* Where texts begin, beside names; a longer name has a line of its own. */
enum { PROGRAM_COLUMN = 22, COMMAND_COLUMN = 24 };

const struct mpm_help_row mpm_help_own[MPM_HELP_OWN_COUNT] = {
    {"help", "[COMMAND]", "this list, or the help of a command: its options"},
    {"completion", "SHELL", "print the completion of bash, zsh or fish"},
};

static void print_row(FILE *out, const char *name, const char *text, size_t column)
{
    size_t length = (size_t)g_utf8_strlen(name, -1) + 2;
    (void)fprintf(out, "  %s", name);
    if (length + 2 > column) {
        (void)fputc('\n', out);
        length = 0;
    }
    (void)fprintf(out, "%*s", (int)(column - length), "");
    mpm_words_wrap(out, text, column, column, MPM_HELP_WIDTH);
}

/* Where a letter has a value: the ways to write it. */
static void print_values(const struct mpm_command_line *line)
{
    for (size_t i = 0; i < line->option_count; i++) {
        const struct mpm_option *const option = &line->options[i];
        if (option->letter == 0 || option->value == NULL)
            continue;
        (void)fprintf(line->out, "Values: --%s %s, --%s=%s, -%c %s or -%c%s.\n", option->name,
                      option->value, option->name, option->value, option->letter, option->value,
                      option->letter, option->value);
        return;
    }
}

void mpm_help_program(const struct mpm_command_line *line)
{
    (void)fprintf(line->out, "Usage: %s COMMAND [OPTION...] [OPERAND...]\n\n", line->program);
    mpm_words_wrap(line->out, line->about, 0, 0, MPM_HELP_WIDTH);
    (void)fprintf(line->out, "\nCommands:\n");
    for (size_t i = 0; i < line->command_count; i++) {
        const struct mpm_command_entry *const entry = &line->commands[i];
        char *const name =
            g_strjoin(entry->operands[0] != '\0' ? " " : "", entry->name, entry->operands, NULL);
        print_row(line->out, name, entry->summary, PROGRAM_COLUMN);
        g_free(name);
    }
    for (size_t i = 0; i < MPM_HELP_OWN_COUNT; i++) {
        char *const name = g_strjoin(" ", mpm_help_own[i].name, mpm_help_own[i].operands, NULL);
        print_row(line->out, name, mpm_help_own[i].summary, PROGRAM_COLUMN);
        g_free(name);
    }
    (void)fprintf(line->out,
                  "\n'%s COMMAND --help' lists the options of a command,\n"
                  "'%s --version' prints the version.\n",
                  line->program, line->program);
    print_values(line);
    (void)fputc('\n', line->out);
    mpm_words_wrap(line->out, line->notes, 0, 0, MPM_HELP_WIDTH);
}

static void print_option(FILE *out, const struct mpm_option *option)
{
    GString *const name = g_string_new(NULL);
    if (option->letter != 0)
        g_string_append_printf(name, "-%c, ", option->letter);
    g_string_append_printf(name, "--%s", option->name);
    if (option->value != NULL)
        g_string_append_printf(name, " %s", option->value);
    const bool repeats = option->kind == MPM_OPTION_LIST || option->kind == MPM_OPTION_JOINED;
    char *const text =
        g_strconcat(option->help, repeats ? "; may be given several times" : "", NULL);
    print_row(out, name->str, text, COMMAND_COLUMN);
    g_free(text);
    g_string_free(name, TRUE);
}

void mpm_help_command(const struct mpm_command_line *line, const struct mpm_command_entry *entry)
{
    (void)fprintf(line->out, "Usage: %s %s [OPTION...]%s%s\n\n", line->program, entry->name,
                  entry->operands[0] != '\0' ? " " : "", entry->operands);
    mpm_words_wrap(line->out, entry->summary, 0, 0, MPM_HELP_WIDTH);
    (void)fprintf(line->out, "\nOptions:\n");
    for (size_t i = 0; i < line->option_count; i++)
        if ((line->options[i].takes & entry->takes) != 0)
            print_option(line->out, &line->options[i]);
    print_row(line->out, "-h, --help", "this help", COMMAND_COLUMN);
    if (entry->description == NULL)
        return;
    (void)fputc('\n', line->out);
    mpm_words_wrap(line->out, entry->description, 0, 0, MPM_HELP_WIDTH);
}

void mpm_help_own_command(const struct mpm_command_line *line, const struct mpm_help_row *row)
{
    (void)fprintf(line->out, "Usage: %s %s %s\n\n", line->program, row->name, row->operands);
    mpm_words_wrap(line->out, row->summary, 0, 0, MPM_HELP_WIDTH);
}
