/* P8: a rod hits a target along the axis r = 0: the state behind both shocks, on the axis, before
 * the release from the rod's rim gets there.
 *
 * The scene has the rod, body 0, below z = 0, and the target, body 1, above it. Parameters: speed
 * of the rod; inner, the radius within which particles are taken; and of both bodies, with rod_ and
 * target_ before their names: density, sound_speed, hugoniot_slope. Exact values: hugoniot.h.
 * Reports, at the end of the scene, in percent of the exact value, means over the middle half
 * between contact and shock: rod_velocity, target_velocity (of the contact's), rod_pressure,
 * target_pressure, rod_density, target_density; rod_shock, target_shock, speeds relative to the
 * bodies ahead, from the places where the pressure is half of the exact one at half the time and at
 * the end; and what follow_report does. The pressure is -stress_zz. Series: profile (z velocity
 * pressure body), exact (z velocity pressure).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/plastic/hugoniot.h"
#include "verification/programs/follow.h"
#include "verification/programs/levels.h"

#include <glib.h>
#include <math.h>
#include <stdlib.h>

enum { AXES = 2, STRESS = 4, ROD = 0, TARGET = 1, BODIES, COLUMNS = 4 };

static const char *const body_names[BODIES] = {"rod", "target"};

struct sample {
    double z, volume, density, velocity, pressure;
    int body;
};

struct study {
    struct hugoniot hugoniot[BODIES];
    struct hugoniot_state behind[BODIES];
    double speed, contact; /* of the rod; u of the contact */
    double front[BODIES];  /* velocity of the shock, along z */
    double inner;
    double time[2], place[2][BODIES];
    size_t count;
    struct sample *samples; /* by z */
    struct follow_result result;
};

/* --------------------------------------------------------------------- reading */

static int by_place(const void *a, const void *b)
{
    const double x = ((const struct sample *)a)->z, y = ((const struct sample *)b)->z;
    return (x > y) - (x < y);
}

static double *field_of(const struct mpm_simulation *simulation, enum mpm_field field,
                        size_t components)
{
    double *const out = g_new(double, components *mpm_simulation_particle_count(simulation));
    mpm_simulation_field(simulation, field, out);
    return out;
}

/* The particles within the inner radius. */
static void read_samples(struct study *study, const struct mpm_simulation *simulation)
{
    const size_t all = mpm_simulation_particle_count(simulation);
    double *const x = field_of(simulation, MPM_FIELD_POSITION, AXES);
    double *const v = field_of(simulation, MPM_FIELD_VELOCITY, AXES);
    double *const stress = field_of(simulation, MPM_FIELD_STRESS, STRESS);
    double *const volume = field_of(simulation, MPM_FIELD_VOLUME, 1);
    double *const mass = field_of(simulation, MPM_FIELD_MASS, 1);
    double *const body = field_of(simulation, MPM_FIELD_BODY, 1);
    study->count = 0;
    for (size_t k = 0; k < all; k++) {
        const double *const s = &stress[STRESS * k];
        if (x[AXES * k] < study->inner)
            study->samples[study->count++] = (struct sample){
                .z = x[AXES * k + 1],
                .volume = volume[k],
                .density = mass[k] / volume[k],
                .velocity = v[AXES * k + 1],
                .pressure = -s[1],
                .body = (int)body[k],
            };
    }
    qsort(study->samples, study->count, sizeof *study->samples, by_place);
    g_free(x);
    g_free(v);
    g_free(stress);
    g_free(volume);
    g_free(mass);
    g_free(body);
}

/* Where the pressure is half of that behind, farthest from the contact in the body. */
static double front_place(const struct study *study, int body)
{
    const double half = 0.5 * study->behind[body].pressure;
    const size_t n = study->count;
    for (size_t k = 1; k < n; k++) {
        const size_t a = body == TARGET ? n - k : k - 1, b = body == TARGET ? n - k - 1 : k;
        const struct sample *const out = &study->samples[a], *const in = &study->samples[b];
        if (out->pressure < half && in->pressure >= half)
            return out->z +
                   (half - out->pressure) / (in->pressure - out->pressure) * (in->z - out->z);
    }
    return (double)NAN;
}

static enum mpm_status measure(void *context, struct measurement *m, const struct mpm_scene *scene,
                               struct mpm_simulation *simulation, struct mpm_error *error)
{
    struct study *const study = context;
    const double end = mpm_scene_end_time(scene);
    study->samples = g_new0(struct sample, mpm_simulation_particle_count(simulation));
    for (int k = 0; k < 2; k++) {
        const double time = end * (k + 1) / 2.0;
        const struct follow follow = {.measurement = m, .end = time, .interval = end / 20.0};
        TRY(follow_run(&follow, simulation, &study->result, error));
        read_samples(study, simulation);
        study->time[k] = mpm_simulation_time(simulation);
        for (int body = 0; body < BODIES; body++)
            study->place[k][body] = front_place(study, body);
    }
    return MPM_OK;
}

/* --------------------------------------------------------------------- results */

struct means {
    double velocity, pressure, density;
};

