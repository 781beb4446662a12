/* H16: plastic work that heats the temperature that is conducted. All nodes have a prescribed
 * velocity, so that a metal of von Mises with linear hardening yields evenly.
 *
 * With the equivalent strain e = strain_rate t, the yield stress Y, its hardening H and the shear
 * modulus G, the plastic strain is p = (3 G e - Y)/(3 G + H) from e = Y/(3 G) on, and the plastic
 * work per undeformed volume is w = Y p + H p^2/2. chi w of it is heat:
 *
 *   process  temperature
 *   even     T_0 + chi w/(rho_0 c): nothing flows
 *   band     a band whose faces are held at T_0, without hardening: T_0 + q a^2/k v of heat.h with
 *            the source q = chi Y strain_rate since yield and half of the width a
 *
 * Parameters: density, heat_capacity, shear, yield, hardening, quinney, start, strain_rate; of a
 * band conductivity, origin (its middle) and length (a).
 *
 * Reports: error_worst, error_l2 (of all particles at the end, % of the largest rise),
 * dissipation_error (of the history's plastic_dissipation against (1 - chi) w, % of w), heat_gap
 * (|plastic_heat - deformation_heat| over it), first_law (with output.energy_balance: |change of
 * total_energy, transfer_loss, expansion_work and thermal_energy, less external work and heat that
 * came in|, over the plastic work), finished; orders over levels. Series: profile.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/heat/heat.h"
#include "verification/measures/error_norms.h"
#include "verification/programs/follow.h"
#include "verification/programs/levels.h"

#include <glib.h>
#include <math.h>
#include <string.h>

enum { AXES = 2, COLUMNS = 3 };

enum process { EVEN, BAND, PROCESSES };
/* What is exactly nothing is reported as this: no number differs from 1 by it. */
static const double LEAST = 1e-17;
static const char *const process_names[PROCESSES] = {"even", "band"};

struct problem {
    enum process process;
    double density, heat_capacity, shear, yield, hardening, quinney, start, strain_rate;
    double conductivity, origin, length;
};

struct outcome {
    bool finished;
    double worst, l2, dissipation, gap, first_law;
};

struct study {
    const struct problem *problem;
    struct outcome *outcome;
    bool last;
};

/* ------------------------------------------------------------------- reference */

/* w at the time t */
static double work_at(const struct problem *problem, double time)
{
    const double strain = problem->strain_rate * time, stiffness = 3.0 * problem->shear;
    const double p =
        fmax(0.0, stiffness * strain - problem->yield) / (stiffness + problem->hardening);
    return (problem->yield + 0.5 * problem->hardening * p) * p;
}

static double rise_at(const struct problem *problem, double place, double time)
{
    const double capacity = problem->density * problem->heat_capacity;
    if (problem->process == EVEN)
        return problem->quinney * work_at(problem, time) / capacity;
    const double square = problem->length * problem->length, k = problem->conductivity;
    const double since = time - problem->yield / (3.0 * problem->shear * problem->strain_rate);
    const double power = problem->quinney * problem->yield * problem->strain_rate;
    return power * square / k *
           heat_source_held(HEAT_SLAB, fabs(place - problem->origin) / problem->length,
                            k * since / (capacity * square));
}

/* ------------------------------------------------------------------- measuring */

static double quantity(const struct mpm_scene *scene, const struct mpm_simulation *simulation,
                       const char *name)
{
    for (size_t k = 0; k < mpm_scene_transport_quantity_count(scene); k++)
        if (strcmp(mpm_scene_transport_quantity(scene, k).name, name) == 0)
            return mpm_simulation_transport_quantity(simulation, k);
    return (double)NAN;
}

/* What changes by nothing but what comes from outside, less that. */
static double closed_sum(const struct mpm_scene *scene, const struct mpm_simulation *simulation)
{
    struct mpm_ledger ledger;
    mpm_simulation_ledger(simulation, &ledger);
    return ledger.total_energy + ledger.transfer_loss + ledger.expansion_work -
           ledger.external_work + quantity(scene, simulation, "thermal_energy") -
           quantity(scene, simulation, "boundary_heat") -
           quantity(scene, simulation, "source_heat") - quantity(scene, simulation, "edge_heat");
}

static void balance(const struct problem *problem, const struct mpm_simulation *simulation,
                    double drift, struct outcome *outcome)
{
    struct mpm_ledger ledger;
    mpm_simulation_ledger(simulation, &ledger);
    const double work =
        work_at(problem, mpm_simulation_time(simulation)) * ledger.mass / problem->density;
    const double kept = (1.0 - problem->quinney) * work;
    outcome->dissipation = fmax(LEAST, 100.0 * fabs(ledger.plastic_dissipation - kept) / work);
    outcome->gap =
        fmax(LEAST, fabs(ledger.plastic_heat - ledger.deformation_heat) / ledger.plastic_heat);
    outcome->first_law = fmax(LEAST, fabs(drift) / work);
}

