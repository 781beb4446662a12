/* The plan of a run.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/suite/plan.h"

#include "verification/common/failure.h"
#include "verification/common/input.h"
#include "verification/common/names.h"

#include "mpm_words.h"

enum mpm_status plan_read_only(const char *path, GHashTable **only, struct mpm_error *error)
{
    char *text = NULL;
    *only = NULL;
    struct mpm_error own = {.status = MPM_OK};
    if (input_text(path, "a file of lines CASE/VARIANT", &text, NULL, &own) != MPM_OK)
        return failure_set(error, own.status, "--only: %s", own.message);
    char **lines = g_strsplit(text, "\n", -1);
    GHashTable *const pairs = g_hash_table_new_full(g_str_hash, g_str_equal, g_free, NULL);
    for (char **line = lines; *line != NULL; line++)
        if (*g_strstrip(*line) != '\0')
            g_hash_table_add(pairs, g_strdup(*line));
    g_strfreev(lines);
    g_free(text);
    if (g_hash_table_size(pairs) == 0) {
        g_hash_table_unref(pairs);
        return failure_set(error, MPM_BAD_INPUT, "--only: %s is empty; allowed: lines CASE/VARIANT",
                           path);
    }
    *only = pairs;
    return MPM_OK;
}

/* Offers a name to the search for what a pattern means; true if the pattern matches it. */
static bool offer(struct mpm_nearest *nearest, const char *name)
{
    mpm_nearest_offer(nearest, name);
    return glob_matches(nearest->word, name);
}

static enum mpm_status check_case_glob(const struct catalogue *catalogue, const char *glob,
                                       struct mpm_error *error)
{
    struct mpm_nearest nearest = {.word = glob};
    char hint[MPM_HINT_SIZE];
    for (size_t c = 0; c < catalogue->count; c++)
        if (offer(&nearest, catalogue->cases[c].file->name))
            return MPM_OK;
    return failure_set(error, MPM_BAD_INPUT, "--case \"%s\" matches no case%s; see mpm-verify list",
                       glob, mpm_nearest_hint(&nearest, hint));
}

static enum mpm_status check_variant_glob(const struct catalogue *catalogue, const char *glob,
                                          const char *case_globs, struct mpm_error *error)
{
    struct mpm_nearest nearest = {.word = glob};
    char hint[MPM_HINT_SIZE];
    for (size_t c = 0; c < catalogue->count; c++) {
        const struct case_file *const file = catalogue->cases[c].file;
        if (!glob_list_matches(case_globs, file->name))
            continue;
        for (unsigned v = 0; v < file->variants_count; v++)
            if (offer(&nearest, file->variants[v].name))
                return MPM_OK;
    }
    return failure_set(error, MPM_BAD_INPUT,
                       "--variant \"%s\" matches no variant of the cases%s; see mpm-verify list",
                       glob, mpm_nearest_hint(&nearest, hint));
}

enum mpm_status plan_check_globs(const struct catalogue *catalogue, const char *case_globs,
                                 const char *variant_globs, struct mpm_error *error)
{
    enum mpm_status status = MPM_OK;
    char **const cases = g_strsplit(case_globs == NULL ? "" : case_globs, ",", -1);
    char **const variants = g_strsplit(variant_globs == NULL ? "" : variant_globs, ",", -1);
    for (char **glob = cases; status == MPM_OK && *glob != NULL; glob++)
        status = check_case_glob(catalogue, *glob, error);
    for (char **glob = variants; status == MPM_OK && *glob != NULL; glob++)
        status = check_variant_glob(catalogue, *glob, case_globs, error);
    g_strfreev(cases);
    g_strfreev(variants);
    return status;
}

static bool is_selected(const struct plan_selection *selection, const struct catalogue_case *entry,
                        const struct case_variant *variant)
{
    if (variant->tier > selection->tier ||
        !glob_list_matches(selection->variant_globs, variant->name))
        return false;
    if (selection->only == NULL)
        return true;
    char *const pair = g_strconcat(entry->file->name, "/", variant->name, NULL);
    const bool listed = g_hash_table_contains(selection->only, pair);
    g_free(pair);
    return listed;
}

