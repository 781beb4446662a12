/* G1: the largest Courant number for which small problems stay bounded, by ladder and bisection.
 *
 * A run is stable if it reaches its end and its energy, less the work done on it, never exceeds
 * that of the start by more than a stated part.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/waves/linear_step.h"
#include "verification/measures/bisection.h"
#include "verification/programs/programs.h"

#include <glib.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

enum {
    PROBLEMS_MAX = 16,
    RUNGS_MAX = 32,
    CELLS_MAX = 1000,
    COLUMNS = 4,
    SETTINGS = 4,
    SETTING_SIZE = 64
};

struct problem {
    char name[SETTING_SIZE];
    const char *scene; /* a file of the case; waves of speed 1 at density 1, velocities of 1 */
    double amplitude;  /* velocity over wave speed: its square is the density */
};

struct study {
    struct measurement *measurement;
    struct problem problems[PROBLEMS_MAX];
    size_t problem_count;
    double rungs[RUNGS_MAX]; /* Courant numbers, rising */
    size_t rung_count;
    double duration;               /* of a run, in times that a wave takes through a cell */
    double growth;                 /* of the energy, from which on a run is unstable */
    double tolerance;              /* of the bisection */
    const struct problem *problem; /* the one at hand */
    size_t tested;                 /* runs of it so far: the ladder comes first */
    double limits[PROBLEMS_MAX * COLUMNS];
    double ladder[RUNGS_MAX * 2]; /* each rung, and how many problems it keeps bounded */
};

/* --------------------------------------------------------------------- parameters */

static enum mpm_status read_rungs(struct study *study, struct mpm_error *error)
{
    const char *text;
    TRY(measurement_text(study->measurement, "courants", &text, error));
    char **words = g_strsplit(text, " ", RUNGS_MAX);
    for (; words[study->rung_count] != NULL; study->rung_count++)
        study->rungs[study->rung_count] = g_ascii_strtod(words[study->rung_count], NULL);
    g_strfreev(words);
    for (size_t k = 0; k < study->rung_count; k++)
        if (!(study->rungs[k] > (k == 0 ? 0.0 : study->rungs[k - 1])))
            return failure_set(error, MPM_BAD_INPUT,
                               "courants: \"%s\": allowed are rising numbers above 0", text);
    return MPM_OK;
}

static enum mpm_status read_problem(struct study *study, const char *name, struct mpm_error *error)
{
    struct problem *const problem = &study->problems[study->problem_count++];
    char key[2 * SETTING_SIZE];
    (void)snprintf(problem->name, sizeof problem->name, "%s", name);
    (void)snprintf(key, sizeof key, "%s_scene", problem->name);
    TRY(measurement_text(study->measurement, key, &problem->scene, error));
    (void)snprintf(key, sizeof key, "%s_amplitude", problem->name);
    return measurement_number(study->measurement, key, &problem->amplitude, error);
}

static enum mpm_status read_parameters(struct study *study, struct mpm_error *error)
{
    struct measurement *const m = study->measurement;
    const char *problems;
    TRY(measurement_number(m, "duration", &study->duration, error));
    TRY(measurement_number(m, "growth", &study->growth, error));
    TRY(measurement_number(m, "tolerance", &study->tolerance, error));
    TRY(read_rungs(study, error));
    TRY(measurement_text(m, "problems", &problems, error));
    char **names = g_strsplit(problems, " ", PROBLEMS_MAX);
    enum mpm_status status = MPM_OK;
    for (char **name = names; status == MPM_OK && *name != NULL; name++)
        status = read_problem(study, *name, error);
    g_strfreev(names);
    return status;
}

/* ------------------------------------------------------------------------ one run */

/* Energy is sampled so often, and a run has so many times the steps that its Courant number
 * requires: one that needs more has let its wave speed run away. */
enum { LOOK_STEPS = 8, STEPS_FACTOR = 10 };

static double energy_of(const struct mpm_simulation *simulation)
{
    struct mpm_ledger ledger;
    mpm_simulation_ledger(simulation, &ledger);
    return ledger.total_energy - ledger.external_work;
}

