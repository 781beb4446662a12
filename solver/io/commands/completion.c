/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/commands/completion.h"

#include "io/commands/help.h"

#include <glib.h>
#include <string.h>

const char mpm_completion_shells[] = "bash|zsh|fish";

/* ------------------------------------------------------- what a value may be */

enum value_kind { VALUE_ANY, VALUE_CHOICE, VALUE_FOLDER, VALUE_FILE, VALUE_NAME };

static enum value_kind kind_of(const char *value, const char *names)
{
    static const char *const files[] = {"FILE", "SCENE", "RESULTS", NULL};
    value += value[0] == '['; /* one that may be left out */
    if (names != NULL)
        return VALUE_NAME;
    if (strchr(value, '|') != NULL)
        return VALUE_CHOICE;
    if (g_str_has_prefix(value, "DIR") || strcmp(value, "BUNDLE") == 0)
        return VALUE_FOLDER;
    return g_strv_contains(files, value) ? VALUE_FILE : VALUE_ANY;
}

/* The command that prints names is to know the folder that is on the command line? */
static bool wants_folder(const char *names)
{
    return names != NULL && g_str_has_suffix(names, " DIR");
}

/* Is there such a command in the line? */
static bool any_wants_folder(const struct mpm_command_line *line)
{
    bool any = false;
    for (size_t i = 0; i < line->option_count; i++)
        any = any || wants_folder(line->options[i].names);
    return any;
}

/* The call of a command that prints names, in any of the shells; `folder` is how the shell calls
 * the function of that name, `otherwise` its word for what follows after a failure. */
static void print_names_call(const struct mpm_command_line *line, const char *list,
                             const char *folder, const char *otherwise)
{
    if (list == NULL) /* no value that is a name */
        return;
    const bool with_folder = wants_folder(list);
    const int length = (int)(strlen(list) - strlen(with_folder ? " DIR" : ""));
    if (with_folder)
        (void)fprintf(line->out, "%s %.*s -- %s 2> /dev/null%s ", line->program, length, list,
                      folder, otherwise);
    (void)fprintf(line->out, "%s %.*s 2> /dev/null", line->program, length, list);
}

/* "a|b" as "a b"; g_free. */
static char *choices_of(const char *value)
{
    return g_strdelimit(g_strdup(value), "|", ' ');
}

/* In single quotes of a shell, where `quote` stands for one of its own; g_free. */
static char *quoted(const char *text, const char *quote)
{
    char **const parts = g_strsplit(text, "'", -1);
    char *const joined = g_strjoinv(quote, parts);
    g_strfreev(parts);
    return joined;
}

static bool takes(const struct mpm_command_entry *entry, const struct mpm_option *option)
{
    return (option->takes & entry->takes) != 0;
}

/* The name of a function: bash has no '-' in it everywhere. */
static char *function_name(const struct mpm_command_line *line)
{
    return g_strdelimit(g_strconcat("_", line->program, NULL), "-", '_');
}

static char *command_names(const struct mpm_command_line *line)
{
    GString *const names = g_string_new(NULL);
    for (size_t i = 0; i < line->command_count; i++)
        g_string_append_printf(names, "%s ", line->commands[i].name);
    for (size_t i = 0; i < MPM_HELP_OWN_COUNT; i++)
        g_string_append_printf(names, "%s%s", i > 0 ? " " : "", mpm_help_own[i].name);
    return g_string_free(names, FALSE);
}

/* --------------------------------------------------------------------- bash */

static void bash_value(const struct mpm_command_line *line, const char *value, const char *list)
{
    FILE *const out = line->out;
    char *const words = choices_of(value);
    switch (kind_of(value, list)) {
    case VALUE_NAME:
        (void)fputs("_touchstone_words \"$(", out);
        print_names_call(line, list, "\"$(_touchstone_folder)\"", " ||");
        (void)fputs(")\"", out);
        break;
    case VALUE_CHOICE:
        (void)fprintf(out, "_touchstone_words '%s'", words);
        break;
    case VALUE_FOLDER:
        (void)fputs("_touchstone_names -d", out);
        break;
    case VALUE_FILE:
        (void)fputs("_touchstone_names -f", out);
        break;
    case VALUE_ANY:
        (void)fputs(":", out);
        break;
    }
    g_free(words);
}