static void plan_variant(const struct catalogue_case *entry, const struct case_variant *variant,
                         GArray *jobs, GArray *checks)
{
    const struct planned_job job = {.entry = entry, .variant = variant};
    const size_t before = checks->len;
    for (unsigned i = 0; i < entry->file->checks_count; i++) {
        const struct case_check *check = &entry->file->checks[i];
        const struct planned_check planned = {jobs->len, check};
        if (globs_match(check->variants, check->variants_count, variant->name))
            g_array_append_val(checks, planned);
    }
    /* A variant without checks runs for its data files if a figure needs them; a method and a
     * row of a comparison, for their numbers. */
    bool needed = checks->len > before || variant->method != NULL ||
                  comparison_has_variant(entry->file->comparison, variant->name);
    for (unsigned i = 0; i < entry->file->figures_count; i++)
        needed = needed || globs_match(entry->file->figures[i].needs,
                                       entry->file->figures[i].needs_count, variant->name);
    if (needed)
        g_array_append_val(jobs, job);
}

enum mpm_status plan_make(const struct catalogue *catalogue, const struct plan_selection *selection,
                          struct plan *plan, struct mpm_error *error)
{
    *plan = (struct plan){.jobs = NULL};
    TRY(plan_check_globs(catalogue, selection->case_globs, selection->variant_globs, error));
    GArray *jobs = g_array_new(FALSE, FALSE, sizeof(struct planned_job));
    GArray *checks = g_array_new(FALSE, FALSE, sizeof(struct planned_check));
    for (size_t c = 0; c < catalogue->count; c++) {
        const struct catalogue_case *entry = &catalogue->cases[c];
        if (!glob_list_matches(selection->case_globs, entry->file->name))
            continue;
        for (unsigned v = 0; v < entry->file->variants_count; v++) {
            const struct case_variant *variant = &entry->file->variants[v];
            if (is_selected(selection, entry, variant))
                plan_variant(entry, variant, jobs, checks);
        }
    }
    plan->job_count = jobs->len;
    plan->check_count = checks->len;
    plan->jobs = (struct planned_job *)(void *)g_array_free(jobs, FALSE);
    plan->checks = (struct planned_check *)(void *)g_array_free(checks, FALSE);
    if (plan->check_count > 0)
        return MPM_OK;
    plan_clear(plan);
    return failure_set(error, MPM_BAD_INPUT,
                       "no check matches --tier %s --case \"%s\" --variant \"%s\"%s; see "
                       "mpm-verify list",
                       tier_name(selection->tier),
                       selection->case_globs == NULL ? "*" : selection->case_globs,
                       selection->variant_globs == NULL ? "*" : selection->variant_globs,
                       selection->only == NULL ? "" : " and the list --only");
}

enum mpm_status plan_check_methods(const struct plan *plan, struct mpm_error *error)
{
    for (size_t i = 0; i < plan->job_count; i++) {
        const struct case_variant *variant = plan->jobs[i].variant;
        struct mpm_scene *scene = NULL;
        struct mpm_error cause = {.status = MPM_OK};
        if (variant->method == NULL)
            continue;
        const enum mpm_status status =
            mpm_scene_read(plan->jobs[i].entry->scene_path, (const char *const *)variant->settings,
                           variant->settings_count, &scene, &cause);
        mpm_scene_free(scene);
        if (status != MPM_OK)
            return failure_set(error, status, "case %s: the scene refuses method %s: %s",
                               plan->jobs[i].entry->file->name, variant->name, cause.message);
    }
    return MPM_OK;
}

void plan_clear(struct plan *plan)
{
    for (size_t i = 0; i < plan->job_count; i++)
        g_free(plan->jobs[i].unfinished);
    g_free(plan->jobs);
    g_free(plan->checks);
    *plan = (struct plan){.jobs = NULL};
}
