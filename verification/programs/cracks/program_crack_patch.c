/* D1: the crack patch test, CRAMP 3.1. A specimen whose crack lies on its plane of symmetry, and
 * half of it with that plane as a condition and no crack algorithm needed: step by step, are they
 * the same?
 *
 * Particles of the whole that lie in the half are compared with those of the half, all fields, at
 * each sample. A difference is divided by the largest value of that field in the half model so far.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/measures/fields.h"
#include "verification/programs/follow.h"
#include "verification/programs/picture.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Fields that are compared; positions as displacements, whose scale is that of the motion. */
static const struct {
    enum mpm_field field;
    const char *quantity;
} FIELDS[] = {
    {MPM_FIELD_POSITION, "displacement_difference"},
    {MPM_FIELD_VELOCITY, "velocity_difference"},
    {MPM_FIELD_DEFORMATION_GRADIENT, "gradient_difference"},
    {MPM_FIELD_STRESS, "stress_difference"},
};
enum { FIELD_COUNT = sizeof FIELDS / sizeof *FIELDS, COLUMNS = 3 + FIELD_COUNT };

/* One field of one model. */
struct values {
    size_t particles, components;
    double *now, *start; /* start: what is taken off, or NULL */
};

struct model {
    struct mpm_scene *scene;
    struct mpm_simulation *simulation;
    struct values fields[FIELD_COUNT];
};

struct study {
    struct model whole, half;
    size_t first; /* particle of the whole that is the half's first */
    double largest[FIELD_COUNT], difference[FIELD_COUNT]; /* so far */
    double opening; /* mean displacement along y of the half's column at the loaded end, now */
    struct follow_rows rows;
};

/* ------------------------------------------------------------------- models */

static void read_fields(struct model *model)
{
    for (int k = 0; k < FIELD_COUNT; k++) {
        struct values *const values = &model->fields[k];
        mpm_simulation_field(model->simulation, FIELDS[k].field, values->now);
        for (size_t i = 0; values->start != NULL && i < values->particles * values->components; i++)
            values->now[i] -= values->start[i];
    }
}

static enum mpm_status create_fields(struct model *model, struct mpm_error *error)
{
    for (int k = 0; k < FIELD_COUNT; k++) {
        struct values *const values = &model->fields[k];
        const bool displacement = FIELDS[k].field == MPM_FIELD_POSITION;
        values->particles = mpm_simulation_particle_count(model->simulation);
        values->components = mpm_field_describe(FIELDS[k].field)->components;
        const size_t size = values->particles * values->components;
        values->now = calloc(size, sizeof *values->now);
        values->start = displacement ? calloc(size, sizeof *values->start) : NULL;
        if (values->now == NULL || (displacement && values->start == NULL))
            return failure_set(error, MPM_ENVIRONMENT_FAILED, "out of memory for fields");
        if (displacement)
            mpm_simulation_field(model->simulation, FIELDS[k].field, values->start);
    }
    return MPM_OK;
}

static enum mpm_status open_model(struct measurement *m, struct model *model,
                                  struct mpm_error *error)
{
    TRY(mpm_simulation_create(model->scene, measurement_options(m), &model->simulation, error));
    return create_fields(model, error);
}

static void close_model(struct model *model)
{
    for (int k = 0; k < FIELD_COUNT; k++) {
        free(model->fields[k].now);
        free(model->fields[k].start);
    }
    mpm_simulation_free(model->simulation);
    mpm_scene_free(model->scene);
}

/* The half's particles are the whole's last ones: bodies are filled row by row, upwards. */
static enum mpm_status match(struct study *study, struct mpm_error *error)
{
    const struct values *const whole = &study->whole.fields[0], *const half =
                                                                    &study->half.fields[0];
    const size_t size = half->particles * half->components;
    if (half->start == NULL || whole->start == NULL || half->particles > whole->particles)
        return failure_set(error, MPM_BAD_INPUT, "the half has more particles than the whole");
    study->first = whole->particles - half->particles;
    for (size_t i = 0; i < size; i++)
        if (whole->start[study->first * half->components + i] != half->start[i])
            return failure_set(error, MPM_BAD_INPUT,
                               "particle %zu of the half is not at a place of the whole",
                               i / half->components);
    return MPM_OK;
}

/* ------------------------------------------------------------------ looking */

static void compare(struct study *study, int k)
{
    const struct values *const half = &study->half.fields[k];
    const double *const whole =
        study->whole.fields[k].now + study->first * study->whole.fields[k].components;
    double difference = 0.0;
    for (size_t i = 0; i < half->particles * half->components; i++) {
        study->largest[k] = field_larger(study->largest[k], fabs(half->now[i]));
        difference = field_larger(difference, fabs(whole[i] - half->now[i]));
    }
    if (FIELDS[k].field == MPM_FIELD_DEFORMATION_GRADIENT)
        study->largest[k] = 1.0;
    if (study->largest[k] > 0.0)
        study->difference[k] = field_larger(study->difference[k], difference / study->largest[k]);
}

