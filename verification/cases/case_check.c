/* case.yaml: rules that no schema can express.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/cases/case_file.h"

#include "verification/cases/case_picture.h"
#include "verification/cases/yaml_place.h"
#include "verification/common/input.h"
#include "verification/common/names.h"

#include <glib.h>
#include <string.h>

static bool variant_matches(const struct case_file *file, const char *glob)
{
    for (unsigned i = 0; i < file->variants_count; i++)
        if (glob_matches(glob, file->variants[i].name))
            return true;
    return false;
}

static enum mpm_status check_globs(const char *path, const struct case_file *file,
                                   const char *place, char *const *globs, unsigned count,
                                   struct mpm_error *error)
{
    for (unsigned i = 0; i < count; i++)
        if (!variant_matches(file, globs[i]))
            return yaml_refuse(path, error, place, "\"%s\" matches no variant", globs[i]);
    return MPM_OK;
}

static enum mpm_status check_parameters(const char *path, const char *place,
                                        const struct case_parameter *parameters, unsigned count,
                                        struct mpm_error *error)
{
    for (unsigned i = 0; i < count; i++)
        for (unsigned j = 0; j < i; j++)
            if (strcmp(parameters[i].name, parameters[j].name) == 0)
                return yaml_refuse(path, error, place, "parameter \"%s\" is given twice",
                                   parameters[i].name);
    return MPM_OK;
}

static enum mpm_status check_variant(const char *path, const struct case_file *file, unsigned index,
                                     struct mpm_error *error)
{
    const struct case_variant *variant = &file->variants[index];
    char place[48];
    g_snprintf(place, sizeof place, variant->method == NULL ? "variants.%u" : "methods", index);
    if (!name_is_sound(variant->name))
        return yaml_refuse(path, error, place, "name \"%s\": %s", variant->name, name_rule);
    for (unsigned i = 0; i < index; i++)
        if (strcmp(variant->name, file->variants[i].name) == 0)
            return yaml_refuse(path, error, place, "name \"%s\" is taken by another variant",
                               variant->name);
    if (!(variant->timeout > 0))
        return yaml_refuse(path, error, place, "timeout %s: allowed are seconds > 0",
                           variant->timeout_text);
    if (variant->settings_count > 0 && file->scene == NULL)
        return yaml_refuse(path, error, place, "settings are given, but the case has no scene");
    for (unsigned i = 0; i < variant->settings_count; i++)
        if (strchr(variant->settings[i], '=') == NULL)
            return yaml_refuse(path, error, place, "setting \"%s\": allowed is PATH=VALUE",
                               variant->settings[i]);
    return check_parameters(path, place, variant->parameters, variant->parameters_count, error);
}

/* Two declarations of one check for one variant. */
static const char *doubled_variant(const struct case_file *file, const struct case_check *one,
                                   const struct case_check *other)
{
    if (strcmp(one->name, other->name) != 0)
        return NULL;
    for (unsigned v = 0; v < file->variants_count; v++) {
        const char *variant = file->variants[v].name;
        if (globs_match(one->variants, one->variants_count, variant) &&
            globs_match(other->variants, other->variants_count, variant))
            return variant;
    }
    return NULL;
}

static enum mpm_status check_check(const char *path, const struct case_file *file, unsigned index,
                                   struct mpm_error *error)
{
    const struct case_check *check = &file->checks[index];
    char place[48];
    g_snprintf(place, sizeof place, "checks.%u", index);
    if (!name_is_sound(check->name))
        return yaml_refuse(path, error, place, "check \"%s\": %s", check->name, name_rule);
    TRY(check_globs(path, file, place, check->variants, check->variants_count, error));
    const bool has_low = check->fails_low_text != NULL, has_high = check->fails_high_text != NULL;
    if (check->outcome == OUTCOME_FAIL ? !(has_low && has_high) : has_low || has_high)
        return yaml_refuse(path, error, place,
                           "check \"%s\": fails_low and fails_high belong to outcome: fail, and it "
                           "needs both",
                           check->name);
    const char *fault = verdict_band_fault(&check->band);
    if (fault != NULL)
        return yaml_refuse(path, error, place, "check \"%s\": %s", check->name, fault);
    for (unsigned i = 0; i < index; i++) {
        const char *variant = doubled_variant(file, check, &file->checks[i]);
        if (variant != NULL)
            return yaml_refuse(path, error, place,
                               "check \"%s\" is declared twice for variant \"%s\"", check->name,
                               variant);
    }
    return MPM_OK;
}

