/* case.yaml: the schema, and reading by it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/cases/case_file.h"

#include "verification/cases/yaml_place.h"
#include "verification/cases/yaml_read.h"
#include "verification/common/rows.h"

#include <glib.h>
#include <math.h>
#include <string.h>

/* ------------------------------------------------------------------ schema */

/* Numbers are read as text and converted by us: the reader's own conversion accepts
 * trailing text ("2 mm"). */
#define TEXT          YAML_TEXT
#define OPTIONAL_TEXT YAML_OPTIONAL_TEXT
#define LIST          YAML_LIST

static const cyaml_schema_field_t parameter_fields[] = {
    TEXT("name", case_parameter, name), TEXT("value", case_parameter, value), CYAML_FIELD_END};
static const cyaml_schema_value_t parameter_schema = {
    CYAML_VALUE_MAPPING(CYAML_FLAG_DEFAULT, struct case_parameter, parameter_fields)};

static const cyaml_strval_t tier_values[] = {{"ci", TIER_CI}, {"full", TIER_FULL}};
static const cyaml_strval_t basis_values[] = {{"theory", BASIS_THEORY},
                                              {"round-off", BASIS_ROUND_OFF},
                                              {"literature", BASIS_LITERATURE},
                                              {"measured", BASIS_MEASURED}};
static const cyaml_strval_t evidence_values[] = {
    {"quadrature", EVIDENCE_QUADRATURE},       {"exact", EVIDENCE_EXACT},
    {"manufactured", EVIDENCE_MANUFACTURED},   {"invariant", EVIDENCE_INVARIANT},
    {"cross-variant", EVIDENCE_CROSS_VARIANT}, {"reference-data", EVIDENCE_REFERENCE_DATA}};
static const cyaml_strval_t outcome_values[] = {{"pass", OUTCOME_PASS}, {"fail", OUTCOME_FAIL}};

static const cyaml_schema_field_t variant_fields[] = {
    TEXT("name", case_variant, name),
    OPTIONAL_TEXT("title", case_variant, title),
    CYAML_FIELD_ENUM("tier", CYAML_FLAG_STRICT, struct case_variant, tier, tier_values,
                     CYAML_ARRAY_LEN(tier_values)),
    TEXT("timeout", case_variant, timeout_text),
    LIST("settings", case_variant, settings, &yaml_text_schema, 0),
    LIST("parameters", case_variant, parameters, &parameter_schema, 0),
    CYAML_FIELD_END};
static const cyaml_schema_value_t variant_schema = {
    CYAML_VALUE_MAPPING(CYAML_FLAG_DEFAULT, struct case_variant, variant_fields)};

static const cyaml_schema_field_t methods_fields[] = {
    LIST("names", case_methods, names, &yaml_text_schema, 1),
    LIST("except", case_methods, except, &yaml_text_schema, 0),
    LIST("full", case_methods, full, &yaml_text_schema, 0),
    CYAML_FIELD_ENUM("tier", CYAML_FLAG_STRICT, struct case_methods, tier, tier_values,
                     CYAML_ARRAY_LEN(tier_values)),
    TEXT("timeout", case_methods, timeout_text),
    LIST("settings", case_methods, settings, &yaml_text_schema, 0),
    LIST("parameters", case_methods, parameters, &parameter_schema, 0),
    CYAML_FIELD_END};

/* What checks and numbers for other solvers state alike. */
#define CHECK_FIELDS(key)                                                                          \
    TEXT(key, case_check, name), TEXT("title", case_check, title),                                 \
        TEXT("quantity", case_check, quantity), TEXT("unit", case_check, unit),                    \
        TEXT("expected", case_check, expected_text), TEXT("low", case_check, low_text),            \
        TEXT("high", case_check, high_text), TEXT("why", case_check, why),                         \
        CYAML_FIELD_ENUM("basis", CYAML_FLAG_STRICT, struct case_check, basis, basis_values,       \
                         CYAML_ARRAY_LEN(basis_values))

static const cyaml_schema_field_t check_fields[] = {
    CHECK_FIELDS("check"),
    LIST("variants", case_check, variants, &yaml_text_schema, 1),
    TEXT("norm", case_check, norm),
    OPTIONAL_TEXT("fails_low", case_check, fails_low_text),
    OPTIONAL_TEXT("fails_high", case_check, fails_high_text),
    OPTIONAL_TEXT("initial", case_check, initial_text),
    OPTIONAL_TEXT("headroom", case_check, headroom),
    CYAML_FIELD_ENUM("evidence", CYAML_FLAG_STRICT | CYAML_FLAG_OPTIONAL, struct case_check,
                     evidence, evidence_values, CYAML_ARRAY_LEN(evidence_values)),
    CYAML_FIELD_ENUM("outcome", CYAML_FLAG_STRICT | CYAML_FLAG_OPTIONAL, struct case_check, outcome,
                     outcome_values, CYAML_ARRAY_LEN(outcome_values)),
    CYAML_FIELD_END};
