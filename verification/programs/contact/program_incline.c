/* C3 and C4: a body on an incline, under gravity that comes on smoothly: it slides, rolls, or is
 * held.
 *
 * The body is body 0 of the scene, the incline the partner of its velocity field 0. Parameters:
 * gravity, angle (of the incline to the horizontal, degrees), friction, static_friction; tilt: of
 * the incline's surface to the x axis, counter clockwise, degrees, so that down the incline is
 * (cos tilt, sin tilt); radius, of a round body, 0 for a block; start: from when on it is measured,
 * after gravity is there in full.
 *
 * A body that moves: its accelerations are the slopes of lines through its velocities from `start`
 * on, by least squares, over those of a rigid body (exact/incline.h). A body that is held is
 * compared with the same scene with the settings of the parameter `bonded`, which runs beside.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/contact/incline.h"
#include "verification/measures/fields.h"
#include "verification/measures/line_fit.h"
#include "verification/programs/contact/body_motion.h"
#include "verification/programs/follow.h"
#include "verification/programs/picture.h"

#include <math.h>
#include <string.h>

enum { AXES = 2, COLUMNS = 7 };

static const double RADIAN = 0.01745329251994329577; /* of a degree */

struct parameters {
    struct incline incline;
    double radius, start, interval, cell;
    double along[AXES]; /* down the incline */
};

struct model {
    struct mpm_scene *scene;
    struct mpm_simulation *simulation;
    struct body_motion body;
    double origin[AXES];
};

struct study {
    struct measurement *measurement;
    struct parameters parameters;
    struct incline_motion exact;
    struct model free, held; /* the second is empty if the body moves */
    struct line_fit travel, turning;
    size_t force_index[AXES];
    double impulse[AXES];  /* of contact, from `start` on */
    double momentum[AXES]; /* at `start` */
    double since;          /* the time then; NaN before */
    double slip, elastic;  /* largest so far */
    double rise, sink;     /* of the centre, farthest so far */
    struct follow_rows rows;
};

/* Components along the incline and away from it. */
static void turn(const struct parameters *p, const double vector[AXES], double turned[AXES])
{
    turned[0] = p->along[0] * vector[0] + p->along[1] * vector[1];
    turned[1] = p->along[0] * vector[1] - p->along[1] * vector[0];
}

static enum mpm_status open_model(const struct measurement *m, struct model *model,
                                  const char *setting, struct mpm_error *error)
{
    TRY(measurement_scene(m, &setting, setting == NULL ? 0 : 1, &model->scene, error));
    TRY(mpm_simulation_create(model->scene, measurement_options(m), &model->simulation, error));
    TRY(body_motion_open(model->simulation, 0, &model->body, error));
    memcpy(model->origin, model->body.place, sizeof model->origin);
    return MPM_OK;
}

static void close_model(struct model *model)
{
    body_motion_close(&model->body);
    mpm_simulation_free(model->simulation);
    mpm_scene_free(model->scene);
}

/* Displacement of the centre, along the incline and away from it. */
static void find_moved(const struct parameters *p, const struct model *model, double moved[AXES])
{
    const double by[AXES] = {model->body.place[0] - model->origin[0],
                             model->body.place[1] - model->origin[1]};
    turn(p, by, moved);
}

static void compare_with_held(struct study *study, const double moved[AXES])
{
    double other[AXES];
    body_motion_read(&study->held.body, study->held.simulation);
    find_moved(&study->parameters, &study->held, other);
    study->slip = field_larger(study->slip, fabs(moved[0] - other[0]));
    study->elastic = field_larger(study->elastic, fabs(other[0]));
}