static void bash_option_values(const struct mpm_command_line *line,
                               const struct mpm_command_entry *entry)
{
    for (size_t i = 0; i < line->option_count; i++) {
        const struct mpm_option *const option = &line->options[i];
        if (!takes(entry, option) || option->value == NULL)
            continue;
        (void)fprintf(line->out, "    %s:--%s", entry->name, option->name);
        if (option->letter != 0)
            (void)fprintf(line->out, " | %s:-%c", entry->name, option->letter);
        (void)fputs(") ", line->out);
        bash_value(line, option->value, option->names);
        (void)fputs("; return ;;\n", line->out);
    }
}

static void bash_options(const struct mpm_command_line *line, const struct mpm_command_entry *entry)
{
    (void)fprintf(line->out, "    %s:-*) _touchstone_words '", entry->name);
    for (size_t i = 0; i < line->option_count; i++)
        if (takes(entry, &line->options[i]))
            (void)fprintf(line->out, "--%s ", line->options[i].name);
    (void)fputs("--help' ;;\n", line->out);
    if (entry->operands[0] == '\0')
        return;
    char **const operands = g_strsplit(entry->operands, " ", -1);
    (void)fprintf(line->out, "    %s:*) ", entry->name);
    /* where operands are of two kinds, files stand for both */
    const bool alike =
        operands[1] == NULL || kind_of(operands[0], NULL) == kind_of(operands[1], NULL);
    bash_value(line, alike ? operands[0] : "FILE", entry->names);
    (void)fputs(" ;;\n", line->out);
    g_strfreev(operands);
}

/* The first folder after the command that is no option's value; its word is as typed. */
static const char bash_folder[] =
    "    _touchstone_folder()\n    {\n"
    "        local i name\n"
    "        for ((i = 2; i < ${#COMP_WORDS[@]}; i++)); do\n"
    "            name=${COMP_WORDS[i]//[\\\\\\'\\\"]/}\n"
    "            [[ ${COMP_WORDS[i - 1]} != -* && -d $name ]] && { printf %s \"$name\"; return; }\n"
    "        done\n    }\n";

static void print_bash(const struct mpm_command_line *line)
{
    char *const function = function_name(line), *const names = command_names(line);
    (void)fprintf(
        line->out,
        "# Completion of %s for bash, made by '%s completion bash'.\n"
        "%s()\n{\n"
        "    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]}\n"
        "    _touchstone_words() { mapfile -t COMPREPLY < <(compgen -W \"$1\" -- \"$word\"); }\n"
        "    _touchstone_names() { compopt -o filenames; mapfile -t COMPREPLY < <(compgen \"$1\" "
        "-- "
        "\"$word\"); }\n"
        "%s    COMPREPLY=()\n"
        "    # --option=value is three words\n"
        "    [ \"$before\" = = ] && before=${COMP_WORDS[COMP_CWORD - 2]}\n"
        "    [ \"$word\" = = ] && word=\n"
        "    if [ \"$COMP_CWORD\" -eq 1 ]; then\n"
        "        _touchstone_words '%s --help --version'\n"
        "        return\n    fi\n"
        "    case ${COMP_WORDS[1]}:$before in\n",
        line->program, line->program, function, any_wants_folder(line) ? bash_folder : "", names);
    for (size_t i = 0; i < line->command_count; i++)
        bash_option_values(line, &line->commands[i]);
    (void)fputs("    esac\n    case ${COMP_WORDS[1]}:$word in\n", line->out);
    for (size_t i = 0; i < line->command_count; i++)
        bash_options(line, &line->commands[i]);
    char *const shells = choices_of(mpm_completion_shells);
    (void)fprintf(line->out,
                  "    help:*) _touchstone_words '%s' ;;\n    completion:*) _touchstone_words '%s' "
                  ";;\n    esac\n}\n"
                  "complete -F %s %s\n",
                  names, shells, function, line->program);
    g_free(shells);
    g_free(names);
    g_free(function);
}

/* ---------------------------------------------------------------------- zsh */

/* A text inside of a specification of _arguments, in single quotes; g_free. */
static char *zsh_text(const char *text)
{
    GString *const escaped = g_string_new(NULL);
    for (const char *c = text; *c != '\0'; c++) {
        if (strchr("[]:\\", *c) != NULL)
            g_string_append_c(escaped, '\\');
        g_string_append_c(escaped, *c);
    }
    char *const whole = quoted(escaped->str, "'\\''");
    g_string_free(escaped, TRUE);
    return whole;
}

