/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/programs/follow.h"

#include <stdlib.h>
#include <string.h>

static void sample_now(const struct follow *follow, const struct mpm_simulation *simulation,
                       struct conservation *conservation)
{
    struct mpm_ledger ledger;
    mpm_simulation_ledger(simulation, &ledger);
    if (conservation->samples == 0)
        conservation_open(conservation, &ledger);
    else
        conservation_add(conservation, &ledger);
    if (follow->sample != NULL)
        follow->sample(follow->context, simulation, &ledger);
}

enum mpm_status follow_step(struct measurement *measurement, struct mpm_simulation *simulation,
                            double limit, bool *alive, struct mpm_error *error)
{
    const enum mpm_status status = mpm_simulation_advance(simulation, limit, error);
    if (status != MPM_RUN_FAILED)
        return status;
    *alive = false;
    measurement_note(measurement, "the run ended: %s", error->message);
    return MPM_OK;
}

enum mpm_status follow_run(const struct follow *follow, struct mpm_simulation *simulation,
                           struct follow_result *result, struct mpm_error *error)
{
    *result = (struct follow_result){.finished = true};
    if (!(follow->interval > 0.0))
        return failure_set(error, MPM_BAD_INPUT, "case %s: samples every %g; allowed: above 0",
                           measurement_case(follow->measurement), follow->interval);
    sample_now(follow, simulation, &result->conservation);
    uint64_t samples = 1; /* multiples of the interval passed, t = 0 among them */
    for (double time = 0.0; time < follow->end;) {
        TRY(follow_step(follow->measurement, simulation, follow->end, &result->finished, error));
        if (!result->finished) {
            sample_now(follow, simulation, &result->conservation);
            break;
        }
        time = mpm_simulation_time(simulation);
        if (mpm_simulation_step(simulation) == 1)
            result->time_step = mpm_simulation_time_step(simulation);
        if (time >= follow->interval * (double)samples || time >= follow->end) {
            sample_now(follow, simulation, &result->conservation);
            while (follow->interval * (double)samples <= time)
                samples++;
        }
    }
    follow_count_work(follow->measurement, simulation);
    return MPM_OK;
}

enum mpm_status follow_to(struct measurement *measurement, struct mpm_simulation *simulation,
                          double time, bool *alive, struct mpm_error *error)
{
    *alive = true;
    while (*alive && mpm_simulation_time(simulation) < time)
        TRY(follow_step(measurement, simulation, time, alive, error));
    return MPM_OK;
}

void follow_count_work(struct measurement *measurement, const struct mpm_simulation *simulation)
{
    measurement_work(measurement,
                     mpm_simulation_step(simulation) * mpm_simulation_particle_count(simulation));
}

enum mpm_status follow_to_rest(struct measurement *m, struct mpm_simulation *simulation, double end,
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

enum mpm_status follow_scene(struct measurement *measurement, const char *const *settings,
                             size_t count, follow_measure *measure, void *context,
                             struct mpm_error *error)
{
    struct mpm_scene *scene = NULL;
    struct mpm_simulation *simulation = NULL;
    enum mpm_status status = measurement_scene(measurement, settings, count, &scene, error);
    if (status == MPM_OK)
        status = mpm_simulation_create(scene, measurement_options(measurement), &simulation, error);
    if (status == MPM_OK)
        status = measure(context, measurement, scene, simulation, error);
    mpm_simulation_free(simulation);
    mpm_scene_free(scene);
    return status;
}

/* -------------------------------------------------------------------- rows */

void follow_rows_add(struct follow_rows *rows, const double *row)
{
    if (rows->count == rows->capacity && !rows->out_of_memory) {
        const size_t capacity = rows->capacity == 0 ? 256 : 2 * rows->capacity;
        double *const grown =
            realloc(rows->values, capacity * rows->columns * sizeof *rows->values);
        rows->out_of_memory = grown == NULL;
        if (grown != NULL) {
            rows->values = grown;
            rows->capacity = capacity;
        }
    }
    if (rows->out_of_memory)
        return;
    memcpy(&rows->values[rows->columns * rows->count], row, rows->columns * sizeof *row);
    rows->count++;
}

void follow_rows_free(struct follow_rows *rows)
{
    free(rows->values);
    *rows = (struct follow_rows){.columns = rows->columns};
}

enum mpm_status follow_rows_check(const struct follow_rows *rows, struct mpm_error *error)
{
    if (rows->out_of_memory)
        return failure_set(error, MPM_ENVIRONMENT_FAILED, "out of memory for the samples");
    return MPM_OK;
}

/* ------------------------------------------------------------------ report */

void follow_report(struct measurement *measurement, const struct follow_result *result, double arm)
{
    const struct conservation *const conservation = &result->conservation;
    measurement_report(measurement, "energy_drift",
                       100.0 * conservation_energy_drift(conservation));
    measurement_report(measurement, "reached", conservation->last.time);
    measurement_report(measurement, "finished", result->finished ? 1.0 : 0.0);
    if (arm > 0.0) {
        measurement_report(measurement, "momentum_drift",
                           conservation_momentum_drift(conservation));
        measurement_report(measurement, "angular_momentum_drift",
                           conservation_angular_momentum_drift(conservation, arm));
    }
}
