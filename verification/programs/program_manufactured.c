/* M: a manufactured solution on levels of refinement, in space, time and particles per cell, alone
 * or together: errors of displacement, velocity, F and stress at all particles, observed orders,
 * the constants of the errors, the grid-convergence index.
 *
 * Parameters of a case:
 *
 *   field, law, geometry, density, bulk, shear   the problem (exact/manufactured.h), as its scene
 *                                                has it; any parameter of the field by its name
 *   end             time, if given
 *   cell_x, cell_y  of the scene with grid.refine=1
 *   length          h is the larger side of a cell over this
 *   refine, particles, steps
 *                   of the first level: grid.refine, particles on a cell's side, steps
 *   looks           instants at which errors are measured
 *   levels          how many; from each to the next the factors (1 or 2) refine_space,
 *                   refine_time and refine_particles
 *   margin          if given, particles that start nearer to an edge are not measured
 *   start_at_once   if given, all starts at t = 0, whatever the times that the scheme requires
 *   picture         if given, the fields of the last level are written at the end
 *
 * Reported, with a suffix for each quantity (_u, _v, _F, _stress), of errors over the size of the
 * exact field: error, error_l1 and error_max on the finest level, in percent; order_last,
 * order_fitted, order_width, order_class and order_max (of L-infinity) over the levels; constant.
 * Of the amplitude of u: index (percent), index_order, index_cover. finished; levels_finished, how
 * many.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/measures/grid_convergence.h"
#include "verification/measures/orders.h"
#include "verification/programs/levels.h"
#include "verification/programs/manufactured_level.h"

#include <assert.h>
#include <glib.h>
#include <math.h>

enum { COLUMNS = 2 + 3 * MANUFACTURED_QUANTITIES };

/* A study: the problem, its first level, and what becomes of it from level to level. */
struct study {
    struct manufactured_problem problem;
    struct manufactured_level first;
    double cell[2]; /* of grid.refine=1 */
    double length;  /* h is the larger side of a cell over this */
    unsigned levels;
    unsigned space, time, particles; /* factors from level to level, 1 or 2 */
    bool picture;
    struct manufactured_outcome outcome[LEVELS_MAX];
    double h[LEVELS_MAX]; /* of what is refined */
};

/* ------------------------------------------------------------- the declaration */

/* The field with its own parameters wherever the case gives one of that name. */
static enum mpm_status read_problem(const struct measurement *m, struct study *study,
                                    struct mpm_error *error)
{
    struct manufactured_setup setup;
    double value;
    TRY(measurement_text(m, "field", &setup.field, error));
    TRY(measurement_text(m, "law", &setup.law, error));
    TRY(measurement_number(m, "density", &setup.density, error));
    TRY(measurement_number(m, "bulk", &setup.bulk, error));
    TRY(measurement_number(m, "shear", &setup.shear, error));
    TRY(measurement_geometry(m, &setup.geometry, error));
    TRY(manufactured_open(&setup, &study->problem, error));
    const struct manufactured_parameter *p;
    for (size_t k = 0; (p = manufactured_parameter_at(study->problem.field, k)) != NULL; k++)
        if (measurement_has(m, p->name)) {
            TRY(measurement_number(m, p->name, &value, error));
            TRY(manufactured_set(&study->problem, p->name, value, error));
        }
    study->first.end = study->problem.end;
    return measurement_has(m, "end") ? measurement_number(m, "end", &study->first.end, error)
                                     : MPM_OK;
}