/* ":NAME:what completes it" */
static void zsh_value(const struct mpm_command_line *line, const char *value, const char *list)
{
    FILE *const out = line->out;
    char *const words = choices_of(value), *const name = zsh_text(value);
    switch (kind_of(value, list)) {
    case VALUE_NAME:
        (void)fprintf(out, ":%s: compadd - $(", name);
        print_names_call(line, list, "\"$(_touchstone_folder)\"", " ||");
        (void)fputs(")", out);
        break;
    case VALUE_CHOICE:
        (void)fprintf(out, ":%s:(%s)", name, words);
        break;
    case VALUE_FOLDER:
        (void)fprintf(out, ":%s:_files -/", name);
        break;
    case VALUE_FILE:
        (void)fprintf(out, ":%s:_files", name);
        break;
    case VALUE_ANY:
        (void)fprintf(out, ":%s: ", name);
        break;
    }
    g_free(name);
    g_free(words);
}

static void zsh_option(const struct mpm_command_line *line, const struct mpm_option *option,
                       bool short_form)
{
    FILE *const out = line->out;
    const bool repeats = option->kind == MPM_OPTION_LIST || option->kind == MPM_OPTION_JOINED;
    char *const help = zsh_text(option->help);
    (void)fprintf(out, " \\\n            '%s", repeats ? "*" : "");
    if (short_form)
        (void)fprintf(out, "-%c%s", option->letter, option->value != NULL ? "+" : "");
    else
        (void)fprintf(out, "--%s%s", option->name, option->value != NULL ? "=" : "");
    (void)fprintf(out, "[%s]", help);
    if (option->value != NULL)
        zsh_value(line, option->value, option->names);
    (void)fputs("'", out);
    g_free(help);
}

static void zsh_command(const struct mpm_command_line *line, const struct mpm_command_entry *entry)
{
    char **const operands = g_strsplit(entry->operands, " ", -1);
    (void)fprintf(line->out, "    %s)\n        _arguments '--help[this help]'", entry->name);
    for (size_t i = 0; i < line->option_count; i++) {
        if (!takes(entry, &line->options[i]))
            continue;
        zsh_option(line, &line->options[i], false);
        if (line->options[i].letter != 0)
            zsh_option(line, &line->options[i], true);
    }
    for (char **operand = operands; *operand != NULL; operand++) {
        (void)fputs(" \\\n            '", line->out);
        zsh_value(line, *operand, operand == operands ? entry->names : NULL);
        (void)fputs("'", line->out);
    }
    (void)fputs(" ;;\n", line->out);
    g_strfreev(operands);
}

static void zsh_describe(FILE *out, const char *name, const char *summary)
{
    char *const text = quoted(summary, "'\\''");
    (void)fprintf(out, "            '%s:%s'\n", name, text);
    g_free(text);
}

static const char zsh_folder[] = "_touchstone_folder() {\n    local i\n"
                                 "    for (( i = 2; i <= $#words; i++ )); do\n"
                                 "        [[ $words[i-1] != -* && -d ${(Q)words[i]} ]] && { print "
                                 "-rn -- ${(Q)words[i]}; return }\n"
                                 "    done\n}\n";

static void print_zsh(const struct mpm_command_line *line)
{
    char *const shells = choices_of(mpm_completion_shells), *const names = command_names(line);
    (void)fprintf(line->out,
                  "#compdef %s\n# Completion of %s for zsh, made by '%s completion zsh'.\n%s"
                  "_%s() {\n    if (( CURRENT == 2 )); then\n        local -a commands=(\n",
                  line->program, line->program, line->program,
                  any_wants_folder(line) ? zsh_folder : "", line->program);
    for (size_t i = 0; i < line->command_count; i++)
        zsh_describe(line->out, line->commands[i].name, line->commands[i].summary);
    for (size_t i = 0; i < MPM_HELP_OWN_COUNT; i++)
        zsh_describe(line->out, mpm_help_own[i].name, mpm_help_own[i].summary);
    (void)fputs(
        "        )\n        _describe -t commands command commands\n        return\n    fi\n"
        "    local command=$words[2]\n    shift words\n    (( CURRENT-- ))\n"
        "    case $command in\n",
        line->out);
    for (size_t i = 0; i < line->command_count; i++)
        zsh_command(line, &line->commands[i]);
    (void)fprintf(line->out,
                  "    help) _arguments ':command:(%s)' ;;\n"
                  "    completion) _arguments ':shell:(%s)' ;;\n    esac\n}\n"
                  "# from a folder of functions it is called, read as a file it registers itself\n"
                  "if [[ $funcstack[1] = _%s ]]; then _%s \"$@\"; else compdef _%s %s; fi\n",
                  names, shells, line->program, line->program, line->program, line->program);
    g_free(names);
    g_free(shells);
}

