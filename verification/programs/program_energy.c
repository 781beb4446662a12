/* E1: total energy over time: how far it moves, which way, and when.
 *
 * Parameters: `interval` of samples; `from` and `to`, the window of mean_gain; `limit`, from which
 * on the energy counts as off (%).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/measures/energy_curve.h"
#include "verification/programs/follow.h"

#include <math.h>

enum { TIME, TOTAL, KINETIC, STRAIN, COLUMNS };

struct study {
    double interval, from, to, limit;
    double start; /* energy at t = 0 */
    struct follow_rows rows;
};

/* The work of moving boundaries belongs to the balance; here they rest and do none. */
static void add_row(void *context, const struct mpm_simulation *simulation,
                    const struct mpm_ledger *ledger)
{
    struct study *const study = context;
    const double energy = ledger->total_energy - ledger->external_work;
    (void)simulation;
    if (study->rows.count == 0)
        study->start = energy;
    const double row[COLUMNS] = {[TIME] = ledger->time,
                                 [TOTAL] = energy / study->start,
                                 [KINETIC] = ledger->kinetic_energy / study->start,
                                 [STRAIN] = ledger->strain_energy / study->start};
    follow_rows_add(&study->rows, row);
}

/* A run that ended early was off by then, however its guard has judged it. */
static void report_time_off(struct measurement *m, const struct follow_result *result,
                            const struct study *study, const struct energy_curve *curve)
{
    const double off = energy_curve_time_off(curve, 0.01 * study->limit);
    if (isfinite(off))
        measurement_report(m, "off_at", off);
    else if (!result->finished)
        measurement_report(m, "off_at", result->conservation.last.time);
    else
        measurement_inconclusive(m, "off_at", "the energy is never off by %g %%", study->limit);
}

static enum mpm_status report(struct measurement *m, const struct follow_result *result,
                              const struct study *study, struct mpm_error *error)
{
    const struct conservation *const conservation = &result->conservation;
    const double *const values = study->rows.values;
    TRY(follow_rows_check(&study->rows, error));
    const struct energy_curve curve = {study->rows.count, COLUMNS, values + TIME, values + TOTAL,
                                       values + STRAIN};
    const double end = 100.0 * conservation_energy_now(conservation);
    measurement_report(m, "gain", 100.0 * energy_curve_extreme(&curve));
    measurement_report(m, "end_gain", end);
    if (conservation->last.time >= study->to)
        measurement_report(m, "mean_gain",
                           100.0 * energy_curve_mean(&curve, study->from, study->to));
    else
        measurement_inconclusive(m, "mean_gain", "the run ended at %g, before %g",
                                 conservation->last.time, study->to);
    if (result->finished)
        measurement_report(m, "swing", energy_curve_swing(&curve, result->time_step));
    else
        measurement_inconclusive(m, "swing", "the run ended early");
    measurement_report(m, "slowest", 100.0 * conservation->smallest_kinetic);
    report_time_off(m, result, study, &curve);
    follow_report(m, result, 0.0);
    measurement_note(m, "total energy between %+.5f %% and %+.5f %%, at the end %+.5f %%",
                     100.0 * conservation->energy_low, 100.0 * conservation->energy_high, end);
    return measurement_series(m, "energy",
                              "time total_over_start kinetic_over_start strain_over_start", COLUMNS,
                              study->rows.count, values, error);
}

static enum mpm_status measure(void *context, struct measurement *m, const struct mpm_scene *scene,
                               struct mpm_simulation *simulation, struct mpm_error *error)
{
    struct study study = {.rows = {.columns = COLUMNS}};
    const struct measurement_parameter table[] = {{"interval", &study.interval},
                                                  {"from", &study.from},
                                                  {"to", &study.to},
                                                  {"limit", &study.limit}};
    struct follow_result result;
    (void)context;
    TRY(measurement_numbers(m, table, sizeof table / sizeof *table, error));
    const struct follow follow = {.measurement = m,
                                  .end = mpm_scene_end_time(scene),
                                  .interval = study.interval,
                                  .sample = add_row,
                                  .context = &study};
    enum mpm_status status = follow_run(&follow, simulation, &result, error);
    if (status == MPM_OK)
        status = report(m, &result, &study, error);
    follow_rows_free(&study.rows);
    return status;
}

static enum mpm_status run(struct measurement *measurement, struct mpm_error *error)
{
    return follow_scene(measurement, NULL, 0, measure, NULL, error);
}

const struct measure_program program_energy = {
    .name = "energy",
    .summary = "kinetic, strain and total energy over time",
    .run = run,
};
