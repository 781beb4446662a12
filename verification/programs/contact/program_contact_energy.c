/* C13: does contact make energy? Kinetic and strain energy and what interfaces store, of bodies on
 * which nothing else does work.
 *
 * Parameter: interval of samples. Reports, in % of the energy at the start,
 *   largest     the largest sum of the three
 *   last        the sum at the end
 * and finished. Draws `energy`: time, sum, kinetic energy, total energy over that at the start.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/programs/follow.h"

#include <math.h>

enum { TIME, SUM, KINETIC, TOTAL, COLUMNS };

struct study {
    double start, largest, last; /* sums; the latter two over the first */
    struct follow_rows rows;
};

static void add_row(void *context, const struct mpm_simulation *simulation,
                    const struct mpm_ledger *ledger)
{
    struct study *const study = context;
    const double sum = ledger->kinetic_energy + ledger->strain_energy + ledger->contact_stored;
    (void)simulation;
    if (study->rows.count == 0)
        study->start = sum;
    const double row[COLUMNS] = {[TIME] = ledger->time,
                                 [SUM] = sum / study->start,
                                 [KINETIC] = ledger->kinetic_energy / study->start,
                                 [TOTAL] = ledger->total_energy / study->start};
    study->largest = fmax(study->largest, row[SUM]);
    study->last = row[SUM];
    follow_rows_add(&study->rows, row);
}

static enum mpm_status report(struct measurement *m, const struct follow_result *result,
                              const struct study *study, struct mpm_error *error)
{
    TRY(follow_rows_check(&study->rows, error));
    measurement_report(m, "finished", result->finished ? 1.0 : 0.0);
    measurement_report(m, "largest", 100.0 * study->largest);
    if (result->finished)
        measurement_report(m, "last", 100.0 * study->last);
    else
        measurement_inconclusive(m, "last", "the run ended early");
    measurement_note(m, "kinetic, strain and stored energy up to %.4g %%, at the end %.4g %%",
                     100.0 * study->largest, 100.0 * study->last);
    return measurement_series(m, "energy",
                              "time sum_over_start kinetic_over_start total_over_start", COLUMNS,
                              study->rows.count, study->rows.values, error);
}

static enum mpm_status measure(void *context, struct measurement *m, const struct mpm_scene *scene,
                               struct mpm_simulation *simulation, struct mpm_error *error)
{
    struct study study = {.rows = {.columns = COLUMNS}};
    double interval;
    struct follow_result result;
    (void)context;
    TRY(measurement_numbers(m, &(struct measurement_parameter){"interval", &interval}, 1, error));
    const struct follow follow = {.measurement = m,
                                  .end = mpm_scene_end_time(scene),
                                  .interval = interval,
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

const struct measure_program program_contact_energy = {
    .name = "contact_energy",
    .summary = "kinetic, strain and stored energy of bodies in contact over time",
    .run = run,
};
