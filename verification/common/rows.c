/* Rows: results on their way from a measuring process to the suite.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/common/rows.h"

#include <jansson.h>
#include <stdlib.h>
#include <string.h>

static const char *const kind_names[ROW_KIND_COUNT] = {
    [ROW_VALUE] = "value",     [ROW_INCONCLUSIVE] = "inconclusive",
    [ROW_SKIP] = "skip",       [ROW_NOTE] = "note",
    [ROW_WORK] = "work",       [ROW_PROCESSOR] = "processor",
    [ROW_MEMORY] = "memory",   [ROW_SERIES] = "series",
    [ROW_FAILURE] = "failure", [ROW_END] = "end",
};

char *row_line(enum row_kind kind, const char *name, const char *text)
{
    char *valid_name = g_utf8_make_valid(name, -1), *valid_text = g_utf8_make_valid(text, -1);
    json_t *object = json_pack("{s:s, s:s, s:s}", "kind", kind_names[kind], "name", valid_name,
                               "text", valid_text);
    char *json = json_dumps(object, JSON_COMPACT);
    char *line = g_strconcat(json, "\n", NULL);
    free(json);
    json_decref(object);
    g_free(valid_name);
    g_free(valid_text);
    return line;
}

char *row_line_value(const char *quantity, double value)
{
    char text[G_ASCII_DTOSTR_BUF_SIZE];
    g_ascii_formatd(text, sizeof text, "%.17g", value);
    return row_line(ROW_VALUE, quantity, text);
}

bool row_number(const char *text, double *value)
{
    char *end;
    *value = g_ascii_strtod(text, &end);
    return end != text && *end == '\0';
}

static void row_clear(void *element)
{
    struct row *row = element;
    g_free(row->name);
    g_free(row->text);
}

static bool row_parse(const char *line, struct row *row)
{
    json_t *object = json_loads(line, JSON_REJECT_DUPLICATES, NULL);
    const char *kind, *name, *text;
    bool found = false;
    if (object != NULL &&
        json_unpack(object, "{s:s, s:s, s:s}", "kind", &kind, "name", &name, "text", &text) == 0)
        for (int k = 0; k < ROW_KIND_COUNT && !found; k++)
            if (strcmp(kind, kind_names[k]) == 0) {
                *row = (struct row){(enum row_kind)k, g_strdup(name), g_strdup(text)};
                found = true;
            }
    json_decref(object);
    return found;
}

GArray *rows_parse(const char *text, unsigned *bad_line)
{
    GArray *rows = g_array_new(FALSE, FALSE, sizeof(struct row));
    g_array_set_clear_func(rows, row_clear);
    char **lines = g_strsplit(text, "\n", -1);
    bool good = true;
    for (unsigned i = 0; good && lines[i] != NULL; i++) {
        struct row row;
        if (*lines[i] == '\0')
            continue;
        good = row_parse(lines[i], &row);
        if (good)
            g_array_append_val(rows, row);
        else
            *bad_line = i + 1;
    }
    g_strfreev(lines);
    if (good)
        return rows;
    g_array_unref(rows);
    return NULL;
}
