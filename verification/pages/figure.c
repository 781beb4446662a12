/* Figures.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/pages/figure.h"

#include "mpm_file.h"

#include <glib.h>
#include <glib/gstdio.h>
#include <string.h>

char *figure_quoted(const char *text)
{
    GString *result = g_string_new("'");
    for (const char *c = text; *c != '\0'; c++)
        if (*c == '\'')
            g_string_append(result, "''");
        else if (*c >= ' ')
            g_string_append_c(result, *c);
    g_string_append_c(result, '\'');
    return g_string_free(result, FALSE);
}

/* Runs gnuplot in `home`; what it said is in *said. */
static bool run_gnuplot(const char *home, const char *settings, const char *script, char **said,
                        GError **failure)
{
    char *command[] = {"gnuplot", "-e", (char *)(uintptr_t)settings, (char *)(uintptr_t)script,
                       NULL};
    /* the scripts are UTF-8, and a picture must not depend on the caller's locale */
    char **environment = g_environ_setenv(g_get_environ(), "LC_ALL", "C.UTF-8", TRUE);
    int state = 0;
    const bool ran =
        g_spawn_sync(home, command, environment, G_SPAWN_SEARCH_PATH | G_SPAWN_STDOUT_TO_DEV_NULL,
                     NULL, NULL, NULL, said, &state, failure) &&
        g_spawn_check_wait_status(state, failure);
    g_strfreev(environment);
    return ran;
}

/* The first line of gnuplot's messages that has information. */
static void take_complaint(const char *said, char *reason, size_t size)
{
    char **lines = g_strsplit(said, "\n", -1);
    const char *complaint = "no message";
    for (char **line = lines; *line != NULL; line++) {
        g_strstrip(*line);
        if (**line == '"' || strstr(*line, "warning:") != NULL) {
            complaint = *line;
            break;
        }
    }
    g_snprintf(reason, size, "gnuplot: %s", complaint);
    g_strfreev(lines);
}

static char *replace(char *text, const char *pattern, const char *replacement)
{
    GRegex *regex = g_regex_new(pattern, G_REGEX_DEFAULT, G_REGEX_MATCH_DEFAULT, NULL);
    char *result = g_regex_replace(regex, text, -1, 0, replacement, G_REGEX_MATCH_DEFAULT, NULL);
    g_regex_unref(regex);
    g_free(text);
    return result;
}

char *figure_dress(const char *svg, const char *title, const char *description)
{
    static const char look[] =
        "<style>svg{color:#1f2328;background:#ffffff}"
        "@media(prefers-color-scheme:dark){svg{color:#d8dee6;background:#15181c}}</style>";
    char *head = g_markup_printf_escaped("<title id=\"title\">%s</title>\n"
                                         "<desc id=\"description\">%s</desc>\n",
                                         title, description);
    char *text =
        replace(g_strdup(svg), "(stroke|fill|color)=(['\"])(black|rgb\\( *0, *0, *0\\)|#000000)\\2",
                "\\1=\\2currentColor\\2");
    text = replace(text, "<svg\\s", "<svg role=\"img\" aria-labelledby=\"title description\" ");
    text = replace(text, "<title>[^<]*</title>\\s*<desc>[^<]*</desc>\\s*", "<!--head-->");
    char **parts = g_strsplit(text, "<!--head-->", 2);
    char *dressed =
        parts[1] == NULL ? g_strdup(text) : g_strconcat(parts[0], head, look, "\n", parts[1], NULL);
    g_strfreev(parts);
    g_free(text);
    g_free(head);
    return dressed;
}

/* The file that the script was to write, dressed. */
static bool dress_file(const char *path, const char *title, const char *description)
{
    char *svg = mpm_file_load(path, NULL);
    bool good = svg != NULL && strstr(svg, "</svg>") != NULL &&
                g_utf8_validate(svg, -1, NULL); /* no text else */
    if (good) {
        char *dressed = figure_dress(svg, title, description);
        good = mpm_file_save(path, dressed, strlen(dressed)) == 0;
        g_free(dressed);
    }
    g_free(svg);
    return good;
}

struct figure_result figure_plot(const struct figure_plot *plot)
{
    struct figure_result result = {.state = FIGURE_FAILED};
    char *path = g_build_filename(plot->home, plot->output, NULL), *said = NULL;
    GError *failure = NULL;
    (void)mpm_file_remove(path); /* or an old picture could stand for a new one */
    const bool ran = run_gnuplot(plot->home, plot->settings, plot->script, &said, &failure);
    if (said == NULL)
        g_snprintf(result.reason, sizeof result.reason, "gnuplot cannot be run: %s",
                   failure->message);
    else if (!ran || strstr(said, "warning:") != NULL)
        take_complaint(said, result.reason, sizeof result.reason);
    else if (!dress_file(path, plot->title, plot->description))
        g_strlcpy(result.reason, "the script wrote no SVG file", sizeof result.reason);
    else
        result.state = FIGURE_DRAWN;
    g_clear_error(&failure);
    g_free(said);
    g_free(path);
    return result;
}
