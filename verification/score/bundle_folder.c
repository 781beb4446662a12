/* What bundles of fields and of numbers have in common, written.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/score/bundle_folder.h"

#include "verification/common/failure.h"
#include "verification/common/input.h"
#include "verification/common/output.h"
#include "verification/common/record.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

/* ------------------------------------------------------------------------- JSON */

/* The sections of a scene that state what the problem is, not how the solver takes it. */
static json_t *problem_of(const json_t *scene)
{
    static const char *const sections[] = {"title",    "thickness", "materials", "bodies",
                                           "boundary", "loads",     "cracks",    "transport"};
    json_t *problem = json_object();
    for (size_t i = 0; i < G_N_ELEMENTS(sections); i++)
        if (json_object_get(scene, sections[i]) != NULL)
            json_object_set(problem, sections[i], json_object_get(scene, sections[i]));
    json_object_set(problem, "resolution_of_the_case", json_object_get(scene, "grid"));
    return problem;
}

/* Laws of scenes as formulas, for those who have other names for them. */
static const struct law {
    const char *name, *formula;
} laws[] = {
    {"linear_elastic",
     "W = G |U - I|^2 + lambda/2 (tr(U - I))^2 per volume of the undeformed body, "
     "U the right stretch: Hooke's law that turns with the body"},
    {"neo_hookean", "W = K/2 ((J^2 - 1)/2 - ln J) + G/2 (J^(-2/3) tr(F F^T) - 3) per volume of the "
                    "undeformed body, J = det F; K and G follow from young and poisson"},
    {"none", "no stress: the material only conducts"},
    {"linear", "cohesive: the traction rises with the opening at `stiffness` to `strength`, then "
               "falls along a line to nothing at the opening 2 toughness/strength"},
};

static bool has_law(const json_t *specs, const char *name)
{
    for (size_t i = 0; i < json_array_size(specs); i++) {
        const json_t *spec = json_array_get(specs, i),
                     *cohesive = json_object_get(spec, "cohesive");
        if (strcmp(record_text(spec, "law"), name) == 0 ||
            strcmp(record_text(cohesive, "law"), name) == 0)
            return true;
    }
    return false;
}

static json_t *laws_of(const json_t *scene)
{
    json_t *object = json_object();
    for (size_t i = 0; i < G_N_ELEMENTS(laws); i++)
        if (has_law(json_object_get(scene, "materials"), laws[i].name) ||
            has_law(json_object_get(scene, "cracks"), laws[i].name))
            json_object_set_new(object, laws[i].name, json_string(laws[i].formula));
    return object;
}

json_t *bundle_facts(const struct catalogue_case *entry, const json_t *scene, const char *about,
                     const char *results)
{
    const struct case_file *file = entry->file;
    json_t *object = json_object();
    json_object_set_new(object, "format", json_integer(1));
    json_object_set_new(object, "family", record_text_of(file->family));
    json_object_set_new(object, "case", record_text_of(file->name));
    json_object_set_new(object, "title", record_text_of(file->title));
    json_object_set_new(object, "summary", record_text_of(file->summary));
    json_object_set_new(object, "about", record_text_of(about));
    json_object_set_new(object, "version", record_text_of(mpm_build_info()->version));
    json_object_set_new(object, "revision", record_text_of(mpm_build_info()->revision));
    json_object_set_new(object, "results", json_string(results));
    json_object_set(object, "geometry", json_object_get(scene, "geometry"));
    json_object_set(object, "units", json_object_get(scene, "units"));
    json_object_set_new(object, "problem", problem_of(scene));
    json_object_set_new(object, "laws", laws_of(scene));
    return object;
}

/* ------------------------------------------------------------------------ words */

GString *bundle_words_begin(const struct catalogue_case *entry, const char *about)
{
    GString *text = g_string_new(NULL);
    g_string_append_printf(text, "# Case %s for other solvers: %s\n\n%s\n\n", entry->file->name,
                           entry->file->title, about);
    return text;
}

