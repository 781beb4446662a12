/* W1: a bar hits a wall; the front against the exact step and against its dispersion.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/waves/step_wave.h"
#include "verification/measures/fields.h"
#include "verification/measures/particle_set.h"
#include "verification/programs/follow.h"
#include "verification/programs/levels.h"

#include <glib.h>
#include <math.h>

enum { STRESS = 4, AXES = 2, COLUMNS = 4 };

struct parameters {
    struct step_wave wave;
    double time;          /* when the front is measured */
    double level_from;    /* the level of the stress is its mean between these parts of c t */
    double level_to;      /* */
    double dispersion, h; /* b and cells of the curve drawn beside the profile */
};

/* The profile along one row of particles, x ascending. */
struct profile {
    size_t count;
    double *x, *pressure; /* over rho c V */
};

static enum mpm_status read_parameters(const struct measurement *m, struct parameters *p,
                                       struct mpm_error *error)
{
    const struct measurement_parameter table[] = {
        {"modulus", &p->wave.modulus},  {"density", &p->wave.density},
        {"speed", &p->wave.speed},      {"time", &p->time},
        {"level_from", &p->level_from}, {"level_to", &p->level_to},
        {"dispersion", &p->dispersion}, {"cell", &p->h},
    };
    return measurement_numbers(m, table, sizeof table / sizeof *table, error);
}

/* The first row of particles: ids go row by row. */
static enum mpm_status read_profile(const struct parameters *p,
                                    const struct mpm_simulation *simulation,
                                    struct profile *profile, struct mpm_error *error)
{
    struct particle_set set;
    TRY(particle_set_create(simulation, 0, &set, error));
    particle_set_read(&set, simulation);
    *profile =
        (struct profile){.x = g_new(double, set.count), .pressure = g_new(double, set.count)};
    for (size_t k = 0; k < set.count; k++) {
        if (k > 0 && set.position[AXES * k] < set.position[AXES * (k - 1)])
            break;
        profile->x[k] = set.position[AXES * k];
        profile->pressure[k] = -set.stress[STRESS * k] / step_wave_pressure(&p->wave);
        profile->count = k + 1;
    }
    particle_set_free(&set);
    return MPM_OK;
}

static void free_profile(struct profile *profile)
{
    g_free(profile->x);
    g_free(profile->pressure);
    *profile = (struct profile){0};
}

/* Where the pressure last falls below one half. */
static double half_place(const struct profile *profile)
{
    for (size_t k = profile->count - 1; k > 0; k--)
        if (profile->pressure[k - 1] >= 0.5) {
            const double part = (profile->pressure[k - 1] - 0.5) /
                                (profile->pressure[k - 1] - profile->pressure[k]);
            return profile->x[k - 1] + part * (profile->x[k] - profile->x[k - 1]);
        }
    return (double)NAN;
}

/* Integral of |p - exact| over x, over c t. */
static double error_l1(const struct profile *profile, double front)
{
    const double step =
        (profile->x[profile->count - 1] - profile->x[0]) / (double)(profile->count - 1);
    double sum = 0.0;
    for (size_t k = 0; k < profile->count; k++)
        sum += fabs(profile->pressure[k] - (profile->x[k] < front ? 1.0 : 0.0));
    return sum * step / front;
}

static double mean_between(const struct profile *profile, double from, double to)
{
    double sum = 0.0, count = 0.0;
    for (size_t k = 0; k < profile->count; k++)
        if (profile->x[k] >= from && profile->x[k] <= to) {
            sum += profile->pressure[k];
            count += 1.0;
        }
    return sum / count;
}

static enum mpm_status write_profile(struct measurement *m, const struct parameters *p,
                                     const struct profile *profile, struct mpm_error *error)
{
    const double front = step_wave_celerity(&p->wave) * p->time;
    double *const rows = g_new(double, COLUMNS * profile->count);
    for (size_t k = 0; k < profile->count; k++) {
        double *const row = &rows[COLUMNS * k];
        const double similarity =
            step_wave_similarity(&p->wave, p->dispersion, p->h, profile->x[k], p->time);
        row[0] = profile->x[k];
        row[1] = profile->pressure[k];
        row[2] = profile->x[k] < front ? 1.0 : 0.0;
        row[3] = step_wave_dispersed(fmin(similarity, 20.0));
    }
    const enum mpm_status status = measurement_series(m, "profile", "x pressure exact dispersed",
                                                      COLUMNS, profile->count, rows, error);
    g_free(rows);
    return status;
}

/* What is judged, in percent of the exact pressure or of c t. */
static void report_profile(struct measurement *m, const struct parameters *p,
                           const struct profile *profile)
{
    const double front = step_wave_celerity(&p->wave) * p->time;
    double highest = 0.0, ahead = 0.0;
    for (size_t k = 0; k < profile->count; k++) {
        highest = field_larger(highest, profile->pressure[k]);
        if (profile->x[k] > 1.2 * front)
            ahead = field_larger(ahead, fabs(profile->pressure[k]));
    }
    measurement_report(m, "arrival", 100.0 * (half_place(profile) / front - 1.0));
    measurement_report(m, "level",
                       100.0 * mean_between(profile, p->level_from * front, p->level_to * front));
    measurement_report(m, "overshoot", 100.0 * (highest - 1.0));
    measurement_report(m, "precursor", 100.0 * ahead);
    measurement_report(m, "error_l1", 100.0 * error_l1(profile, front));
}

/* A run and what came of it. */
struct study {
    const struct parameters *parameters;
    struct follow_result result;
    struct profile profile;
};

/* Up to the time of the measurement. */
static enum mpm_status measure(void *context, struct measurement *m, const struct mpm_scene *scene,
                               struct mpm_simulation *simulation, struct mpm_error *error)
{
    struct study *const study = context;
    const double time = study->parameters->time;
    const struct follow follow = {.measurement = m, .end = time, .interval = time / 50.0};
    (void)scene;
    TRY(follow_run(&follow, simulation, &study->result, error));
    return read_profile(study->parameters, simulation, &study->profile, error);
}

static enum mpm_status run(struct measurement *m, struct mpm_error *error)
{
    struct parameters p;
    struct levels levels;
    struct study study = {.parameters = &p};
    double errors[LEVELS_MAX] = {0};
    TRY(read_parameters(m, &p, error));
    TRY(levels_read(m, &levels, error));
    const double front = step_wave_celerity(&p.wave) * p.time;
    for (size_t k = 0; k < levels_runs(&levels); k++) {
        enum mpm_status status =
            follow_scene(m, &levels.setting[k], levels.count == 0 ? 0 : 1, measure, &study, error);
        const bool last = k + 1 == levels_runs(&levels);
        if (status == MPM_OK) {
            errors[k] = 100.0 * error_l1(&study.profile, front);
            if (last)
                report_profile(m, &p, &study.profile);
            if (last)
                status = write_profile(m, &p, &study.profile, error);
        }
        free_profile(&study.profile);
        TRY(status);
    }
    follow_report(m, &study.result, 0.0);
    return levels.count > 0 ? levels_report(m, &levels, "", errors, error) : MPM_OK;
}

const struct measure_program program_step_wave = {
    .name = "step_wave",
    .summary = "the front of a step wave: arrival, level, overshoot, L1 error",
    .run = run,
};
