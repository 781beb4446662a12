/* P5: plane shocks in a strip, against exact profiles.
 *
 * `problem` is what the strip holds, and is held against:
 *
 *   plate  a body with Mie and Grueneisen's law hits a plane of symmetry at x = 0 with `speed`:
 *          hugoniot.h, with the parameters density, sound_speed, hugoniot_slope, gruneisen,
 *          specific_heat, start_temperature
 *   tube   an ideal gas, gamma = `index`, with left_density, left_velocity, left_pressure at x < 0
 *          and the same of the right: riemann.h
 *
 * x counts from `origin`. Reports, of the time of the scene's end: means of pressure, density,
 * energy and (plate) temperature between plateau_from and plateau_to, in percent of the exact ones
 * in its middle, and pressure_scatter, the standard deviation; shock_speed, in percent of that
 * relative to the body ahead, from the places where the pressure last falls through the mean of the
 * states beside the front, at half the time and at its end; wall_energy, the mean internal energy
 * of the particles with x below wall_to in percent of the plateau's exact one (without it: none);
 * energy_drift; error_density, error_velocity, error_pressure, error_energy: integrals of the
 * absolute error over the strip, over that of the exact field, in percent, and their orders over
 * levels. Series: profile.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/plastic/hugoniot.h"
#include "verification/exact/plastic/riemann.h"
#include "verification/programs/follow.h"
#include "verification/programs/levels.h"

#include <glib.h>
#include <math.h>
#include <stdlib.h>

enum { AXES = 2, STRESS = 4, COLUMNS = 11 };

enum quantity { DENSITY, VELOCITY, PRESSURE, ENERGY, TEMPERATURE, QUANTITIES };
static const char *const names[QUANTITIES] = {"density", "velocity", "pressure", "energy",
                                              "temperature"};

enum kind { PLATE, TUBE, KINDS };
static const char *const kinds[KINDS] = {"plate", "tube"};

struct problem {
    enum kind kind;
    double origin, plateau_from, plateau_to, wall_to, speed;
    struct hugoniot hugoniot;
    struct hugoniot_state behind;
    struct riemann riemann;
    double front;         /* velocity of the shock to the right */
    double ahead;         /* of the body ahead of it */
    double half_pressure; /* mean of those before and behind */
};

/* A particle: its place, its volume, what it has. */
struct sample {
    double x, volume, value[QUANTITIES];
};

struct study {
    const struct problem *problem;
    struct follow_result result;
    size_t count;
    struct sample *samples; /* at the end, x ascending */
    double place[2], time[2];
};

/* ------------------------------------------------------------------ exact fields */

static void exact_plate(const struct problem *p, double x, double t, double value[QUANTITIES])
{
    const bool hit = x < p->front * t;
    value[DENSITY] = p->hugoniot.density / (hit ? p->behind.relative_volume : 1.0);
    value[VELOCITY] = hit ? 0.0 : -p->speed;
    value[PRESSURE] = hit ? p->behind.pressure : 0.0;
    value[ENERGY] = hit ? p->behind.energy : 0.0;
    value[TEMPERATURE] = hit ? p->behind.temperature : p->hugoniot.start_temperature;
}

static void exact_tube(const struct problem *p, double x, double t, double value[QUANTITIES])
{
    const struct riemann_state state = riemann_sample(&p->riemann, x / t);
    value[DENSITY] = state.density;
    value[VELOCITY] = state.velocity;
    value[PRESSURE] = state.pressure;
    value[ENERGY] = state.pressure / ((p->riemann.index - 1.0) * state.density);
    value[TEMPERATURE] = 0.0; /* its gas has none */
}

static void exact(const struct problem *p, double x, double t, double value[QUANTITIES])
{
    (p->kind == PLATE ? exact_plate : exact_tube)(p, x - p->origin, t, value);
}

/* ------------------------------------------------------------------------ samples */

static int by_place(const void *a, const void *b)
{
    const double x = ((const struct sample *)a)->x, y = ((const struct sample *)b)->x;
    return (x > y) - (x < y);
}

static void read_samples(struct study *study, const struct mpm_simulation *simulation)
{
    const size_t count = study->count;
    double *const field = g_new(double, STRESS *count), *const volume = g_new(double, count);
    mpm_simulation_field(simulation, MPM_FIELD_VOLUME, volume);
    mpm_simulation_field(simulation, MPM_FIELD_MASS, field);
    for (size_t k = 0; k < count; k++) {
        study->samples[k].volume = volume[k];
        study->samples[k].value[DENSITY] = field[k] / volume[k];
    }
    mpm_simulation_field(simulation, MPM_FIELD_POSITION, field);
    for (size_t k = 0; k < count; k++)
        study->samples[k].x = field[AXES * k];
    mpm_simulation_field(simulation, MPM_FIELD_VELOCITY, field);
    for (size_t k = 0; k < count; k++)
        study->samples[k].value[VELOCITY] = field[AXES * k];
    mpm_simulation_field(simulation, MPM_FIELD_STRESS, field);
    for (size_t k = 0; k < count; k++)
        study->samples[k].value[PRESSURE] = -field[STRESS * k];
    mpm_simulation_field(simulation, MPM_FIELD_INTERNAL_ENERGY, field);
    for (size_t k = 0; k < count; k++)
        study->samples[k].value[ENERGY] = field[k];
    mpm_simulation_field(simulation, MPM_FIELD_STATE_TEMPERATURE, field);
    for (size_t k = 0; k < count; k++)
        study->samples[k].value[TEMPERATURE] = field[k];
    qsort(study->samples, count, sizeof *study->samples, by_place);
    g_free(field);
    g_free(volume);
}

