/* H10: bodies that deform and heat, as one system: gases under a prescribed motion, solids that
 * vibrate.
 *
 * With V the volume of all particles over that at t = 0, T their mean temperature, and the gas of
 * the parameters gas_constant and heat_capacity (at constant volume), gamma = 1 + R/c:
 *
 *   process     what is held against what at every step
 *   adiabatic   T against T_0 V^(1 - gamma), the work done against c m (T_0 - T)
 *   isothermal  T against T_0, the work done against m R T_0 ln V
 *   cycle       the work done in all over the heat taken in, against 1 - cold/hot; T and the
 *               entropy m (c ln T + R ln V) at the end against the start
 *   closed      only the first law
 *
 * The first law: total_energy + expansion_work + thermal_energy + thermoelastic_energy is what it
 * was, external work and inflow of heat; without heat of deformation expansion_work is no part of
 * it, since heat from outside keeps the temperatures. Of a cycle, whose motion is prescribed and
 * not steady, only the gas: expansion_work + thermal_energy. Reports: temperature_error, work_error
 * (% of the exact work at the end), efficiency, efficiency_error, temperature_closure,
 * entropy_closure (over R m), entropy_change (sum of dQ/T over R m), first_law (% of the largest
 * size of expansion_work), finished; orders of efficiency_error and first_law over levels of the
 * time step. Series: process.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/programs/follow.h"
#include "verification/programs/levels.h"

#include <glib.h>
#include <math.h>
#include <string.h>

enum { COLUMNS = 7 };
static const double SAMPLE = 1e-4; /* of the run: less than any step */

enum process { ADIABATIC, ISOTHERMAL, CYCLE, CLOSED, PROCESSES };
static const char *const process_names[PROCESSES] = {"adiabatic", "isothermal", "cycle", "closed"};

struct problem {
    enum process process;
    double gas_constant, heat_capacity, hot, cold;
};

/* All particles at one time; the sums are since t = 0. */
struct sample {
    double time, volume, temperature, pressure, work, heat, energy;
};

struct outcome {
    double temperature_error, work_error, efficiency, temperature_closure, entropy_closure,
        entropy_change, first_law;
    bool finished;
};

struct watch {
    const struct problem *problem;
    const struct mpm_scene *scene;
    double *volume, *temperature, *stress, mass;
    struct sample start, last;
    double heat_taken, largest_work, largest_imbalance;
    struct outcome *outcome;
    struct follow_rows rows;
};

/* ------------------------------------------------------------------ sampling */

static double heat_of(const struct mpm_scene *scene, const struct mpm_simulation *simulation,
                      const char *name)
{
    for (size_t k = 0; k < mpm_scene_transport_quantity_count(scene); k++)
        if (strcmp(mpm_scene_transport_quantity(scene, k).name, name) == 0)
            return mpm_simulation_transport_quantity(simulation, k);
    return (double)NAN;
}

static struct sample look(const struct watch *watch, const struct mpm_simulation *simulation,
                          const struct mpm_ledger *ledger)
{
    enum { STRESS = 4, YY = 1 };
    const struct mpm_scene *const scene = watch->scene;
    const size_t count = mpm_simulation_particle_count(simulation);
    struct sample now = {.time = ledger->time, .work = ledger->expansion_work};
    mpm_simulation_field(simulation, MPM_FIELD_VOLUME, watch->volume);
    mpm_simulation_field(simulation, MPM_FIELD_TEMPERATURE, watch->temperature);
    mpm_simulation_field(simulation, MPM_FIELD_STRESS, watch->stress);
    for (size_t p = 0; p < count; p++) {
        now.volume += watch->volume[p];
        now.temperature += watch->temperature[p] / (double)count;
        now.pressure -= watch->stress[STRESS * p + YY] / (double)count;
    }
    now.heat = heat_of(scene, simulation, "boundary_heat") +
               heat_of(scene, simulation, "source_heat") + heat_of(scene, simulation, "edge_heat");
    now.energy = heat_of(scene, simulation, "thermal_energy") - now.heat;
    if (mpm_scene_heats(scene))
        now.energy += ledger->expansion_work + ledger->thermoelastic_energy;
    if (watch->problem->process != CYCLE)
        now.energy += ledger->total_energy - ledger->external_work;
    return now;
}