static enum mpm_status read_study(const struct measurement *m, struct study *study,
                                  struct mpm_error *error)
{
    TRY(read_problem(m, study, error));
    TRY(measurement_number(m, "cell_x", &study->cell[0], error));
    TRY(measurement_number(m, "cell_y", &study->cell[1], error));
    TRY(measurement_number(m, "length", &study->length, error));
    TRY(measurement_count(m, "refine", 1, 1024, &study->first.refine, error));
    TRY(measurement_count(m, "particles", 1, 16, &study->first.particles, error));
    TRY(measurement_count(m, "steps", 1, 1000000, &study->first.steps, error));
    TRY(measurement_count(m, "looks", 1, 1000, &study->first.looks, error));
    TRY(measurement_count(m, "levels", 1, LEVELS_MAX, &study->levels, error));
    TRY(measurement_count(m, "refine_space", 1, 2, &study->space, error));
    TRY(measurement_count(m, "refine_time", 1, 2, &study->time, error));
    TRY(measurement_count(m, "refine_particles", 1, 2, &study->particles, error));
    study->picture = measurement_has(m, "picture");
    study->first.at_once = measurement_has(m, "start_at_once");
    if (measurement_has(m, "margin"))
        TRY(measurement_number(m, "margin", &study->first.margin, error));
    if (study->levels > 1 && study->space == 1 && study->time == 1 && study->particles == 1)
        return failure_set(
            error, MPM_BAD_INPUT,
            "case %s, variant %s: \"levels\" is %u and nothing is refined; allowed: 1, "
            "or 2 for one of refine_space, refine_time and refine_particles",
            measurement_case(m), measurement_variant(m), study->levels);
    if (study->first.steps % study->first.looks != 0)
        return failure_set(error, MPM_BAD_INPUT,
                           "case %s: parameter \"steps\" is %u; allowed: "
                           "multiples of \"looks\", %u",
                           measurement_case(m), study->first.steps, study->first.looks);
    return MPM_OK;
}

/* ------------------------------------------------------------------- the levels */

/* A field of which a term, or half of what nodes see, is missing measures nothing. */
static enum mpm_status check_activity(struct measurement *m, const struct study *study,
                                      struct mpm_error *error)
{
    struct manufactured_activity a;
    const double cell[2] = {study->cell[0] / study->first.refine,
                            study->cell[1] / study->first.refine};
    TRY(manufactured_activity(&study->problem, study->first.end, cell, &a, error));
    measurement_note(m,
                     "at the end: acceleration %.3g and %.3g of each equation, Div P %.3g and "
                     "%.3g, its hoop terms %.3g and %.3g, nonlinear %.3g; velocity %.3g and %.3g "
                     "of its largest",
                     a.acceleration[0], a.acceleration[1], a.divergence[0], a.divergence[1],
                     a.hoop[0], a.hoop[1], a.nonlinear, a.velocity[0], a.velocity[1]);
    return MPM_OK;
}

/* h is the cell where cells are refined, else the step, else the particles' distance. */
static double level_size(const struct study *study, const struct manufactured_level *level)
{
    if (study->space > 1)
        return fmax(study->cell[0], study->cell[1]) / (level->refine * study->length);
    return study->time > 1 ? 1.0 / level->steps : 1.0 / level->particles;
}

static enum mpm_status run_levels(struct measurement *m, struct study *study,
                                  struct mpm_error *error)
{
    struct manufactured_level level = study->first;
    for (unsigned k = 0; k < study->levels; k++) {
        const bool last = k + 1 == study->levels;
        level.series = last && study->picture ? "field" : NULL;
        study->h[k] = level_size(study, &level);
        TRY(manufactured_level_run(m, &study->problem, &level, &study->outcome[k], error));
        level.refine *= study->space;
        level.steps *= study->time;
        level.particles *= study->particles;
    }
    return MPM_OK;
}

/* -------------------------------------------------------------------- reporting */

/* L2 error over the size of the exact field on each level. */
static void relative_errors(const struct study *study, unsigned quantity, double *errors)
{
    for (unsigned k = 0; k < study->levels; k++)
        errors[k] = error_norms_relative(&study->outcome[k].norms[quantity]);
}

/* The constant belongs to the whole order next to the fitted one, at least 1: it jumps by a power
 * of the number of cells when the order does. */