static enum mpm_status watch(const struct study *study, struct mpm_simulation *simulation,
                             double end, double most_steps, bool *stable, struct mpm_error *error)
{
    const double limit = (1.0 + study->growth) * energy_of(simulation);
    *stable = true;
    while (*stable && mpm_simulation_time(simulation) < end) {
        const enum mpm_status status = mpm_simulation_advance(simulation, end, error);
        if (status != MPM_OK && status != MPM_RUN_FAILED)
            return status;
        const uint64_t step = mpm_simulation_step(simulation);
        *stable = status == MPM_OK && (double)step < most_steps;
        if (*stable && (step % LOOK_STEPS == 0 || mpm_simulation_time(simulation) >= end))
            *stable = energy_of(simulation) <= limit;
    }
    return MPM_OK;
}

static enum mpm_status test_courant(void *context, double courant, bool *stable,
                                    struct mpm_error *error)
{
    struct study *const study = context;
    const struct problem *const problem = study->problem;
    const double end = study->duration * problem->amplitude;
    char settings[SETTINGS][SETTING_SIZE];
    (void)snprintf(settings[0], SETTING_SIZE, "materials.0.density=%.17g",
                   problem->amplitude * problem->amplitude);
    (void)snprintf(settings[1], SETTING_SIZE, "time.end=%.17g", end);
    (void)snprintf(settings[2], SETTING_SIZE, "time.courant=%.17g", courant);
    (void)snprintf(settings[3], SETTING_SIZE, "time.allow_unstable=true");
    const char *const texts[SETTINGS] = {settings[0], settings[1], settings[2], settings[3]};
    struct mpm_scene *scene = NULL;
    struct mpm_simulation *simulation = NULL;
    enum mpm_status status =
        measurement_scene_file(study->measurement, problem->scene, texts, SETTINGS, &scene, error);
    if (status == MPM_OK)
        status = mpm_simulation_create(scene, measurement_options(study->measurement), &simulation,
                                       error);
    if (status == MPM_OK)
        status =
            watch(study, simulation, end, STEPS_FACTOR * study->duration / courant, stable, error);
    if (status == MPM_OK) {
        measurement_work(study->measurement, mpm_simulation_step(simulation) *
                                                 mpm_simulation_particle_count(simulation));
        if (study->tested < study->rung_count) {
            study->ladder[2 * study->tested] = courant;
            study->ladder[2 * study->tested + 1] += *stable ? 1.0 : 0.0;
        }
        study->tested++;
    }
    mpm_simulation_free(simulation);
    mpm_scene_free(scene);
    return status;
}

/* ------------------------------------------------------------------------ results */

static void report_problem(const struct study *study, const struct bisection_border *border)
{
    char quantity[2 * SETTING_SIZE];
    (void)snprintf(quantity, sizeof quantity, "largest_stable_courant_%s", study->problem->name);
    measurement_report(study->measurement, quantity, border->passes);
    if (border->stray > 0)
        measurement_note(study->measurement,
                         "%s: unstable at Courant number %.3g, but stable at %zu larger ones of "
                         "the ladder",
                         study->problem->name, border->fails, border->stray);
    if (!isfinite(border->fails))
        measurement_note(study->measurement, "%s: stable up to the end of the ladder, %.3g",
                         study->problem->name, border->passes);
}

/* Place of `name` among `count` names, or `count`. */
static size_t place_of(const char *name, const char *const *names, size_t count)
{
    size_t place = 0;
    while (place < count && strcmp(names[place], name) != 0)
        place++;
    return place;
}

/* `theory`: "SHAPE ORDER" of a bar of `cells` cells with `particles` along x in each, whose linear
 * theory is beside the first problem. */