/* Where the pressure last falls through that of the middle of the front. */
static double front_place(const struct study *study)
{
    const double half = study->problem->half_pressure;
    for (size_t k = study->count; k-- > 1;) {
        const struct sample *const a = &study->samples[k - 1], *const b = &study->samples[k];
        if (a->value[PRESSURE] >= half && b->value[PRESSURE] < half) {
            const double part =
                (a->value[PRESSURE] - half) / (a->value[PRESSURE] - b->value[PRESSURE]);
            return a->x + part * (b->x - a->x);
        }
    }
    return (double)NAN;
}

static enum mpm_status measure(void *context, struct measurement *m, const struct mpm_scene *scene,
                               struct mpm_simulation *simulation, struct mpm_error *error)
{
    struct study *const study = context;
    const double end = mpm_scene_end_time(scene);
    study->count = mpm_simulation_particle_count(simulation);
    study->samples = g_new0(struct sample, study->count);
    for (int k = 0; k < 2; k++) {
        const double time = end * (k + 1) / 2.0;
        const struct follow follow = {.measurement = m, .end = time, .interval = end / 50.0};
        TRY(follow_run(&follow, simulation, &study->result, error));
        read_samples(study, simulation);
        study->time[k] = mpm_simulation_time(simulation);
        study->place[k] = front_place(study);
    }
    return MPM_OK;
}

/* ------------------------------------------------------------------------ results */

/* Mean over the plateau in percent of the exact state in its middle; and the scatter. */
static double plateau(const struct study *study, enum quantity quantity, double *scatter)
{
    const struct problem *const p = study->problem;
    double wanted[QUANTITIES], sum = 0.0, squares = 0.0, weight = 0.0;
    exact(p, 0.5 * (p->plateau_from + p->plateau_to), study->time[1], wanted);
    for (size_t k = 0; k < study->count; k++) {
        const struct sample *const s = &study->samples[k];
        const double off = s->value[quantity] / wanted[quantity] - 1.0;
        if (s->x < p->plateau_from || s->x > p->plateau_to)
            continue;
        sum += s->volume * off;
        squares += s->volume * off * off;
        weight += s->volume;
    }
    const double mean = sum / weight;
    *scatter = 100.0 * sqrt(squares / weight - mean * mean);
    return 100.0 * (1.0 + mean);
}

static double error_l1(const struct study *study, enum quantity quantity)
{
    double sum = 0.0, scale = 0.0;
    for (size_t k = 0; k < study->count; k++) {
        const struct sample *const s = &study->samples[k];
        double wanted[QUANTITIES];
        exact(study->problem, s->x, study->time[1], wanted);
        sum += s->volume * fabs(s->value[quantity] - wanted[quantity]);
        scale += s->volume * fabs(wanted[quantity]);
    }
    return 100.0 * sum / scale;
}

static double wall_energy(const struct study *study)
{
    const struct problem *const p = study->problem;
    double wanted[QUANTITIES], sum = 0.0, weight = 0.0;
    exact(p, 0.5 * (p->plateau_from + p->plateau_to), study->time[1], wanted);
    for (size_t k = 0; k < study->count; k++)
        if (study->samples[k].x < p->wall_to) {
            sum += study->samples[k].volume * study->samples[k].value[ENERGY];
            weight += study->samples[k].volume;
        }
    return 100.0 * sum / weight / wanted[ENERGY];
}

static void report(struct measurement *m, const struct study *study)
{
    const struct problem *const p = study->problem;
    const double missing = study->result.finished ? 0.0 : (double)NAN;
    const double speed =
        (study->place[1] - study->place[0]) / (study->time[1] - study->time[0]) - p->ahead;
    double scatter;
    for (int k = 0; k < QUANTITIES; k++)
        if (k != VELOCITY && (k != TEMPERATURE || p->kind == PLATE)) {
            const double off = plateau(study, (enum quantity)k, &scatter);
            levels_report_value(m, names[k], "", missing + off);
            if (k == PRESSURE)
                levels_report_value(m, "pressure_scatter", "", missing + scatter);
        }
    levels_report_value(m, "shock_speed", "", missing + 100.0 * speed / (p->front - p->ahead));
    if (measurement_has(m, "wall_to"))
        levels_report_value(m, "wall_energy", "", missing + wall_energy(study));
    follow_report(m, &study->result, 0.0);
}

