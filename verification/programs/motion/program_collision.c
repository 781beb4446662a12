/* E2, C8 and C11b: two disks or spheres collide and part: momentum, energy, restitution, the gap
 * they meet at.
 *
 * With the parameter `axial: 1`, for axisymmetry, where radial momenta have no balance: the drift
 * of momentum along z. With `friction`, for disks that meet off their line with contact between
 * them: the impulse on the first one across the line of centres at the closest distance over that
 * along it, and how far its spin is what that impulse gives to a rigid disk. With `wave_speed`:
 * contact_time, from 1 % to 99 % of the change of the speed at which the centres part, over the
 * time that waves take through a disk.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/measures/fields.h"
#include "verification/programs/contact/body_motion.h"
#include "verification/programs/follow.h"

#include <glib.h>
#include <math.h>
#include <string.h>

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
    double line[AXES];  /* unit vector from the first centre to the second at that distance */
    double left;        /* kinetic and strain energy over that at the start, now */
    double axial_drift; /* of momentum along y or z, so far */
    double axial;       /* that momentum, at the start */
    double start[AXES], now[AXES]; /* momentum of the first body */
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

/* Distance of the centres and the speed at which it grows; d: from the first to the second. */
static void relate(const struct body_sum sums[BODIES], double d[AXES], double *distance,
                   double *speed)
{
    double along = 0.0;
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
    double between[AXES];
    relate(sums, between, &study->distance, &study->separation);
    if (study->rows.count == 0) {
        study->axial = ledger->momentum[1];
        memcpy(study->start, sums[0].momentum, sizeof study->start);
        study->approach = -study->separation;
        study->energy = ledger->total_energy;
    }
    study->left = (ledger->kinetic_energy + ledger->strain_energy) / study->energy;
    memcpy(study->now, sums[0].momentum, sizeof study->now);
    study->axial_drift =
        field_larger(study->axial_drift, fabs(ledger->momentum[1] - study->axial) /
                                             sqrt(2.0 * ledger->mass * study->energy));
    for (size_t axis = 0; axis < AXES && study->distance < study->closest; axis++)
        study->line[axis] = between[axis] / study->distance;
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

/* Of the impulse on the first body; its spin is counted as that impulse turns it. */
static enum mpm_status report_oblique(struct measurement *m, const struct study *study,
                                      const struct mpm_simulation *simulation,
                                      struct mpm_error *error)
{
    const double *const n = study->line;
    const double j[AXES] = {study->now[0] - study->start[0], study->now[1] - study->start[1]};
    const double along = -(j[0] * n[0] + j[1] * n[1]), across = n[0] * j[1] - n[1] * j[0];
    struct body_motion body;
    enum mpm_status status = body_motion_open(simulation, 0, &body, error);
    if (status == MPM_OK) {
        const double radius = 0.5 * study->diameter;
        const double turned = 0.5 * body.mass * radius * body.angular / body.inertia;
        measurement_report(m, "friction_angle", fabs(across) / along);
        measurement_report(m, "spin_impulse", fabs(turned) / along);
        measurement_note(m, "impulse along %.6g, across %.6g, spin times m R/2 %.6g", along, across,
                         turned);
    }
    body_motion_close(&body);
    return status;
}

/* When the centres' speed has passed `part` of its change, from the samples. */
static double time_of(const struct study *study, double part)
{
    const double *const row = study->rows.values;
    const size_t n = study->rows.count;
    const double end = row[COLUMNS * (n - 1) + 2], level = -1.0 + part * (end + 1.0);
    for (size_t k = 1; k < n; k++) {
        const double *const now = row + COLUMNS * k, *const before = now - COLUMNS;
        if (now[2] >= level)
            return before[0] + (now[0] - before[0]) * (level - before[2]) / (now[2] - before[2]);
    }
    return (double)NAN;
}

static enum mpm_status report(struct measurement *m, const struct study *study,
                              const struct follow_result *result, double cell,
                              struct mpm_error *error)
{
    measurement_report(m, "restitution", study->separation / study->approach);
    measurement_report(m, "contact_gap", study->contact_gap / cell);
    measurement_report(m, "squeeze", 100.0 * (1.0 - study->closest / study->diameter));
    measurement_report(m, "energy_left", 100.0 * study->left);
    measurement_report(m, "parted", (study->distance - study->diameter) / cell);
    follow_report(m, result, study->diameter / 2.0);
    if (measurement_has(m, "wave_speed")) {
        double wave_speed;
        TRY(measurement_number(m, "wave_speed", &wave_speed, error));
        measurement_report(m, "contact_time",
                           (time_of(study, 0.99) - time_of(study, 0.01)) * wave_speed /
                               study->diameter);
    }
    if (measurement_has(m, "axial"))
        measurement_report(m, "axial_momentum_drift", study->axial_drift);
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
    if (status == MPM_OK && measurement_has(m, "friction"))
        status = report_oblique(m, &study, simulation, error);
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
