/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/common/result_lines.h"

#include "verification/common/failure.h"
#include "verification/common/input.h"
#include "verification/common/result_path.h"

#include <glib.h>
#include <string.h>

/* Takes a line in; *fault is why not. */
static bool add_line(const struct result_format *format, const char *text, json_t **run,
                     json_t *lines, GString *fault)
{
    json_error_t cause;
    json_t *object = json_loads(text, JSON_REJECT_DUPLICATES, &cause);
    const bool first = *run == NULL;
    if (object == NULL) {
        g_string_assign(fault, cause.text);
        return false;
    }
    if (!record_fits(object, first ? format->run : format->line, fault) ||
        !(first ? format->is_run : format->is_line)(object, fault)) {
        json_decref(object);
        return false;
    }
    if (first)
        *run = object;
    else
        json_array_append_new(lines, object);
    return true;
}

/* One line after the other; a file that ends in a line has one newline more than lines. */
static enum mpm_status read_lines(const char *path, const struct result_format *format,
                                  char **texts, json_t **run, json_t *lines,
                                  struct mpm_error *error)
{
    GString *fault = g_string_new(NULL);
    enum mpm_status status = MPM_OK;
    for (unsigned i = 0; status == MPM_OK && texts[i] != NULL; i++)
        if (*texts[i] != '\0' && !add_line(format, texts[i], run, lines, fault))
            status = failure_set(error, MPM_BAD_INPUT, "%s:%u: is no %s: %s", path, i + 1,
                                 *run == NULL ? "record of a run" : format->noun, fault->str);
    if (status == MPM_OK && *run == NULL)
        status = failure_set(error, MPM_BAD_INPUT, "%s: is empty", path);
    g_string_free(fault, TRUE);
    return status;
}

static enum mpm_status read_file(const char *path, const struct result_format *format, json_t **run,
                                 json_t *lines, struct mpm_error *error)
{
    char *text = NULL, *allowed = NULL;
    size_t length = 0;
    TRY(result_file_check(path, error));
    allowed = g_strdup_printf("the output folder of %s", format->command);
    const enum mpm_status there = input_text(path, allowed, &text, &length, error);
    g_free(allowed);
    TRY(there);
    char **texts = g_strsplit(text, "\n", -1);
    const enum mpm_status status =
        strlen(text) == length ? read_lines(path, format, texts, run, lines, error)
                               : failure_set(error, MPM_BAD_INPUT, "%s: holds a zero byte", path);
    g_strfreev(texts);
    g_free(text);
    return status;
}

enum mpm_status result_lines_read(const char *folder, const struct result_format *format,
                                  json_t **run, json_t **lines, struct mpm_error *error)
{
    char *path = g_build_filename(folder, format->file, NULL);
    *run = NULL;
    *lines = json_array();
    const enum mpm_status status = read_file(path, format, run, *lines, error);
    g_free(path);
    if (status != MPM_OK) {
        json_decref(*run);
        json_decref(*lines);
        *run = *lines = NULL;
    }
    return status;
}