static enum mpm_status compare(const struct study *study, struct measurement *m,
                               const struct mpm_simulation *simulation, struct mpm_error *error)
{
    const size_t count = mpm_simulation_particle_count(simulation);
    const double time = mpm_simulation_time(simulation);
    double *const position = g_new(double, AXES *count), *const mass = g_new(double, count);
    double *const value = g_new(double, count), *const wanted = g_new(double, count);
    double *const rows = g_new(double, COLUMNS *count);
    double largest = 0.0;
    mpm_simulation_field(simulation, MPM_FIELD_POSITION, position);
    mpm_simulation_field(simulation, MPM_FIELD_MASS, mass);
    mpm_simulation_field(simulation, MPM_FIELD_TEMPERATURE, value);
    for (size_t p = 0; p < count; p++) {
        const double rise = rise_at(study->problem, position[AXES * p], time);
        wanted[p] = study->problem->start + rise;
        largest = fmax(largest, rise);
        memcpy(rows + COLUMNS * p, (double[]){position[AXES * p], value[p], wanted[p]},
               COLUMNS * sizeof *rows);
    }
    const struct error_norms norms = error_norms(count, 1, NULL, mass, value, wanted);
    study->outcome->worst = 100.0 * norms.linf / largest;
    study->outcome->l2 = 100.0 * norms.l2 / largest;
    const enum mpm_status status =
        study->last
            ? measurement_series(m, "profile", "x temperature exact", COLUMNS, count, rows, error)
            : MPM_OK;
    g_free(position);
    g_free(mass);
    g_free(value);
    g_free(wanted);
    g_free(rows);
    return status;
}

static enum mpm_status measure(void *context, struct measurement *m, const struct mpm_scene *scene,
                               struct mpm_simulation *simulation, struct mpm_error *error)
{
    const struct study *const study = context;
    const double start = closed_sum(scene, simulation);
    study->outcome->finished = true;
    TRY(follow_to(m, simulation, mpm_scene_end_time(scene), &study->outcome->finished, error));
    follow_count_work(m, simulation);
    balance(study->problem, simulation, closed_sum(scene, simulation) - start, study->outcome);
    return compare(study, m, simulation, error);
}

/* --------------------------------------------------------------------- running */

static enum mpm_status read_problem(const struct measurement *m, struct problem *problem,
                                    struct mpm_error *error)
{
    const struct measurement_parameter metal[] = {
        {"density", &problem->density},     {"heat_capacity", &problem->heat_capacity},
        {"shear", &problem->shear},         {"yield", &problem->yield},
        {"hardening", &problem->hardening}, {"quinney", &problem->quinney},
        {"start", &problem->start},         {"strain_rate", &problem->strain_rate}};
    const struct measurement_parameter band[] = {{"conductivity", &problem->conductivity},
                                                 {"origin", &problem->origin},
                                                 {"length", &problem->length}};
    size_t process;
    TRY(measurement_choice(m, "process", process_names, PROCESSES, &process, error));
    TRY(measurement_numbers(m, metal, G_N_ELEMENTS(metal), error));
    problem->process = (enum process)process;
    return problem->process == BAND ? measurement_numbers(m, band, G_N_ELEMENTS(band), error)
                                    : MPM_OK;
}

static void report(struct measurement *m, const struct outcome *outcome)
{
    const double missing = outcome->finished ? 0.0 : (double)NAN;
    levels_report_value(m, "error_worst", "", missing + outcome->worst);
    levels_report_value(m, "error_l2", "", missing + outcome->l2);
    levels_report_value(m, "dissipation_error", "", missing + outcome->dissipation);
    levels_report_value(m, "heat_gap", "", missing + outcome->gap);
    levels_report_value(m, "first_law", "", missing + outcome->first_law);
    measurement_report(m, "finished", outcome->finished ? 1.0 : 0.0);
}

static enum mpm_status run(struct measurement *m, struct mpm_error *error)
{
    struct problem problem = {.process = EVEN};
    struct levels levels;
    struct outcome outcome = {.finished = false};
    double l2[LEVELS_MAX] = {0.0};
    TRY(read_problem(m, &problem, error));
    TRY(levels_read(m, &levels, error));
    for (size_t k = 0; k < levels_runs(&levels); k++) {
        outcome = (struct outcome){.finished = false};
        struct study study = {&problem, &outcome, k + 1 == levels_runs(&levels)};
        TRY(follow_scene(m, &levels.setting[k], levels.count == 0 ? 0 : 1, measure, &study, error));
        l2[k] = outcome.finished ? outcome.l2 : (double)NAN;
        measurement_note(m, "level %zu: error %.6g %%", k + 1, l2[k]);
    }
    report(m, &outcome);
    return levels.count == 0 ? MPM_OK : levels_report(m, &levels, "_l2", l2, error);
}

const struct measure_program program_plastic_heat = {
    .name = "plastic_heat",
    .summary = "plastic work that heats evenly, and a band that conducts this heat away",
    .run = run,
};
