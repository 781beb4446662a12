/* A bundle, read.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/score/bundle.h"

#include "verification/common/failure.h"
#include "verification/common/input.h"
#include "verification/common/names.h"
#include "verification/common/record.h"
#include "verification/score/readers.h"

#include <math.h>
#include <string.h>

const char *const agreement_norm_names[AGREEMENT_NORMS] = {
    [AGREEMENT_L1] = "l1",
    [AGREEMENT_L2] = "l2",
    [AGREEMENT_LINF] = "linf",
    [AGREEMENT_MEAN] = "mean",
};

double bundle_time(const struct bundle *bundle, size_t instant)
{
    return bundle->end * (double)instant / (double)bundle->instants;
}

const double *bundle_reference(const struct bundle *bundle, enum score_column column,
                               size_t instant)
{
    const size_t points = bundle->lattice.count[0] * bundle->lattice.count[1];
    const double *all = (const double *)(const void *)bundle->reference.column[column]->data;
    return all + (bundle->rest ? 0 : instant) * points;
}

void bundle_close(struct bundle *bundle)
{
    score_table_close(&bundle->reference);
    json_decref(bundle->json);
    g_free(bundle->folder);
    g_free(bundle->words);
    g_free(bundle->criteria);
    *bundle = (struct bundle){.folder = NULL};
}

static enum mpm_status refuse(const struct bundle *bundle, struct mpm_error *error, const char *key,
                              const char *allowed)
{
    return failure_set(error, MPM_BAD_INPUT, "%s/problem.json: %s: allowed is %s", bundle->folder,
                       key, allowed);
}

static bool read_pair(const json_t *object, const char *key, double pair[2])
{
    const json_t *array = json_object_get(object, key);
    for (size_t i = 0; i < 2; i++) {
        if (!json_is_number(json_array_get(array, i)))
            return false;
        pair[i] = json_number_value(json_array_get(array, i));
    }
    return json_array_size(array) == 2;
}

static enum mpm_status read_points(struct bundle *bundle, struct mpm_error *error)
{
    const json_t *points = json_object_get(bundle->json, "points");
    struct lattice *lattice = &bundle->lattice;
    double count[2];
    if (!read_pair(points, "from", lattice->from) || !read_pair(points, "to", lattice->to) ||
        !read_pair(points, "count", count))
        return refuse(bundle, error, "points", "from, to and count, two numbers each");
    for (size_t a = 0; a < 2; a++) {
        if (!(count[a] >= 1 && count[a] <= 10000) || !(lattice->from[a] < lattice->to[a]))
            return refuse(bundle, error, "points", "from below to, and a count from 1 to 10000");
        lattice->count[a] = (size_t)count[a];
    }
    lattice->polar = json_is_true(json_object_get(points, "polar"));
    lattice->linear = strcmp(record_text(points, "interpolation"), "linear") == 0;
    return MPM_OK;
}

static enum mpm_status read_setting(struct bundle *bundle, struct mpm_error *error)
{
    static const char *const geometries[] = {
        [MPM_PLANE_STRAIN] = "plane_strain",
        [MPM_PLANE_STRESS] = "plane_stress",
        [MPM_AXISYMMETRIC] = "axisymmetric",
    };
    const char *geometry = record_text(bundle->json, "geometry");
    const json_t *units = json_object_get(bundle->json, "units");
    size_t g = 0;
    while (g < G_N_ELEMENTS(geometries) && strcmp(geometries[g], geometry) != 0)
        g++;
    if (g == G_N_ELEMENTS(geometries))
        return refuse(bundle, error, "geometry", "plane_strain, plane_stress or axisymmetric");
    bundle->format =
        (struct score_format){(enum mpm_geometry)g,
                              {record_text(units, "length"), record_text(units, "mass"),
                               record_text(units, "time"), record_text(units, "temperature")},
                              (int)json_integer_value(json_object_get(bundle->json, "body"))};
    bundle->end = record_number(bundle->json, "end");
    const json_int_t instants = json_integer_value(json_object_get(bundle->json, "instants"));
    if (!(bundle->end > 0) || instants < 1 || instants > 1000)
        return refuse(bundle, error, "end, instants", "an end > 0 and 1 to 1000 instants");
    bundle->instants = (size_t)instants;
    bundle->rest = json_is_true(json_object_get(bundle->json, "at_rest"));
    return read_points(bundle, error);
}

static enum mpm_status read_columns(struct bundle *bundle, const json_t *object,
                                    struct bundle_criterion *criterion, struct mpm_error *error)
{
    const json_t *names = json_object_get(object, "columns");
    criterion->column_count = json_array_size(names);
    if (criterion->column_count < 1 || criterion->column_count > CRITERION_COLUMNS)
        return refuse(bundle, error, "criteria: columns", "1 to 5 columns");
    for (size_t i = 0; i < criterion->column_count; i++) {
        const char *name = json_string_value(json_array_get(names, i));
        criterion->columns[i] =
            score_column_find(name == NULL ? "" : name, bundle->format.geometry);
        if (criterion->columns[i] == SCORE_COLUMNS ||
            !score_table_has(&bundle->reference, criterion->columns[i]))
            return refuse(bundle, error, "criteria: columns", "a column of reference.csv");
    }
    return MPM_OK;
}

/* A text of the bundle's own JSON, as the struct of checks has it. */
static char *text_of(const json_t *object, const char *key)
{
    return (char *)json_string_value(json_object_get(object, key));
}

