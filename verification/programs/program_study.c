/* A run of a user's convergence study (mpm-verify study): the scene as `mpm run` runs it, and
 * numbers taken of its history.csv and of its particles at the end.
 *
 * Parameters: `measures`, how many; of each, with its number from 1 on as suffix, `quantity`,
 * `take`, `at` (for take at: a place or a time), `reference` (optional: a formula, or a file *.csv
 * of the case's folder), `axisymmetric` (0, 1) and `folder`, that of the references. Reports
 * measure_<k>, reference_<k> where there is one, and completed. A scene with checkpoints goes on
 * from the last one if the process before was killed; processor time is then that of the last
 * process.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "mpm_file.h"
#include "mpm_yaml.h"
#include "verification/common/folders.h"
#include "verification/programs/programs.h"
#include "verification/programs/study_measure.h"

#include <math.h>
#include <string.h>

enum { MEASURES_MAX = 64 };

struct study {
    struct measurement *measurement;
    struct study_measure measures[MEASURES_MAX];
    struct study_number numbers[MEASURES_MAX];
    unsigned count;
    struct study_particles start;
    double end;
    bool ended; /* numbers of fields are there */
    uint64_t particle_steps;
};

static enum mpm_status text_of(const struct measurement *m, const char *name, unsigned k,
                               const char **text, struct mpm_error *error)
{
    char key[32];
    g_snprintf(key, sizeof key, "%s_%u", name, k + 1);
    *text = NULL;
    return measurement_has(m, key) || strcmp(name, "quantity") == 0 || strcmp(name, "take") == 0
               ? measurement_text(m, key, text, error)
               : MPM_OK;
}

static enum mpm_status read_measure(struct study *study, unsigned k, bool axisymmetric,
                                    struct mpm_error *error)
{
    const struct measurement *const m = study->measurement;
    struct study_measure *const measure = &study->measures[k];
    const char *take, *reference, *at;
    TRY(text_of(m, "quantity", k, &measure->quantity, error));
    TRY(text_of(m, "take", k, &take, error));
    TRY(text_of(m, "at", k, &at, error));
    TRY(text_of(m, "reference", k, &reference, error));
    measure->field = field_quantity_find(measure->quantity);
    if (!take_find(take, &measure->take))
        return failure_set(error, MPM_BAD_INPUT, "take \"%s\": allowed are %s", take, take_names());
    if (at != NULL) {
        char key[32];
        size_t count;
        g_snprintf(key, sizeof key, "at_%u", k + 1);
        TRY(measurement_list(m, key, 2, measure->at, &count, error));
    }
    if (reference == NULL)
        return MPM_OK;
    const bool file = g_str_has_suffix(reference, ".csv");
    const char *folder = NULL;
    if (file)
        TRY(measurement_text(m, "folder", &folder, error));
    char *text = file ? g_build_filename(folder, reference, NULL) : g_strdup(reference);
    const enum mpm_status status =
        study_reference_open(text, axisymmetric, &measure->reference, error);
    g_free(text);
    return status;
}

static enum mpm_status read_measures(struct study *study, struct mpm_error *error)
{
    unsigned axisymmetric;
    TRY(measurement_count(study->measurement, "measures", 1, MEASURES_MAX, &study->count, error));
    TRY(measurement_count(study->measurement, "axisymmetric", 0, 1, &axisymmetric, error));
    for (unsigned k = 0; k < study->count; k++)
        TRY(read_measure(study, k, axisymmetric == 1, error));
    return MPM_OK;
}

/* A simulation for a moment: a run gives its particles after the first step only. It
 * has no monitor, so that pictures are of the run. */
static enum mpm_status read_start(struct study *study, const struct mpm_scene *scene,
                                  struct mpm_error *error)
{
    struct mpm_simulation_options options = *measurement_options(study->measurement);
    struct mpm_simulation *simulation;
    options.monitor = NULL;
    TRY(mpm_simulation_create(scene, &options, &simulation, error));
    const size_t count = mpm_simulation_particle_count(simulation);
    double *mass = g_new(double, count);
    study->start = (struct study_particles){count, g_new(double, 2 * count), g_new(double, count)};
    mpm_simulation_field(simulation, MPM_FIELD_POSITION, study->start.position);
    mpm_simulation_field(simulation, MPM_FIELD_VOLUME, study->start.weight);
    mpm_simulation_field(simulation, MPM_FIELD_MASS, mass);
    for (size_t p = 0; p < count; p++)
        if (!(mass[p] > 0.0))
            study->start.weight[p] = 0.0;
    g_free(mass);
    mpm_simulation_free(simulation);
    return MPM_OK;
}

static void after_step(void *context, double fraction, const struct mpm_simulation *simulation)
{
    struct study *const study = context;
    struct mpm_rest rest;
    (void)fraction;
    study->particle_steps = mpm_simulation_step(simulation) * study->start.count;
    study->ended =
        mpm_simulation_time(simulation) >= study->end || mpm_simulation_at_rest(simulation, &rest);
    for (unsigned k = 0; study->ended && k < study->count; k++)
        if (study->measures[k].field != NULL)
            study->numbers[k] = study_measure_field(&study->measures[k], &study->start, simulation);
}

static void note_warning(void *context, const char *warning)
{
    const struct study *const study = context;
    measurement_note(study->measurement, "%s", warning);
}

