/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/programs/table_named.h"

#include "verification/common/csv.h"
#include "verification/common/rows.h"

#include <string.h>

static void column_free(void *column)
{
    g_array_free(column, TRUE);
}

static enum mpm_status use_names(void *context, const struct csv_line *line,
                                 struct mpm_error *error)
{
    const struct table_named *const table = context;
    (void)error;
    for (size_t i = 0; i < line->count; i++) {
        g_ptr_array_add(table->names, g_strdup(line->cells[i]));
        g_ptr_array_add(table->columns, g_array_new(FALSE, FALSE, sizeof(double)));
    }
    return MPM_OK;
}

static enum mpm_status use_row(void *context, const struct csv_line *line, struct mpm_error *error)
{
    struct table_named *const table = context;
    for (size_t i = 0; i < line->count; i++) {
        double value;
        if (!row_number(line->cells[i], &value))
            return failure_set(error, MPM_BAD_INPUT, "%s: %s: \"%s\": allowed are numbers",
                               line->place, (char *)table->names->pdata[i], line->cells[i]);
        g_array_append_val((GArray *)table->columns->pdata[i], value);
    }
    table->rows++;
    return MPM_OK;
}

enum mpm_status table_named_read(const char *path, struct table_named *table,
                                 struct mpm_error *error)
{
    *table = (struct table_named){g_ptr_array_new_with_free_func(g_free),
                                  g_ptr_array_new_with_free_func(column_free), 0};
    return csv_read(path, use_names, use_row, table, error);
}

void table_named_clear(struct table_named *table)
{
    g_ptr_array_unref(table->names);
    g_ptr_array_unref(table->columns);
}

const double *table_named_column(const struct table_named *table, const char *name)
{
    for (unsigned i = 0; i < table->names->len; i++)
        if (strcmp(table->names->pdata[i], name) == 0)
            return (const double *)(const void *)((GArray *)table->columns->pdata[i])->data;
    return NULL;
}

char *table_named_list(const struct table_named *table)
{
    GString *list = g_string_new(NULL);
    for (unsigned i = 0; i < table->names->len; i++)
        g_string_append_printf(list, "%s%s", i == 0 ? "" : ", ", (char *)table->names->pdata[i]);
    return g_string_free(list, FALSE);
}