/* Spin is counted as down the incline: clockwise. */
static void look(struct study *study)
{
    const struct parameters *const p = &study->parameters;
    const double time = mpm_simulation_time(study->free.simulation);
    const struct body_motion *const body = &study->free.body;
    double velocity[AXES], moved[AXES], force[AXES];
    body_motion_read(&study->free.body, study->free.simulation);
    turn(p, body->velocity, velocity);
    find_moved(p, &study->free, moved);
    for (int axis = 0; axis < AXES; axis++)
        force[axis] =
            mpm_simulation_contact_quantity(study->free.simulation, study->force_index[axis]);
    turn(p, (const double[]){force[0], force[1]}, force);
    const double spin = -body->angular / body->inertia;
    if (time >= p->start) {
        line_fit_add(&study->travel, time, velocity[0]);
        line_fit_add(&study->turning, time, spin);
    }
    study->rise = field_larger(study->rise, moved[1]);
    study->sink = field_larger(study->sink, -moved[1]);
    if (study->held.simulation != NULL)
        compare_with_held(study, moved);
    const double row[COLUMNS] = {time,     velocity[0], velocity[1], spin,
                                 moved[0], force[0],    force[1]};
    follow_rows_add(&study->rows, row);
}

/* The impulse of contact from `start` on, step by step. */
static void add_impulse(struct study *study)
{
    struct model *const model = &study->free;
    const double time = mpm_simulation_time(model->simulation);
    if (!isnan(study->since)) {
        for (int axis = 0; axis < AXES; axis++)
            study->impulse[axis] +=
                mpm_simulation_contact_quantity(model->simulation, study->force_index[axis]) *
                mpm_simulation_time_step(model->simulation);
        return;
    }
    if (time < study->parameters.start)
        return;
    body_motion_read(&model->body, model->simulation);
    study->since = time;
    for (int axis = 0; axis < AXES; axis++)
        study->momentum[axis] = model->body.mass * model->body.velocity[axis];
}

/* Momentum gained less that of gravity and of contact, over that of gravity. */
static double find_imbalance(const struct study *study)
{
    const struct parameters *const p = &study->parameters;
    const struct body_motion *const body = &study->free.body;
    const double time = mpm_simulation_time(study->free.simulation) - study->since;
    const double weight = body->mass * p->incline.gravity * time;
    double rest[AXES], along[AXES];
    for (int axis = 0; axis < AXES; axis++)
        rest[axis] =
            body->mass * body->velocity[axis] - study->momentum[axis] - study->impulse[axis];
    turn(p, rest, along);
    return hypot(along[0] / weight - sin(p->incline.angle),
                 along[1] / weight + cos(p->incline.angle));
}

static void report_contact(const struct study *study)
{
    struct measurement *const m = study->measurement;
    const struct parameters *const p = &study->parameters;
    double impulse[AXES];
    turn(p, study->impulse, impulse);
    const double weight = study->free.body.mass * p->incline.gravity *
                          (mpm_simulation_time(study->free.simulation) - study->since);
    measurement_report(m, "imbalance", find_imbalance(study));
    measurement_report(m, "normal_force_ratio", impulse[1] / (weight * cos(p->incline.angle)));
    measurement_note(m, "friction over pressure: %.6f; highest %.4g, lowest %.4g cells",
                     -impulse[0] / impulse[1], study->rise / p->cell, -study->sink / p->cell);
}

static void report(const struct study *study, bool finished)
{
    struct measurement *const m = study->measurement;
    const struct incline_motion *const exact = &study->exact;
    measurement_report(m, "finished", finished ? 1.0 : 0.0);
    if (!finished) {
        measurement_inconclusive(m, exact->acceleration > 0.0 ? "acceleration_ratio" : "slip",
                                 "the run did not reach its end");
        return;
    }
    measurement_report(m, "rise",
                       (study->rise > study->sink ? study->rise : study->sink) /
                           study->parameters.cell);
    report_contact(study);
    if (exact->acceleration > 0.0) {
        const double ratio = line_fit_slope(&study->travel) / exact->acceleration;
        measurement_report(m, "acceleration_ratio", ratio);
        measurement_report(m, "acceleration_error", 100.0 * fabs(ratio - 1.0));
    }
    if (study->held.simulation != NULL)
        measurement_report(m, "slip", 100.0 * study->slip / study->elastic);
    if (exact->spin > 0.0)
        measurement_report(m, "spin_ratio", line_fit_slope(&study->turning) / exact->spin);
}

/* ------------------------------------------------------------------ running */