static enum mpm_status check_figure(const char *path, const struct case_file *file, unsigned index,
                                    struct mpm_error *error)
{
    const struct case_figure *figure = &file->figures[index];
    char place[48];
    g_snprintf(place, sizeof place, "figures.%u", index);
    if (!name_is_sound(figure->name))
        return yaml_refuse(path, error, place, "name \"%s\": %s", figure->name, name_rule);
    for (unsigned i = 0; i < index; i++)
        if (strcmp(figure->name, file->figures[i].name) == 0)
            return yaml_refuse(path, error, place, "name \"%s\" is taken by another figure",
                               figure->name);
    if (!name_is_script(figure->script))
        return yaml_refuse(path, error, place,
                           "script \"%s\": allowed is a file *.gp beside case.yaml, its name of "
                           "letters, digits, '_' and '-'",
                           figure->script);
    char *folder = g_path_get_dirname(path);
    char *script = g_build_filename(folder, figure->script, NULL);
    enum mpm_path kind;
    const enum mpm_status found = input_kind(script, &kind, error);
    g_free(folder);
    g_free(script);
    TRY(found);
    if (kind != MPM_PATH_FILE)
        return yaml_refuse(path, error, place, "script \"%s\": no such file", figure->script);
    return check_globs(path, file, place, figure->needs, figure->needs_count, error);
}

static bool has_column(const struct case_comparison *comparison, const char *quantity)
{
    for (unsigned i = 0; i < comparison->columns_count; i++)
        if (strcmp(comparison->columns[i].quantity, quantity) == 0)
            return true;
    return false;
}

/* The keys that name a column, and the figure. */
static enum mpm_status check_names(const char *path, const struct case_file *file,
                                   struct mpm_error *error)
{
    const struct case_comparison *comparison = file->comparison;
    const struct {
        const char *key, *quantity;
    } keys[] = {{"main", comparison->main}, {"cost", comparison->cost}};
    for (size_t i = 0; i < G_N_ELEMENTS(keys); i++)
        if (keys[i].quantity != NULL && !has_column(comparison, keys[i].quantity))
            return yaml_refuse(path, error, "comparison", "%s: \"%s\" is the quantity of no column",
                               keys[i].key, keys[i].quantity);
    bool there = comparison->figure == NULL;
    for (unsigned i = 0; i < file->figures_count; i++)
        there = there || strcmp(file->figures[i].name, comparison->figure) == 0;
    if (!there)
        return yaml_refuse(path, error, "comparison", "figure: \"%s\" is no figure of the case",
                           comparison->figure);
    return MPM_OK;
}

static enum mpm_status check_column(const char *path, const struct case_comparison *comparison,
                                    unsigned index, struct mpm_error *error)
{
    const struct case_column *column = &comparison->columns[index];
    char place[48];
    g_snprintf(place, sizeof place, "comparison.columns.%u", index);
    if (!(column->tolerance >= 0) || !(column->floor >= 0))
        return yaml_refuse(path, error, place, "tolerance and floor: allowed are numbers >= 0");
    if (column->beyond != NULL && column->limit_text == NULL)
        return yaml_refuse(path, error, place, "beyond: \"%s\" belongs to a limit", column->beyond);
    if (column->where != NULL &&
        (!has_column(comparison, column->where) || strcmp(column->where, column->quantity) == 0))
        return yaml_refuse(path, error, place, "where: \"%s\" is the quantity of no other column",
                           column->where);
    for (unsigned i = 0; i < index; i++)
        if (strcmp(column->title, comparison->columns[i].title) == 0)
            return yaml_refuse(path, error, place, "title \"%s\" is taken by another column",
                               column->title);
    return MPM_OK;
}

static enum mpm_status check_comparison(const char *path, const struct case_file *file,
                                        struct mpm_error *error)
{
    const struct case_comparison *comparison = file->comparison;
    if (comparison == NULL)
        return MPM_OK;
    TRY(check_globs(path, file, "comparison", comparison->variants, comparison->variants_count,
                    error));
    for (unsigned i = 0; i < comparison->columns_count; i++)
        TRY(check_column(path, comparison, i, error));
    TRY(check_names(path, file, error));
    const struct case_pareto *pareto = comparison->pareto;
    if (pareto == NULL)
        return MPM_OK;
    const char *unknown = !has_column(comparison, pareto->x)   ? pareto->x
                          : !has_column(comparison, pareto->y) ? pareto->y
                                                               : NULL;
    if (unknown != NULL)
        return yaml_refuse(path, error, "comparison.pareto", "\"%s\" is the quantity of no column",
                           unknown);
    if (g_strcmp0(pareto->x, pareto->y) == 0)
        return yaml_refuse(path, error, "comparison.pareto", "x and y are the same quantity");
    return MPM_OK;
}

static enum mpm_status check_criterion(const char *path, const struct case_bundle *bundle,
                                       unsigned index, struct mpm_error *error)
{
    const struct case_criterion *criterion = &bundle->criteria[index];
    char place[48];
    g_snprintf(place, sizeof place, "bundle.criteria.%u", index);
    if (!name_is_sound(criterion->name))
        return yaml_refuse(path, error, place, "criterion \"%s\": %s", criterion->name, name_rule);
    for (unsigned i = 0; i < index; i++)
        if (strcmp(criterion->name, bundle->criteria[i].name) == 0)
            return yaml_refuse(path, error, place, "criterion \"%s\" is there twice",
                               criterion->name);
    if (!(criterion->within > 0 && criterion->within < 100))
        return yaml_refuse(path, error, place,
                           "within %s: allowed are more than 0 and less than "
                           "100 %%",
                           criterion->within_text);
    return MPM_OK;
}

