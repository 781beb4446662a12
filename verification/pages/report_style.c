/* The style of a report.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/pages/report_style.h"

#include "mpm_file.h"
#include "verification/common/input.h"
#include "verification/common/resources.h"

#include <errno.h>
#include <glib.h>

enum mpm_status report_style_read(const char *reports, struct report_style *style,
                                  struct mpm_error *error)
{
    *style = (struct report_style){.page = NULL};
    const struct {
        const char *name;
        char **text;
    } files[] = {{"page.html", &style->page},
                 {"report.css", &style->css},
                 {"table.js", &style->script},
                 {"filter.js", &style->filter},
                 {"glossary.md", &style->glossary}};
    enum mpm_status status = MPM_OK;
    if (reports == NULL)
        return failure_set(error, MPM_ENVIRONMENT_FAILED, RESOURCES_NO_REPORTS);
    for (size_t i = 0; status == MPM_OK && i < G_N_ELEMENTS(files); i++) {
        char *path = g_build_filename(reports, files[i].name, NULL);
        *files[i].text = mpm_file_load(path, NULL);
        if (*files[i].text == NULL)
            status = failure_set(error, MPM_ENVIRONMENT_FAILED, "%s: cannot be read: %s", path,
                                 g_strerror(errno));
        g_free(path);
    }
    if (status == MPM_OK) {
        char *path = g_build_filename(reports, "equations.json", NULL);
        status = input_json(path, JSON_REJECT_DUPLICATES, &style->equations, error);
        const struct mpm_error why = *error;
        if (status != MPM_OK) /* it is the installation's, not the user's */
            status = failure_set(error, MPM_ENVIRONMENT_FAILED, "%s", why.message);
        g_free(path);
    }
    if (status != MPM_OK)
        report_style_clear(style);
    return status;
}

void report_style_clear(struct report_style *style)
{
    g_free(style->page);
    g_free(style->css);
    g_free(style->script);
    g_free(style->filter);
    g_free(style->glossary);
    json_decref(style->equations);
    *style = (struct report_style){.page = NULL};
}
