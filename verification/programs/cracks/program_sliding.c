/* D5: a block that gravity pulls along a crack. It slides with a = g (sin theta - mu cos theta), or
 * it does not slide, and then moves as it would without the crack.
 *
 * The block is body 1 of the scene, and its velocity and displacement are means over its mass. In a
 * scene in which it slides, the acceleration is the slope of the line through the velocities from
 * `start` on, by least squares. With `acceleration: 0` the scene `intact`, which has no crack,
 * runs beside, and the block's displacements in the two are compared. Along the crack is along x,
 * unless the parameter `tilt` turns it, in degrees counter clockwise: 90 is along z in axisymmetry.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/measures/fields.h"
#include "verification/measures/line_fit.h"
#include "verification/programs/follow.h"

#include <math.h>
#include <stdlib.h>

enum { BLOCK = 1, COLUMNS = 5 };

struct parameters {
    double acceleration; /* exact; 0: the block does not slide */
    double start;        /* from when on it is measured */
    double interval;     /* between two samples */
    double along[2];     /* unit vector along the crack */
};

/* One model, and the block's particles in it. */
struct model {
    struct mpm_scene *scene;
    struct mpm_simulation *simulation;
    size_t count;
    double *values;     /* scratch: 2 a particle of the model */
    double *mass;       /* 0 but in the block */
    double start[2];    /* its place */
    double velocity[2]; /* of the moment, along the crack and on the left of it; and so */
    double displacement[2];
};

/* Sums for a line through the velocities. */
struct study {
    struct parameters parameters;
    struct model cracked, intact; /* the second is empty if it slides */
    struct line_fit line;
    double slip, sink; /* largest so far, along and normal to the crack */
    double elastic;    /* displacement of the intact block along the crack, largest so far */
    struct follow_rows rows;
};

/* -------------------------------------------------------------------- model */

static void block_mean(const struct model *model, enum mpm_field field, double mean[2])
{
    double mass = 0.0;
    mean[0] = mean[1] = 0.0;
    mpm_simulation_field(model->simulation, field, model->values);
    for (size_t p = 0; p < model->count; p++) {
        mass += model->mass[p];
        for (int axis = 0; axis < 2; axis++)
            mean[axis] += model->mass[p] * model->values[2 * p + (size_t)axis];
    }
    for (int axis = 0; axis < 2; axis++)
        mean[axis] /= mass;
}

/* From the axes of the grid to those of the crack. */
static void turn(const double along[2], double vector[2])
{
    const double left = along[0] * vector[1] - along[1] * vector[0];
    vector[0] = along[0] * vector[0] + along[1] * vector[1];
    vector[1] = left;
}

static void read_block(struct model *model, const double along[2])
{
    block_mean(model, MPM_FIELD_VELOCITY, model->velocity);
    block_mean(model, MPM_FIELD_POSITION, model->displacement);
    for (int axis = 0; axis < 2; axis++)
        model->displacement[axis] -= model->start[axis];
    turn(along, model->velocity);
    turn(along, model->displacement);
}

static enum mpm_status open_model(const struct measurement *m, struct model *model,
                                  struct mpm_error *error)
{
    TRY(mpm_simulation_create(model->scene, measurement_options(m), &model->simulation, error));
    model->count = mpm_simulation_particle_count(model->simulation);
    model->values = calloc(2 * model->count, sizeof *model->values);
    model->mass = calloc(model->count, sizeof *model->mass);
    if (model->values == NULL || model->mass == NULL)
        return failure_set(error, MPM_ENVIRONMENT_FAILED, "out of memory for fields");
    mpm_simulation_field(model->simulation, MPM_FIELD_MASS, model->mass);
    mpm_simulation_field(model->simulation, MPM_FIELD_BODY, model->values);
    for (size_t p = 0; p < model->count; p++)
        if (model->values[p] != BLOCK)
            model->mass[p] = 0.0;
    block_mean(model, MPM_FIELD_POSITION, model->start);
    return MPM_OK;
}

static void close_model(struct model *model)
{
    free(model->values);
    free(model->mass);
    mpm_simulation_free(model->simulation);
    mpm_scene_free(model->scene);
}

/* ------------------------------------------------------------------ looking */