static enum mpm_status report_theory(const struct study *study, double limit,
                                     struct mpm_error *error)
{
    static const char *const shapes[] = {"classic", "ugimp", "bspline2", "bspline3"};
    static const char *const orders[] = {"usl", "musl", "usf", "usavg"};
    enum { SHAPES = sizeof shapes / sizeof *shapes, ORDERS = sizeof orders / sizeof *orders };
    const char *text;
    unsigned cells, particles;
    char shape[16] = "", order[16] = "";
    TRY(measurement_text(study->measurement, "theory", &text, error));
    TRY(measurement_count(study->measurement, "cells", 1, CELLS_MAX, &cells, error));
    TRY(measurement_count(study->measurement, "particles", 1, LINEAR_PARTICLES_MAX, &particles,
                          error));
    (void)sscanf(text, "%15s %15s", shape, order);
    const size_t s = place_of(shape, shapes, SHAPES), o = place_of(order, orders, ORDERS);
    if (s == SHAPES || o == ORDERS)
        return failure_set(error, MPM_BAD_INPUT, "theory: \"%s\": allowed are a shape and an order",
                           text);
    const struct linear_row row = {(enum linear_shape)s, (enum linear_order)o, particles, 0.0};
    const double predicted = linear_step_limit(&row, (int)cells);
    measurement_report(study->measurement, "predicted", predicted);
    measurement_report(study->measurement, "over_predicted", limit / predicted);
    const double pair[2] = {predicted, limit};
    return measurement_series(study->measurement, "theory", "predicted found", 2, 1, pair, error);
}

/* `known`: 1 and what the solver's table of limits has too much for this method, in problems up to
 * that amplitude and beyond. */
static enum mpm_status report_known(const struct study *study, struct mpm_error *error)
{
    struct mpm_scene *scene = NULL;
    double border, small = HUGE_VAL, large = HUGE_VAL;
    TRY(measurement_number(study->measurement, "known", &border, error));
    for (size_t k = 0; k < study->problem_count; k++) {
        const double limit = study->limits[COLUMNS * k + 2];
        if (study->problems[k].amplitude <= border)
            small = fmin(small, limit);
        else
            large = fmin(large, limit);
    }
    TRY(measurement_scene_file(study->measurement, study->problems[0].scene, NULL, 0, &scene,
                               error));
    const struct mpm_stability known = mpm_scene_stability(scene);
    mpm_scene_free(scene);
    measurement_report(study->measurement, "table_small", 1.0 + (known.small - small));
    measurement_report(study->measurement, "table_large", 1.0 + (known.large - large));
    measurement_report(study->measurement, "table_measured", known.measured ? 1.0 : 0.0);
    return MPM_OK;
}

static enum mpm_status map(struct study *study, struct mpm_error *error)
{
    struct measurement *const m = study->measurement;
    double least = HUGE_VAL, first = 0.0;
    size_t passed = 0, stray = 0;
    double *limit = study->limits;
    for (size_t k = 0; k < study->problem_count; k++) {
        struct bisection_border border;
        study->problem = &study->problems[k];
        study->tested = 0;
        TRY(bisection_find(study->rungs, study->rung_count, study->tolerance, test_courant, study,
                           &border, error));
        report_problem(study, &border);
        *limit++ = (double)k;
        *limit++ = study->problem->amplitude;
        *limit++ = border.passes;
        *limit++ = border.fails;
        least = fmin(least, border.passes);
        first = k == 0 ? border.passes : first;
        passed += border.passed;
        stray += border.stray;
    }
    measurement_report(m, "largest_stable_courant", least);
    measurement_report(m, "fraction_finished",
                       100.0 * (double)passed / (double)(study->problem_count * study->rung_count));
    measurement_report(m, "stray", (double)stray);
    if (measurement_has(m, "theory"))
        TRY(report_theory(study, first, error));
    if (measurement_has(m, "known"))
        TRY(report_known(study, error));
    TRY(measurement_series(m, "limits", "problem amplitude stable unstable", COLUMNS,
                           study->problem_count, study->limits, error));
    return measurement_series(m, "ladder", "courant problems", 2, study->rung_count, study->ladder,
                              error);
}

static enum mpm_status run(struct measurement *measurement, struct mpm_error *error)
{
    struct study study = {.measurement = measurement};
    TRY(read_parameters(&study, error));
    return map(&study, error);
}

const struct measure_program program_stability = {
    .name = "stability",
    .summary = "largest Courant number for which small problems stay bounded",
    .run = run,
};