static enum mpm_status take_history(struct study *study, const char *folder,
                                    struct mpm_error *error)
{
    struct table_named history;
    char *path = g_build_filename(folder, "history.csv", NULL);
    enum mpm_status status = table_named_read(path, &history, error);
    for (unsigned k = 0; status == MPM_OK && k < study->count; k++)
        if (study->measures[k].field == NULL)
            status =
                study_measure_history(&study->measures[k], &history, &study->numbers[k], error);
    table_named_clear(&history);
    g_free(path);
    return status;
}

static void report_number(struct study *study, const char *name, unsigned k, double value)
{
    char quantity[32];
    g_snprintf(quantity, sizeof quantity, "%s_%u", name, k + 1);
    if (isfinite(value))
        measurement_report(study->measurement, quantity, value);
    else
        measurement_inconclusive(study->measurement, quantity,
                                 "%s: is not finite, or its place or instant is outside of the "
                                 "body, the run or the reference",
                                 study->measures[k].quantity);
}

static void report(struct study *study)
{
    for (unsigned k = 0; k < study->count; k++) {
        const struct study_measure *const measure = &study->measures[k];
        report_number(study, "measure", k, study->numbers[k].value);
        if (study_reference_given(&measure->reference) && !take_is_norm(measure->take))
            report_number(study, "reference", k, study->numbers[k].reference);
    }
    measurement_report(study->measurement, "completed", 1.0);
}

static enum mpm_status run_scene(struct study *study, const struct mpm_scene *scene,
                                 const char *folder, bool resume, struct mpm_error *error)
{
    const struct mpm_run_options options = {.output = folder,
                                            .simulation = *measurement_options(study->measurement),
                                            .overwrite = !resume,
                                            .resume = resume,
                                            .progress = after_step,
                                            .warn = note_warning,
                                            .progress_context = study};
    const enum mpm_status status = mpm_scene_run(scene, &options, error);
    measurement_work(study->measurement, study->particle_steps);
    TRY(status);
    if (!study->ended)
        return failure_set(error, MPM_RUN_FAILED, "the run did not come to time.end = %g",
                           study->end);
    TRY(take_history(study, folder, error));
    report(study);
    return MPM_OK;
}

static enum mpm_status run_in_temporary(struct study *study, const struct mpm_scene *scene,
                                        struct mpm_error *error)
{
    char *folder;
    TRY(mpm_folder_make_temporary(&folder, error));
    const enum mpm_status status = run_scene(study, scene, folder, false, error);
    (void)mpm_folder_remove_all(folder, NULL);
    g_free(folder);
    return status;
}

/* ------------------------------------------------------------------------ going on */

static bool is_given(const struct mpm_tree_node *root, const char *path)
{
    const struct mpm_tree_node *const node = mpm_tree_find(root, path, NULL);
    double value;
    return node != NULL && node->kind == MPM_TREE_SCALAR && mpm_number_parse(node->text, &value);
}

static enum mpm_status has_checkpoints(const struct mpm_scene *scene, bool *has,
                                       struct mpm_error *error)
{
    struct mpm_tree_node *root;
    TRY(mpm_scene_tree(scene, &root, error));
    *has = is_given(root, "output.checkpoint") || is_given(root, "output.checkpoint_seconds");
    mpm_tree_free(root);
    return MPM_OK;
}

/* In the folder that outlives this process, from its checkpoint if there is one. A checkpoint that
 * cannot be taken, or a process that still runs there, is no failure: the run begins again apart.
 */
static enum mpm_status run_where_others_go_on(struct study *study, const struct mpm_scene *scene,
                                              struct mpm_error *error)
{
    static const char *const names[] = {"checkpoint.h5", "checkpoint-previous.h5"};
    const char *const folder = measurement_unfinished(study->measurement);
    bool begun = false;
    for (size_t i = 0; i < G_N_ELEMENTS(names); i++) {
        char *path = g_build_filename(folder, names[i], NULL);
        begun = begun || mpm_path_kind(path) != MPM_PATH_NONE;
        g_free(path);
    }
    TRY(folder_make(folder, error));
    const enum mpm_status status = run_scene(study, scene, folder, begun, error);
    if (status == MPM_BAD_INPUT)
        return run_in_temporary(study, scene, error);
    if (status == MPM_OK || status == MPM_RUN_FAILED)
        (void)mpm_folder_remove_all(folder, NULL);
    return status;
}

static enum mpm_status run_in_folder(struct study *study, struct mpm_error *error)
{
    struct mpm_scene *scene;
    bool lasting = false;
    TRY(measurement_scene(study->measurement, NULL, 0, &scene, error));
    study->end = mpm_scene_end_time(scene);
    enum mpm_status status = has_checkpoints(scene, &lasting, error);
    if (status == MPM_OK)
        status = read_start(study, scene, error);
    if (status == MPM_OK && lasting && measurement_unfinished(study->measurement) != NULL)
        status = run_where_others_go_on(study, scene, error);
    else if (status == MPM_OK)
        status = run_in_temporary(study, scene, error);
    mpm_scene_free(scene);
    return status;
}

static enum mpm_status run(struct measurement *measurement, struct mpm_error *error)
{
    struct study *study = g_new0(struct study, 1);
    study->measurement = measurement;
    enum mpm_status status = read_measures(study, error);
    if (status == MPM_OK)
        status = run_in_folder(study, error);
    for (unsigned k = 0; k < MEASURES_MAX; k++)
        study_reference_close(&study->measures[k].reference);
    g_free(study->start.position);
    g_free(study->start.weight);
    g_free(study);
    return status;
}

const struct measure_program program_study = {
    .name = "study",
    .summary = "a run of a user's scene, and numbers taken of it",
    .run = run,
};
