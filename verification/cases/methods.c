/* methods.yaml, and the variants that cases make of it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/cases/methods.h"

#include "verification/cases/yaml_place.h"
#include "verification/cases/yaml_read.h"
#include "verification/common/input.h"
#include "verification/common/names.h"

#include <glib.h>
#include <stdlib.h>
#include <string.h>

static const char file_name[] = "methods.yaml";

/* ------------------------------------------------------------------ the table */

static const struct mpm_key method_keys[] = {
    YAML_TEXT("name", method, name), YAML_TEXT("group", method, group),
    YAML_TEXT("title", method, title), YAML_TEXTS("settings", method, settings, 1), YAML_END};
static const struct mpm_key part_keys[] = {YAML_TEXT("part", method_part, name),
                                           YAML_TEXT("kind", method_part, kind),
                                           YAML_TEXT("title", method_part, title), YAML_END};
static const struct mpm_key table_keys[] = {
    YAML_INTEGER("format", method_table, format, 1, 1),
    YAML_LIST("parts", method_table, parts, method_part, part_keys, 0),
    YAML_LIST("methods", method_table, methods, method, method_keys, 1), YAML_END};
static const struct mpm_key table_file = YAML_FILE(method_table, table_keys);

static bool same_settings(const struct method *one, const struct method *other)
{
    bool same = one->settings_count == other->settings_count;
    for (unsigned i = 0; same && i < one->settings_count; i++)
        same = strcmp(one->settings[i], other->settings[i]) == 0;
    return same;
}

/* The reader of a report looks every part of a name up. */
static enum mpm_status check_parts(const char *path, const struct method_table *table,
                                   const struct method *method, const char *place,
                                   struct mpm_error *error)
{
    char **parts = g_strsplit(method->name, "_", -1);
    enum mpm_status status = MPM_OK;
    for (char **part = parts; status == MPM_OK && table->parts_count > 0 && *part != NULL; part++) {
        bool known = false;
        for (unsigned i = 0; !known && i < table->parts_count; i++)
            known = glob_matches(table->parts[i].name, *part);
        if (!known)
            status = yaml_refuse(path, error, place, "name \"%s\": parts does not explain \"%s\"",
                                 method->name, *part);
    }
    g_strfreev(parts);
    return status;
}

static enum mpm_status check_method(const char *path, const struct method_table *table,
                                    unsigned index, struct mpm_error *error)
{
    const struct method *method = &table->methods[index];
    char place[32];
    g_snprintf(place, sizeof place, "methods.%u", index);
    if (!name_is_sound(method->name))
        return yaml_refuse(path, error, place, "name \"%s\": %s", method->name, name_rule);
    for (unsigned i = 0; i < method->settings_count; i++)
        if (strchr(method->settings[i], '=') == NULL)
            return yaml_refuse(path, error, place, "setting \"%s\": allowed is PATH=VALUE",
                               method->settings[i]);
    TRY(check_parts(path, table, method, place, error));
    for (unsigned i = 0; i < index; i++) {
        if (strcmp(method->name, table->methods[i].name) == 0)
            return yaml_refuse(path, error, place, "name \"%s\" is taken by another method",
                               method->name);
        if (same_settings(method, &table->methods[i]))
            return yaml_refuse(path, error, place, "\"%s\" has the settings of \"%s\"",
                               method->name, table->methods[i].name);
    }
    return MPM_OK;
}

static enum mpm_status check_table(const char *path, const struct method_table *table,
                                   struct mpm_error *error)
{
    for (unsigned i = 0; i < table->methods_count; i++)
        TRY(check_method(path, table, i, error));
    return MPM_OK;
}

enum mpm_status methods_load(const char *folder, struct method_table **table,
                             struct mpm_error *error)
{
    char *path = g_build_filename(folder, file_name, NULL);
    enum mpm_path kind;
    enum mpm_status status = input_kind(path, &kind, error);
    void *data = NULL;
    *table = NULL;
    if (status == MPM_OK && kind != MPM_PATH_NONE)
        status = mpm_keys_read(path, &table_file, &data, error);
    if (status == MPM_OK && data != NULL)
        status = check_table(path, data, error);
    if (status == MPM_OK)
        *table = data;
    else
        methods_free(data);
    g_free(path);
    return status;
}

void methods_free(struct method_table *table)
{
    mpm_keys_free(&table_file, table);
}

/* --------------------------------------------------------------- the variants */

/* The file is memory of malloc, as its reader made it, and what is added to it must be. */
static char *copy_text(const char *text)
{
    const size_t size = strlen(text) + 1;
    char *copy = malloc(size);
    return copy == NULL ? NULL : memcpy(copy, text, size);
}

