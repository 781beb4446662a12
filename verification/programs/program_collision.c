/* E2: two disks collide and part: momentum, energy, restitution, the gap they meet at.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/programs/follow.h"

#include <glib.h>
#include <math.h>

enum { AXES = 2, BODIES = 2, COLUMNS = 5 };

/* Sums over the particles of one body. */
struct body_sum {
    double mass, place[AXES], momentum[AXES];
};

struct study {
    size_t count;
    double *mass, *body, *position, *velocity;
    double diameter;
    double approach;    /* speed at which the centres close in, at the start */
    double energy;      /* total, at the start */
    double separation;  /* speed at which they part, now */
    double distance;    /* of the centres, now */
    double closest;     /* least distance so far */
    double contact_gap; /* between the rims when the momentum of a body first moves; NaN before */
    struct follow_rows rows;
};

static void add_up(const struct study *study, struct body_sum sums[BODIES])
{
    for (size_t b = 0; b < BODIES; b++)
        sums[b] = (struct body_sum){0};
    for (size_t p = 0; p < study->count; p++) {
        struct body_sum *const sum = &sums[study->body[p] < 0.5 ? 0 : 1];
        sum->mass += study->mass[p];
        for (size_t axis = 0; axis < AXES; axis++) {
            sum->place[axis] += study->mass[p] * study->position[AXES * p + axis];
            sum->momentum[axis] += study->mass[p] * study->velocity[AXES * p + axis];
        }
    }
}

/* Distance of the centres and the speed at which it grows. */
static void relate(const struct body_sum sums[BODIES], double *distance, double *speed)
{
    double d[AXES], along = 0.0;
    for (size_t axis = 0; axis < AXES; axis++)
        d[axis] = sums[1].place[axis] / sums[1].mass - sums[0].place[axis] / sums[0].mass;
    *distance = hypot(d[0], d[1]);
    for (size_t axis = 0; axis < AXES; axis++)
        along += d[axis] / *distance *
                 (sums[1].momentum[axis] / sums[1].mass - sums[0].momentum[axis] / sums[0].mass);
    *speed = along;
}

static void look(void *context, const struct mpm_simulation *simulation,
                 const struct mpm_ledger *ledger)
{
    static const double MOVED = 1e-6; /* part of the approach that counts as contact */
    struct study *const study = context;
    struct body_sum sums[BODIES];
    mpm_simulation_field(simulation, MPM_FIELD_POSITION, study->position);
    mpm_simulation_field(simulation, MPM_FIELD_VELOCITY, study->velocity);
    add_up(study, sums);
    relate(sums, &study->distance, &study->separation);
    if (study->rows.count == 0) {
        study->approach = -study->separation;
        study->energy = ledger->total_energy;
    }
    study->closest = fmin(study->closest, study->distance);
    if (isnan(study->contact_gap) &&
        fabs(study->separation + study->approach) > MOVED * study->approach)
        study->contact_gap = study->distance - study->diameter;
    const double row[COLUMNS] = {
        ledger->time, study->distance - study->diameter, study->separation / study->approach,
        ledger->kinetic_energy / study->energy, ledger->total_energy / study->energy};
    follow_rows_add(&study->rows, row);
}

static void open_study(struct study *study, const struct mpm_simulation *simulation,
                       double diameter)
{
    const size_t n = mpm_simulation_particle_count(simulation);
    *study = (struct study){.count = n,
                            .mass = g_new(double, n),
                            .body = g_new(double, n),
                            .position = g_new(double, AXES *n),
                            .velocity = g_new(double, AXES *n),
                            .diameter = diameter,
                            .closest = HUGE_VAL,
                            .contact_gap = (double)NAN,
                            .rows = {.columns = COLUMNS}};
    mpm_simulation_field(simulation, MPM_FIELD_MASS, study->mass);
    mpm_simulation_field(simulation, MPM_FIELD_BODY, study->body);
}

static void close_study(struct study *study)
{
    g_free(study->mass);
    g_free(study->body);
    g_free(study->position);
    g_free(study->velocity);
    follow_rows_free(&study->rows);
}

static enum mpm_status report(struct measurement *m, const struct study *study,
                              const struct follow_result *result, double cell,
                              struct mpm_error *error)
{
    measurement_report(m, "restitution", study->separation / study->approach);
    measurement_report(m, "contact_gap", study->contact_gap / cell);
    measurement_report(m, "squeeze", 100.0 * (1.0 - study->closest / study->diameter));
    measurement_report(m, "parted", (study->distance - study->diameter) / cell);
    follow_report(m, result, study->diameter / 2.0);
    return measurement_series(m, "collision", "time gap speed kinetic_over_start total_over_start",
                              COLUMNS, study->rows.count, study->rows.values, error);
}

static enum mpm_status measure(void *context, struct measurement *m, const struct mpm_scene *scene,
                               struct mpm_simulation *simulation, struct mpm_error *error)
{
    const double end = mpm_scene_end_time(scene);
    (void)context;
    double diameter, cell, interval;
    TRY(measurement_number(m, "diameter", &diameter, error));
    TRY(measurement_number(m, "cell", &cell, error));
    TRY(measurement_number(m, "interval", &interval, error));
    struct study study;
    struct follow_result result;
    open_study(&study, simulation, diameter);
    const struct follow follow = {
        .measurement = m, .end = end, .interval = interval, .sample = look, .context = &study};
    enum mpm_status status = follow_run(&follow, simulation, &result, error);
    if (status == MPM_OK)
        status = follow_rows_check(&study.rows, error);
    if (status == MPM_OK)
        status = report(m, &study, &result, cell, error);
    close_study(&study);
    return status;
}

static enum mpm_status run(struct measurement *measurement, struct mpm_error *error)
{
    return follow_scene(measurement, NULL, 0, measure, NULL, error);
}

const struct measure_program program_collision = {
    .name = "collision",
    .summary = "two bodies collide and part: momentum, energy, restitution",
    .run = run,
};
