/* The catalogue: finding and reading its cases.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/cases/catalogue.h"

#include "verification/cases/case_file.h"
#include "verification/cases/methods.h"
#include "verification/cases/yaml_place.h"
#include "verification/common/input.h"
#include "verification/common/names.h"

#include <glib.h>
#include <stdlib.h>
#include <string.h>

enum case_evidence check_evidence(const struct case_file *file, const struct case_check *check)
{
    return check->evidence != EVIDENCE_NOT_STATED ? check->evidence : file->evidence;
}

const char *tier_name(enum tier tier)
{
    static const char *const names[] = {"ci", "full"};
    return names[tier];
}

bool comparison_has_variant(const struct case_comparison *comparison, const char *variant)
{
    return comparison != NULL &&
           (comparison->variants_count == 0 ||
            globs_match(comparison->variants, comparison->variants_count, variant));
}

static void case_clear(void *element)
{
    struct catalogue_case *entry = element;
    case_file_free(entry->file);
    g_free(entry->folder);
    g_free(entry->scene_path);
    g_free(entry->readme);
}

/* What cases refer to by name. */
struct sources {
    struct program_table programs;
    const struct method_table *methods;
};

static enum mpm_status check_home(const char *path, const struct catalogue_case *entry,
                                  const char *family, const char *name, struct mpm_error *error)
{
    const struct case_file *file = entry->file;
    if (strcmp(file->family, family) != 0 || strcmp(file->name, name) != 0)
        return failure_set(error, MPM_BAD_INPUT,
                           "%s: family %s, case %s must be the folder's: %s/%s", path, file->family,
                           file->name, family, name);
    enum mpm_path kind = MPM_PATH_FILE;
    if (entry->scene_path != NULL)
        TRY(input_kind(entry->scene_path, &kind, error));
    if (kind != MPM_PATH_FILE)
        return failure_set(error, MPM_BAD_INPUT, "%s:%u: scene: \"%s\": no such file", path,
                           yaml_place_line(path, "scene"), file->scene);
    return MPM_OK;
}

static enum mpm_status refuse_program(const char *path, const char *name,
                                      struct program_table programs, struct mpm_error *error)
{
    GString *names = g_string_new(NULL);
    for (size_t i = 0; i < programs.count; i++)
        g_string_append_printf(names, " %s", programs.programs[i]->name);
    failure_set(error, MPM_BAD_INPUT, "%s:%u: program: \"%s\": allowed are%s", path,
                yaml_place_line(path, "program"), name, names->str);
    g_string_free(names, TRUE);
    return MPM_BAD_INPUT;
}

static enum mpm_status read_readme(struct catalogue_case *entry, struct mpm_error *error)
{
    char *path = g_build_filename(entry->folder, "README.md", NULL);
    size_t length = 0;
    enum mpm_status status =
        input_text(path, "a text on the case, in UTF-8", &entry->readme, &length, error);
    if (status == MPM_OK && (length == 0 || !g_utf8_validate(entry->readme, -1, NULL)))
        status = failure_set(error, MPM_BAD_INPUT,
                             "%s: a case needs a README.md in UTF-8: problem, source equation, "
                             "reference, criterion and why",
                             path);
    g_free(path);
    return status;
}

static enum mpm_status case_fill(const char *path, const char *family, const char *name,
                                 const struct sources *sources, struct catalogue_case *entry,
                                 struct mpm_error *error)
{
    TRY(case_file_load(path, &entry->file, error));
    TRY(methods_add_variants(path, sources->methods, entry->file, error));
    TRY(case_file_check(path, entry->file, error));
    if (entry->file->scene != NULL)
        entry->scene_path = g_build_filename(entry->folder, entry->file->scene, NULL);
    TRY(check_home(path, entry, family, name, error));
    entry->methods = sources->methods;
    entry->program = programs_find(sources->programs, entry->file->program_name);
    if (entry->program == NULL)
        return refuse_program(path, entry->file->program_name, sources->programs, error);
    return read_readme(entry, error);
}

char *catalogue_scene_path(const struct catalogue_case *entry, const struct case_variant *variant)
{
    for (unsigned i = 0; i < variant->parameters_count; i++)
        if (strcmp(variant->parameters[i].name, "scene") == 0)
            return g_build_filename(entry->folder, variant->parameters[i].value, NULL);
    return g_strdup(entry->scene_path);
}

/* Those that a catalogue may hold: not hidden. */
static enum mpm_status folders_in(const char *folder, GPtrArray **folders, struct mpm_error *error)
{
    GPtrArray *names;
    enum mpm_status status = input_names(folder, &names, error);
    *folders = g_ptr_array_new_with_free_func(g_free);
    for (guint i = 0; status == MPM_OK && i < names->len; i++) {
        const char *name = names->pdata[i];
        char *path = g_build_filename(folder, name, NULL);
        enum mpm_path kind = MPM_PATH_NONE;
        if (*name != '.')
            status = input_kind(path, &kind, error);
        if (kind == MPM_PATH_FOLDER)
            g_ptr_array_add(*folders, g_strdup(name));
        g_free(path);
    }
    if (names != NULL)
        g_ptr_array_unref(names);
    return status;
}

