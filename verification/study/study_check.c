/* The rules of a study.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "mpm_expression.h"
#include "verification/common/names.h"
#include "verification/programs/study_measure.h"
#include "verification/study/study_scene.h"

#include <stdlib.h>
#include <string.h>

static const char default_timeout[] = "3600";

static enum mpm_status check_refine(const struct study *study, struct mpm_error *error)
{
    if (study->refine_count == 0)
        return failure_set(error, MPM_BAD_INPUT,
                           "refine: is empty or missing: allowed are up to %d whole numbers from 1 "
                           "on that rise, as in --refine 1,2,4",
                           STUDY_LEVELS_MAX);
    if (study->refine_count > STUDY_LEVELS_MAX)
        return failure_set(error, MPM_BAD_INPUT, "refine: %u levels: allowed are up to %d",
                           study->refine_count, STUDY_LEVELS_MAX);
    for (unsigned i = 0; i < study->refine_count; i++)
        if (study->refine[i] < 1 || (i > 0 && study->refine[i] <= study->refine[i - 1]))
            return failure_set(error, MPM_BAD_INPUT,
                               "refine: %" PRId64 ": allowed are whole numbers from 1 on that rise",
                               study->refine[i]);
    return MPM_OK;
}

static enum mpm_status check_settings(const struct study *study, struct mpm_error *error)
{
    for (unsigned i = 0; i < study->settings_count; i++)
        if (strchr(study->settings[i], '=') == NULL)
            return failure_set(error, MPM_BAD_INPUT, "setting \"%s\": allowed is PATH=VALUE",
                               study->settings[i]);
    for (unsigned i = 0; i < study->vary_count; i++) {
        const struct study_vary *vary = &study->vary[i];
        if (strcmp(vary->path, "grid.refine") == 0)
            return failure_set(error, MPM_BAD_INPUT,
                               "vary: grid.refine is what refine multiplies: allowed are the other "
                               "paths of the scene");
        for (unsigned k = 0; k < i; k++)
            if (strcmp(vary->path, study->vary[k].path) == 0)
                return failure_set(error, MPM_BAD_INPUT, "vary: %s is given twice", vary->path);
        for (unsigned k = 0; k < vary->values_count; k++) {
            if (*vary->values[k] == '\0')
                return failure_set(error, MPM_BAD_INPUT, "vary: %s: value %u is empty", vary->path,
                                   k + 1);
            for (unsigned j = 0; j < k; j++)
                if (strcmp(vary->values[k], vary->values[j]) == 0)
                    return failure_set(error, MPM_BAD_INPUT, "vary: %s: %s is given twice",
                                       vary->path, vary->values[k]);
        }
    }
    return MPM_OK;
}

/* -------------------------------------------------------------------- measures */

static enum mpm_status check_take(struct study_entry *entry, struct mpm_error *error)
{
    const bool field = field_quantity_find(entry->quantity) != NULL;
    if (entry->take_text == NULL && !field)
        entry->take_text = g_strdup(take_name(TAKE_LAST));
    if (entry->take_text == NULL || !take_find(entry->take_text, &entry->take) ||
        (field && entry->take == TAKE_LAST))
        return failure_set(error, MPM_BAD_INPUT,
                           "measure of %s: take \"%s\": allowed are %s (last of history.csv alone)",
                           entry->quantity, entry->take_text == NULL ? "" : entry->take_text,
                           take_names());
    const bool needs_time = entry->take == TAKE_AT && !field;
    const bool needs_place = entry->take == TAKE_AT && field;
    if (needs_time != (entry->instant_text != NULL) || needs_place != (entry->at_text[0] != NULL))
        return failure_set(error, MPM_BAD_INPUT, "measure of %s, take %s: allowed is %s",
                           entry->quantity, entry->take_text,
                           needs_time    ? "a time and no place, as in energy:at@0.5"
                           : needs_place ? "a place and no time, as in velocity_x:at@3,4"
                                         : "neither a place nor a time");
    return MPM_OK;
}

static enum mpm_status check_reference(const struct study *study, struct study_entry *entry,
                                       struct mpm_error *error)
{
    const char *text = entry->reference;
    struct study_reference reference;
    struct mpm_error cause;
    entry->against = AGAINST_RICHARDSON;
    if (text != NULL && strcmp(text, "finest") == 0)
        entry->against = AGAINST_FINEST;
    else if (text != NULL && mpm_number_parse(text, &entry->number) && !take_is_norm(entry->take))
        entry->against = AGAINST_NUMBER;
    else if (text != NULL && strcmp(text, "richardson") != 0)
        entry->against = AGAINST_EVALUATED;
    if (take_is_norm(entry->take) != (entry->against == AGAINST_EVALUATED) &&
        take_is_norm(entry->take))
        return failure_set(error, MPM_BAD_INPUT,
                           "measure of %s, take %s: is a norm of the error: allowed is a reference "
                           "that is an expression of %s and t, or a file *.csv",
                           entry->quantity, entry->take_text,
                           study->axisymmetric ? "r, z" : "x, y");
    if (entry->against != AGAINST_EVALUATED)
        return MPM_OK;
    const enum mpm_status status =
        study_reference_open(text, study->axisymmetric, &reference, &cause);
    study_reference_close(&reference);
    return status == MPM_OK ? MPM_OK
                            : failure_set(error, status, "measure of %s: reference \"%s\": %s",
                                          entry->quantity, text, cause.message);
}