static void look(struct study *study)
{
    const double time = mpm_simulation_time(study->cracked.simulation);
    const double *const moved = study->cracked.displacement, *const other =
                                                                 study->intact.displacement;
    read_block(&study->cracked, study->parameters.along);
    if (study->intact.simulation != NULL)
        read_block(&study->intact, study->parameters.along);
    if (time >= study->parameters.start)
        line_fit_add(&study->line, time, study->cracked.velocity[0]);
    study->slip = field_larger(study->slip, fabs(moved[0] - other[0]));
    study->sink = field_larger(study->sink, fabs(moved[1] - other[1]));
    study->elastic = field_larger(study->elastic, fabs(other[0]));
    const double row[COLUMNS] = {time, study->cracked.velocity[0], study->cracked.velocity[1],
                                 moved[0], moved[1]};
    follow_rows_add(&study->rows, row);
}

static void report(const struct study *study, struct measurement *m, bool finished)
{
    const double exact = study->parameters.acceleration, found = line_fit_slope(&study->line);
    measurement_report(m, "finished", finished ? 1.0 : 0.0);
    measurement_report(m, "distance", study->cracked.displacement[0]);
    measurement_note(m, "the block has sunk by %.5g", -study->cracked.displacement[1]);
    if (!finished) {
        measurement_inconclusive(m, exact > 0.0 ? "acceleration_ratio" : "slip",
                                 "the run did not reach its end");
        return;
    }
    if (exact > 0.0) {
        measurement_report(m, "acceleration_ratio", found / exact);
        measurement_report(m, "rise", study->sink);
        return;
    }
    measurement_report(m, "slip", 100.0 * study->slip / study->elastic);
    measurement_report(m, "sink", 100.0 * study->sink / study->elastic);
}

static enum mpm_status follow(struct study *study, struct measurement *m, struct mpm_error *error)
{
    const struct parameters *const p = &study->parameters;
    const double end = mpm_scene_end_time(study->cracked.scene);
    bool alive = true;
    study->rows.columns = COLUMNS;
    for (size_t k = 0; alive && (double)k * p->interval <= end * (1.0 + 1e-12); k++) {
        const double time = fmin(p->interval * (double)k, end);
        TRY(follow_to(m, study->cracked.simulation, time, &alive, error));
        if (alive && study->intact.simulation != NULL)
            TRY(follow_to(m, study->intact.simulation, time, &alive, error));
        if (alive)
            look(study);
    }
    report(study, m, alive);
    follow_count_work(m, study->cracked.simulation);
    if (study->intact.simulation != NULL)
        follow_count_work(m, study->intact.simulation);
    TRY(follow_rows_check(&study->rows, error));
    return measurement_series(m, "block", "time velocity sinking distance sunk", COLUMNS,
                              study->rows.count, study->rows.values, error);
}

static enum mpm_status open_models(struct study *study, struct measurement *m,
                                   struct mpm_error *error)
{
    const char *intact;
    TRY(measurement_text(m, "intact", &intact, error));
    TRY(measurement_scene(m, NULL, 0, &study->cracked.scene, error));
    TRY(open_model(m, &study->cracked, error));
    if (study->parameters.acceleration > 0.0)
        return MPM_OK;
    TRY(measurement_scene(m, (const char *const[]){intact}, 1, &study->intact.scene, error));
    return open_model(m, &study->intact, error);
}

static enum mpm_status read_direction(const struct measurement *m, double along[2],
                                      struct mpm_error *error)
{
    double tilt = 0.0;
    if (measurement_has(m, "tilt"))
        TRY(measurement_number(m, "tilt", &tilt, error));
    along[0] = cos(tilt * acos(-1.0) / 180.0);
    along[1] = sin(tilt * acos(-1.0) / 180.0);
    return MPM_OK;
}

static enum mpm_status run(struct measurement *measurement, struct mpm_error *error)
{
    struct study study = {0};
    const struct measurement_parameter table[] = {
        {"acceleration", &study.parameters.acceleration},
        {"start", &study.parameters.start},
        {"interval", &study.parameters.interval},
    };
    TRY(measurement_numbers(measurement, table, sizeof table / sizeof *table, error));
    TRY(read_direction(measurement, study.parameters.along, error));
    enum mpm_status status = open_models(&study, measurement, error);
    if (status == MPM_OK)
        status = follow(&study, measurement, error);
    follow_rows_free(&study.rows);
    close_model(&study.cracked);
    close_model(&study.intact);
    return status;
}

const struct measure_program program_sliding = {
    .name = "sliding",
    .summary = "a block on an incline that gravity pulls along a crack",
    .run = run,
};