static const cyaml_schema_value_t check_schema = {
    CYAML_VALUE_MAPPING(CYAML_FLAG_DEFAULT, struct case_check, check_fields)};

static const cyaml_schema_field_t figure_fields[] = {
    TEXT("name", case_figure, name),
    TEXT("script", case_figure, script),
    TEXT("title", case_figure, title),
    TEXT("caption", case_figure, caption),
    TEXT("reference", case_figure, reference),
    LIST("needs", case_figure, needs, &yaml_text_schema, 0),
    CYAML_FIELD_END};
static const cyaml_schema_value_t figure_schema = {
    CYAML_VALUE_MAPPING(CYAML_FLAG_DEFAULT, struct case_figure, figure_fields)};

static const cyaml_strval_t better_values[] = {
    {"low", COMPARISON_LOW}, {"high", COMPARISON_HIGH}, {"zero", COMPARISON_ZERO}};

static const cyaml_schema_field_t column_fields[] = {
    TEXT("quantity", case_column, quantity),
    TEXT("title", case_column, title),
    TEXT("unit", case_column, unit),
    CYAML_FIELD_ENUM("better", CYAML_FLAG_STRICT, struct case_column, better, better_values,
                     CYAML_ARRAY_LEN(better_values)),
    OPTIONAL_TEXT("tolerance", case_column, tolerance_text),
    OPTIONAL_TEXT("floor", case_column, floor_text),
    OPTIONAL_TEXT("limit", case_column, limit_text),
    OPTIONAL_TEXT("beyond", case_column, beyond),
    OPTIONAL_TEXT("missing", case_column, missing),
    OPTIONAL_TEXT("about", case_column, about),
    OPTIONAL_TEXT("case", case_column, case_name),
    OPTIONAL_TEXT("where", case_column, where),
    CYAML_FIELD_END};
static const cyaml_schema_value_t column_schema = {
    CYAML_VALUE_MAPPING(CYAML_FLAG_DEFAULT, struct case_column, column_fields)};

static const cyaml_schema_field_t pareto_fields[] = {TEXT("x", case_pareto, x),
                                                     TEXT("y", case_pareto, y), CYAML_FIELD_END};

static const cyaml_schema_field_t comparison_fields[] = {
    TEXT("title", case_comparison, title),
    OPTIONAL_TEXT("summary", case_comparison, summary),
    LIST("variants", case_comparison, variants, &yaml_text_schema, 0),
    LIST("columns", case_comparison, columns, &column_schema, 1),
    CYAML_FIELD_MAPPING_PTR("pareto", CYAML_FLAG_POINTER | CYAML_FLAG_OPTIONAL,
                            struct case_comparison, pareto, pareto_fields),
    OPTIONAL_TEXT("main", case_comparison, main),
    OPTIONAL_TEXT("cost", case_comparison, cost),
    OPTIONAL_TEXT("setup", case_comparison, setup),
    OPTIONAL_TEXT("figure", case_comparison, figure),
    LIST("notes", case_comparison, notes, &yaml_text_schema, 0),
    CYAML_FIELD_END};

static const cyaml_strval_t norm_values[] = {
    {"l1", AGREEMENT_L1}, {"l2", AGREEMENT_L2}, {"linf", AGREEMENT_LINF}, {"mean", AGREEMENT_MEAN}};

static const cyaml_schema_field_t criterion_fields[] = {
    TEXT("criterion", case_criterion, name),
    TEXT("title", case_criterion, title),
    LIST("columns", case_criterion, columns, &yaml_text_schema, 1),
    CYAML_FIELD_ENUM("norm", CYAML_FLAG_STRICT, struct case_criterion, norm, norm_values,
                     CYAML_ARRAY_LEN(norm_values)),
    TEXT("within", case_criterion, within_text),
    TEXT("why", case_criterion, why),
    CYAML_FIELD_END};
static const cyaml_schema_value_t criterion_schema = {
    CYAML_VALUE_MAPPING(CYAML_FLAG_DEFAULT, struct case_criterion, criterion_fields)};

