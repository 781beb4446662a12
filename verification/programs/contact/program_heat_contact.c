/* Case H11: two bodies of different temperature brought together, side by side along the first
 * axis, against the exact field (heat_layers.h); or with nothing between them that lets heat
 * through.
 *
 * The scene runs to its end; all particles are held against the exact field at their places then.
 * Parameters: width_1, width_2 (the first body ends where the second begins), conductivity_1 and
 * _2, capacity_1 and _2 (per volume), start_1 and _2, conductance (0: none flows, inf: perfect
 * contact), origin, height (of the bodies, for what has passed), field: cylinder or slabs.
 *
 * `field: lumped`: two bodies, or the sides of a crack, that conduct so well that each is of one
 * temperature, with surfaces of any direction, told apart by their temperatures at t = 0. Of the
 * parameters start, capacity (per mass), conductance and `area` (of their contact) alone: with the
 * heat capacities C_1, C_2 of their particles, what has passed is
 *
 *     C_1 C_2/(C_1 + C_2) (T_1 - T_2) (1 - exp(-conductance area (1/C_1 + 1/C_2) t)).
 *
 * Reports: error_l2, error_worst (% of the difference at t = 0), passed_part (heat that has gone
 * from the first field to the second over the exact one; where the scene has contact
 * and something flows), between (temperature at the contact: of the particles nearest to it on
 * either side, as straight lines through two columns give it, mean of both), heat_imbalance (change
 * of heat over that at t = 0), unchanged (1 if no bit of any temperature has changed), finished;
 * orders over levels. Series: profile.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/common/failure.h"
#include "verification/exact/contact/heat_layers.h"
#include "verification/measures/error_norms.h"
#include "verification/programs/follow.h"
#include "verification/programs/levels.h"

#include <glib.h>
#include <math.h>
#include <string.h>

enum { AXES = 2, COLUMNS = 4, COLUMN_COUNT = 2 };
enum field { SLABS, CYLINDER, LUMPED, FIELDS };
static const char *const field_names[FIELDS] = {"slabs", "cylinder", "lumped"};

struct problem {
    struct heat_layers layers;
    struct heat_layers_series series;
    double origin, height;
    enum field kind;
    double area; /* lumped */
};

struct outcome {
    bool finished, unchanged;
    double error_l2, error_worst, passed_part, between, imbalance;
};

struct study {
    struct problem *problem;
    struct outcome *outcome;
    bool last;
};

/* ------------------------------------------------------------------ the problem */

static enum mpm_status read_problem(const struct measurement *m, struct problem *problem,
                                    struct mpm_error *error)
{
    struct heat_layers *const layers = &problem->layers;
    const struct measurement_parameter needed[] = {
        {"width_1", &layers->width[0]},
        {"width_2", &layers->width[1]},
        {"conductivity_1", &layers->conductivity[0]},
        {"conductivity_2", &layers->conductivity[1]},
        {"capacity_1", &layers->capacity[0]},
        {"capacity_2", &layers->capacity[1]},
        {"start_1", &layers->start[0]},
        {"start_2", &layers->start[1]},
        {"origin", &problem->origin},
        {"height", &problem->height},
    };
    size_t field;
    TRY(measurement_choice(m, "field", field_names, FIELDS, &field, error));
    TRY(measurement_numbers(m, needed, G_N_ELEMENTS(needed), error));
    problem->kind = (enum field)field;
    layers->cylinder = field == CYLINDER;
    if (field == LUMPED)
        TRY(measurement_number(m, "area", &problem->area, error));
    layers->conductance = HUGE_VAL;
    return measurement_has(m, "conductance")
               ? measurement_number(m, "conductance", &layers->conductance, error)
               : MPM_OK;
}

/* Before the run: its end is known. */
static enum mpm_status solve(struct problem *problem, double time, struct mpm_error *error)
{
    if (problem->layers.conductance == 0.0 || problem->kind == LUMPED ||
        heat_layers_solve(&problem->layers, time, &problem->series))
        return MPM_OK;
    return failure_set(error, MPM_BAD_INPUT,
                       "no series for the two bodies at time %g: too early for its modes", time);
}

static int body_of(const struct problem *problem, double place)
{
    return place - problem->origin < problem->layers.width[0] ? 0 : 1;
}

static double exact(const struct problem *problem, double place, double time)
{
    const int body = body_of(problem, place);
    return problem->layers.conductance == 0.0
               ? problem->layers.start[body]
               : heat_layers_value(&problem->series, body, place - problem->origin, time);
}

/* ------------------------------------------------------------------ measuring */

