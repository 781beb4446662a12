/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "support/document.h"

#include <glib.h>
#include <math.h>
#include <string.h>

char *test_text_replaced(char *text, const char *from, const char *to)
{
    char **parts = g_strsplit(text, from, -1), *joined = g_strjoinv(to, parts);
    g_strfreev(parts);
    g_free(text);
    return joined;
}

char *test_text_squeezed(const char *text)
{
    char **words = g_strsplit_set(text, " \t", -1);
    GString *joined = g_string_new(NULL);
    for (char **word = words; *word != NULL; word++)
        if (**word != '\0')
            g_string_append_printf(joined, "%s%s", joined->len > 0 ? " " : "", *word);
    g_strfreev(words);
    return g_string_free(joined, FALSE);
}

bool test_document_command(const char *line)
{
    return g_str_has_prefix(line, "    build/release/bin/") ||
           g_str_has_prefix(line, "    python3 ") || g_str_has_prefix(line, "    sed ");
}

struct test_command test_document_run(const char *line, const char *folder, const char *more)
{
    static const char BIN[] = "@bin@/";
    char *bin = g_strconcat(g_getenv("MPM_BIN"), "/", NULL), *work = g_strconcat(folder, "/", NULL);
    char *text = g_strconcat(line, more, NULL);
    text = test_text_replaced(text, "build/release/bin/", BIN);
    text = test_text_replaced(text, "build/", work);
    text = test_text_replaced(text, BIN, bin);
    struct test_command command = test_command_run("/bin/sh", "-c", text, NULL);
    g_free(text);
    g_free(work);
    g_free(bin);
    return command;
}

static bool word_agrees(const char *one, const char *other, double tolerance)
{
    char *end[2];
    const double numbers[2] = {g_ascii_strtod(one, &end[0]), g_ascii_strtod(other, &end[1])};
    if (strcmp(one, other) == 0)
        return true;
    return end[0] != one && *end[0] == '\0' && end[1] != other && *end[1] == '\0' &&
           fabs(numbers[0] - numbers[1]) <= tolerance * fabs(numbers[1]);
}

bool test_words_agree(const char *one, const char *other, double tolerance)
{
    char *text[2] = {test_text_squeezed(one), test_text_squeezed(other)};
    char **words[2] = {g_strsplit(text[0], " ", -1), g_strsplit(text[1], " ", -1)};
    bool agree = g_strv_length(words[0]) == g_strv_length(words[1]);
    for (guint k = 0; agree && words[0][k] != NULL; k++)
        agree = word_agrees(words[0][k], words[1][k], tolerance);
    for (int k = 0; k < 2; k++) {
        g_strfreev(words[k]);
        g_free(text[k]);
    }
    return agree;
}

/* ---------------------------------------------------------------------- pictures */

static const char *drawing(const char *picture, char **version)
{
    static const char begin[] = "<desc>", end[] = "</desc>";
    const char *from = strstr(picture, begin);
    const char *to = from == NULL ? NULL : strstr(from, end);
    *version = to == NULL ? g_strdup("") : g_strndup(from, (gsize)(to - from));
    return to == NULL ? picture : to;
}

static const char *past_blanks(const char *text)
{
    return text + strspn(text, " \t\n");
}

/* Lines break where numbers have more digits, so blanks do not count; words between elements are
 * compared letter by letter, also if they are numbers. */
static bool elements_agree(const char *one, const char *other, double pixels)
{
    bool inside = false;
    for (;;) {
        one = past_blanks(one);
        other = past_blanks(other);
        char *end[2] = {NULL, NULL};
        if (inside && (g_ascii_isdigit(*one) || *one == '-')) {
            const double numbers[2] = {g_ascii_strtod(one, &end[0]),
                                       g_ascii_strtod(other, &end[1])};
            if (end[0] != one && end[1] != other) {
                if (!(fabs(numbers[0] - numbers[1]) <= pixels))
                    return false;
                one = end[0];
                other = end[1];
                continue;
            }
        }
        if (*one != *other)
            return false;
        if (*one == '\0')
            return true;
        inside = *one == '<' || (inside && *one != '>');
        one++;
        other++;
    }
}

bool test_pictures_agree(const char *one, const char *other, double pixels)
{
    char *versions[2];
    const char *drawings[2] = {drawing(one, &versions[0]), drawing(other, &versions[1])};
    const bool agree =
        strcmp(versions[0], versions[1]) != 0 || elements_agree(drawings[0], drawings[1], pixels);
    g_free(versions[1]);
    g_free(versions[0]);
    return agree;
}
