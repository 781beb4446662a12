/* D8, C12: what a part of a scene, a crack or contact between its bodies, adds to a step: how many
 * particles have additional fields, at how many points bodies meet, and how much time it takes.
 *
 * The same scene with and without that part takes turns, a few steps each, so that whatever
 * else the machine does meets both alike; processor time, not time of day, and the median of the
 * rounds' ratios: single rounds that were disturbed do not count. A turn begins with a step that is
 * not timed: it brings the model's data into the caches, which have the other one's.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/programs/follow.h"

#include <math.h>
#include <stdlib.h>
#include <time.h>

enum { PLAIN, ADDED, MODELS, ROUNDS_MAX = 1000, STEPS_MAX = 1000 };

struct model {
    struct mpm_scene *scene;
    struct mpm_simulation *simulation;
};

struct study {
    struct model models[MODELS];
    unsigned rounds, steps;
    double seconds[MODELS]; /* in all */
    double *ratios;         /* per round */
    struct follow_rows rows;
};

static double seconds_now(void)
{
    struct timespec now;
    (void)clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static enum mpm_status open_model(struct measurement *m, const char *setting, struct model *model,
                                  struct mpm_error *error)
{
    struct mpm_simulation_options options = *measurement_options(m);
    options.threads = 1;
    TRY(measurement_scene(m, &setting, setting == NULL ? 0 : 1, &model->scene, error));
    return mpm_simulation_create(model->scene, &options, &model->simulation, error);
}

static enum mpm_status advance(struct study *study, int k, double *seconds, struct mpm_error *error)
{
    TRY(mpm_simulation_advance(study->models[k].simulation, HUGE_VAL, error));
    const double start = seconds_now();
    for (unsigned step = 0; step < study->steps; step++)
        TRY(mpm_simulation_advance(study->models[k].simulation, HUGE_VAL, error));
    *seconds = seconds_now() - start;
    study->seconds[k] += *seconds;
    return MPM_OK;
}

static int by_size(const void *one, const void *other)
{
    const double a = *(const double *)one, b = *(const double *)other;
    return (a > b) - (a < b);
}

static enum mpm_status take_rounds(struct study *study, struct mpm_error *error)
{
    double seconds[MODELS];
    for (int k = 0; k < MODELS; k++) /* not counted: memory touched for the first time */
        TRY(advance(study, k, &seconds[k], error));
    study->seconds[PLAIN] = study->seconds[ADDED] = 0.0;
    for (unsigned round = 0; round < study->rounds; round++) {
        for (int turn = 0; turn < MODELS; turn++) {
            const int k = round % 2 == 0 ? turn : MODELS - 1 - turn;
            TRY(advance(study, k, &seconds[k], error));
        }
        study->ratios[round] = seconds[ADDED] / seconds[PLAIN];
        follow_rows_add(&study->rows, (const double[]){(double)(round + 1), study->ratios[round]});
    }
    return MPM_OK;
}

static enum mpm_status report(struct study *study, struct measurement *m, struct mpm_error *error)
{
    const double particles = (double)mpm_simulation_particle_count(study->models[PLAIN].simulation);
    const double work = particles * (double)study->rounds * (double)study->steps;
    qsort(study->ratios, study->rounds, sizeof *study->ratios, by_size);
    const double beside = (double)mpm_simulation_field_particles(study->models[ADDED].simulation);
    measurement_report(m, "particles", particles);
    measurement_report(m, "field_particles", beside);
    measurement_report(m, "field_share", 100.0 * beside / particles);
    measurement_report(m, "contact_points",
                       (double)mpm_simulation_contact_point_count(study->models[ADDED].simulation));
    measurement_report(m, "time_ratio", study->ratios[study->rounds / 2]);
    measurement_report(m, "ratio_lower_quarter", study->ratios[study->rounds / 4]);
    measurement_report(m, "ratio_upper_quarter",
                       study->ratios[study->rounds - 1 - study->rounds / 4]);
    measurement_report(m, "plain_nanoseconds", 1e9 * study->seconds[PLAIN] / work);
    measurement_report(m, "added_nanoseconds", 1e9 * study->seconds[ADDED] / work);
    for (int k = 0; k < MODELS; k++)
        follow_count_work(m, study->models[k].simulation);
    TRY(follow_rows_check(&study->rows, error));
    return measurement_series(m, "rounds", "round ratio", study->rows.columns, study->rows.count,
                              study->rows.values, error);
}

static enum mpm_status run(struct measurement *measurement, struct mpm_error *error)
{
    struct study study = {.rows = {.columns = 2}};
    const char *added;
    if (measurement_options(measurement)->kernels == MPM_KERNELS_REFERENCE) {
        measurement_skip(measurement, "all particles take the reference kernels");
        return MPM_OK;
    }
    TRY(measurement_text(measurement, "added", &added, error));
    TRY(measurement_count(measurement, "rounds", 4, ROUNDS_MAX, &study.rounds, error));
    TRY(measurement_count(measurement, "steps", 1, STEPS_MAX, &study.steps, error));
    study.ratios = calloc(study.rounds, sizeof *study.ratios);
    enum mpm_status status =
        study.ratios != NULL
            ? open_model(measurement, NULL, &study.models[PLAIN], error)
            : failure_set(error, MPM_ENVIRONMENT_FAILED, "out of memory for the rounds");
    if (status == MPM_OK)
        status = open_model(measurement, added, &study.models[ADDED], error);
    if (status == MPM_OK)
        status = take_rounds(&study, error);
    if (status == MPM_OK)
        status = report(&study, measurement, error);
    for (int k = 0; k < MODELS; k++) {
        mpm_simulation_free(study.models[k].simulation);
        mpm_scene_free(study.models[k].scene);
    }
    follow_rows_free(&study.rows);
    free(study.ratios);
    return status;
}

const struct measure_program program_overhead = {
    .name = "overhead",
    .summary = "processor time of the same scene with and without a part of it, in turns",
    .run = run,
};