static void report_quantity(struct measurement *m, const struct study *study, unsigned quantity)
{
    const char *const suffix = manufactured_suffix[quantity];
    assert(study->levels >= 1 && study->levels <= LEVELS_MAX); /* read_study */
    const unsigned last = study->levels - 1;
    const struct error_norms *const norms = &study->outcome[last].norms[quantity];
    double errors[LEVELS_MAX] = {0}, largest[LEVELS_MAX] = {0};
    relative_errors(study, quantity, errors);
    for (unsigned k = 0; k < study->levels; k++)
        largest[k] = study->outcome[k].norms[quantity].linf;
    levels_report_value(m, "error", suffix, 100.0 * errors[last]);
    levels_report_value(m, "error_l1", suffix, 100.0 * norms->l1 / norms->exact_l2);
    levels_report_value(m, "error_max", suffix, 100.0 * norms->linf / norms->exact_linf);
    if (study->levels == 1)
        return;
    levels_report_orders(m, study->levels, suffix, errors);
    const double order = fmax(1.0, round(order_fitted(study->levels, study->h, errors)));
    levels_report_value(m, "constant", suffix, order_constant(order, study->h[last], errors[last]));
    levels_report_value(m, "order_max", suffix, order_fitted(study->levels, study->h, largest));
}

/* The index of the displacement's amplitude, whose limit is known: 1. */
static void report_index(struct measurement *m, const struct study *study)
{
    if (study->levels < 3)
        return;
    const struct manufactured_outcome *const fine = &study->outcome[study->levels - 1];
    const struct grid_convergence g = grid_convergence(
        fine[-2].amplitude, fine[-1].amplitude, fine[0].amplitude, 2.0, GRID_CONVERGENCE_SAFETY);
    levels_report_value(m, "index", "", 100.0 * g.index);
    levels_report_value(m, "index_cover", "", g.index / fabs(fine->amplitude - 1.0));
    levels_report_value(m, "index_order", "", g.order);
}

static enum mpm_status write_levels(struct measurement *m, const struct study *study,
                                    struct mpm_error *error)
{
    double rows[COLUMNS * LEVELS_MAX];
    for (unsigned k = 0; k < study->levels; k++) {
        double *row = &rows[COLUMNS * k];
        *row++ = study->h[k];
        *row++ = study->outcome[k].amplitude;
        for (unsigned q = 0; q < MANUFACTURED_QUANTITIES; q++) {
            const struct error_norms *const n = &study->outcome[k].norms[q];
            *row++ = n->l2 / n->exact_l2;
            *row++ = n->l1 / n->exact_l2;
            *row++ = n->linf / n->exact_linf;
        }
    }
    return measurement_series(m, "levels",
                              "h amplitude u_l2 u_l1 u_max v_l2 v_l1 v_max F_l2 F_l1 F_max "
                              "stress_l2 stress_l1 stress_max",
                              COLUMNS, study->levels, rows, error);
}

static void note_quantity(struct measurement *m, const struct study *study, unsigned quantity)
{
    double errors[LEVELS_MAX] = {0};
    relative_errors(study, quantity, errors);
    GString *const text = g_string_new(NULL);
    for (unsigned k = 0; k < study->levels; k++)
        g_string_append_printf(text, " %.3g", errors[k]);
    if (study->levels > 1) {
        const struct order_fit fit = order_fit(study->levels, study->h, errors);
        g_string_append(text, "; orders");
        for (size_t k = 1; k < study->levels; k++)
            g_string_append_printf(text, " %.3f", order_pair(k, study->h, errors));
        g_string_append_printf(text, ", fitted %.3f -/+ %.2g: %s", fit.order, fit.half_width,
                               order_class_name(order_classify(study->levels, study->h, errors)));
    }
    measurement_note(m, "relative L2 error of %s:%s", manufactured_suffix[quantity] + 1, text->str);
    g_string_free(text, TRUE);
}

static enum mpm_status run(struct measurement *m, struct mpm_error *error)
{
    struct study study = {0};
    TRY(read_study(m, &study, error));
    TRY(check_activity(m, &study, error));
    TRY(run_levels(m, &study, error));
    unsigned finished = 0;
    for (unsigned k = 0; k < study.levels; k++)
        finished += study.outcome[k].finished;
    measurement_report(m, "finished", finished == study.levels ? 1.0 : 0.0);
    measurement_report(m, "levels_finished", finished);
    for (unsigned q = 0; q < MANUFACTURED_QUANTITIES; q++) {
        report_quantity(m, &study, q);
        note_quantity(m, &study, q);
    }
    report_index(m, &study);
    return write_levels(m, &study, error);
}

const struct measure_program program_manufactured = {
    .name = "manufactured",
    .summary = "a manufactured solution over levels: errors, orders, constants",
    .run = run,
};
