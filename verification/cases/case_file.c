/* case.yaml: the table of its keys, and reading by it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/cases/case_file.h"

#include "verification/cases/yaml_read.h"
#include "verification/common/failure.h"

#include <glib.h>

/* ------------------------------------------------------------------ schema */

#define TEXT            YAML_TEXT
#define OPTIONAL_TEXT   YAML_OPTIONAL_TEXT
#define NUMBER          YAML_NUMBER
#define OPTIONAL_NUMBER YAML_OPTIONAL_NUMBER
#define TEXTS           YAML_TEXTS
#define LIST            YAML_LIST

static const struct mpm_key parameter_keys[] = {TEXT("name", case_parameter, name),
                                                TEXT("value", case_parameter, value), YAML_END};

static const struct mpm_choice tier_values[] = {{"ci", TIER_CI}, {"full", TIER_FULL}};
static const struct mpm_choice basis_values[] = {{"theory", BASIS_THEORY},
                                                 {"round-off", BASIS_ROUND_OFF},
                                                 {"literature", BASIS_LITERATURE},
                                                 {"independent calculation", BASIS_INDEPENDENT},
                                                 {"measured", BASIS_MEASURED}};
static const struct mpm_choice evidence_values[] = {
    {"quadrature", EVIDENCE_QUADRATURE},       {"exact", EVIDENCE_EXACT},
    {"manufactured", EVIDENCE_MANUFACTURED},   {"invariant", EVIDENCE_INVARIANT},
    {"cross-variant", EVIDENCE_CROSS_VARIANT}, {"reference-data", EVIDENCE_REFERENCE_DATA}};
static const struct mpm_choice outcome_values[] = {{"pass", OUTCOME_PASS}, {"fail", OUTCOME_FAIL}};

static const struct mpm_key variant_keys[] = {
    TEXT("name", case_variant, name),
    OPTIONAL_TEXT("title", case_variant, title),
    YAML_CHOICE("tier", true, case_variant, tier, tier_values),
    NUMBER("timeout", case_variant, timeout_text),
    TEXTS("settings", case_variant, settings, 0),
    LIST("parameters", case_variant, parameters, case_parameter, parameter_keys, 0),
    YAML_END};

static const struct mpm_key methods_keys[] = {
    TEXTS("names", case_methods, names, 1),
    TEXTS("except", case_methods, except, 0),
    TEXTS("full", case_methods, full, 0),
    YAML_CHOICE("tier", true, case_methods, tier, tier_values),
    NUMBER("timeout", case_methods, timeout_text),
    TEXTS("settings", case_methods, settings, 0),
    LIST("parameters", case_methods, parameters, case_parameter, parameter_keys, 0),
    YAML_END};

/* What checks and numbers for other solvers state alike. */
#define CHECK_KEYS(key)                                                                            \
    TEXT(key, case_check, name), TEXT("title", case_check, title),                                 \
        TEXT("quantity", case_check, quantity), TEXT("unit", case_check, unit),                    \
        NUMBER("expected", case_check, expected_text), NUMBER("low", case_check, low_text),        \
        NUMBER("high", case_check, high_text), TEXT("why", case_check, why),                       \
        YAML_CHOICE("basis", true, case_check, basis, basis_values)

static const struct mpm_key check_keys[] = {
    CHECK_KEYS("check"),
    TEXTS("variants", case_check, variants, 1),
    TEXT("norm", case_check, norm),
    OPTIONAL_NUMBER("fails_low", case_check, fails_low_text),
    OPTIONAL_NUMBER("fails_high", case_check, fails_high_text),
    OPTIONAL_NUMBER("initial", case_check, initial_text),
    OPTIONAL_TEXT("headroom", case_check, headroom),
    YAML_CHOICE("evidence", false, case_check, evidence, evidence_values),
    YAML_CHOICE("outcome", false, case_check, outcome, outcome_values),
    YAML_END};

static const struct mpm_key figure_keys[] = {TEXT("name", case_figure, name),
                                             TEXT("script", case_figure, script),
                                             TEXT("title", case_figure, title),
                                             TEXT("caption", case_figure, caption),
                                             TEXT("reference", case_figure, reference),
                                             TEXTS("needs", case_figure, needs, 0),
                                             YAML_END};