/* Of the particles with the smallest x at the start. */
static double opening_of(const struct values *displacement)
{
    double least = HUGE_VAL, sum = 0.0;
    size_t count = 0;
    for (size_t p = 0; p < displacement->particles; p++)
        least = fmin(least, displacement->start[2 * p]);
    for (size_t p = 0; p < displacement->particles; p++)
        if (displacement->start[2 * p] == least) {
            sum += displacement->now[2 * p + 1];
            count++;
        }
    return sum / (double)count;
}

static void look(struct study *study)
{
    double row[COLUMNS];
    read_fields(&study->whole);
    read_fields(&study->half);
    for (int k = 0; k < FIELD_COUNT; k++)
        compare(study, k);
    study->opening = opening_of(&study->half.fields[0]);
    row[0] = mpm_simulation_time(study->half.simulation);
    row[1] = (double)mpm_simulation_step(study->half.simulation);
    row[2] = study->opening;
    for (int k = 0; k < FIELD_COUNT; k++)
        row[3 + k] = study->difference[k];
    follow_rows_add(&study->rows, row);
}

static void report(const struct study *study, struct measurement *m, bool finished)
{
    measurement_report(m, "finished", finished ? 1.0 : 0.0);
    measurement_report(m, "opening", study->opening);
    measurement_note(m, "largest stress %.5g", study->largest[FIELD_COUNT - 1]);
    for (int k = 0; k < FIELD_COUNT; k++) {
        if (finished)
            measurement_report(m, FIELDS[k].quantity, study->difference[k]);
        else
            measurement_inconclusive(m, FIELDS[k].quantity, "a model did not reach its end");
    }
}

/* The first component of the stress of both, where the variant has a picture: CRAMP Fig. 1. */
static enum mpm_status draw(const struct study *study, struct measurement *m,
                            struct mpm_error *error)
{
    struct picture picture;
    bool asked;
    TRY(picture_read(m, &picture, &asked, error));
    if (!asked)
        return MPM_OK;
    TRY(picture_write(m, &picture, study->whole.simulation, MPM_FIELD_STRESS, 0, "whole", error));
    return picture_write(m, &picture, study->half.simulation, MPM_FIELD_STRESS, 0, "half", error);
}

static enum mpm_status follow(struct study *study, struct measurement *m, struct mpm_error *error)
{
    double interval;
    TRY(measurement_number(m, "interval", &interval, error));
    const double end = mpm_scene_end_time(study->half.scene);
    bool alive = true, whole_alive = true;
    study->rows.columns = COLUMNS;
    for (size_t k = 1; alive && whole_alive && (double)(k - 1) * interval < end; k++) {
        const double time = fmin(interval * (double)k, end);
        TRY(follow_to(m, study->whole.simulation, time, &whole_alive, error));
        TRY(follow_to(m, study->half.simulation, time, &alive, error));
        if (alive && whole_alive)
            look(study);
    }
    report(study, m, alive && whole_alive);
    follow_count_work(m, study->whole.simulation);
    follow_count_work(m, study->half.simulation);
    TRY(draw(study, m, error));
    if (study->rows.out_of_memory)
        return failure_set(error, MPM_ENVIRONMENT_FAILED, "out of memory for the curve");
    return measurement_series(m, "difference",
                              "time step opening displacement velocity gradient stress", COLUMNS,
                              study->rows.count, study->rows.values, error);
}

static enum mpm_status run(struct measurement *measurement, struct mpm_error *error)
{
    struct study study = {0};
    const char *half, *setting; /* of the whole alone */
    TRY(measurement_text(measurement, "half", &half, error));
    TRY(measurement_text(measurement, "whole", &setting, error));
    enum mpm_status status = measurement_scene(measurement, &setting, 1, &study.whole.scene, error);
    if (status == MPM_OK)
        status = measurement_scene_file(measurement, half, NULL, 0, &study.half.scene, error);
    if (status == MPM_OK)
        status = open_model(measurement, &study.whole, error);
    if (status == MPM_OK)
        status = open_model(measurement, &study.half, error);
    if (status == MPM_OK)
        status = match(&study, error);
    if (status == MPM_OK)
        status = follow(&study, measurement, error);
    follow_rows_free(&study.rows);
    close_model(&study.whole);
    close_model(&study.half);
    return status;
}

const struct measure_program program_crack_patch = {
    .name = "crack_patch",
    .summary = "a specimen with a crack on its plane of symmetry against half of it",
    .run = run,
};
