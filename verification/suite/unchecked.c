/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/suite/unchecked.h"
#include "verification/common/record.h"

#include <string.h>

/* Of every run, whatever its program. */
static const char *const of_all[] = {"particle_steps", "cpu_seconds", "seconds", "peak_bytes"};

/* "PROGRAM QUANTITY" without a number at its end. */
static char *key_of(const char *program, const char *quantity)
{
    size_t length = strlen(quantity);
    while (length > 0 && g_ascii_isdigit(quantity[length - 1]))
        length--;
    const bool numbered = length > 0 && quantity[length] != '\0' && quantity[length - 1] == '_';
    return g_strdup_printf("%s %.*s", program, (int)(numbered ? length - 1 : strlen(quantity)),
                           quantity);
}

static const struct catalogue_case *case_named(const struct catalogue *catalogue, const char *name)
{
    for (size_t i = 0; i < catalogue->count; i++)
        if (strcmp(catalogue->cases[i].file->name, name) == 0)
            return &catalogue->cases[i];
    return NULL;
}

static void add_columns(const struct catalogue *catalogue, const struct catalogue_case *entry,
                        GHashTable *used)
{
    const struct case_comparison *const comparison = entry->file->comparison;
    for (unsigned i = 0; comparison != NULL && i < comparison->columns_count; i++) {
        const struct case_column *const column = &comparison->columns[i];
        const struct catalogue_case *const owner =
            column->case_name == NULL ? entry : case_named(catalogue, column->case_name);
        if (owner != NULL)
            g_hash_table_add(used, key_of(owner->program->name, column->quantity));
    }
}

static GHashTable *used_quantities(const struct catalogue *catalogue)
{
    GHashTable *const used = g_hash_table_new_full(g_str_hash, g_str_equal, g_free, NULL);
    for (size_t i = 0; i < catalogue->count; i++) {
        const struct catalogue_case *const entry = &catalogue->cases[i];
        for (unsigned k = 0; k < entry->file->checks_count; k++)
            g_hash_table_add(used, key_of(entry->program->name, entry->file->checks[k].quantity));
        add_columns(catalogue, entry, used);
    }
    return used;
}

/* The program of a case of the plan; NULL if the plan has no such case. */
static const char *program_of(const struct plan *plan, const char *name)
{
    for (size_t i = 0; i < plan->job_count; i++)
        if (strcmp(plan->jobs[i].entry->file->name, name) == 0)
            return plan->jobs[i].entry->program->name;
    return NULL;
}

static int compare_texts(const void *one, const void *other)
{
    return strcmp(*(const char *const *)one, *(const char *const *)other);
}

GPtrArray *unchecked_quantities(const struct catalogue *catalogue, const struct plan *plan,
                                const json_t *measurements)
{
    GHashTable *const seen = used_quantities(catalogue);
    GPtrArray *const found = g_ptr_array_new_with_free_func(g_free);
    for (size_t i = 0; i < json_array_size(measurements); i++) {
        const json_t *const line = json_array_get(measurements, i);
        const char *const quantity = record_text(line, "quantity");
        const char *const program = program_of(plan, record_text(line, "case"));
        /* a study's numbers go to tables of its own */
        bool common = program == NULL || strcmp(program, "study") == 0;
        for (size_t k = 0; k < G_N_ELEMENTS(of_all); k++)
            common = common || strcmp(of_all[k], quantity) == 0;
        char *const key = common ? NULL : key_of(program, quantity);
        if (key != NULL && g_hash_table_add(seen, g_strdup(key)))
            g_ptr_array_add(found, g_strdup(key));
        g_free(key);
    }
    g_ptr_array_sort(found, compare_texts);
    g_hash_table_unref(seen);
    return found;
}
