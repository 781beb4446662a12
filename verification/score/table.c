/* A table of material points at instants.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/score/table.h"

#include "verification/common/failure.h"

#include <string.h>

void score_table_open(struct score_table *table)
{
    *table = (struct score_table){.unread = g_ptr_array_new_with_free_func(g_free)};
}

void score_table_close(struct score_table *table)
{
    for (int c = 0; c < SCORE_COLUMNS; c++)
        if (table->column[c] != NULL)
            g_array_unref(table->column[c]);
    if (table->unread != NULL)
        g_ptr_array_unref(table->unread);
    *table = (struct score_table){.rows = 0};
}

bool score_table_has(const struct score_table *table, enum score_column column)
{
    return table->column[column] != NULL;
}

double score_table_value(const struct score_table *table, enum score_column column, size_t row)
{
    return g_array_index(table->column[column], double, row);
}

double *score_table_add(struct score_table *table, enum score_column column)
{
    if (table->column[column] == NULL)
        table->column[column] = g_array_new(FALSE, TRUE, sizeof(double));
    g_array_set_size(table->column[column], (guint)table->rows);
    return (double *)(void *)table->column[column]->data;
}

void score_table_unread(struct score_table *table, const char *name)
{
    for (guint i = 0; i < table->unread->len; i++)
        if (strcmp(table->unread->pdata[i], name) == 0)
            return;
    g_ptr_array_add(table->unread, g_strdup(name));
}

enum mpm_status score_table_append(struct score_table *table, const struct score_table *more,
                                   enum mpm_geometry geometry, const char *path,
                                   struct mpm_error *error)
{
    const bool first = table->rows == 0;
    for (int c = 0; c < SCORE_COLUMNS; c++) {
        const enum score_column column = (enum score_column)c;
        if (first && score_table_has(more, column))
            score_table_add(table, column);
        if (score_table_has(table, column) != score_table_has(more, column))
            return failure_set(error, MPM_BAD_INPUT, "%s: %s column %s, the files before it %s",
                               path, score_table_has(more, column) ? "has a" : "has no",
                               score_column_name(column, geometry),
                               score_table_has(more, column) ? "have none" : "have one");
        if (score_table_has(more, column) && more->rows > 0)
            g_array_append_vals(table->column[column], more->column[column]->data,
                                (guint)more->rows);
    }
    table->rows += more->rows;
    for (guint i = 0; i < more->unread->len; i++)
        score_table_unread(table, more->unread->pdata[i]);
    return MPM_OK;
}

enum mpm_status score_check_unit(const struct score_format *format, enum score_column column,
                                 const char *unit, const char *place, struct mpm_error *error)
{
    char *wanted = score_column_unit(column, &format->units);
    const enum mpm_status status =
        strcmp(wanted, unit) == 0
            ? MPM_OK
            : failure_set(error, MPM_BAD_INPUT, "%s: %s is in \"%s\": allowed is \"%s\"", place,
                          score_column_name(column, format->geometry), unit, wanted);
    g_free(wanted);
    return status;
}