static enum mpm_status draw(const struct study *study, struct mpm_error *error)
{
    struct picture picture;
    bool asked;
    TRY(picture_read(study->measurement, &picture, &asked, error));
    if (!asked)
        return MPM_OK;
    TRY(picture_write(study->measurement, &picture, study->free.simulation, MPM_FIELD_STRESS, 1,
                      "stress", error));
    return picture_write(study->measurement, &picture, study->free.simulation, MPM_FIELD_VELOCITY,
                         0, "speed", error);
}

/* To the next sample; *alive: both models got there. */
static enum mpm_status advance(struct study *study, double time, bool *alive,
                               struct mpm_error *error)
{
    while (*alive && mpm_simulation_time(study->free.simulation) < time) {
        TRY(follow_step(study->measurement, study->free.simulation, time, alive, error));
        add_impulse(study);
    }
    if (*alive && study->held.simulation != NULL)
        TRY(follow_to(study->measurement, study->held.simulation, time, alive, error));
    return MPM_OK;
}

static enum mpm_status follow(struct study *study, struct mpm_error *error)
{
    const double end = mpm_scene_end_time(study->free.scene);
    const double interval = study->parameters.interval;
    bool alive = true;
    for (size_t k = 0; alive && (double)k * interval <= end * (1.0 + 1e-12); k++) {
        TRY(advance(study, fmin(interval * (double)k, end), &alive, error));
        if (alive)
            look(study);
    }
    report(study, alive);
    follow_count_work(study->measurement, study->free.simulation);
    if (study->held.simulation != NULL)
        follow_count_work(study->measurement, study->held.simulation);
    TRY(follow_rows_check(&study->rows, error));
    TRY(draw(study, error));
    return measurement_series(study->measurement, "body",
                              "time velocity rising spin distance friction pressure", COLUMNS,
                              study->rows.count, study->rows.values, error);
}

static enum mpm_status read_parameters(struct measurement *m, struct parameters *p,
                                       struct mpm_error *error)
{
    double angle, tilt;
    const struct measurement_parameter table[] = {
        {"gravity", &p->incline.gravity},
        {"angle", &angle},
        {"friction", &p->incline.friction},
        {"static_friction", &p->incline.static_friction},
        {"tilt", &tilt},
        {"radius", &p->radius},
        {"start", &p->start},
        {"interval", &p->interval},
        {"cell", &p->cell},
    };
    TRY(measurement_numbers(m, table, sizeof table / sizeof *table, error));
    p->incline.angle = angle * RADIAN;
    p->along[0] = cos(tilt * RADIAN);
    p->along[1] = sin(tilt * RADIAN);
    return MPM_OK;
}

static enum mpm_status open_study(struct study *study, struct mpm_error *error)
{
    struct measurement *const m = study->measurement;
    struct parameters *const p = &study->parameters;
    TRY(read_parameters(m, p, error));
    study->exact =
        p->radius > 0.0 ? incline_round(&p->incline, 0.5, p->radius) : incline_block(&p->incline);
    TRY(open_model(m, &study->free, NULL, error));
    TRY(contact_quantity_find(study->free.scene, "0_1", "force_x", &study->force_index[0], error));
    TRY(contact_quantity_find(study->free.scene, "0_1", "force_y", &study->force_index[1], error));
    if (study->exact.acceleration > 0.0)
        return MPM_OK;
    const char *bonded;
    TRY(measurement_text(m, "bonded", &bonded, error));
    return open_model(m, &study->held, bonded, error);
}

static enum mpm_status run(struct measurement *measurement, struct mpm_error *error)
{
    struct study study = {
        .measurement = measurement, .since = (double)NAN, .rows = {.columns = COLUMNS}};
    enum mpm_status status = open_study(&study, error);
    if (status == MPM_OK)
        status = follow(&study, error);
    follow_rows_free(&study.rows);
    close_model(&study.free);
    close_model(&study.held);
    return status;
}

const struct measure_program program_incline = {
    .name = "incline",
    .summary = "a block or a disk on an incline, in contact with it",
    .run = run,
};