static enum mpm_status check_entry(struct study *study, unsigned k, struct mpm_error *error)
{
    struct study_entry *const entry = &study->measures[k];
    TRY(check_take(entry, error));
    TRY(check_reference(study, entry, error));
    if (entry->name == NULL)
        entry->name = g_strconcat(entry->quantity, "_", entry->take_text, NULL);
    if (!name_is_sound(entry->name))
        return failure_set(error, MPM_BAD_INPUT, "measure \"%s\": %s", entry->name, name_rule);
    for (unsigned i = 0; i < k; i++)
        if (strcmp(entry->name, study->measures[i].name) == 0)
            return failure_set(error, MPM_BAD_INPUT,
                               "measure \"%s\" is there twice: give one of them another name in a "
                               "study file (measure: NAME)",
                               entry->name);
    for (unsigned i = 0; i < 2 && entry->order_text[0] != NULL; i++)
        entry->order[i] = g_ascii_strtod(entry->order_text[i], NULL);
    if (entry->order_text[0] != NULL && !(entry->order[0] < entry->order[1]))
        return failure_set(error, MPM_BAD_INPUT,
                           "measure \"%s\": order: allowed are two numbers that rise", entry->name);
    return MPM_OK;
}

static enum mpm_status check_measures(struct study *study, struct mpm_error *error)
{
    if (study->measures_count == 0 || study->measures_count > STUDY_MEASURES_MAX)
        return failure_set(error, MPM_BAD_INPUT,
                           "measures: %u are given: allowed are 1 to %d, as in --measure "
                           "strain_energy:max",
                           study->measures_count, STUDY_MEASURES_MAX);
    for (unsigned k = 0; k < study->measures_count; k++)
        TRY(check_entry(study, k, error));
    return MPM_OK;
}

/* ------------------------------------------------------------------------ runs */

/* The time of a measure has to be in the run. */
static enum mpm_status check_times(const struct study *study, const struct mpm_scene *scene,
                                   struct mpm_error *error)
{
    const double end = mpm_scene_end_time(scene);
    for (unsigned k = 0; k < study->measures_count; k++) {
        const struct study_entry *entry = &study->measures[k];
        const double time =
            entry->instant_text == NULL ? 0.0 : g_ascii_strtod(entry->instant_text, NULL);
        if (!(time >= 0.0 && time <= end))
            return failure_set(error, MPM_BAD_INPUT,
                               "measure \"%s\": time %s: allowed are 0 to time.end = %g",
                               entry->name, entry->instant_text, end);
    }
    return MPM_OK;
}

static enum mpm_status check_run(struct study *study, const struct study_run *run, bool first,
                                 struct mpm_error *error)
{
    struct mpm_scene *scene;
    TRY(mpm_scene_read(study->scene, (const char *const *)run->settings,
                       g_strv_length(run->settings), &scene, error));
    const enum mpm_status status = check_times(study, scene, error);
    mpm_scene_free(scene);
    TRY(status);
    return first ? study_scene_try(study, run, error) : MPM_OK;
}

static enum mpm_status check_runs(struct study *study, struct mpm_error *error)
{
    GArray *runs;
    TRY(study_runs(study, &runs, error));
    enum mpm_status status = MPM_OK;
    for (unsigned i = 0; status == MPM_OK && i < runs->len; i++) {
        const struct study_run *run = &g_array_index(runs, struct study_run, i);
        struct mpm_error cause;
        status = check_run(study, run, i % study->refine_count == 0, &cause);
        if (status != MPM_OK)
            failure_set(error, status, "%s%srefined by %" PRId64 ": %s", run->variant,
                        *run->variant == '\0' ? "" : ", ", run->level, cause.message);
    }
    g_array_unref(runs);
    return status;
}

enum mpm_status study_complete(struct study *study, struct mpm_error *error)
{
    TRY(check_refine(study, error));
    if (study->timeout_text == NULL)
        study->timeout_text = g_strdup(default_timeout);
    if (!mpm_number_parse(study->timeout_text, &study->timeout) || !(study->timeout > 0.0))
        return failure_set(error, MPM_BAD_INPUT, "timeout \"%s\": allowed are seconds above 0",
                           study->timeout_text);
    TRY(study_scene_open(study, error));
    TRY(check_settings(study, error));
    return check_measures(study, error);
}

enum mpm_status study_check(struct study *study, struct mpm_error *error)
{
    TRY(study_complete(study, error));
    return check_runs(study, error);
}