static const struct mpm_choice field_values[] = {
    {"by_law", PICTURE_BY_LAW},
    {"speed", PICTURE_SPEED},
    {"velocity_x", PICTURE_VELOCITY_X},
    {"velocity_y", PICTURE_VELOCITY_Y},
    {"displacement", PICTURE_DISPLACEMENT},
    {"displacement_x", PICTURE_DISPLACEMENT_X},
    {"displacement_y", PICTURE_DISPLACEMENT_Y},
    {"von_mises", PICTURE_VON_MISES},
    {"pressure", PICTURE_PRESSURE},
    {"stress_xx", PICTURE_STRESS_XX},
    {"stress_yy", PICTURE_STRESS_YY},
    {"stress_zz", PICTURE_STRESS_ZZ},
    {"stress_xy", PICTURE_STRESS_XY},
    {"volume_ratio", PICTURE_VOLUME_RATIO},
    {"temperature", PICTURE_TEMPERATURE},
    {"concentration", PICTURE_CONCENTRATION},
    {"plastic_strain", PICTURE_PLASTIC_STRAIN},
    {"internal_energy", PICTURE_INTERNAL_ENERGY},
    {"state_temperature", PICTURE_STATE_TEMPERATURE},
    {"fringe", PICTURE_FRINGE},
};

static const struct mpm_key picture_keys[] = {
    OPTIONAL_TEXT("variant", case_picture, variant),
    YAML_CHOICE("field", false, case_picture, field, field_values),
    YAML_OPTIONAL_INTEGER("simulation", case_picture, simulation, 1, 1000),
    OPTIONAL_NUMBER("time", case_picture, time_text),
    OPTIONAL_NUMBER("magnify", case_picture, magnify_text),
    YAML_OPTIONAL_INTEGER("frames", case_picture, frames, 2, 40),
    YAML_FLAG("strip", case_picture, strip),
    OPTIONAL_TEXT("caption", case_picture, caption),
    YAML_END};

static const struct mpm_choice better_values[] = {
    {"low", COMPARISON_LOW}, {"high", COMPARISON_HIGH}, {"zero", COMPARISON_ZERO}};

static const struct mpm_key column_keys[] = {
    TEXT("quantity", case_column, quantity),
    TEXT("title", case_column, title),
    TEXT("unit", case_column, unit),
    YAML_CHOICE("better", true, case_column, better, better_values),
    OPTIONAL_NUMBER("tolerance", case_column, tolerance_text),
    OPTIONAL_NUMBER("floor", case_column, floor_text),
    OPTIONAL_NUMBER("limit", case_column, limit_text),
    OPTIONAL_TEXT("beyond", case_column, beyond),
    OPTIONAL_TEXT("missing", case_column, missing),
    OPTIONAL_TEXT("about", case_column, about),
    OPTIONAL_TEXT("case", case_column, case_name),
    OPTIONAL_TEXT("where", case_column, where),
    YAML_END};

static const struct mpm_key pareto_keys[] = {TEXT("x", case_pareto, x), TEXT("y", case_pareto, y),
                                             YAML_END};

static const struct mpm_key comparison_keys[] = {
    TEXT("title", case_comparison, title),
    OPTIONAL_TEXT("summary", case_comparison, summary),
    TEXTS("variants", case_comparison, variants, 0),
    LIST("columns", case_comparison, columns, case_column, column_keys, 1),
    YAML_GROUP("pareto", case_comparison, pareto, case_pareto, pareto_keys),
    OPTIONAL_TEXT("main", case_comparison, main),
    OPTIONAL_TEXT("cost", case_comparison, cost),
    OPTIONAL_TEXT("setup", case_comparison, setup),
    OPTIONAL_TEXT("figure", case_comparison, figure),
    TEXTS("notes", case_comparison, notes, 0),
    YAML_END};

static const struct mpm_choice norm_values[] = {
    {"l1", AGREEMENT_L1}, {"l2", AGREEMENT_L2}, {"linf", AGREEMENT_LINF}, {"mean", AGREEMENT_MEAN}};

static const struct mpm_key criterion_keys[] = {
    TEXT("criterion", case_criterion, name),
    TEXT("title", case_criterion, title),
    TEXTS("columns", case_criterion, columns, 1),
    YAML_CHOICE("norm", true, case_criterion, norm, norm_values),
    NUMBER("within", case_criterion, within_text),
    TEXT("why", case_criterion, why),
    YAML_END};

static const struct mpm_key bundle_keys[] = {
    TEXT("reference", case_bundle, reference),
    TEXT("about", case_bundle, about),
    LIST("parameters", case_bundle, parameters, case_parameter, parameter_keys, 0),
    YAML_TWO_NUMBERS("from", case_bundle, from_text),
    YAML_TWO_NUMBERS("to", case_bundle, to_text),
    YAML_TWO_INTEGERS("points", case_bundle, points, 1, 10000),
    YAML_FLAG("polar", case_bundle, polar),
    YAML_FLAG("linear", case_bundle, linear),
    YAML_FLAG("rest", case_bundle, rest),
    NUMBER("end", case_bundle, end_text),
    YAML_INTEGER("instants", case_bundle, instants, 1, 1000),
    YAML_OPTIONAL_INTEGER("body", case_bundle, body, 0, 1e6),
    LIST("criteria", case_bundle, criteria, case_criterion, criterion_keys, 1),
    YAML_END};

