/* T1, T3, T4 and the static R1: a body under load against its exact state of rest.
 *
 * The scene runs until it is at rest, or to its end if it does not ask for rest. Then all particles
 * are held against the exact state at their initial places. Errors are in percent of the largest
 * exact stress, displacement and strain.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/measures/fields.h"
#include "verification/measures/particle_set.h"
#include "verification/suite/follow.h"
#include "verification/suite/levels.h"
#include "verification/suite/static_solution.h"

#include <glib.h>
#include <math.h>

enum { AXES = STATIC_AXES, STRESS = STATIC_STRESS, GRADIENT = 5, COLUMNS = 10, ALONG = 1 };

/* Errors of one run. */
struct errors {
    double pair_stress_l2;        /* of the means of two particles each, see pair_error */
    double inner_displacement_l2; /* without four particles at either end of a row */
    double stress_worst, stress_l2, displacement_worst, displacement_l2, strain_worst;
    double axial_worst;            /* of the stress along y or z */
    double edge_axial, rest_axial; /* its mean in the uppermost row, and below the middle */
};

struct outcome {
    struct errors errors;
    double time;
    double imbalance; /* of the energy, over the work of external forces */
    bool finished;
};

/* What is seen of the particles. */
struct view {
    struct particle_set set;
    double *strain, *mass; /* AXES a particle; 1 */
};

static enum mpm_status open_view(const struct mpm_simulation *simulation, struct view *view,
                                 struct mpm_error *error)
{
    TRY(particle_set_create(simulation, 0, &view->set, error));
    view->strain = g_new(double, AXES * view->set.count);
    view->mass = g_new(double, view->set.count);
    return MPM_OK;
}

static void read_view(struct view *view, const struct mpm_simulation *simulation)
{
    struct particle_set *const set = &view->set;
    particle_set_read(set, simulation);
    mpm_simulation_field(simulation, MPM_FIELD_MASS, set->all);
    for (size_t k = 0; k < set->count; k++)
        view->mass[k] = set->all[set->index[k]];
    mpm_simulation_field(simulation, MPM_FIELD_DEFORMATION_GRADIENT, set->all);
    for (size_t k = 0; k < set->count; k++) {
        const double *const f = &set->all[GRADIENT * set->index[k]];
        view->strain[AXES * k] = f[0] - 1.0;
        view->strain[AXES * k + 1] = f[3] - 1.0;
    }
}

static void close_view(struct view *view)
{
    particle_set_free(&view->set);
    g_free(view->strain);
    g_free(view->mass);
}

/* --------------------------------------------------------------- measuring */

/* Root of the mean square over the mass, and the largest value. */
struct norm {
    double squares, mass, largest;
};

static void norm_add(struct norm *norm, const double *value, const double *exact, size_t count,
                     double mass)
{
    double square = 0.0;
    for (size_t c = 0; c < count; c++) {
        const double difference = value[c] - exact[c];
        square += difference * difference;
        norm->largest = field_larger(norm->largest, fabs(difference));
    }
    norm->squares += mass * square;
    norm->mass += mass;
}

static double norm_l2(const struct norm *norm)
{
    return sqrt(norm->squares / norm->mass);
}

/* The error of the mean stress of particles 2 k and 2 k + 1, the two of a cell in a row of them:
 * the gradients of hat functions are those of the cell, and exact to second order at its centre
 * only. */
static double pair_error(const struct static_solution *solution, const struct view *view)
{
    const double *const sigma = view->set.stress;
    struct norm norm = {0};
    for (size_t k = 0; k + 1 < view->set.count; k += 2) {
        const struct static_state exact[2] = {
            solution->at(solution, &view->set.start[AXES * k]),
            solution->at(solution, &view->set.start[AXES * (k + 1)]),
        };
        double mean[STRESS], exact_mean[STRESS];
        for (size_t c = 0; c < STRESS; c++) {
            mean[c] = 0.5 * (sigma[STRESS * k + c] + sigma[STRESS * (k + 1) + c]);
            exact_mean[c] = 0.5 * (exact[0].stress[c] + exact[1].stress[c]);
        }
        norm_add(&norm, mean, exact_mean, STRESS, view->mass[k] + view->mass[k + 1]);
    }
    return norm_l2(&norm);
}

static double highest_start(const struct particle_set *set)
{
    double highest = -HUGE_VAL;
    for (size_t k = 0; k < set->count; k++)
        highest = fmax(highest, set->start[AXES * k + ALONG]);
    return highest;
}