static enum mpm_status check_number(const char *path, const struct case_numbers *numbers,
                                    unsigned index, struct mpm_error *error)
{
    const struct case_check *number = &numbers->list[index];
    char place[48];
    g_snprintf(place, sizeof place, "bundle_of_numbers.list.%u", index);
    if (!name_is_sound(number->name))
        return yaml_refuse(path, error, place, "number \"%s\": %s", number->name, name_rule);
    const char *fault = verdict_band_fault(&number->band);
    if (fault != NULL)
        return yaml_refuse(path, error, place, "number \"%s\": %s", number->name, fault);
    for (unsigned i = 0; i < index; i++)
        if (strcmp(number->name, numbers->list[i].name) == 0)
            return yaml_refuse(path, error, place, "number \"%s\" is there twice", number->name);
    return MPM_OK;
}

/* Whether a path leads no way up or out. */
static bool stays_within(const char *path)
{
    char **parts = g_strsplit(path, "/", -1);
    const bool within =
        !g_path_is_absolute(path) && !g_strv_contains((const char *const *)parts, "..");
    g_strfreev(parts);
    return within;
}

static enum mpm_status check_numbers(const char *path, const struct case_file *file,
                                     struct mpm_error *error)
{
    const struct case_numbers *numbers = file->numbers;
    if (numbers == NULL)
        return MPM_OK;
    if (file->bundle != NULL || file->no_bundle != NULL)
        return yaml_refuse(path, error, "bundle_of_numbers",
                           "there is a %s as well; allowed is one",
                           file->bundle != NULL ? "bundle" : "no_bundle");
    for (unsigned i = 0; i < numbers->files_count; i++)
        if (!stays_within(numbers->files[i]))
            return yaml_refuse(path, error, "bundle_of_numbers",
                               "file \"%s\": allowed is one within reference_data",
                               numbers->files[i]);
    for (unsigned i = 0; i < numbers->list_count; i++)
        TRY(check_number(path, numbers, i, error));
    return file->scene != NULL ? MPM_OK
                               : yaml_refuse(path, error, "bundle_of_numbers",
                                             "states the case's scene, and it has none");
}

static enum mpm_status check_bundle(const char *path, const struct case_file *file,
                                    struct mpm_error *error)
{
    const struct case_bundle *bundle = file->bundle;
    if (bundle == NULL)
        return MPM_OK;
    if (file->no_bundle != NULL)
        return yaml_refuse(path, error, "no_bundle", "there is a bundle");
    if (file->scene == NULL)
        return yaml_refuse(path, error, "bundle", "states the case's scene, and it has none");
    for (unsigned a = 0; a < 2; a++)
        if (!(bundle->from[a] < bundle->to[a]))
            return yaml_refuse(path, error, "bundle", "from must be less than to");
    if (!(bundle->end > 0))
        return yaml_refuse(path, error, "bundle", "end %s: allowed are times > 0",
                           bundle->end_text);
    for (unsigned i = 0; i < bundle->criteria_count; i++)
        TRY(check_criterion(path, bundle, i, error));
    return MPM_OK;
}

static unsigned independent_count(const struct case_check *checks, unsigned count)
{
    unsigned independent = 0;
    for (unsigned i = 0; i < count; i++)
        independent += checks[i].basis == BASIS_INDEPENDENT;
    return independent;
}

/* A band that rests on a calculation is worth what can be repeated of it. */
static enum mpm_status check_calculation(const char *path, const struct case_file *file,
                                         struct mpm_error *error)
{
    unsigned count = independent_count(file->checks, file->checks_count);
    if (file->numbers != NULL)
        count += independent_count(file->numbers->list, file->numbers->list_count);
    if (count > 0 && file->calculation == NULL)
        return yaml_refuse(path, error, "calculation",
                           "is missing: bands from an independent calculation need what it "
                           "computed and how to repeat it");
    if (count == 0 && file->calculation != NULL)
        return yaml_refuse(path, error, "calculation",
                           "no band has the basis \"independent calculation\"");
    return MPM_OK;
}

enum mpm_status case_file_check(const char *path, const struct case_file *file,
                                struct mpm_error *error)
{
    if (!name_is_sound(file->family))
        return yaml_refuse(path, error, "family", "\"%s\": %s", file->family, name_rule);
    if (!name_is_sound(file->name))
        return yaml_refuse(path, error, "case", "\"%s\": %s", file->name, name_rule);
    TRY(check_parameters(path, "parameters", file->parameters, file->parameters_count, error));
    if (file->variants_count == 0)
        return yaml_refuse(path, error, "case", "has neither variants nor methods");
    for (unsigned i = 0; i < file->variants_count; i++)
        TRY(check_variant(path, file, i, error));
    for (unsigned i = 0; i < file->checks_count; i++)
        TRY(check_check(path, file, i, error));
    for (unsigned i = 0; i < file->figures_count; i++)
        TRY(check_figure(path, file, i, error));
    TRY(check_calculation(path, file, error));
    TRY(check_comparison(path, file, error));
    TRY(check_bundle(path, file, error));
    TRY(case_picture_check(path, file, error));
    return check_numbers(path, file, error);
}
