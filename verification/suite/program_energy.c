/* E1: total energy over time.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/suite/follow.h"

enum { COLUMNS = 4 };

struct curve {
    double start; /* energy at t = 0 */
    struct follow_rows rows;
};

/* The work of moving boundaries belongs to the balance; here they rest and do none. */
static void add_row(void *context, const struct mpm_simulation *simulation,
                    const struct mpm_ledger *ledger)
{
    struct curve *const curve = context;
    const double energy = ledger->total_energy - ledger->external_work;
    (void)simulation;
    if (curve->rows.count == 0)
        curve->start = energy;
    const double row[COLUMNS] = {ledger->time, energy / curve->start,
                                 ledger->kinetic_energy / curve->start,
                                 ledger->strain_energy / curve->start};
    follow_rows_add(&curve->rows, row);
}

static enum mpm_status report(struct measurement *m, const struct follow_result *result,
                              const struct curve *curve, struct mpm_error *error)
{
    const struct books *const books = &result->books;
    const double end = 100.0 * books_energy_now(books);
    measurement_report(m, "drift", 100.0 * books_energy_drift(books));
    measurement_report(m, "span", 100.0 * (books->energy_high - books->energy_low));
    measurement_report(m, "end_drift", end);
    measurement_report(m, "slowest", 100.0 * books->smallest_kinetic);
    follow_report(m, result, 0.0);
    measurement_note(m, "total energy between %+.5f %% and %+.5f %%, at the end %+.5f %%",
                     100.0 * books->energy_low, 100.0 * books->energy_high, end);
    TRY(follow_rows_check(&curve->rows, error));
    return measurement_series(m, "energy",
                              "time total_over_start kinetic_over_start strain_over_start", COLUMNS,
                              curve->rows.count, curve->rows.values, error);
}

static enum mpm_status measure(void *context, struct measurement *m, const struct mpm_scene *scene,
                               struct mpm_simulation *simulation, struct mpm_error *error)
{
    const double end = mpm_scene_end_time(scene);
    (void)context;
    double interval;
    TRY(measurement_number(m, "interval", &interval, error));
    struct curve curve = {.rows = {.columns = COLUMNS}};
    struct follow_result result;
    const struct follow follow = {
        .measurement = m, .end = end, .interval = interval, .sample = add_row, .context = &curve};
    enum mpm_status status = follow_run(&follow, simulation, &result, error);
    if (status == MPM_OK)
        status = report(m, &result, &curve, error);
    follow_rows_free(&curve.rows);
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