/* Mean axial stress of the particles that began between two heights. */
static double mean_axial(const struct view *view, double from, double to)
{
    double sum = 0.0, mass = 0.0;
    for (size_t k = 0; k < view->set.count; k++) {
        const double start = view->set.start[AXES * k + ALONG];
        if (start < from || start > to)
            continue;
        sum += view->mass[k] * view->set.stress[STRESS * k + ALONG];
        mass += view->mass[k];
    }
    return sum / mass;
}

/* In a row of particles, without two cells at either end: what faces do not spoil. */
static double inner_error(const struct static_solution *solution, const struct view *view)
{
    enum { AWAY = 4 };
    const struct particle_set *const set = &view->set;
    struct norm norm = {0};
    for (size_t k = AWAY; k + AWAY < set->count; k++) {
        const double *const start = &set->start[AXES * k];
        const struct static_state exact = solution->at(solution, start);
        const double moved[AXES] = {set->position[AXES * k] - start[0],
                                    set->position[AXES * k + 1] - start[1]};
        norm_add(&norm, moved, exact.displacement, AXES, view->mass[k]);
    }
    return norm_l2(&norm);
}

static struct errors measure(const struct static_solution *solution, const struct view *view)
{
    const struct particle_set *const set = &view->set;
    const double highest = highest_start(set);
    struct norm stress = {0}, displacement = {0}, strain = {0}, axial = {0};
    for (size_t k = 0; k < set->count; k++) {
        const double *const start = &set->start[AXES * k];
        const double *const sigma = &set->stress[STRESS * k];
        const struct static_state exact = solution->at(solution, start);
        const double moved[AXES] = {set->position[AXES * k] - start[0],
                                    set->position[AXES * k + 1] - start[1]};
        norm_add(&stress, sigma, exact.stress, STRESS, view->mass[k]);
        norm_add(&axial, &sigma[ALONG], &exact.stress[ALONG], 1, view->mass[k]);
        norm_add(&displacement, moved, exact.displacement, AXES, view->mass[k]);
        norm_add(&strain, &view->strain[AXES * k], exact.strain, AXES, view->mass[k]);
    }
    const double of_stress = 100.0 / solution->stress_scale;
    const double of_displacement = 100.0 / solution->displacement_scale;
    return (struct errors){
        .pair_stress_l2 = of_stress * pair_error(solution, view),
        .inner_displacement_l2 = of_displacement * inner_error(solution, view),
        .stress_worst = of_stress * stress.largest,
        .stress_l2 = of_stress * norm_l2(&stress),
        .displacement_worst = of_displacement * displacement.largest,
        .displacement_l2 = of_displacement * norm_l2(&displacement),
        .strain_worst = 100.0 / solution->strain_scale * strain.largest,
        .axial_worst = of_stress * axial.largest,
        .edge_axial = mean_axial(view, highest * (1.0 - 1e-9), HUGE_VAL),
        .rest_axial = mean_axial(view, -HUGE_VAL, 0.5 * highest),
    };
}

static enum mpm_status write_profile(struct measurement *m, const struct static_solution *solution,
                                     const struct view *view, struct mpm_error *error)
{
    const struct particle_set *const set = &view->set;
    double *const rows = g_new(double, COLUMNS * set->count);
    for (size_t k = 0; k < set->count; k++) {
        const double *const start = &set->start[AXES * k];
        const struct static_state exact = solution->at(solution, start);
        double *const row = &rows[COLUMNS * k];
        row[0] = start[0];
        row[1] = start[1];
        for (size_t c = 0; c < STRESS; c++)
            row[2 + c] = set->stress[STRESS * k + c];
        for (size_t c = 0; c < STRESS; c++)
            row[2 + STRESS + c] = exact.stress[c];
    }
    const enum mpm_status status =
        measurement_series(m, "profile", "x0 y0 xx yy zz xy exact_xx exact_yy exact_zz exact_xy",
                           COLUMNS, set->count, rows, error);
    g_free(rows);
    return status;
}

/* ----------------------------------------------------------------- running */

/* To rest or to the end; *finished: that was reached. */
static enum mpm_status settle(struct measurement *m, struct mpm_simulation *simulation, double end,
                              bool *finished, struct mpm_error *error)
{
    struct mpm_rest rest;
    bool alive = true, at_rest = mpm_simulation_at_rest(simulation, &rest);
    while (alive && !at_rest && mpm_simulation_time(simulation) < end) {
        TRY(follow_step(m, simulation, end, &alive, error));
        at_rest = mpm_simulation_at_rest(simulation, &rest);
    }
    follow_count_work(m, simulation);
    *finished = alive && (at_rest || !rest.asked);
    if (alive && !*finished)
        measurement_note(m, "not at rest at the end: residual %g, kinetic energy %g", rest.residual,
                         rest.kinetic_energy);
    return MPM_OK;
}

