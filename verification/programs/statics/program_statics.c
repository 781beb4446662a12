/* T1, T3, T4 and the static R1: a body under load against its exact state of rest.
 *
 * The scene runs until it is at rest, or to its end if it has no `time.rest`. Then all particles
 * are held against the exact state at their initial places. Errors are in percent of the largest
 * exact stress, displacement and strain.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/measures/error_norms.h"
#include "verification/measures/particle_set.h"
#include "verification/programs/follow.h"
#include "verification/programs/levels.h"
#include "verification/programs/statics/static_solution.h"

#include <glib.h>
#include <math.h>

enum { AXES = STATIC_AXES, STRESS = STATIC_STRESS, GRADIENT = 5, COLUMNS = 10, ALONG = 1 };

/* Errors of one run. */
struct errors {
    double pair_stress_l2;        /* of the means of two particles each, see pair_error */
    double inner_displacement_l2; /* without four particles at either end of a row */
    double stress_worst, stress_l2, displacement_worst, displacement_l2, strain_worst;
    /* mean stress along y or z in the uppermost row, and below the middle */
    double edge_axial, rest_axial;
};

struct outcome {
    struct errors errors;
    double time;
    double imbalance; /* of the energy, over the work of external forces */
    bool finished;
};

/* What is seen of the particles, and what should be. */
struct view {
    struct particle_set set;
    double *mass;
    double *strain, *exact_strain; /* AXES a particle */
    double *moved, *exact_moved;
    double *exact_stress; /* STRESS a particle */
};

static enum mpm_status open_view(const struct mpm_simulation *simulation, struct view *view,
                                 struct mpm_error *error)
{
    TRY(particle_set_create(simulation, 0, &view->set, error));
    const size_t n = view->set.count;
    view->mass = g_new(double, n);
    view->strain = g_new(double, AXES *n);
    view->exact_strain = g_new(double, AXES *n);
    view->moved = g_new(double, AXES *n);
    view->exact_moved = g_new(double, AXES *n);
    view->exact_stress = g_new(double, STRESS *n);
    return MPM_OK;
}

static void read_view(struct view *view, const struct static_solution *solution,
                      const struct mpm_simulation *simulation)
{
    struct particle_set *const set = &view->set;
    particle_set_read(set, simulation);
    mpm_simulation_field(simulation, MPM_FIELD_MASS, set->all);
    for (size_t k = 0; k < set->count; k++)
        view->mass[k] = set->all[set->index[k]];
    mpm_simulation_field(simulation, MPM_FIELD_DEFORMATION_GRADIENT, set->all);
    for (size_t k = 0; k < set->count; k++) {
        const double *const f = &set->all[GRADIENT * set->index[k]];
        const struct static_state exact = solution->at(solution, &set->start[AXES * k]);
        view->strain[AXES * k] = f[0] - 1.0;
        view->strain[AXES * k + 1] = f[3] - 1.0;
        for (size_t c = 0; c < AXES; c++) {
            view->moved[AXES * k + c] = set->position[AXES * k + c] - set->start[AXES * k + c];
            view->exact_moved[AXES * k + c] = exact.displacement[c];
            view->exact_strain[AXES * k + c] = exact.strain[c];
        }
        for (size_t c = 0; c < STRESS; c++)
            view->exact_stress[STRESS * k + c] = exact.stress[c];
    }
}

static void close_view(struct view *view)
{
    particle_set_free(&view->set);
    g_free(view->mass);
    g_free(view->strain);
    g_free(view->exact_strain);
    g_free(view->moved);
    g_free(view->exact_moved);
    g_free(view->exact_stress);
}

/* --------------------------------------------------------------- measuring */

/* Of all particles' components, the worst one. */
static double worst(size_t count, const double *computed, const double *exact)
{
    return error_norms(count, 1, NULL, NULL, computed, exact).linf;
}

/* The error of the mean stress of particles 2 k and 2 k + 1, the two of a cell in a row of them:
 * the gradients of hat functions are those of the cell, and exact to second order at its centre
 * only. */