void bundle_words_of_laws(GString *text, const json_t *json)
{
    json_t *const formulas = json_object_get(json, "laws");
    for (void *law = json_object_iter(formulas); law != NULL;
         law = json_object_iter_next(formulas, law))
        g_string_append_printf(text, "- `%s`: %s.\n", json_object_iter_key(law),
                               json_string_value(json_object_iter_value(law)));
    g_string_append_c(text, '\n');
}

char *bundle_words_end(const struct catalogue_case *entry, GString *text)
{
    g_string_append_printf(text,
                           "\n---\n\nThe suite's own text on the case, of its own solver "
                           "included:\n\n%s",
                           entry->readme);
    return g_string_free(text, FALSE);
}

/* ------------------------------------------------------------------------ files */

/* Only a new or empty folder, or a bundle of the same case, is written to. */
static enum mpm_status check_home(const char *home, const char *name, struct mpm_error *error)
{
    char **const names = mpm_folder_list(home);
    if (names == NULL && errno != ENOTDIR)
        return errno == ENOENT ? MPM_OK : mpm_file_unread(home, errno, NULL, error);
    bool empty = names != NULL;
    for (char **one = names; one != NULL && *one != NULL; one++)
        empty = empty && g_str_has_suffix(*one, MPM_PARTIAL_SUFFIX);
    mpm_folder_list_free(names);
    if (empty)
        return MPM_OK;
    char *path = g_build_filename(home, "problem.json", NULL);
    json_t *json;
    struct mpm_error own = {.status = MPM_OK};
    if (input_json(path, 0, &json, &own) == MPM_ENVIRONMENT_FAILED) {
        g_free(path);
        return failure_set(error, own.status, "%s", own.message);
    }
    const bool bundle = json_integer_value(json_object_get(json, "format")) == 1 &&
                        strcmp(record_text(json, "case"), name) == 0;
    json_decref(json);
    g_free(path);
    return bundle ? MPM_OK
                  : failure_set(error, MPM_BAD_INPUT,
                                "%s: is there and no bundle of case %s: allowed are a new or "
                                "empty folder, or such a bundle",
                                home, name);
}

/* What an export that fails leaves is a bundle that is refused until it is exported again. */
static enum mpm_status mark_unfinished(const char *home, const struct catalogue_case *entry,
                                       struct mpm_error *error)
{
    json_t *json = json_pack("{s:i, s:s, s:s}", "format", 1, "family", entry->file->family, "case",
                             entry->file->name);
    char *text = json_dumps(json, JSON_PRESERVE_ORDER);
    const enum mpm_status status = output_write(home, "problem.json", text, error);
    free(text);
    json_decref(json);
    return status;
}

enum mpm_status bundle_home(const struct catalogue_case *entry, const char *folder, char **home,
                            struct mpm_error *error)
{
    *home = g_build_filename(folder, entry->file->name, NULL);
    enum mpm_status status = check_home(*home, entry->file->name, error);
    if (status == MPM_OK && mpm_folder_make(*home) != 0)
        status = failure_set(error, MPM_ENVIRONMENT_FAILED, "%s: cannot be made: %s", *home,
                             g_strerror(errno));
    if (status == MPM_OK)
        status = mark_unfinished(*home, entry, error);
    if (status != MPM_OK) {
        g_free(*home);
        *home = NULL;
    }
    return status;
}

enum mpm_status bundle_describe(const char *home, const char *words, const json_t *json,
                                struct mpm_error *error)
{
    char *dump = json_dumps(json, JSON_INDENT(2) | JSON_PRESERVE_ORDER | JSON_REAL_PRECISION(15));
    char *text = g_strconcat(dump, "\n", NULL);
    enum mpm_status status = output_write(home, "problem.md", words, error);
    if (status == MPM_OK)
        status = output_write(home, "problem.json", text, error);
    g_free(text);
    free(dump);
    return status;
}