static double heat(const struct mpm_scene *scene, const struct mpm_simulation *simulation)
{
    for (size_t k = 0; k < mpm_scene_transport_quantity_count(scene); k++)
        if (strcmp(mpm_scene_transport_quantity(scene, k).name, "thermal_energy") == 0)
            return mpm_simulation_transport_quantity(simulation, k);
    return (double)NAN;
}

/* Between the first two fields; NaN without contact. */
static double passed(const struct mpm_scene *scene, const struct mpm_simulation *simulation)
{
    for (size_t k = 0; k < mpm_scene_contact_quantity_count(scene); k++)
        if (strcmp(mpm_scene_contact_quantity(scene, k).name, "contact_0_1_heat") == 0)
            return mpm_simulation_contact_quantity(simulation, k);
    return (double)NAN;
}

/* Where lines through the means of the two columns of particles nearest to the contact meet it. */
static double value_at_contact(const struct problem *problem, int body, size_t count,
                               const double *position, const double *value)
{
    const double at = problem->origin + problem->layers.width[0], slack = 1e-9;
    double distance[COLUMN_COUNT], mean[COLUMN_COUNT];
    for (int column = 0; column < COLUMN_COUNT; column++) {
        double sum = 0.0;
        size_t n = 0;
        distance[column] = HUGE_VAL;
        for (size_t p = 0; p < count; p++) {
            const double away = fabs(position[AXES * p] - at);
            if (body_of(problem, position[AXES * p]) == body &&
                (column == 0 || away > distance[0] + slack))
                distance[column] = fmin(distance[column], away);
        }
        for (size_t p = 0; p < count; p++)
            if (body_of(problem, position[AXES * p]) == body &&
                fabs(fabs(position[AXES * p] - at) - distance[column]) < slack) {
                sum += value[p];
                n++;
            }
        mean[column] = sum / (double)n;
    }
    return mean[0] + (mean[0] - mean[1]) * distance[0] / (distance[1] - distance[0]);
}

static enum mpm_status write_profile(struct measurement *m, size_t count, const double *position,
                                     const double *value, const double *wanted,
                                     struct mpm_error *error)
{
    double *const rows = g_new(double, COLUMNS *count);
    for (size_t p = 0; p < count; p++) {
        double *const row = rows + COLUMNS * p;
        row[0] = position[AXES * p];
        row[1] = position[AXES * p + 1];
        row[2] = value[p];
        row[3] = wanted[p];
    }
    const enum mpm_status status =
        measurement_series(m, "profile", "x y temperature exact", COLUMNS, count, rows, error);
    g_free(rows);
    return status;
}

static void compare(const struct problem *problem, size_t count, const double *position,
                    const double *mass, const double *value, const double *wanted,
                    struct outcome *outcome)
{
    const struct heat_layers *const layers = &problem->layers;
    const double percent = 100.0 / fabs(layers->start[0] - layers->start[1]);
    const struct error_norms norms = error_norms(count, 1, NULL, mass, value, wanted);
    outcome->error_l2 = percent * norms.l2;
    outcome->error_worst = percent * norms.linf;
    outcome->between = 0.5 * (value_at_contact(problem, 0, count, position, value) +
                              value_at_contact(problem, 1, count, position, value));
}

/* Heat that the bodies of one temperature have exchanged, over the exact one. */
static double lumped_part(const struct problem *problem, const struct mpm_simulation *simulation,
                          const double *first)
{
    const struct heat_layers *const layers = &problem->layers;
    const size_t count = mpm_simulation_particle_count(simulation);
    double *const value = g_new(double, count), *const mass = g_new(double, count);
    double capacity[2] = {0.0, 0.0}, lost = 0.0;
    mpm_simulation_field(simulation, MPM_FIELD_TEMPERATURE, value);
    mpm_simulation_field(simulation, MPM_FIELD_MASS, mass);
    for (size_t p = 0; p < count; p++) {
        const int body =
            fabs(first[p] - layers->start[0]) < fabs(first[p] - layers->start[1]) ? 0 : 1;
        capacity[body] += layers->capacity[body] * mass[p];
        if (body == 0)
            lost += layers->capacity[0] * mass[p] * (first[p] - value[p]);
    }
    g_free(value);
    g_free(mass);
    const double both = capacity[0] * capacity[1] / (capacity[0] + capacity[1]);
    const double rate = layers->conductance * problem->area / both;
    return lost / (both * (layers->start[0] - layers->start[1]) *
                   -expm1(-rate * mpm_simulation_time(simulation)));
}

