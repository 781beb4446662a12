/* E1: total energy over time.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/suite/programs.h"

#include <math.h>
#include <stdlib.h>

enum { COLUMNS = 4 };

struct books {
    double start;     /* energy at t = 0 */
    double low, high; /* extremes of (E - W) / E(0) - 1 */
    double end;       /* the same at the end */
    double slowest;   /* smallest kinetic energy over E(0): the impact has happened */
    double *rows;
    size_t row_count, row_capacity;
};

/* The work of moving boundaries belongs to the balance; here they rest and do none. */
static void add_sample(struct books *books, const struct mpm_simulation *simulation)
{
    struct mpm_ledger ledger;
    mpm_simulation_ledger(simulation, &ledger);
    const double energy = ledger.total_energy - ledger.external_work;
    if (books->row_count == 0)
        books->start = energy;
    const double drift = energy / books->start - 1.0;
    books->low = fmin(books->low, drift);
    books->high = fmax(books->high, drift);
    books->end = drift;
    books->slowest = fmin(books->slowest, ledger.kinetic_energy / books->start);
    if (books->row_count == books->row_capacity)
        return;
    double *const row = &books->rows[COLUMNS * books->row_count++];
    row[0] = ledger.time;
    row[1] = energy / books->start;
    row[2] = ledger.kinetic_energy / books->start;
    row[3] = ledger.strain_energy / books->start;
}

static enum mpm_status follow(struct measurement *m, struct mpm_simulation *simulation, double end,
                              double interval, struct books *books, struct mpm_error *error)
{
    add_sample(books, simulation);
    for (double time = 0.0; time < end;) {
        const enum mpm_status status = mpm_simulation_advance(simulation, end, error);
        if (status == MPM_RUN_FAILED) {
            measurement_note(m, "the run ended: %s", error->message);
            break;
        }
        TRY(status);
        time = mpm_simulation_time(simulation);
        if (time >= interval * (double)books->row_count || time >= end)
            add_sample(books, simulation);
    }
    add_sample(books, simulation);
    return MPM_OK;
}

static enum mpm_status report(struct measurement *m, const struct mpm_simulation *simulation,
                              const struct books *books, struct mpm_error *error)
{
    measurement_report(m, "drift", 100.0 * fmax(books->high, -books->low));
    measurement_report(m, "span", 100.0 * (books->high - books->low));
    measurement_report(m, "end_drift", 100.0 * books->end);
    measurement_report(m, "slowest", 100.0 * books->slowest);
    measurement_report(m, "reached", mpm_simulation_time(simulation));
    measurement_note(m, "total energy between %+.5f %% and %+.5f %%, at the end %+.5f %%",
                     100.0 * books->low, 100.0 * books->high, 100.0 * books->end);
    measurement_work(m,
                     mpm_simulation_step(simulation) * mpm_simulation_particle_count(simulation));
    return measurement_series(m, "energy",
                              "time total_over_start kinetic_over_start "
                              "strain_over_start",
                              COLUMNS, books->row_count, books->rows, error);
}

static enum mpm_status measure(struct measurement *m, const struct mpm_scene *scene,
                               struct mpm_simulation *simulation, struct mpm_error *error)
{
    double interval;
    TRY(measurement_number(m, "interval", &interval, error));
    const double end = mpm_scene_end_time(scene);
    struct books books = {.slowest = HUGE_VAL, .row_capacity = (size_t)(end / interval) + 16};
    books.rows = calloc(books.row_capacity * COLUMNS, sizeof *books.rows);
    if (books.rows == NULL)
        return failure_set(error, MPM_ENVIRONMENT_FAILED, "out of memory for the energy curve");
    enum mpm_status status = follow(m, simulation, end, interval, &books, error);
    if (status == MPM_OK)
        status = report(m, simulation, &books, error);
    free(books.rows);
    return status;
}

static enum mpm_status run(struct measurement *measurement, struct mpm_error *error)
{
    struct mpm_scene *scene = NULL;
    struct mpm_simulation *simulation = NULL;
    enum mpm_status status = measurement_scene(measurement, NULL, 0, &scene, error);
    if (status == MPM_OK)
        status = mpm_simulation_create(scene, measurement_options(measurement), &simulation, error);
    if (status == MPM_OK)
        status = measure(measurement, scene, simulation, error);
    mpm_simulation_free(simulation);
    mpm_scene_free(scene);
    return status;
}

const struct measure_program program_energy = {
    .name = "energy",
    .summary = "kinetic, strain and total energy over time",
    .run = run,
};