static enum mpm_status write_profile(struct measurement *m, const struct study *study,
                                     struct mpm_error *error)
{
    double *const rows = g_new(double, COLUMNS * study->count);
    for (size_t k = 0; k < study->count; k++) {
        double *const row = &rows[COLUMNS * k], wanted[QUANTITIES];
        const struct sample *const s = &study->samples[k];
        exact(study->problem, s->x, study->time[1], wanted);
        row[0] = s->x;
        for (int q = 0; q < QUANTITIES; q++) {
            row[1 + q] = isnan(s->value[q]) ? 0.0 : s->value[q];
            row[1 + QUANTITIES + q] = wanted[q];
        }
    }
    const enum mpm_status status =
        measurement_series(m, "profile", "x rho v p e T rho_exact v_exact p_exact e_exact T_exact",
                           COLUMNS, study->count, rows, error);
    g_free(rows);
    return status;
}

/* ------------------------------------------------------------------------ problem */

static enum mpm_status read_plate(const struct measurement *m, struct problem *p,
                                  struct mpm_error *error)
{
    struct hugoniot *const h = &p->hugoniot;
    const struct measurement_parameter table[] = {
        {"speed", &p->speed},
        {"density", &h->density},
        {"sound_speed", &h->sound_speed},
        {"hugoniot_slope", &h->slope},
        {"gruneisen", &h->gruneisen},
        {"specific_heat", &h->specific_heat},
        {"start_temperature", &h->start_temperature},
    };
    TRY(measurement_numbers(m, table, G_N_ELEMENTS(table), error));
    p->behind = hugoniot_behind(h, p->speed);
    p->ahead = -p->speed;
    p->front = p->behind.shock_speed - p->speed;
    p->half_pressure = 0.5 * p->behind.pressure;
    return MPM_OK;
}

static enum mpm_status read_tube(const struct measurement *m, struct problem *p,
                                 struct mpm_error *error)
{
    struct riemann *const r = &p->riemann;
    const struct measurement_parameter table[] = {
        {"index", &r->index},
        {"left_density", &r->side[0].density},
        {"left_velocity", &r->side[0].velocity},
        {"left_pressure", &r->side[0].pressure},
        {"right_density", &r->side[1].density},
        {"right_velocity", &r->side[1].velocity},
        {"right_pressure", &r->side[1].pressure},
    };
    TRY(measurement_numbers(m, table, G_N_ELEMENTS(table), error));
    riemann_solve(r);
    p->ahead = r->side[1].velocity;
    p->front = riemann_front(r, 1);
    p->half_pressure = 0.5 * (r->pressure + r->side[1].pressure);
    return MPM_OK;
}

static enum mpm_status read_problem(const struct measurement *m, struct problem *p,
                                    struct mpm_error *error)
{
    const struct measurement_parameter table[] = {
        {"origin", &p->origin}, {"plateau_from", &p->plateau_from}, {"plateau_to", &p->plateau_to}};
    size_t kind;
    TRY(measurement_choice(m, "problem", kinds, KINDS, &kind, error));
    TRY(measurement_numbers(m, table, G_N_ELEMENTS(table), error));
    if (measurement_has(m, "wall_to"))
        TRY(measurement_number(m, "wall_to", &p->wall_to, error));
    p->kind = (enum kind)kind;
    return p->kind == PLATE ? read_plate(m, p, error) : read_tube(m, p, error);
}

static void report_suffixed(struct measurement *m, const char *name, enum quantity quantity,
                            double value)
{
    char suffix[32];
    (void)g_snprintf(suffix, sizeof suffix, "_%s", names[quantity]);
    levels_report_value(m, name, suffix, value);
}

static enum mpm_status run(struct measurement *m, struct mpm_error *error)
{
    struct problem problem = {.origin = 0.0};
    struct levels levels;
    double errors[TEMPERATURE][LEVELS_MAX] = {{0.0}};
    TRY(read_problem(m, &problem, error));
    TRY(levels_read(m, &levels, error));
    for (size_t k = 0; k < levels_runs(&levels); k++) {
        struct study study = {.problem = &problem};
        enum mpm_status status =
            follow_scene(m, &levels.setting[k], levels.count == 0 ? 0 : 1, measure, &study, error);
        const bool last = k + 1 == levels_runs(&levels);
        const double missing = study.result.finished ? 0.0 : (double)NAN;
        for (int q = 0; q < TEMPERATURE && status == MPM_OK; q++) {
            errors[q][k] = missing + error_l1(&study, (enum quantity)q);
            if (last)
                report_suffixed(m, "error", (enum quantity)q, errors[q][k]);
        }
        if (status == MPM_OK && last) {
            report(m, &study);
            status = write_profile(m, &study, error);
        }
        g_free(study.samples);
        TRY(status);
    }
    for (int q = 0; q < TEMPERATURE && levels.count > 0; q++) {
        char suffix[32];
        (void)g_snprintf(suffix, sizeof suffix, "_%s", names[q]);
        TRY(levels_report(m, &levels, suffix, errors[q], error));
    }
    return MPM_OK;
}

const struct measure_program program_shock = {
    .name = "shock",
    .summary = "plane shocks: plates that collide, shock tubes, a gas that hits a wall",
    .run = run,
};
