/* Names and patterns.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/common/names.h"

#include <fnmatch.h>
#include <glib.h>
#include <string.h>

bool glob_matches(const char *glob, const char *name)
{
    return fnmatch(glob, name, 0) == 0;
}

bool globs_match(char *const *globs, unsigned count, const char *name)
{
    for (unsigned i = 0; i < count; i++)
        if (glob_matches(globs[i], name))
            return true;
    return false;
}

bool glob_list_matches(const char *globs, const char *name)
{
    if (globs == NULL)
        return true;
    char **const list = g_strsplit(globs, ",", -1);
    const bool matches = globs_match(list, g_strv_length(list), name);
    g_strfreev(list);
    return matches;
}

/* Names become parts of file names, links and globs. */
bool name_is_sound(const char *text)
{
    return *text != '\0' && strlen(text) <= 64 &&
           strspn(text, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-") ==
               strlen(text);
}

const char name_rule[] = "allowed are 1 to 64 letters, digits, '_' and '-'";

bool name_is_plain(const char *text)
{
    for (const char *c = text; *c != '\0'; c++)
        if (!g_ascii_isalnum(*c) && *c != '_' && *c != '-')
            return false;
    return *text != '\0';
}

bool name_is_script(const char *text)
{
    const size_t length = strlen(text), suffix = strlen(".gp");
    if (!g_str_has_suffix(text, ".gp") || *text == '-')
        return false;
    char *name = g_strndup(text, length - suffix);
    const bool plain = name_is_plain(name);
    g_free(name);
    return plain;
}
