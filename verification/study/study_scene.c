/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/study/study_scene.h"

#include "mpm_expression.h"
#include "mpm_file.h"
#include "verification/common/input.h"
#include "verification/programs/table_named.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ------------------------------------------------------------------------- reading */

static char *scalar(const struct mpm_tree_node *root, const char *path)
{
    const struct mpm_tree_node *node = mpm_tree_find(root, path, NULL);
    return node == NULL || node->kind != MPM_TREE_SCALAR ? NULL : g_strdup(node->text);
}

enum mpm_status study_scene_open(struct study *study, struct mpm_error *error)
{
    struct mpm_tree_node *root;
    TRY(mpm_tree_read(study->scene, &root, error));
    char *geometry = scalar(root, "geometry");
    study->axisymmetric = g_strcmp0(geometry, "axisymmetric") == 0;
    free(study->length_unit);
    study->length_unit = scalar(root, "units.length");
    if (study->title == NULL)
        study->title = scalar(root, "title");
    if (study->title == NULL || *study->title == '\0') {
        free(study->title);
        study->title = g_path_get_basename(study->scene);
    }
    g_free(geometry);
    mpm_tree_free(root);
    free(study->scene_text);
    study->scene_text = NULL;
    return input_text(study->scene, NULL, &study->scene_text, NULL, error);
}

/* The value that the last setting gives to a path, or else the scene; NULL: none. g_free. */
static char *effective(const struct mpm_tree_node *root, const GPtrArray *settings,
                       const char *path)
{
    const size_t length = strlen(path);
    for (unsigned i = settings->len; i-- > 0;) {
        const char *setting = settings->pdata[i];
        if (strncmp(setting, path, length) == 0 && setting[length] == '=')
            return g_strdup(setting + length + 1);
    }
    return scalar(root, path);
}

/* NaN: none is given. */
static enum mpm_status effective_number(const struct mpm_tree_node *root, const GPtrArray *settings,
                                        const char *path, double *value, struct mpm_error *error)
{
    char *text = effective(root, settings, path);
    *value = (double)NAN;
    enum mpm_status status = MPM_OK;
    if (text != NULL && !mpm_number_parse(text, value))
        status = failure_set(error, MPM_BAD_INPUT, "%s: \"%s\": allowed is a number", path, text);
    g_free(text);
    return status;
}

/* A whole group in a setting would hide what a level has to multiply. */
static enum mpm_status refuse_groups(const GPtrArray *settings, struct mpm_error *error)
{
    static const char *const groups[] = {"grid=", "grid.cell=", "time=", "output="};
    for (unsigned i = 0; i < settings->len; i++)
        for (size_t k = 0; k < G_N_ELEMENTS(groups); k++)
            if (g_str_has_prefix(settings->pdata[i], groups[k]))
                return failure_set(error, MPM_BAD_INPUT,
                                   "setting \"%s\": a study needs the keys of %.*s one by one, as "
                                   "in grid.cell.0=2",
                                   (char *)settings->pdata[i], (int)strlen(groups[k]) - 1,
                                   groups[k]);
    return MPM_OK;
}

/* ------------------------------------------------------------------------ refining */

static bool needs_curve(const struct study *study)
{
    for (unsigned k = 0; k < study->measures_count; k++)
        if (field_quantity_find(study->measures[k].quantity) == NULL &&
            study->measures[k].take != TAKE_LAST)
            return true;
    return false;
}

enum { CURVE_ROWS = 1000 };

static enum mpm_status add_settings(const struct study *study, const struct mpm_tree_node *root,
                                    int64_t level, GPtrArray *settings, double *cell,
                                    struct mpm_error *error)
{
    double refine, step, end, history;
    TRY(refuse_groups(settings, error));
    TRY(effective_number(root, settings, "grid.cell.0", cell, error));
    TRY(effective_number(root, settings, "grid.refine", &refine, error));
    TRY(effective_number(root, settings, "time.step", &step, error));
    TRY(effective_number(root, settings, "time.end", &end, error));
    TRY(effective_number(root, settings, "output.history", &history, error));
    char *steps = effective(root, settings, "time.steps");
    const bool limited = steps != NULL;
    g_free(steps);
    if (limited)
        return failure_set(error, MPM_BAD_INPUT,
                           "%s: time.steps: a study compares runs at one time: allowed is time.end "
                           "alone",
                           study->scene);
    const double whole = (double)level * (isnan(refine) ? 1.0 : refine);
    *cell /= whole;
    g_ptr_array_add(settings, g_strdup_printf("grid.refine=%.0f", whole));
    if (!isnan(step))
        g_ptr_array_add(settings, g_strdup_printf("time.step=%.17g", step / (double)level));
    if (isnan(history) && needs_curve(study))
        g_ptr_array_add(settings, g_strdup_printf("output.history=%.17g", end / CURVE_ROWS));
    g_ptr_array_add(settings, g_strdup_printf("output.snapshots=%.17g", end));
    return MPM_OK;
}