static const cyaml_schema_field_t bundle_fields[] = {
    TEXT("reference", case_bundle, reference),
    TEXT("about", case_bundle, about),
    LIST("parameters", case_bundle, parameters, &parameter_schema, 0),
    LIST("from", case_bundle, from_text, &yaml_text_schema, 2),
    LIST("to", case_bundle, to_text, &yaml_text_schema, 2),
    LIST("points", case_bundle, points_text, &yaml_text_schema, 2),
    CYAML_FIELD_BOOL("polar", CYAML_FLAG_OPTIONAL, struct case_bundle, polar),
    CYAML_FIELD_BOOL("linear", CYAML_FLAG_OPTIONAL, struct case_bundle, linear),
    CYAML_FIELD_BOOL("rest", CYAML_FLAG_OPTIONAL, struct case_bundle, rest),
    TEXT("end", case_bundle, end_text),
    CYAML_FIELD_INT("instants", CYAML_FLAG_DEFAULT, struct case_bundle, instants),
    CYAML_FIELD_INT("body", CYAML_FLAG_OPTIONAL, struct case_bundle, body),
    LIST("criteria", case_bundle, criteria, &criterion_schema, 1),
    CYAML_FIELD_END};

static const cyaml_schema_field_t number_fields[] = {CHECK_FIELDS("number"), CYAML_FIELD_END};
static const cyaml_schema_value_t number_schema = {
    CYAML_VALUE_MAPPING(CYAML_FLAG_DEFAULT, struct case_check, number_fields)};

static const cyaml_schema_field_t numbers_fields[] = {
    TEXT("about", case_numbers, about), LIST("files", case_numbers, files, &yaml_text_schema, 0),
    LIST("list", case_numbers, list, &number_schema, 1), CYAML_FIELD_END};

static const cyaml_schema_field_t file_fields[] = {
    CYAML_FIELD_INT("format", CYAML_FLAG_DEFAULT, struct case_file, format),
    TEXT("family", case_file, family),
    TEXT("case", case_file, name),
    TEXT("title", case_file, title),
    TEXT("summary", case_file, summary),
    LIST("tags", case_file, tags, &yaml_text_schema, 0),
    CYAML_FIELD_ENUM("evidence", CYAML_FLAG_STRICT | CYAML_FLAG_OPTIONAL, struct case_file,
                     evidence, evidence_values, CYAML_ARRAY_LEN(evidence_values)),
    TEXT("program", case_file, program_name),
    OPTIONAL_TEXT("scene", case_file, scene),
    LIST("parameters", case_file, parameters, &parameter_schema, 0),
    LIST("variants", case_file, variants, &variant_schema, 0),
    CYAML_FIELD_MAPPING_PTR("methods", CYAML_FLAG_POINTER | CYAML_FLAG_OPTIONAL, struct case_file,
                            methods, methods_fields),
    LIST("checks", case_file, checks, &check_schema, 1),
    LIST("figures", case_file, figures, &figure_schema, 0),
    CYAML_FIELD_MAPPING_PTR("comparison", CYAML_FLAG_POINTER | CYAML_FLAG_OPTIONAL,
                            struct case_file, comparison, comparison_fields),
    CYAML_FIELD_MAPPING_PTR("bundle", CYAML_FLAG_POINTER | CYAML_FLAG_OPTIONAL, struct case_file,
                            bundle, bundle_fields),
    CYAML_FIELD_MAPPING_PTR("bundle_of_numbers", CYAML_FLAG_POINTER | CYAML_FLAG_OPTIONAL,
                            struct case_file, numbers, numbers_fields),
    OPTIONAL_TEXT("no_bundle", case_file, no_bundle),
    CYAML_FIELD_END};
static const cyaml_schema_value_t file_schema = {
    CYAML_VALUE_MAPPING(CYAML_FLAG_POINTER, struct case_file, file_fields)};

/* ----------------------------------------------------------------- numbers */

static enum mpm_status convert(const char *path, const char *place, const char *key,
                               const char *text, double *value, struct mpm_error *error)
{
    if (strspn(text, "0123456789+-.eE") == strlen(text) && row_number(text, value) &&
        isfinite(*value))
        return MPM_OK;
    char *full = g_strconcat(place, ".", key, NULL);
    const unsigned line = yaml_place_line(path, full);
    g_free(full);
    return failure_set(error, MPM_BAD_INPUT, "%s:%u: %s: %s: \"%s\" is not a finite number", path,
                       line, place, key, text);
}