/* T of the process at the volume at hand. */
static double wanted_temperature(const struct problem *problem, const struct sample *start,
                                 double relative_volume)
{
    return problem->process == ADIABATIC
               ? start->temperature *
                     pow(relative_volume, -problem->gas_constant / problem->heat_capacity)
               : start->temperature;
}

static void add_row(struct watch *watch, const struct sample *now)
{
    const struct problem *const problem = watch->problem;
    const double relative = now->volume / watch->start.volume;
    const double row[COLUMNS] = {now->time,
                                 relative,
                                 now->temperature,
                                 now->pressure,
                                 now->work,
                                 now->heat,
                                 wanted_temperature(problem, &watch->start, relative)};
    follow_rows_add(&watch->rows, row);
}

static void sample(void *context, const struct mpm_simulation *simulation,
                   const struct mpm_ledger *ledger)
{
    struct watch *const watch = context;
    struct outcome *const outcome = watch->outcome;
    const struct sample now = look(watch, simulation, ledger);
    add_row(watch, &now);
    if (mpm_simulation_step(simulation) == 0) {
        watch->start = watch->last = now;
        watch->mass = ledger->mass;
        return;
    }
    const double wanted =
        wanted_temperature(watch->problem, &watch->start, now.volume / watch->start.volume);
    const double given = now.heat - watch->last.heat;
    outcome->temperature_error =
        fmax(outcome->temperature_error, fabs(now.temperature - wanted) / watch->start.temperature);
    outcome->entropy_change += 2.0 * given / (now.temperature + watch->last.temperature);
    watch->heat_taken += fmax(given, 0.0);
    watch->largest_work = fmax(watch->largest_work, fabs(now.work));
    watch->largest_imbalance =
        fmax(watch->largest_imbalance, fabs(now.energy - watch->start.energy));
    watch->last = now;
}

/* ------------------------------------------------------------------- results */

static double exact_work(const struct watch *watch)
{
    const struct problem *const problem = watch->problem;
    const double relative = watch->last.volume / watch->start.volume;
    const double start = watch->start.temperature;
    if (problem->process == ISOTHERMAL)
        return watch->mass * problem->gas_constant * start * log(relative);
    return watch->mass * problem->heat_capacity *
           (start - wanted_temperature(problem, &watch->start, relative));
}

static void finish(const struct watch *watch)
{
    struct outcome *const outcome = watch->outcome;
    const struct problem *const problem = watch->problem;
    const struct sample *const end = &watch->last, *const start = &watch->start;
    const double scale = watch->mass * problem->gas_constant;
    outcome->work_error = fabs(end->work / exact_work(watch) - 1.0);
    outcome->efficiency = end->work / watch->heat_taken;
    outcome->temperature_closure = fabs(end->temperature / start->temperature - 1.0);
    outcome->entropy_closure =
        fabs(log(end->volume / start->volume) + problem->heat_capacity / problem->gas_constant *
                                                    log(end->temperature / start->temperature));
    outcome->entropy_change = fabs(outcome->entropy_change) / scale;
    outcome->first_law = 100.0 * watch->largest_imbalance / watch->largest_work;
}

static enum mpm_status measure_scene(void *context, struct measurement *m,
                                     const struct mpm_scene *scene,
                                     struct mpm_simulation *simulation, struct mpm_error *error)
{
    struct watch *const watch = context;
    const size_t count = mpm_simulation_particle_count(simulation);
    struct follow_result result;
    watch->scene = scene;
    watch->volume = g_new(double, count);
    watch->temperature = g_new(double, count);
    watch->stress = g_new(double, 4 * count);
    const struct follow follow = {m, mpm_scene_end_time(scene), SAMPLE * mpm_scene_end_time(scene),
                                  sample, watch};
    enum mpm_status status = follow_run(&follow, simulation, &result, error);
    if (status == MPM_OK) {
        watch->outcome->finished = result.finished;
        finish(watch);
    }
    g_free(watch->volume);
    g_free(watch->temperature);
    g_free(watch->stress);
    return status;
}

