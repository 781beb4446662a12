/* Figures.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/pages/figure.h"

#include "mpm_file.h"
#include "mpm_gnuplot.h"
#include "verification/common/input.h"
#include "verification/common/output.h"
#include "verification/pages/figure_script.h"
#include "verification/pages/figure_shorten.h"

#include <errno.h>
#include <glib.h>
#include <string.h>

char *figure_quoted(const char *text)
{
    GString *result = g_string_new(NULL);
    /* for gnuplot, two single quotes at the beginning are an empty text */
    const size_t first = strspn(text, "'");
    if (first > 0)
        g_string_append_printf(result, "\"%.*s\".", (int)first, text);
    g_string_append_c(result, '\'');
    for (const char *c = text + first; *c != '\0'; c++)
        if (*c == '\'')
            g_string_append(result, "''");
        else if ((unsigned char)*c >= ' ')
            g_string_append_c(result, *c);
    g_string_append_c(result, '\'');
    return g_string_free(result, FALSE);
}

/* The first line of gnuplot's messages that has information, as an error. */
static enum mpm_status complaint(const char *said, struct mpm_error *error)
{
    char **lines = g_strsplit(said, "\n", -1);
    const char *shown = "no message";
    for (char **line = lines; *line != NULL; line++) {
        g_strstrip(*line);
        if (**line != '\0')
            shown = *line; /* if none has a place: the last, as gnuplot shows the command before */
        if (**line == '"' || strstr(*line, "warning:") != NULL) {
            shown = *line;
            break;
        }
    }
    const enum mpm_status status = failure_set(error, MPM_ENVIRONMENT_FAILED, "gnuplot: %s", shown);
    g_strfreev(lines);
    return status;
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

/* -------------------------------------------------------------------- drawing */

static const char picture[] = "figure.svg", style[] = ".style.gp", axes[] = ".axes.gp";

static bool is_picture(const char *text)
{
    return strstr(text, "</svg>") != NULL && g_utf8_validate(text, -1, NULL);
}

/* The size that gnuplot gave the picture: pages keep room for it before it is there. */
static void read_size(const char *svg, struct figure_result *result)
{
    static const char begin[] = "viewBox=\"0 0 ";
    const char *box = strstr(svg, begin);
    char *rest = NULL;
    result->width = 760; /* that of style.gp */
    result->height = 470;
    if (box == NULL)
        return;
    const gint64 width = g_ascii_strtoll(box + strlen(begin), &rest, 10);
    const gint64 height = g_ascii_strtoll(rest, NULL, 10);
    if (width > 0 && width < G_MAXINT && height > 0 && height < G_MAXINT) {
        result->width = (int)width;
        result->height = (int)height;
    }
}

/* What the script wrote, dressed, as the file that it is to be. */
static enum mpm_status dress_file(const char *home, const struct figure_plot *plot,
                                  struct figure_result *result, struct mpm_error *error)
{
    char *path = g_build_filename(home, picture, NULL), *svg = NULL;
    enum mpm_status status = input_text(path, NULL, &svg, NULL, error);
    if (status == MPM_BAD_INPUT || (svg != NULL && !is_picture(svg)))
        status = failure_set(error, MPM_ENVIRONMENT_FAILED, "the script wrote no SVG file");
    if (status == MPM_OK && svg != NULL) {
        read_size(svg, result);
        char *dressed = figure_dress(svg, plot->title, plot->description);
        char *shorter = figure_shorten(dressed);
        status = output_write(plot->folder, plot->output, shorter, error);
        g_free(shorter);
        g_free(dressed);
    }
    g_free(svg);
    g_free(path);
    return status;
}

/* The text is checked and then copied, so that nothing else runs than was read. */
static enum mpm_status stage_text(const char *home, const char *name, const char *text,
                                  bool generated, struct mpm_error *error)
{
    TRY(figure_script_check(name, text, generated, error));
    return output_write(home, name, text, error);
}

static enum mpm_status stage_file(const char *home, const char *name, const char *path,
                                  struct mpm_error *error)
{
    char *text = mpm_file_load(path, NULL);
    if (text == NULL)
        return failure_set(error, MPM_ENVIRONMENT_FAILED, "%s: cannot be read: %s", path,
                           g_strerror(errno));
    const enum mpm_status status = stage_text(home, name, text, false, error);
    g_free(text);
    return status;
}

static enum mpm_status stage(const char *home, const char *script, const struct figure_plot *plot,
                             struct mpm_error *error)
{
    TRY(figure_script_check("settings", plot->settings, true, error));
    TRY(stage_file(home, style, plot->style, error));
    if (plot->axes != NULL)
        TRY(stage_text(home, axes, plot->axes, true, error));
    return stage_file(home, script, plot->script, error);
}

/* Runs the staged script; its complaint is a failure. */
static enum mpm_status draw(const char *home, const char *script, const struct figure_plot *plot,
                            struct figure_result *result, struct mpm_error *error)
{
    char *settings = g_strdup_printf("style='%s'; axes='%s'; output='%s'; %s", style, axes, picture,
                                     plot->settings);
    char *said = NULL;
    char *failure = NULL;
    enum mpm_status status = MPM_OK;
    const bool ran = mpm_gnuplot_run(home, settings, script, &said, &failure);
    if (said == NULL)
        status = failure_set(error, MPM_ENVIRONMENT_FAILED, "gnuplot cannot be run: %s", failure);
    else if (!ran || strstr(said, "warning:") != NULL)
        status = complaint(said, error);
    g_free(failure);
    g_free(said);
    g_free(settings);
    return status == MPM_OK ? dress_file(home, plot, result, error) : status;
}

struct figure_result figure_plot(const struct figure_plot *plot)
{
    struct figure_result result = {.state = FIGURE_FAILED};
    struct mpm_error error = {.status = MPM_OK};
    char *old = g_build_filename(plot->folder, plot->output, NULL);
    char *script = g_path_get_basename(plot->script);
    char *home = NULL;
    enum mpm_status status = mpm_folder_make_temporary(&home, &error);
    if (status == MPM_OK)
        status = stage(home, script, plot, &error);
    /* or an old picture could stand for a new one */
    if (status == MPM_OK && mpm_file_remove(old) != 0 && errno != ENOENT)
        status = mpm_file_failed(old, errno, &error);
    if (status == MPM_OK)
        status = draw(home, script, plot, &result, &error);
    if (status == MPM_OK)
        result.state = FIGURE_DRAWN;
    else
        g_strlcpy(result.reason, error.message, sizeof result.reason);
    if (home != NULL)
        (void)mpm_folder_remove_all(home, NULL);
    g_free(home);
    g_free(script);
    g_free(old);
    return result;
}