static struct means plateau(const struct study *study, int body)
{
    const double time = study->time[1], contact = study->contact * time;
    const double way = study->front[body] * time - contact;
    struct means sum = {0.0, 0.0, 0.0};
    double weight = 0.0;
    for (size_t k = 0; k < study->count; k++) {
        const struct sample *const s = &study->samples[k];
        const double part = (s->z - contact) / way;
        if (s->body != body || part < 0.25 || part > 0.75)
            continue;
        sum.velocity += s->volume * s->velocity;
        sum.pressure += s->volume * s->pressure;
        sum.density += s->volume * s->density;
        weight += s->volume;
    }
    return (struct means){sum.velocity / weight, sum.pressure / weight, sum.density / weight};
}

static void report_of(struct measurement *m, const char *body, const char *quantity, double value)
{
    char name[48];
    (void)g_snprintf(name, sizeof name, "%s_%s", body, quantity);
    levels_report_value(m, name, "", value);
}

static void report(struct measurement *m, const struct study *study)
{
    const double missing = study->result.finished ? 0.0 : (double)NAN;
    for (int body = 0; body < BODIES; body++) {
        const struct hugoniot_state *const exact = &study->behind[body];
        const struct means means = plateau(study, body);
        const double density = study->hugoniot[body].density / exact->relative_volume;
        const double speed =
            (study->place[1][body] - study->place[0][body]) / (study->time[1] - study->time[0]);
        const double ahead = body == ROD ? study->speed : 0.0;
        const struct {
            const char *name;
            double value;
        } table[] = {
            {"velocity", means.velocity / study->contact},
            {"pressure", means.pressure / exact->pressure},
            {"density", means.density / density},
            {"shock", fabs(speed - ahead) / exact->shock_speed},
        };
        for (size_t k = 0; k < G_N_ELEMENTS(table); k++)
            report_of(m, body_names[body], table[k].name, missing + 100.0 * table[k].value);
    }
    follow_report(m, &study->result, 0.0);
}

static enum mpm_status write_profile(struct measurement *m, const struct study *study,
                                     struct mpm_error *error)
{
    double *const rows = g_new(double, COLUMNS * study->count);
    for (size_t k = 0; k < study->count; k++) {
        const struct sample *const s = &study->samples[k];
        const double row[COLUMNS] = {s->z, s->velocity, s->pressure, s->body};
        for (int c = 0; c < COLUMNS; c++)
            rows[COLUMNS * k + (size_t)c] = row[c];
    }
    const enum mpm_status status = measurement_series(m, "profile", "z velocity pressure body",
                                                      COLUMNS, study->count, rows, error);
    g_free(rows);
    return status;
}

/* Contact and shocks, exact, at the end. */
static enum mpm_status write_exact(struct measurement *m, const struct study *study,
                                   struct mpm_error *error)
{
    const double time = study->time[1], pressure = study->behind[ROD].pressure;
    const double rows[][3] = {
        {study->front[ROD] * time, study->speed, 0.0},
        {study->front[ROD] * time, study->contact, pressure},
        {study->contact * time, study->contact, pressure},
        {study->front[TARGET] * time, study->contact, pressure},
        {study->front[TARGET] * time, 0.0, 0.0},
    };
    return measurement_series(m, "exact", "z velocity pressure", 3, G_N_ELEMENTS(rows), rows[0],
                              error);
}

static enum mpm_status read_problem(const struct measurement *m, struct study *study,
                                    struct mpm_error *error)
{
    struct hugoniot *const h = study->hugoniot;
    const struct measurement_parameter table[] = {
        {"speed", &study->speed},
        {"inner", &study->inner},
        {"rod_density", &h[ROD].density},
        {"rod_sound_speed", &h[ROD].sound_speed},
        {"rod_hugoniot_slope", &h[ROD].slope},
        {"target_density", &h[TARGET].density},
        {"target_sound_speed", &h[TARGET].sound_speed},
        {"target_hugoniot_slope", &h[TARGET].slope},
    };
    TRY(measurement_numbers(m, table, G_N_ELEMENTS(table), error));
    h[ROD].specific_heat = h[TARGET].specific_heat = 1.0; /* no temperature here */
    study->contact = hugoniot_contact(&h[ROD], &h[TARGET], study->speed);
    study->behind[ROD] = hugoniot_behind(&h[ROD], study->speed - study->contact);
    study->behind[TARGET] = hugoniot_behind(&h[TARGET], study->contact);
    study->front[ROD] = study->speed - study->behind[ROD].shock_speed;
    study->front[TARGET] = study->behind[TARGET].shock_speed;
    return MPM_OK;
}

static enum mpm_status run(struct measurement *m, struct mpm_error *error)
{
    struct study study = {.inner = 0.0};
    TRY(read_problem(m, &study, error));
    enum mpm_status status = follow_scene(m, NULL, 0, measure, &study, error);
    if (status == MPM_OK) {
        report(m, &study);
        status = write_profile(m, &study, error);
    }
    if (status == MPM_OK)
        status = write_exact(m, &study, error);
    g_free(study.samples);
    return status;
}

const struct measure_program program_first_contact = {
    .name = "first_contact",
    .summary = "a rod hits a target: velocity, pressure and shocks on the axis before release",
    .run = run,
};