static double pair_error(const struct view *view)
{
    const double *const sigma = view->set.stress, *const exact = view->exact_stress;
    const size_t pairs = view->set.count / 2;
    double *const mean = g_new(double, STRESS *pairs);
    double *const exact_mean = g_new(double, STRESS *pairs);
    double *const mass = g_new(double, pairs);
    for (size_t k = 0; k < pairs; k++) {
        mass[k] = view->mass[2 * k] + view->mass[2 * k + 1];
        for (size_t c = 0; c < STRESS; c++) {
            const size_t one = 2 * STRESS * k + c, other = one + STRESS;
            mean[STRESS * k + c] = 0.5 * (sigma[one] + sigma[other]);
            exact_mean[STRESS * k + c] = 0.5 * (exact[one] + exact[other]);
        }
    }
    const double error = error_norms(pairs, STRESS, NULL, mass, mean, exact_mean).l2;
    g_free(mean);
    g_free(exact_mean);
    g_free(mass);
    return error;
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

/* Of displacement in a row of particles, without two cells at either end: what faces do not
 * spoil. */
static double inner_error(const struct view *view)
{
    enum { AWAY = 4 };
    const size_t n = view->set.count;
    double *const mass = g_new0(double, n);
    for (size_t k = AWAY; k + AWAY < n; k++)
        mass[k] = view->mass[k];
    const double error = error_norms(n, AXES, NULL, mass, view->moved, view->exact_moved).l2;
    g_free(mass);
    return error;
}

static struct errors measure(const struct static_solution *solution, const struct view *view)
{
    const struct particle_set *const set = &view->set;
    const size_t n = set->count;
    const double highest = highest_start(set), *const mass = view->mass;
    const double of_stress = 100.0 / solution->stress_scale;
    const double of_displacement = 100.0 / solution->displacement_scale;
    const double of_strain = 100.0 / solution->strain_scale;
    const struct error_norms stress =
        error_norms(n, STRESS, NULL, mass, set->stress, view->exact_stress);
    const struct error_norms displacement =
        error_norms(n, AXES, NULL, mass, view->moved, view->exact_moved);
    return (struct errors){
        .pair_stress_l2 = of_stress * pair_error(view),
        .inner_displacement_l2 = of_displacement * inner_error(view),
        .stress_worst = of_stress * worst(STRESS * n, set->stress, view->exact_stress),
        .stress_l2 = of_stress * stress.l2,
        .displacement_worst = of_displacement * worst(AXES * n, view->moved, view->exact_moved),
        .displacement_l2 = of_displacement * displacement.l2,
        .strain_worst = of_strain * worst(AXES * n, view->strain, view->exact_strain),
        .edge_axial = mean_axial(view, highest * (1.0 - 1e-9), HUGE_VAL),
        .rest_axial = mean_axial(view, -HUGE_VAL, 0.5 * highest),
    };
}

static enum mpm_status write_profile(struct measurement *m, const struct view *view,
                                     struct mpm_error *error)
{
    const struct particle_set *const set = &view->set;
    double *const rows = g_new(double, COLUMNS * set->count);
    for (size_t k = 0; k < set->count; k++) {
        double *const row = &rows[COLUMNS * k];
        row[0] = set->start[AXES * k];
        row[1] = set->start[AXES * k + 1];
        for (size_t c = 0; c < STRESS; c++)
            row[2 + c] = set->stress[STRESS * k + c];
        for (size_t c = 0; c < STRESS; c++)
            row[2 + STRESS + c] = view->exact_stress[STRESS * k + c];
    }
    const enum mpm_status status =
        measurement_series(m, "profile", "x0 y0 xx yy zz xy exact_xx exact_yy exact_zz exact_xy",
                           COLUMNS, set->count, rows, error);
    g_free(rows);
    return status;
}

/* ----------------------------------------------------------------- running */

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
        status =
            follow_to_rest(m, simulation, mpm_scene_end_time(scene), &outcome->finished, error);
    if (status == MPM_OK) {
        mpm_simulation_ledger(simulation, &now);
        outcome->time = now.time;
        outcome->imbalance = (now.total_energy - start.total_energy) / now.external_work - 1.0;
        read_view(&view, study->solution, simulation);
        outcome->errors = measure(study->solution, &view);
        if (study->last)
            status = write_profile(m, &view, error);
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
        {"stress_worst", e->stress_worst},
        {"stress_l2", e->stress_l2},
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
    measurement_report(m, "energy_imbalance", 100.0 * fabs(outcome->imbalance));
}

/* Errors over the levels, by kind. */
enum kind { OF_STRESS, OF_PAIRS, OF_DISPLACEMENT, OF_INNER, KINDS };
static const char *const suffixes[KINDS] = {"_stress", "_pairs", "_displacement", "_inner"};

static enum mpm_status run(struct measurement *m, struct mpm_error *error)
{
    struct static_solution solution;
    struct levels levels;
    double errors[KINDS][LEVELS_MAX] = {{0.0}};
    struct outcome outcome = {.finished = false};
    TRY(static_solution_read(m, &solution, error));
    TRY(levels_read(m, &levels, error));
    for (size_t k = 0; k < levels_runs(&levels); k++) {
        const bool last = k + 1 == levels_runs(&levels);
        outcome = (struct outcome){.finished = false};
        struct study study = {&solution, last, &outcome};
        TRY(follow_scene(m, &levels.setting[k], levels.count == 0 ? 0 : 1, measure_scene, &study,
                         error));
        const double missing = outcome.finished ? 0.0 : (double)NAN;
        errors[OF_STRESS][k] = missing + outcome.errors.stress_l2;
        errors[OF_PAIRS][k] = missing + outcome.errors.pair_stress_l2;
        errors[OF_INNER][k] = missing + outcome.errors.inner_displacement_l2;
        errors[OF_DISPLACEMENT][k] = missing + outcome.errors.displacement_l2;
    }
    report(m, &solution, &outcome);
    for (size_t k = 0; levels.count > 0 && k < KINDS; k++)
        TRY(levels_report(m, &levels, suffixes[k], errors[k], error));
    return MPM_OK;
}

const struct measure_program program_statics = {
    .name = "statics",
    .summary = "a body under load against its exact state of rest",
    .run = run,
};
