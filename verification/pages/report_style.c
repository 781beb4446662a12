/* The style of a report.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/pages/report_style.h"

#include "mpm_file.h"

#include <errno.h>
#include <glib.h>

/* From the folder itself, or else from `reports`. */
static enum mpm_status read_style_file(const char *folder, const char *reports, const char *name,
                                       char **text, struct mpm_error *error)
{
    char *own = g_build_filename(folder, "style", name, NULL);
    char *shared = g_build_filename(reports == NULL ? "" : reports, name, NULL);
    *text = mpm_file_load(own, NULL);
    const int reason = *text != NULL ? 0 : errno;
    if (reason == ENOENT)
        *text = mpm_file_load(shared, NULL);
    enum mpm_status status = MPM_OK;
    if (*text == NULL && reason == ENOENT)
        status =
            failure_set(error, MPM_ENVIRONMENT_FAILED, "%s: neither this nor %s can be read: %s",
                        own, shared, g_strerror(errno));
    else if (*text == NULL)
        status = failure_set(error, MPM_ENVIRONMENT_FAILED, "%s: cannot be read: %s", own,
                             g_strerror(reason));
    g_free(own);
    g_free(shared);
    return status;
}

enum mpm_status report_style_read(const char *folder, const char *reports,
                                  struct report_style *style, struct mpm_error *error)
{
    *style = (struct report_style){.page = NULL};
    const struct {
        const char *name;
        char **text;
    } files[] = {{"page.html", &style->page},
                 {"report.css", &style->css},
                 {"table.js", &style->script},
                 {"glossary.md", &style->glossary}};
    enum mpm_status status = MPM_OK;
    for (size_t i = 0; status == MPM_OK && i < G_N_ELEMENTS(files); i++)
        status = read_style_file(folder, reports, files[i].name, files[i].text, error);
    if (status != MPM_OK)
        report_style_clear(style);
    return status;
}

void report_style_clear(struct report_style *style)
{
    g_free(style->page);
    g_free(style->css);
    g_free(style->script);
    g_free(style->glossary);
    *style = (struct report_style){.page = NULL};
}
