/* The figures of a case.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/report/case_figure.h"

#include "mpm_file.h"
#include "verification/common/names.h"

#include <glib.h>
#include <string.h>

static bool finished(const json_t *variant)
{
    return strcmp(record_text(variant, "outcome"), "returned") == 0;
}

/* The names, separated by blanks, of the variants that `globs` select; "" with a reason
 * if a glob selects none of this run's or one that did not finish. */
static char *variants_needed(const json_t *entry, const json_t *globs, char *reason, size_t size)
{
    GString *names = g_string_new(NULL);
    const json_t *variants = json_object_get(entry, "variants");
    bool whole = true;
    for (size_t g = 0; g < json_array_size(globs); g++) {
        const char *glob = json_string_value(json_array_get(globs, g));
        size_t matched = 0;
        for (size_t v = 0; glob != NULL && v < json_array_size(variants); v++) {
            const json_t *variant = json_array_get(variants, v);
            const char *name = record_text(variant, "variant");
            if (!glob_matches(glob, name))
                continue;
            matched++;
            if (!finished(variant)) {
                g_snprintf(reason, size, "variant %s did not finish: %s", name,
                           record_text(variant, "outcome"));
                whole = false;
            }
            g_string_append_printf(names, "%s%s", names->len == 0 ? "" : " ", name);
        }
        if (matched == 0 && whole) {
            g_snprintf(reason, size, "it needs variant %s, which this run did not select", glob);
            whole = false;
        }
    }
    if (!whole)
        g_string_truncate(names, 0);
    return g_string_free(names, FALSE);
}

static char *settings_of(const json_t *run, const json_t *figure, const char *variants)
{
    char *stamp = g_strdup_printf("Touchstone %s, %s", record_text(run, "version"),
                                  record_text(run, "revision"));
    char *quoted_stamp = figure_quoted(stamp);
    char *quoted_name = figure_quoted(record_text(figure, "figure"));
    char *settings =
        g_strdup_printf("style='../../style/style.gp'; output='figure-%s.svg'; name=%s; data='.'; "
                        "source='source'; variants='%s'; stamp=%s",
                        record_text(figure, "figure"), quoted_name, variants, quoted_stamp);
    g_free(stamp);
    g_free(quoted_stamp);
    g_free(quoted_name);
    return settings;
}

static struct figure_result draw(const char *home, const char *settings, const json_t *figure)
{
    char *file = g_strdup_printf("figure-%s.svg", record_text(figure, "figure"));
    char *script = g_build_filename("source", record_text(figure, "script"), NULL);
    char *description = g_strdup_printf("%s Reference: %s", record_text(figure, "caption"),
                                        record_text(figure, "reference"));
    const struct figure_result result = figure_plot(&(struct figure_plot){
        home, script, settings, file, record_text(figure, "title"), description});
    g_free(description);
    g_free(script);
    g_free(file);
    return result;
}

struct figure_result figure_draw(const char *folder, const json_t *run, const json_t *entry,
                                 const json_t *figure)
{
    struct figure_result result = {.state = FIGURE_WITHOUT_DATA};
    char *home = g_build_filename(folder, "cases", record_text(entry, "case"), NULL);
    char *variants = variants_needed(entry, json_object_get(figure, "needs"), result.reason,
                                     sizeof result.reason);
    char *source = g_build_filename(home, "source", NULL);
    if (result.reason[0] == '\0' && mpm_path_kind(source) == MPM_PATH_NONE)
        g_strlcpy(result.reason, "this folder holds the result lines alone, not the figure's data",
                  sizeof result.reason);
    g_free(source);
    if (result.reason[0] == '\0') {
        char *settings = settings_of(run, figure, variants);
        result = draw(home, settings, figure);
        g_free(settings);
    }
    g_free(variants);
    g_free(home);
    return result;
}