/* `list`: the key of the list that holds it. */
static enum mpm_status convert_check(const char *path, const char *list, unsigned index,
                                     struct case_check *check, struct mpm_error *error)
{
    struct verdict_band *band = &check->band;
    const struct {
        const char *key, *text;
        double *value;
    } numbers[] = {
        {"expected", check->expected_text, &band->expected},
        {"low", check->low_text, &band->low},
        {"high", check->high_text, &band->high},
        {"fails_low", check->fails_low_text, &band->fails_low},
        {"fails_high", check->fails_high_text, &band->fails_high},
        {"initial", check->initial_text, &band->initial},
    };
    char place[48];
    g_snprintf(place, sizeof place, "%s.%u", list, index);
    for (size_t i = 0; i < G_N_ELEMENTS(numbers); i++)
        if (numbers[i].text != NULL)
            TRY(convert(path, place, numbers[i].key, numbers[i].text, numbers[i].value, error));
    band->weakness = check->outcome == OUTCOME_FAIL;
    band->has_initial = check->initial_text != NULL;
    return MPM_OK;
}

static enum mpm_status convert_column(const char *path, unsigned index, struct case_column *column,
                                      struct mpm_error *error)
{
    char place[48];
    g_snprintf(place, sizeof place, "comparison.columns.%u", index);
    column->tolerance = 0.05;
    column->floor = 0.0;
    if (column->tolerance_text != NULL)
        TRY(convert(path, place, "tolerance", column->tolerance_text, &column->tolerance, error));
    if (column->floor_text != NULL)
        TRY(convert(path, place, "floor", column->floor_text, &column->floor, error));
    if (column->limit_text != NULL)
        TRY(convert(path, place, "limit", column->limit_text, &column->limit, error));
    return MPM_OK;
}

static enum mpm_status convert_pair(const char *path, const char *key, char *const *texts,
                                    unsigned count, double values[2], struct mpm_error *error)
{
    if (count != 2)
        return yaml_refuse(path, error, "bundle", "%s: allowed are two numbers", key);
    for (unsigned i = 0; i < 2; i++)
        TRY(convert(path, "bundle", key, texts[i], &values[i], error));
    return MPM_OK;
}

static enum mpm_status convert_bundle(const char *path, struct case_bundle *bundle,
                                      struct mpm_error *error)
{
    TRY(convert_pair(path, "from", bundle->from_text, bundle->from_text_count, bundle->from,
                     error));
    TRY(convert_pair(path, "to", bundle->to_text, bundle->to_text_count, bundle->to, error));
    TRY(convert_pair(path, "points", bundle->points_text, bundle->points_text_count, bundle->points,
                     error));
    TRY(convert(path, "bundle", "end", bundle->end_text, &bundle->end, error));
    for (unsigned i = 0; i < bundle->criteria_count; i++) {
        char place[48];
        g_snprintf(place, sizeof place, "bundle.criteria.%u", i);
        TRY(convert(path, place, "within", bundle->criteria[i].within_text,
                    &bundle->criteria[i].within, error));
    }
    return MPM_OK;
}

static enum mpm_status convert_numbers(const char *path, struct case_file *file,
                                       struct mpm_error *error)
{
    for (unsigned i = 0; i < file->variants_count; i++) {
        char place[32];
        g_snprintf(place, sizeof place, "variants.%u", i);
        TRY(convert(path, place, "timeout", file->variants[i].timeout_text,
                    &file->variants[i].timeout, error));
    }
    if (file->methods != NULL)
        TRY(convert(path, "methods", "timeout", file->methods->timeout_text,
                    &file->methods->timeout, error));
    for (unsigned i = 0; i < file->checks_count; i++)
        TRY(convert_check(path, "checks", i, &file->checks[i], error));
    for (unsigned i = 0; file->numbers != NULL && i < file->numbers->list_count; i++)
        TRY(convert_check(path, "bundle_of_numbers.list", i, &file->numbers->list[i], error));
    for (unsigned i = 0; file->comparison != NULL && i < file->comparison->columns_count; i++)
        TRY(convert_column(path, i, &file->comparison->columns[i], error));
    return file->bundle == NULL ? MPM_OK : convert_bundle(path, file->bundle, error);
}

enum mpm_status case_file_load(const char *path, struct case_file **file, struct mpm_error *error)
{
    void *data;
    *file = NULL;
    TRY(yaml_read(path, &file_schema, &data, error));
    *file = data;
    const enum mpm_status status = convert_numbers(path, *file, error);
    if (status != MPM_OK) {
        case_file_free(*file);
        *file = NULL;
    }
    return status;
}

void case_file_free(struct case_file *file)
{
    yaml_read_free(&file_schema, file);
}