static bool copy_settings(struct case_variant *variant, const struct method *method,
                          const struct case_methods *extra)
{
    const unsigned count = method->settings_count + extra->settings_count;
    variant->settings = calloc(count, sizeof *variant->settings);
    if (variant->settings == NULL)
        return false;
    for (unsigned i = 0; i < count; i++) {
        const char *setting = i < method->settings_count
                                  ? method->settings[i]
                                  : extra->settings[i - method->settings_count];
        variant->settings[i] = copy_text(setting);
        if (variant->settings[i] == NULL)
            return false;
        variant->settings_count++;
    }
    return true;
}

static bool copy_parameters(struct case_variant *variant, const struct case_methods *methods)
{
    if (methods->parameters_count == 0)
        return true;
    variant->parameters = calloc(methods->parameters_count, sizeof *variant->parameters);
    if (variant->parameters == NULL)
        return false;
    variant->parameters_count = methods->parameters_count;
    for (unsigned i = 0; i < methods->parameters_count; i++) {
        struct case_parameter *copy = &variant->parameters[i];
        copy->name = copy_text(methods->parameters[i].name);
        copy->value = copy_text(methods->parameters[i].value);
        if (copy->name == NULL || copy->value == NULL)
            return false;
    }
    return true;
}

static enum mpm_status add_variant(struct case_file *file, const struct method *method,
                                   struct mpm_error *error)
{
    const struct case_methods *methods = file->methods;
    struct case_variant *grown =
        realloc(file->variants, (file->variants_count + 1) * sizeof *file->variants);
    if (grown == NULL)
        return failure_set(error, MPM_ENVIRONMENT_FAILED, "out of memory for variants");
    file->variants = grown;
    struct case_variant *variant = &grown[file->variants_count++];
    *variant = (struct case_variant){.name = copy_text(method->name), .method = method};
    const bool late = globs_match(methods->full, methods->full_count, method->name);
    variant->tier = late ? TIER_FULL : methods->tier;
    variant->timeout_text = copy_text(methods->timeout_text);
    variant->timeout = methods->timeout;
    if (variant->name == NULL || variant->timeout_text == NULL ||
        !copy_settings(variant, method, methods) || !copy_parameters(variant, methods))
        return failure_set(error, MPM_ENVIRONMENT_FAILED, "out of memory for variants");
    return MPM_OK;
}

static bool is_selected(const struct case_methods *methods, const char *name)
{
    return globs_match(methods->names, methods->names_count, name) &&
           !globs_match(methods->except, methods->except_count, name);
}

/* Each glob must select a method of the table, among those that are named. */
static enum mpm_status check_globs(const char *path, const struct method_table *table,
                                   const struct case_methods *methods, char *const *globs,
                                   unsigned count, const char *key, struct mpm_error *error)
{
    for (unsigned g = 0; g < count; g++) {
        bool used = false;
        for (unsigned i = 0; i < table->methods_count; i++)
            used =
                used || (glob_matches(globs[g], table->methods[i].name) &&
                         globs_match(methods->names, methods->names_count, table->methods[i].name));
        if (!used)
            return yaml_refuse(path, error, "methods", "%s: \"%s\" matches no method%s", key,
                               globs[g],
                               globs == methods->names ? " of methods.yaml" : " of names");
    }
    return MPM_OK;
}

enum mpm_status methods_add_variants(const char *path, const struct method_table *table,
                                     struct case_file *file, struct mpm_error *error)
{
    const struct case_methods *methods = file->methods;
    const unsigned own = file->variants_count;
    if (methods == NULL)
        return MPM_OK;
    if (table == NULL)
        return yaml_refuse(path, error, "methods", "the catalogue has no %s", file_name);
    if (file->scene == NULL)
        return yaml_refuse(path, error, "methods",
                           "are settings of a scene, and the case has none");
    TRY(check_globs(path, table, methods, methods->names, methods->names_count, "names", error));
    TRY(check_globs(path, table, methods, methods->except, methods->except_count, "except", error));
    TRY(check_globs(path, table, methods, methods->full, methods->full_count, "full", error));
    for (unsigned i = 0; i < table->methods_count; i++) {
        const char *name = table->methods[i].name;
        if (!is_selected(methods, name))
            continue;
        for (unsigned v = 0; v < own; v++)
            if (strcmp(file->variants[v].name, name) == 0)
                return yaml_refuse(path, error, "methods",
                                   "\"%s\" is the name of a variant, too: name it in except", name);
        TRY(add_variant(file, &table->methods[i], error));
    }
    return MPM_OK;
}