static enum mpm_status read_check(const struct bundle *bundle, const json_t *object,
                                  struct case_check *check, struct mpm_error *error)
{
    *check = (struct case_check){.name = text_of(object, "criterion"),
                                 .title = text_of(object, "title"),
                                 .quantity = text_of(object, "criterion"),
                                 .unit = text_of(object, "unit"),
                                 .norm = text_of(object, "quantity"),
                                 .why = text_of(object, "why"),
                                 .band = {.expected = record_number(object, "expected"),
                                          .low = record_number(object, "low"),
                                          .high = record_number(object, "high")}};
    if (check->name == NULL || !name_is_sound(check->name) || check->title == NULL ||
        check->why == NULL)
        return refuse(bundle, error, "criteria", "criterion, title and why");
    const char *fault = verdict_band_fault(&check->band);
    if (fault == NULL)
        return MPM_OK;
    return failure_set(error, MPM_BAD_INPUT, "%s/problem.json: criterion %s: %s", bundle->folder,
                       check->name, fault);
}

static enum mpm_status read_criterion(struct bundle *bundle, const json_t *object,
                                      struct bundle_criterion *criterion, struct mpm_error *error)
{
    size_t norm = 0;
    while (norm < AGREEMENT_NORMS &&
           strcmp(agreement_norm_names[norm], record_text(object, "norm")) != 0)
        norm++;
    if (norm == AGREEMENT_NORMS)
        return refuse(bundle, error, "criteria: norm", "l1, l2, linf or mean");
    criterion->norm = (enum agreement_norm)norm;
    TRY(read_check(bundle, object, &criterion->check, error));
    criterion->check.unit = (char *)"%";
    criterion->check.norm = (char *)agreement_norm_words(criterion->norm);
    criterion->check.basis = BASIS_THEORY;
    return read_columns(bundle, object, criterion, error);
}

static enum mpm_status read_number(struct bundle *bundle, const json_t *object,
                                   struct bundle_criterion *criterion, struct mpm_error *error)
{
    struct case_check *check = &criterion->check;
    TRY(read_check(bundle, object, check, error));
    if (check->unit == NULL || check->norm == NULL)
        return refuse(bundle, error, "criteria", "quantity and unit");
    return basis_find(record_text(object, "basis"), &check->basis)
               ? MPM_OK
               : refuse(bundle, error, "criteria: basis",
                        "theory, round-off, literature, independent calculation or measured");
}

static enum mpm_status read_criteria(struct bundle *bundle, struct mpm_error *error)
{
    const json_t *criteria = json_object_get(bundle->json, "criteria");
    bundle->criterion_count = json_array_size(criteria);
    if (bundle->criterion_count == 0)
        return refuse(bundle, error, "criteria", "a list of at least one");
    bundle->criteria = g_new0(struct bundle_criterion, bundle->criterion_count);
    for (size_t i = 0; i < bundle->criterion_count; i++) {
        const json_t *const object = json_array_get(criteria, i);
        TRY((bundle->numbers ? read_number : read_criterion)(bundle, object, &bundle->criteria[i],
                                                             error));
        for (size_t k = 0; k < i; k++)
            if (strcmp(bundle->criteria[k].check.name, bundle->criteria[i].check.name) == 0)
                return refuse(bundle, error, "criteria: criterion", "each name once");
    }
    return MPM_OK;
}

static enum mpm_status read_reference(struct bundle *bundle, struct mpm_error *error)
{
    char *path = g_build_filename(bundle->folder, "reference.csv", NULL);
    const size_t points = bundle->lattice.count[0] * bundle->lattice.count[1];
    const size_t rows = points * (bundle->rest ? 1 : bundle->instants + 1);
    enum mpm_status status = score_read_csv(path, &bundle->format, &bundle->reference, error);
    if (status == MPM_OK && bundle->reference.rows != rows)
        status = failure_set(error, MPM_BAD_INPUT,
                             "%s: has %zu rows: allowed are %zu, for each "
                             "point at each instant",
                             path, bundle->reference.rows, rows);
    g_free(path);
    return status;
}

static enum mpm_status read_files(struct bundle *bundle, struct mpm_error *error)
{
    char *path = g_build_filename(bundle->folder, "problem.json", NULL);
    char *words = g_build_filename(bundle->folder, "problem.md", NULL);
    enum mpm_status status = input_json(path, 0, &bundle->json, error);
    if (status == MPM_OK && json_integer_value(json_object_get(bundle->json, "format")) != 1)
        status = refuse(bundle, error, "format", "1");
    if (status == MPM_OK && !(name_is_sound(record_text(bundle->json, "family")) &&
                              name_is_sound(record_text(bundle->json, "case"))))
        status = refuse(bundle, error, "family, case", name_rule);
    if (status == MPM_OK)
        status = input_text(words, NULL, &bundle->words, NULL, error);
    g_free(words);
    g_free(path);
    return status;
}

static enum mpm_status read_kind(struct bundle *bundle, struct mpm_error *error)
{
    const char *results = record_text(bundle->json, "results");
    bundle->numbers = strcmp(results, "numbers") == 0;
    return bundle->numbers || strcmp(results, "fields") == 0
               ? MPM_OK
               : refuse(bundle, error, "results",
                        "fields or numbers; of a bundle without it: export it again");
}

enum mpm_status bundle_read(const char *folder, struct bundle *bundle, struct mpm_error *error)
{
    *bundle = (struct bundle){.folder = g_strdup(folder)};
    score_table_open(&bundle->reference);
    enum mpm_status status = read_files(bundle, error);
    if (status == MPM_OK)
        status = read_kind(bundle, error);
    if (status == MPM_OK && !bundle->numbers)
        status = read_setting(bundle, error);
    if (status == MPM_OK && !bundle->numbers)
        status = read_reference(bundle, error);
    if (status == MPM_OK)
        status = read_criteria(bundle, error);
    if (status != MPM_OK)
        bundle_close(bundle);
    return status;
}
