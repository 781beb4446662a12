/* The table behind `mpm schema`, from the same descriptors that the checks use.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/schema.h"

#include "io/scene_schema.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { COLUMNS = 6, ROWS_MAX = 256, CELL_SIZE = 256 };

struct table {
    size_t rows;
    char cells[ROWS_MAX][COLUMNS][CELL_SIZE];
};

static void add_row(struct table *table, const char *const cells[COLUMNS])
{
    if (table->rows == ROWS_MAX)
        return; /* a test holds the table complete */
    for (size_t i = 0; i < COLUMNS; i++)
        (void)snprintf(table->cells[table->rows][i], CELL_SIZE, "%s", cells[i]);
    table->rows++;
}

static const char *default_text(const struct mpm_key *key)
{
    if (key->required)
        return "required";
    return key->fallback != NULL ? key->fallback : "-";
}

static void add_keys(struct table *table, const struct mpm_key *group, const char *prefix)
{
    static const char *const places[] = {
        [MPM_ANYWHERE] = "",
        [MPM_ONLY_PLANAR] = " (planar scenes only)",
        [MPM_ONLY_AXISYMMETRIC] = " (axisymmetric scenes only)",
    };
    for (const struct mpm_key *key = group->children; key->name != NULL; key++) {
        char path[CELL_SIZE], help[CELL_SIZE], range[MPM_ALLOWED_SIZE];
        (void)snprintf(path, sizeof path, "%s%s", prefix, key->name);
        (void)snprintf(help, sizeof help, "%s%s", key->help, places[key->where]);
        add_row(table,
                (const char *const[COLUMNS]){path, mpm_key_type(key), key->unit, default_text(key),
                                             mpm_key_range(key, range), help});
        if (key->children == NULL)
            continue;
        char inner[CELL_SIZE];
        (void)snprintf(inner, sizeof inner, "%.200s%s.", path,
                       key->shape == MPM_KEY_LIST ? "[]" : "");
        add_keys(table, key, inner);
    }
}

/* Writes the table to `text`, or only counts its characters if that is NULL. */
static size_t write_rows(const struct table *table, const size_t width[COLUMNS], char *text)
{
    size_t used = 0;
    for (size_t row = 0; row < table->rows; row++)
        for (size_t i = 0; i < COLUMNS; i++) {
            const char *cell = table->cells[row][i];
            const bool last = i + 1 == COLUMNS;
            const size_t length = last ? strlen(cell) : width[i] + 2;
            if (text != NULL)
                (void)sprintf(text + used, "%-*s%s", (int)length, cell, last ? "\n" : "");
            used += length + last;
        }
    return used;
}

char *mpm_schema_text(void)
{
    struct table *table = calloc(1, sizeof *table);
    if (table == NULL)
        return NULL;
    add_row(table,
            (const char *const[COLUMNS]){"KEY", "TYPE", "UNIT", "DEFAULT", "RANGE", "MEANING"});
    add_keys(table, &mpm_scene_root, "");
    size_t width[COLUMNS] = {0};
    for (size_t row = 0; row < table->rows; row++)
        for (size_t i = 0; i < COLUMNS; i++)
            if (strlen(table->cells[row][i]) > width[i])
                width[i] = strlen(table->cells[row][i]);
    char *text = malloc(write_rows(table, width, NULL) + 1);
    if (text != NULL)
        (void)write_rows(table, width, text);
    free(table);
    return text;
}
