/* G3: a scene at the edge of what a method can do: how far it gets, what ends it, and the state
 * then.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/programs/follow.h"

#include <inttypes.h>
#include <math.h>

/* Endings by number, and the causes that the solver names. */
static const struct {
    enum mpm_cause causes[2];
    const char *name;
} endings[] = {
    {{0}, "none"}, /* numbers begin with 1: a check's band must not hold zero */
    {{0}, "reached its end"},
    {{MPM_CAUSE_INVERTED}, "inverted"},
    {{MPM_CAUSE_LEFT_GRID}, "left the grid"},
    {{MPM_CAUSE_PASSED_AXIS}, "past the axis"},
    {{MPM_CAUSE_OUTRAN_CELL, MPM_CAUSE_DOMAIN}, "too fast or too big for a cell"},
    {{MPM_CAUSE_LOAD}, "load not finite"},
    {{MPM_CAUSE_ENERGY}, "energy grown"},
    {{MPM_CAUSE_WAVES}, "waves too fast"},
    {{MPM_CAUSE_NOT_FINITE}, "not finite"},
};
enum {
    ENDINGS = sizeof endings / sizeof endings[0],
    REACHED_END = 1,
    LOOKS = 500,
    ROWS = LOOKS + 2,
    COLUMNS = 4
};

struct record {
    double start;          /* E - W at t = 0 */
    double low, high;      /* extremes of E - W - start */
    double largest;        /* E, the scale */
    double j_min, j_max;   /* of all times */
    struct mpm_ledger now; /* the last sample */
    double end;            /* of the run */
    double rows[ROWS * COLUMNS];
    size_t row_count;
};

static void look(struct record *record, const struct mpm_simulation *simulation)
{
    mpm_simulation_ledger(simulation, &record->now);
    const struct mpm_ledger *const now = &record->now;
    const double change = now->total_energy - now->external_work - record->start;
    record->low = fmin(record->low, change);
    record->high = fmax(record->high, change);
    record->largest = fmax(record->largest, now->total_energy);
    record->j_min = fmin(record->j_min, now->j_min);
    record->j_max = fmax(record->j_max, now->j_max);
    const double row[COLUMNS] = {100.0 * now->time / record->end, change, now->j_min, now->j_max};
    for (size_t c = 0; c < COLUMNS && record->row_count < ROWS; c++)
        record->rows[COLUMNS * record->row_count + c] = row[c];
    record->row_count += record->row_count < ROWS;
}

static void start(struct record *record, const struct mpm_simulation *simulation, double end)
{
    *record = (struct record){.j_min = HUGE_VAL, .end = end};
    mpm_simulation_ledger(simulation, &record->now);
    record->start = record->now.total_energy - record->now.external_work;
    look(record, simulation);
}

static int ending_of(enum mpm_cause cause)
{
    for (int k = REACHED_END + 1; k < ENDINGS; k++)
        if (cause != MPM_CAUSE_NONE &&
            (cause == endings[k].causes[0] || cause == endings[k].causes[1]))
            return k;
    return ENDINGS;
}

/* Runs to `end` and sets *ending to what stopped it. */
static enum mpm_status follow(struct measurement *m, struct mpm_simulation *simulation, double end,
                              struct record *record, int *ending, struct mpm_error *error)
{
    start(record, simulation, end);
    *ending = REACHED_END;
    for (int k = 1; *ending == REACHED_END && mpm_simulation_time(simulation) < end;) {
        const enum mpm_status status = mpm_simulation_advance(simulation, end, error);
        if (status == MPM_RUN_FAILED) {
            *ending = ending_of(error->cause);
            measurement_note(m, "the run ended: %s", error->message);
        } else if (status != MPM_OK) {
            return status;
        }
        if (mpm_simulation_time(simulation) >= end * k / LOOKS) {
            look(record, simulation);
            k++;
        }
    }
    look(record, simulation);
    return MPM_OK;
}

static enum mpm_status report(struct measurement *m, const struct mpm_simulation *simulation,
                              const struct record *record, int ending, struct mpm_error *error)
{
    measurement_report(m, "ending", ending);
    measurement_report(m, "progress", 100.0 * record->now.time / record->end);
    measurement_note(m, "%" PRIu64 " steps", mpm_simulation_step(simulation));
    measurement_report(m, "j_min", record->j_min);
    measurement_report(m, "j_max", record->j_max);
    measurement_report(m, "j_min_end", record->now.j_min);
    measurement_report(m, "j_max_end", record->now.j_max);
    measurement_report(m, "energy_drift",
                       100.0 * fmax(record->high, -record->low) / record->largest);
    follow_count_work(m, simulation);
    return measurement_series(m, "state", "progress energy_change j_min j_max", COLUMNS,
                              record->row_count, record->rows, error);
}

static enum mpm_status measure(void *context, struct measurement *m, const struct mpm_scene *scene,
                               struct mpm_simulation *simulation, struct mpm_error *error)
{
    struct record record;
    int ending;
    (void)context;
    TRY(follow(m, simulation, mpm_scene_end_time(scene), &record, &ending, error));
    return report(m, simulation, &record, ending, error);
}

static enum mpm_status run(struct measurement *measurement, struct mpm_error *error)
{
    return follow_scene(measurement, NULL, 0, measure, NULL, error);
}

const struct measure_program program_extremes = {
    .name = "extremes",
    .summary = "how far a scene gets, what ends it, and its state then",
    .run = run,
};
