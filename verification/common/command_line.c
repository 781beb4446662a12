/* The command as typed.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/common/command_line.h"

#include <glib.h>
#include <stdbool.h>
#include <string.h>

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