enum mpm_status study_scene_refine(const struct study *study, int64_t level, GPtrArray *settings,
                                   double *cell, struct mpm_error *error)
{
    struct mpm_tree_node *root;
    TRY(mpm_tree_read(study->scene, &root, error));
    const enum mpm_status status = add_settings(study, root, level, settings, cell, error);
    mpm_tree_free(root);
    return status;
}

/* -------------------------------------------------------------------------- trying */

/* Units are a comment below the names of history.csv. */
static char *unit_of_column(const char *text, const struct table_named *table, const char *name)
{
    char **lines = g_strsplit(text, "\n", 3);
    char **units = NULL, *unit = NULL;
    if (g_strv_length(lines) >= 2 && lines[1][0] == '#')
        units = g_strsplit(lines[1] + 1, ",", -1);
    for (unsigned i = 0; units != NULL && i < table->names->len && units[i] != NULL; i++)
        if (strcmp(table->names->pdata[i], name) == 0)
            unit = g_strdup(g_strstrip(units[i]));
    g_strfreev(units);
    g_strfreev(lines);
    return unit == NULL ? g_strdup("1") : unit;
}

static enum mpm_status try_measure(struct study_entry *entry, const struct mpm_scene *scene,
                                   const char *history, const struct table_named *table,
                                   struct mpm_error *error)
{
    const struct field_quantity *field = field_quantity_find(entry->quantity);
    const bool there = field != NULL ? mpm_scene_has_field(scene, field->field)
                                     : table_named_column(table, entry->quantity) != NULL;
    if (!there) {
        char *columns = table_named_list(table);
        failure_set(error, MPM_BAD_INPUT,
                    "measure \"%s\": the scene has no quantity \"%s\": allowed are %s, and of "
                    "particles %s",
                    entry->name, entry->quantity, columns, field_quantity_names());
        g_free(columns);
        return MPM_BAD_INPUT;
    }
    if (entry->unit == NULL && field != NULL) {
        char unit[MPM_FIELD_UNIT_SIZE];
        mpm_scene_field_unit(scene, field->field, unit);
        entry->unit = g_strdup(unit);
    } else if (entry->unit == NULL) {
        entry->unit = unit_of_column(history, table, entry->quantity);
    }
    return MPM_OK;
}

static enum mpm_status try_in(struct study *study, const struct mpm_scene *scene,
                              const char *folder, struct mpm_error *error)
{
    const struct mpm_run_options options = {
        .output = folder, .simulation = {.threads = 1}, .overwrite = true};
    struct table_named table;
    enum mpm_status status = mpm_scene_run(scene, &options, error);
    /* what a run comes to is a result of the study, not of its input */
    if (status != MPM_RUN_FAILED)
        TRY(status);
    char *path = g_build_filename(folder, "history.csv", NULL), *text = NULL;
    status = table_named_read(path, &table, error);
    if (status == MPM_OK)
        status = input_text(path, NULL, &text, NULL, error);
    for (unsigned k = 0; status == MPM_OK && k < study->measures_count; k++)
        status = try_measure(&study->measures[k], scene, text, &table, error);
    table_named_clear(&table);
    g_free(text);
    g_free(path);
    return status;
}

enum mpm_status study_scene_try(struct study *study, const struct study_run *run,
                                struct mpm_error *error)
{
    struct mpm_scene *scene = NULL;
    const unsigned count = g_strv_length(run->settings);
    const char **settings = g_new(const char *, count + 1);
    memcpy(settings, run->settings, count * sizeof *settings);
    settings[count] = "time.steps=1";
    char *folder = NULL;
    enum mpm_status status = mpm_folder_make_temporary(&folder, error);
    if (status == MPM_OK)
        status = mpm_scene_read(study->scene, settings, count + 1, &scene, error);
    if (status == MPM_OK)
        status = try_in(study, scene, folder, error);
    mpm_scene_free(scene);
    if (folder != NULL)
        (void)mpm_folder_remove_all(folder, NULL);
    g_free(folder);
    g_free(settings);
    return status;
}
