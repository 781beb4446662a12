/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/common/result_lines.h"

#include "verification/common/failure.h"
#include "verification/common/input.h"

#include <glib.h>

static bool add_line(const struct result_format *format, const char *text, json_t **run,
                     json_t *lines)
{
    json_t *object = json_loads(text, JSON_REJECT_DUPLICATES, NULL);
    if (*run == NULL && format->is_run(object)) {
        *run = object;
        return true;
    }
    if (*run != NULL && format->is_line(object)) {
        json_array_append_new(lines, object);
        return true;
    }
    json_decref(object);
    return false;
}

enum mpm_status result_lines_read(const char *folder, const struct result_format *format,
                                  json_t **run, json_t **lines, struct mpm_error *error)
{
    char *path = g_build_filename(folder, format->file, NULL), *text = NULL;
    char *const allowed = g_strdup_printf("the output folder of %s", format->command);
    enum mpm_status status = input_text(path, allowed, &text, NULL, error);
    *run = NULL;
    *lines = json_array();
    g_free(allowed);
    char **texts = g_strsplit(text == NULL ? "" : text, "\n", -1);
    for (unsigned i = 0; status == MPM_OK && texts[i] != NULL; i++)
        if (*texts[i] != '\0' && !add_line(format, texts[i], run, *lines))
            status = failure_set(error, MPM_BAD_INPUT, "%s:%u: is no %s", path, i + 1,
                                 *run == NULL ? "record of a run" : format->noun);
    if (status == MPM_OK && *run == NULL)
        status = failure_set(error, MPM_BAD_INPUT, "%s: is empty", path);
    g_strfreev(texts);
    g_free(text);
    g_free(path);
    if (status != MPM_OK) {
        json_decref(*run);
        json_decref(*lines);
        *run = *lines = NULL;
    }
    return status;
}