/* ----------------------------------------------------------------- reporting */

static enum mpm_status read_problem(const struct measurement *m, struct problem *problem,
                                    struct mpm_error *error)
{
    size_t place;
    TRY(measurement_choice(m, "process", process_names, PROCESSES, &place, error));
    problem->process = (enum process)place;
    if (problem->process == CLOSED)
        return MPM_OK;
    const struct measurement_parameter gas[] = {{"gas_constant", &problem->gas_constant},
                                                {"heat_capacity", &problem->heat_capacity}};
    const struct measurement_parameter ends[] = {{"hot", &problem->hot}, {"cold", &problem->cold}};
    TRY(measurement_numbers(m, gas, G_N_ELEMENTS(gas), error));
    return problem->process == CYCLE ? measurement_numbers(m, ends, G_N_ELEMENTS(ends), error)
                                     : MPM_OK;
}

static double efficiency_error(const struct problem *problem, const struct outcome *outcome)
{
    return fabs(outcome->efficiency - (1.0 - problem->cold / problem->hot));
}

static void report(struct measurement *m, const struct problem *problem,
                   const struct outcome *outcome)
{
    const double missing = outcome->finished ? 0.0 : (double)NAN;
    measurement_report(m, "finished", outcome->finished ? 1.0 : 0.0);
    levels_report_value(m, "first_law", "", missing + outcome->first_law);
    if (problem->process == ADIABATIC || problem->process == ISOTHERMAL) {
        levels_report_value(m, "temperature_error", "", missing + outcome->temperature_error);
        levels_report_value(m, "work_error", "", missing + 100.0 * outcome->work_error);
    }
    if (problem->process != CYCLE)
        return;
    levels_report_value(m, "efficiency", "", missing + outcome->efficiency);
    levels_report_value(m, "efficiency_error", "", missing + efficiency_error(problem, outcome));
    levels_report_value(m, "temperature_closure", "", missing + outcome->temperature_closure);
    levels_report_value(m, "entropy_closure", "", missing + outcome->entropy_closure);
    levels_report_value(m, "entropy_change", "", missing + outcome->entropy_change);
}

static enum mpm_status run(struct measurement *m, struct mpm_error *error)
{
    struct problem problem = {.process = CLOSED};
    struct levels levels;
    struct outcome outcome = {.finished = false};
    double laws[LEVELS_MAX] = {0.0}, efficiencies[LEVELS_MAX] = {0.0};
    TRY(read_problem(m, &problem, error));
    TRY(levels_read(m, &levels, error));
    for (size_t k = 0; k < levels_runs(&levels); k++) {
        outcome = (struct outcome){.finished = false};
        struct watch watch = {.problem = &problem, .outcome = &outcome, .rows.columns = COLUMNS};
        enum mpm_status status = follow_scene(m, &levels.setting[k], levels.count == 0 ? 0 : 1,
                                              measure_scene, &watch, error);
        if (status == MPM_OK)
            status = follow_rows_check(&watch.rows, error);
        if (status == MPM_OK && k + 1 == levels_runs(&levels))
            status = measurement_series(m, "process", "t V T p work heat T_exact", COLUMNS,
                                        watch.rows.count, watch.rows.values, error);
        follow_rows_free(&watch.rows);
        TRY(status);
        const double missing = outcome.finished ? 0.0 : (double)NAN;
        laws[k] = missing + outcome.first_law;
        efficiencies[k] = missing + efficiency_error(&problem, &outcome);
        measurement_note(m, "level %zu: first law %.3g %%, efficiency %.8f", k + 1, laws[k],
                         outcome.efficiency);
    }
    report(m, &problem, &outcome);
    if (levels.count == 0)
        return MPM_OK;
    TRY(levels_report(m, &levels, "_law", laws, error));
    return problem.process == CYCLE ? levels_report(m, &levels, "_efficiency", efficiencies, error)
                                    : MPM_OK;
}

const struct measure_program program_thermodynamics = {
    .name = "thermodynamics",
    .summary = "gases and solids that deform and heat: work, heat, entropy, the first law",
    .run = run,
};