static enum mpm_status measure_end(const struct study *study, struct measurement *m,
                                   struct mpm_simulation *simulation, const double *first,
                                   struct mpm_error *error)
{
    const struct problem *const problem = study->problem;
    const size_t count = mpm_simulation_particle_count(simulation);
    const double time = mpm_simulation_time(simulation);
    double *const value = g_new(double, count), *const mass = g_new(double, count);
    double *const wanted = g_new(double, count), *const position = g_new(double, AXES *count);
    mpm_simulation_field(simulation, MPM_FIELD_TEMPERATURE, value);
    mpm_simulation_field(simulation, MPM_FIELD_POSITION, position);
    mpm_simulation_field(simulation, MPM_FIELD_MASS, mass);
    for (size_t p = 0; p < count; p++)
        wanted[p] = exact(problem, position[AXES * p], time);
    compare(problem, count, position, mass, value, wanted, study->outcome);
    study->outcome->unchanged = memcmp(first, value, count * sizeof *value) == 0;
    const enum mpm_status status =
        study->last ? write_profile(m, count, position, value, wanted, error) : MPM_OK;
    g_free(value);
    g_free(mass);
    g_free(wanted);
    g_free(position);
    return status;
}

static enum mpm_status measure_scene(void *context, struct measurement *m,
                                     const struct mpm_scene *scene,
                                     struct mpm_simulation *simulation, struct mpm_error *error)
{
    const struct study *const study = context;
    struct outcome *const outcome = study->outcome;
    const size_t count = mpm_simulation_particle_count(simulation);
    const double at_start = heat(scene, simulation);
    TRY(solve(study->problem, mpm_scene_end_time(scene), error));
    double *const first = g_new(double, count);
    mpm_simulation_field(simulation, MPM_FIELD_TEMPERATURE, first);
    outcome->finished = true;
    enum mpm_status status =
        follow_to(m, simulation, mpm_scene_end_time(scene), &outcome->finished, error);
    follow_count_work(m, simulation);
    if (status == MPM_OK && study->problem->kind == LUMPED)
        outcome->passed_part = lumped_part(study->problem, simulation, first);
    else if (status == MPM_OK)
        status = measure_end(study, m, simulation, first, error);
    g_free(first);
    outcome->imbalance = fabs(heat(scene, simulation) - at_start) / fabs(at_start);
    if (study->problem->layers.conductance > 0.0 && study->problem->kind != LUMPED) {
        const double wanted =
            study->problem->height *
            heat_layers_passed(&study->problem->series, mpm_simulation_time(simulation));
        outcome->passed_part = passed(scene, simulation) / wanted;
    }
    return status;
}

/* ------------------------------------------------------------------ reporting */

static void report(struct measurement *m, const struct problem *problem,
                   const struct outcome *outcome)
{
    const double missing = outcome->finished ? 0.0 : (double)NAN;
    if (problem->kind != LUMPED) {
        levels_report_value(m, "error_l2", "", missing + outcome->error_l2);
        levels_report_value(m, "error_worst", "", missing + outcome->error_worst);
        levels_report_value(m, "between", "", missing + outcome->between);
        measurement_report(m, "unchanged", outcome->unchanged ? 1.0 : 0.0);
    }
    if (problem->layers.conductance > 0.0 && !isnan(outcome->passed_part))
        levels_report_value(m, "passed_part", "", missing + outcome->passed_part);
    measurement_report(m, "finished", outcome->finished ? 1.0 : 0.0);
}

static enum mpm_status run(struct measurement *m, struct mpm_error *error)
{
    struct problem problem = {.origin = 0.0};
    struct levels levels;
    struct outcome outcome = {.finished = false};
    double l2[LEVELS_MAX] = {0.0}, worst[LEVELS_MAX] = {0.0};
    double unbalanced = 0.0;
    TRY(read_problem(m, &problem, error));
    TRY(levels_read(m, &levels, error));
    for (size_t k = 0; k < levels_runs(&levels); k++) {
        outcome = (struct outcome){.finished = false};
        struct study study = {&problem, &outcome, k + 1 == levels_runs(&levels)};
        TRY(follow_scene(m, &levels.setting[k], levels.count == 0 ? 0 : 1, measure_scene, &study,
                         error));
        const double missing = outcome.finished ? 0.0 : (double)NAN;
        l2[k] = missing + outcome.error_l2;
        worst[k] = missing + outcome.error_worst;
        unbalanced = fmax(unbalanced, outcome.imbalance);
        measurement_note(m, "level %zu: error %.6g %% (worst %.6g %%), between %.6f, passed %.6f",
                         k + 1, l2[k], worst[k], outcome.between, outcome.passed_part);
    }
    report(m, &problem, &outcome);
    measurement_report(m, "heat_imbalance", unbalanced);
    if (levels.count == 0)
        return MPM_OK;
    TRY(levels_report(m, &levels, "_l2", l2, error));
    return levels_report(m, &levels, "_worst", worst, error);
}

const struct measure_program program_heat_contact = {
    .name = "heat_contact",
    .summary = "two bodies of different temperature in contact, against the exact field",
    .run = run,
};