static const struct mpm_key number_keys[] = {CHECK_KEYS("number"), YAML_END};

static const struct mpm_key numbers_keys[] = {
    TEXT("about", case_numbers, about), TEXTS("files", case_numbers, files, 0),
    LIST("list", case_numbers, list, case_check, number_keys, 1), YAML_END};

static const struct mpm_key file_keys[] = {
    YAML_INTEGER("format", case_file, format, 1, 1),
    TEXT("family", case_file, family),
    TEXT("case", case_file, name),
    TEXT("title", case_file, title),
    TEXT("summary", case_file, summary),
    TEXTS("tags", case_file, tags, 0),
    YAML_CHOICE("evidence", false, case_file, evidence, evidence_values),
    OPTIONAL_TEXT("calculation", case_file, calculation),
    TEXT("program", case_file, program_name),
    OPTIONAL_TEXT("scene", case_file, scene),
    LIST("parameters", case_file, parameters, case_parameter, parameter_keys, 0),
    LIST("variants", case_file, variants, case_variant, variant_keys, 0),
    YAML_GROUP("methods", case_file, methods, case_methods, methods_keys),
    LIST("checks", case_file, checks, case_check, check_keys, 1),
    LIST("figures", case_file, figures, case_figure, figure_keys, 0),
    YAML_GROUP("picture", case_file, picture, case_picture, picture_keys),
    OPTIONAL_TEXT("no_picture", case_file, no_picture),
    YAML_GROUP("comparison", case_file, comparison, case_comparison, comparison_keys),
    YAML_GROUP("bundle", case_file, bundle, case_bundle, bundle_keys),
    YAML_GROUP("bundle_of_numbers", case_file, numbers, case_numbers, numbers_keys),
    OPTIONAL_TEXT("no_bundle", case_file, no_bundle),
    YAML_END};
static const struct mpm_key whole_file = YAML_FILE(case_file, file_keys);

/* ----------------------------------------------------------------- numbers */

/* The table has found a number, or there is none. */
static double number_or(const char *text, double fallback)
{
    return text != NULL ? g_ascii_strtod(text, NULL) : fallback;
}

static void convert_check(struct case_check *check)
{
    check->band = (struct verdict_band){
        .expected = number_or(check->expected_text, 0.0),
        .low = number_or(check->low_text, 0.0),
        .high = number_or(check->high_text, 0.0),
        .fails_low = number_or(check->fails_low_text, 0.0),
        .fails_high = number_or(check->fails_high_text, 0.0),
        .initial = number_or(check->initial_text, 0.0),
        .weakness = check->outcome == OUTCOME_FAIL,
        .has_initial = check->initial_text != NULL,
    };
}

static void convert_bundle(struct case_bundle *bundle)
{
    for (unsigned a = 0; a < 2; a++) {
        bundle->from[a] = number_or(bundle->from_text[a], 0.0);
        bundle->to[a] = number_or(bundle->to_text[a], 0.0);
    }
    bundle->end = number_or(bundle->end_text, 0.0);
    for (unsigned i = 0; i < bundle->criteria_count; i++)
        bundle->criteria[i].within = number_or(bundle->criteria[i].within_text, 0.0);
}

static void convert_numbers(struct case_file *file)
{
    for (unsigned i = 0; i < file->variants_count; i++)
        file->variants[i].timeout = number_or(file->variants[i].timeout_text, 0.0);
    if (file->methods != NULL)
        file->methods->timeout = number_or(file->methods->timeout_text, 0.0);
    for (unsigned i = 0; i < file->checks_count; i++)
        convert_check(&file->checks[i]);
    for (unsigned i = 0; file->numbers != NULL && i < file->numbers->list_count; i++)
        convert_check(&file->numbers->list[i]);
    for (unsigned i = 0; file->comparison != NULL && i < file->comparison->columns_count; i++) {
        struct case_column *column = &file->comparison->columns[i];
        column->tolerance = number_or(column->tolerance_text, 0.05);
        column->floor = number_or(column->floor_text, 0.0);
        column->limit = number_or(column->limit_text, 0.0);
    }
    if (file->bundle != NULL)
        convert_bundle(file->bundle);
    if (file->picture != NULL) {
        file->picture->time = number_or(file->picture->time_text, (double)NAN);
        file->picture->magnify = number_or(file->picture->magnify_text, (double)NAN);
    }
}

enum mpm_status case_file_load(const char *path, struct case_file **file, struct mpm_error *error)
{
    void *data;
    *file = NULL;
    TRY(mpm_keys_read(path, &whole_file, &data, error));
    *file = data;
    convert_numbers(*file);
    return MPM_OK;
}

void case_file_free(struct case_file *file)
{
    mpm_keys_free(&whole_file, file);
}
