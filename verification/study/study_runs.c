/* The grid of a study's runs.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/study/study.h"

#include "verification/common/names.h"
#include "verification/study/study_scene.h"

#include <string.h>

static void run_clear(void *element)
{
    struct study_run *run = element;
    g_free(run->name);
    g_free(run->variant);
    g_strfreev(run->settings);
}

static size_t group_count(const struct study *study)
{
    size_t count = 1;
    for (unsigned i = 0; i < study->vary_count && count <= STUDY_RUNS_MAX; i++)
        count *= study->vary[i].values_count;
    return count;
}

/* Which value of the i-th path the group has; the last path changes fastest. */
static const char *value_of(const struct study *study, size_t group, unsigned i)
{
    size_t block = 1;
    for (unsigned k = i + 1; k < study->vary_count; k++)
        block *= study->vary[k].values_count;
    return study->vary[i].values[group / block % study->vary[i].values_count];
}

static char *variant_of(const struct study *study, size_t group)
{
    GString *text = g_string_new(NULL);
    for (unsigned i = 0; i < study->vary_count; i++)
        g_string_append_printf(text, "%s%s=%s", i == 0 ? "" : " ", study->vary[i].path,
                               value_of(study, group, i));
    return g_string_free(text, FALSE);
}

/* Of its values; a run keeps its name, and so its result, when values or levels are added. */
static char *group_name(const struct study *study, size_t group)
{
    GString *name = g_string_new(NULL);
    for (unsigned i = 0; i < study->vary_count; i++)
        g_string_append_printf(name, "%s-", value_of(study, group, i));
    for (char *c = name->str; *c != '\0'; c++)
        if (!g_ascii_isalnum(*c) && *c != '-' && *c != '_')
            *c = '_';
    return g_string_free(name, FALSE);
}

static bool name_is_taken(const GArray *runs, const char *name)
{
    for (unsigned i = 0; i < runs->len; i++)
        if (strcmp(g_array_index(runs, struct study_run, i).name, name) == 0)
            return true;
    return false;
}

static enum mpm_status add_run(const struct study *study, size_t group, int64_t level, GArray *runs,
                               struct mpm_error *error)
{
    GPtrArray *settings = g_ptr_array_new();
    struct study_run run = {.group = group, .level = level};
    for (unsigned i = 0; i < study->settings_count; i++)
        g_ptr_array_add(settings, g_strdup(study->settings[i]));
    for (unsigned i = 0; i < study->vary_count; i++)
        g_ptr_array_add(settings,
                        g_strconcat(study->vary[i].path, "=", value_of(study, group, i), NULL));
    const enum mpm_status status = study_scene_refine(study, level, settings, &run.cell, error);
    g_ptr_array_add(settings, NULL);
    run.settings = (char **)g_ptr_array_free(settings, FALSE);
    run.variant = variant_of(study, group);
    char *prefix = group_name(study, group);
    run.name = g_strdup_printf("%sr%" PRId64, prefix, level);
    for (size_t number = group + 1; !name_is_sound(run.name) || name_is_taken(runs, run.name);
         number += STUDY_RUNS_MAX) {
        g_free(run.name);
        run.name = g_strdup_printf("v%zu-r%" PRId64, number, level);
    }
    g_free(prefix);
    g_array_append_val(runs, run);
    return status;
}

enum mpm_status study_runs(const struct study *study, GArray **runs, struct mpm_error *error)
{
    const size_t groups = group_count(study);
    *runs = NULL;
    if (groups * study->refine_count > STUDY_RUNS_MAX)
        return failure_set(error, MPM_BAD_INPUT,
                           "the study has more than %d runs, levels times values of vary: allowed "
                           "are up to %d",
                           STUDY_RUNS_MAX, STUDY_RUNS_MAX);
    *runs = g_array_new(FALSE, FALSE, sizeof(struct study_run));
    g_array_set_clear_func(*runs, run_clear);
    enum mpm_status status = MPM_OK;
    for (size_t g = 0; status == MPM_OK && g < groups; g++)
        for (unsigned k = 0; status == MPM_OK && k < study->refine_count; k++)
            status = add_run(study, g, study->refine[k], *runs, error);
    if (status != MPM_OK) {
        g_array_unref(*runs);
        *runs = NULL;
    }
    return status;
}