static enum mpm_status add_case(const char *folder, const char *family, const char *name,
                                const struct sources *sources, GArray *cases,
                                struct mpm_error *error)
{
    char *home = g_build_filename(folder, family, name, NULL);
    char *path = g_build_filename(home, "case.yaml", NULL);
    struct catalogue_case entry = {.folder = home};
    const enum mpm_status status = case_fill(path, family, name, sources, &entry, error);
    g_array_append_val(cases, entry);
    g_free(path);
    return status;
}

static enum mpm_status check_unique(const GArray *cases, struct mpm_error *error)
{
    for (unsigned i = 0; i < cases->len; i++)
        for (unsigned j = 0; j < i; j++) {
            const struct catalogue_case *one = &g_array_index(cases, struct catalogue_case, i);
            const struct catalogue_case *other = &g_array_index(cases, struct catalogue_case, j);
            if (strcmp(one->file->name, other->file->name) == 0)
                return failure_set(error, MPM_BAD_INPUT, "%s: case %s is also in %s", one->folder,
                                   one->file->name, other->folder);
        }
    return MPM_OK;
}

/* Columns may come from other cases, which must be there. */
static enum mpm_status check_columns(const GArray *cases, const struct catalogue_case *entry,
                                     struct mpm_error *error)
{
    const struct case_comparison *comparison = entry->file->comparison;
    for (unsigned c = 0; comparison != NULL && c < comparison->columns_count; c++) {
        const char *wanted = comparison->columns[c].case_name;
        bool there = wanted == NULL;
        for (unsigned i = 0; !there && i < cases->len; i++)
            there = strcmp(g_array_index(cases, struct catalogue_case, i).file->name, wanted) == 0;
        if (there)
            continue;
        char *path = g_build_filename(entry->folder, "case.yaml", NULL), place[48];
        g_snprintf(place, sizeof place, "comparison.columns.%u", c);
        yaml_refuse(path, error, place, "case \"%s\": the catalogue has none of that name", wanted);
        g_free(path);
        return MPM_BAD_INPUT;
    }
    return MPM_OK;
}

static enum mpm_status add_families(const char *folder, const struct sources *sources,
                                    GArray *cases, struct mpm_error *error)
{
    GPtrArray *families;
    enum mpm_status status = folders_in(folder, &families, error);
    for (unsigned f = 0; status == MPM_OK && f < families->len; f++) {
        const char *family = families->pdata[f];
        char *family_folder = g_build_filename(folder, family, NULL);
        GPtrArray *names;
        status = folders_in(family_folder, &names, error);
        for (unsigned c = 0; status == MPM_OK && c < names->len; c++)
            status = add_case(folder, family, names->pdata[c], sources, cases, error);
        g_ptr_array_unref(names);
        g_free(family_folder);
    }
    g_ptr_array_unref(families);
    return status;
}

enum mpm_status catalogue_read(const char *folder, struct program_table programs,
                               struct catalogue **catalogue, struct mpm_error *error)
{
    *catalogue = NULL;
    enum mpm_path kind;
    TRY(input_kind(folder, &kind, error));
    if (kind != MPM_PATH_FOLDER)
        return failure_set(error, MPM_BAD_INPUT, "%s: no such folder of a catalogue", folder);
    struct method_table *methods;
    TRY(methods_load(folder, &methods, error));
    GArray *cases = g_array_new(FALSE, TRUE, sizeof(struct catalogue_case));
    g_array_set_clear_func(cases, case_clear);
    const struct sources sources = {programs, methods};
    enum mpm_status status = add_families(folder, &sources, cases, error);
    if (status == MPM_OK)
        status = check_unique(cases, error);
    for (unsigned i = 0; status == MPM_OK && i < cases->len; i++)
        status = check_columns(cases, &g_array_index(cases, struct catalogue_case, i), error);
    if (status == MPM_OK && cases->len == 0)
        status = failure_set(error, MPM_BAD_INPUT,
                             "%s: holds no case: expected FAMILY/CASE/case.yaml", folder);
    if (status != MPM_OK) {
        g_array_unref(cases);
        methods_free(methods);
        return status;
    }
    *catalogue = g_new0(struct catalogue, 1);
    (*catalogue)->folder = g_strdup(folder);
    (*catalogue)->methods = methods;
    (*catalogue)->count = cases->len;
    (*catalogue)->cases = (struct catalogue_case *)(void *)g_array_free(cases, FALSE);
    return MPM_OK;
}

void catalogue_free(struct catalogue *catalogue)
{
    if (catalogue == NULL)
        return;
    for (size_t i = 0; i < catalogue->count; i++)
        case_clear(&catalogue->cases[i]);
    g_free(catalogue->cases);
    methods_free(catalogue->methods);
    g_free(catalogue->folder);
    g_free(catalogue);
}