/* --------------------------------------------------------------------- fish */

/* "-x -a 'a b'": what may follow. */
static void fish_value(const struct mpm_command_line *line, const char *value, const char *list)
{
    FILE *const out = line->out;
    char *const words = choices_of(value);
    switch (kind_of(value, list)) {
    case VALUE_NAME:
        (void)fputs(" -x -a '(", out);
        print_names_call(line, list, "(__touchstone_folder)", "; or");
        (void)fputs(")'", out);
        break;
    case VALUE_CHOICE:
        (void)fprintf(out, " -x -a '%s'", words);
        break;
    case VALUE_FOLDER:
        (void)fputs(" -x -a '(__fish_complete_directories)'", out);
        break;
    case VALUE_FILE:
        (void)fputs(" -r -F", out);
        break;
    case VALUE_ANY:
        (void)fputs(" -x", out);
        break;
    }
    g_free(words);
}

static void fish_name(const struct mpm_command_line *line, const char *name, const char *summary)
{
    char *const text = quoted(summary, "\\'");
    (void)fprintf(line->out, "complete -c %s -n __fish_use_subcommand -a %s -d '%s'\n",
                  line->program, name, text);
    g_free(text);
}

static void fish_command(const struct mpm_command_line *line, const struct mpm_command_entry *entry)
{
    char **const operands = g_strsplit(entry->operands, " ", -1);
    char *const start = g_strdup_printf("complete -c %s -n '__fish_seen_subcommand_from %s'",
                                        line->program, entry->name);
    for (size_t i = 0; i < line->option_count; i++) {
        const struct mpm_option *const option = &line->options[i];
        if (!takes(entry, option))
            continue;
        char *const help = quoted(option->help, "\\'");
        (void)fprintf(line->out, "%s -l %s", start, option->name);
        if (option->letter != 0)
            (void)fprintf(line->out, " -s %c", option->letter);
        if (option->value != NULL)
            fish_value(line, option->value, option->names);
        (void)fprintf(line->out, " -d '%s'\n", help);
        g_free(help);
    }
    (void)fprintf(line->out, "%s -l help -s h -d 'this help'\n", start);
    for (char **operand = operands; *operand != NULL; operand++) {
        const char *const names = operand == operands ? entry->names : NULL;
        if (kind_of(*operand, names) == VALUE_ANY)
            continue;
        (void)fputs(start, line->out);
        fish_value(line, *operand, names);
        (void)fputc('\n', line->out);
    }
    g_free(start);
    g_strfreev(operands);
}

static const char fish_folder[] =
    "function __touchstone_folder\n    set -l words (commandline -opc)\n    set -l before -\n"
    "    for word in $words[2..-1]\n"
    "        if not string match -q -- '-*' $before; and test -d \"$word\"\n"
    "            echo $word\n            return\n        end\n"
    "        set before $word\n    end\nend\n";

static void print_fish(const struct mpm_command_line *line)
{
    char *const shells = choices_of(mpm_completion_shells), *const names = command_names(line);
    (void)fprintf(
        line->out,
        "# Completion of %s for fish, made by '%s completion fish'.\n%scomplete -c %s -f\n",
        line->program, line->program, any_wants_folder(line) ? fish_folder : "", line->program);
    for (size_t i = 0; i < line->command_count; i++)
        fish_name(line, line->commands[i].name, line->commands[i].summary);
    for (size_t i = 0; i < MPM_HELP_OWN_COUNT; i++)
        fish_name(line, mpm_help_own[i].name, mpm_help_own[i].summary);
    for (size_t i = 0; i < line->command_count; i++)
        fish_command(line, &line->commands[i]);
    (void)fprintf(line->out,
                  "complete -c %s -n '__fish_seen_subcommand_from help' -a '%s'\n"
                  "complete -c %s -n '__fish_seen_subcommand_from completion' -a '%s'\n",
                  line->program, names, line->program, shells);
    g_free(names);
    g_free(shells);
}

bool mpm_completion_print(const struct mpm_command_line *line, const char *shell)
{
    static const struct {
        const char *name;
        void (*print)(const struct mpm_command_line *line);
    } shells[] = {{"bash", print_bash}, {"zsh", print_zsh}, {"fish", print_fish}};
    for (size_t i = 0; i < G_N_ELEMENTS(shells); i++)
        if (g_strcmp0(shell, shells[i].name) == 0) {
            shells[i].print(line);
            return true;
        }
    return false;
}