/* A run: its solution, and whether its profile is written. */
struct study {
    const struct static_solution *solution;
    bool last;
    struct outcome *outcome;
};

static enum mpm_status measure_scene(void *context, struct measurement *m,
                                     const struct mpm_scene *scene,
                                     struct mpm_simulation *simulation, struct mpm_error *error)
{
    const struct study *const study = context;
    struct outcome *const outcome = study->outcome;
    struct view view = {0};
    struct mpm_ledger start, now;
    mpm_simulation_ledger(simulation, &start);
    enum mpm_status status = open_view(simulation, &view, error);
    if (status == MPM_OK)
        status = settle(m, simulation, mpm_scene_end_time(scene), &outcome->finished, error);
    if (status == MPM_OK) {
        mpm_simulation_ledger(simulation, &now);
        outcome->time = now.time;
        outcome->imbalance = (now.total_energy - start.total_energy) / now.external_work - 1.0;
        read_view(&view, simulation);
        outcome->errors = measure(study->solution, &view);
        if (study->last)
            status = write_profile(m, study->solution, &view, error);
    }
    close_view(&view);
    return status;
}

/* --------------------------------------------------------------- reporting */

static void report(struct measurement *m, const struct static_solution *solution,
                   const struct outcome *outcome)
{
    const struct errors *const e = &outcome->errors;
    const struct {
        const char *name;
        double value;
    } table[] = {
        {"pair_stress_l2", e->pair_stress_l2},
        {"inner_displacement_l2", e->inner_displacement_l2},
        {"stress_worst", e->stress_worst},
        {"stress_l2", e->stress_l2},
        {"axial_worst", e->axial_worst},
        {"displacement_worst", e->displacement_worst},
        {"displacement_l2", e->displacement_l2},
        {"strain_worst", e->strain_worst},
        {"edge_stress", 100.0 * e->edge_axial / solution->stress_scale},
        {"interior_stress", 100.0 * e->rest_axial / solution->stress_scale},
    };
    for (size_t k = 0; k < sizeof table / sizeof *table; k++)
        if (outcome->finished)
            measurement_report(m, table[k].name, table[k].value);
        else
            measurement_inconclusive(m, table[k].name, "the run did not come to its end");
    measurement_report(m, "finished", outcome->finished ? 1.0 : 0.0);
    measurement_report(m, "reached", outcome->time);
    measurement_report(m, "energy_drift", 100.0 * fabs(outcome->imbalance));
}

/* Errors over the levels, by kind. */
enum kind { OF_STRESS, OF_PAIRS, OF_DISPLACEMENT, OF_INNER, KINDS };
static const char *const suffixes[KINDS] = {"_stress", "_pairs", "_displacement", "_inner"};

static enum mpm_status report_orders(struct measurement *m, const struct levels *levels,
                                     double errors[KINDS][LEVELS_MAX], bool finished,
                                     struct mpm_error *error)
{
    for (size_t k = 0; k < KINDS; k++) {
        if (finished) {
            TRY(levels_report(m, levels, suffixes[k], errors[k], error));
            continue;
        }
        for (size_t order = 0; order < 2; order++) {
            char *const name =
                g_strconcat(order == 0 ? "order_last" : "order_fitted", suffixes[k], NULL);
            measurement_inconclusive(m, name, "a grid's run did not come to its end");
            g_free(name);
        }
    }
    return MPM_OK;
}

static enum mpm_status run(struct measurement *m, struct mpm_error *error)
{
    struct static_solution solution;
    struct levels levels;
    double errors[KINDS][LEVELS_MAX] = {{0.0}};
    struct outcome outcome = {.finished = false};
    bool finished = true;
    TRY(static_solution_read(m, &solution, error));
    TRY(levels_read(m, &levels, error));
    for (size_t k = 0; k < levels_runs(&levels); k++) {
        const bool last = k + 1 == levels_runs(&levels);
        outcome = (struct outcome){.finished = false};
        struct study study = {&solution, last, &outcome};
        TRY(follow_scene(m, &levels.setting[k], levels.count == 0 ? 0 : 1, measure_scene, &study,
                         error));
        errors[OF_STRESS][k] = outcome.errors.stress_l2;
        errors[OF_PAIRS][k] = outcome.errors.pair_stress_l2;
        errors[OF_INNER][k] = outcome.errors.inner_displacement_l2;
        errors[OF_DISPLACEMENT][k] = outcome.errors.displacement_l2;
        finished = finished && outcome.finished;
    }
    report(m, &solution, &outcome);
    if (levels.count > 0)
        return report_orders(m, &levels, errors, finished, error);
    return MPM_OK;
}

const struct measure_program program_statics = {
    .name = "statics",
    .summary = "a body under load against its exact state of rest",
    .run = run,
};
