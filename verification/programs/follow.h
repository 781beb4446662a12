/* Running a scene and sampling its ledger: what every measuring program of energy, momentum and
 * waves does around its own samples.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_PROGRAMS_FOLLOW_H
#define VERIFICATION_PROGRAMS_FOLLOW_H

#include "verification/measures/conservation.h"
#include "verification/programs/programs.h"

/* What a program does with a sample; the ledger is that of the moment. */
typedef void follow_sample(void *context, const struct mpm_simulation *simulation,
                           const struct mpm_ledger *ledger);

struct follow {
    struct measurement *measurement;
    double end;            /* time */
    double interval;       /* samples at t = 0, the first step at or after each multiple, the end */
    follow_sample *sample; /* NULL: the ledger alone */
    void *context;
};

/* What came of it. */
struct follow_result {
    struct conservation conservation;
    double time_step; /* the first one */
    bool finished;    /* false: the guard ended the run, its message is a note of the variant */
};

/* Advances to the end or to where the run breaks, which is a result and no failure; then the
 * result describes the last good state. Adds the work to the measurement. */
enum mpm_status follow_run(const struct follow *follow, struct mpm_simulation *simulation,
                           struct follow_result *result, struct mpm_error *error);

/* One step, not beyond `limit`. A run that its guard ends is a result here too: *alive becomes
 * false, else it stays as it is, and the guard's message is a note of the variant. */
enum mpm_status follow_step(struct measurement *measurement, struct mpm_simulation *simulation,
                            double limit, bool *alive, struct mpm_error *error);

/* Advances to `time`, landing on it; *alive: it got there. */
enum mpm_status follow_to(struct measurement *measurement, struct mpm_simulation *simulation,
                          double time, bool *alive, struct mpm_error *error);

/* Advances until the run is at rest, or to `end` where its scene has no `time.rest`; *finished:
 * it came to that. A run that its guard ends, or that is not at rest by `end`, is a result: a note
 * of the variant states it. Counts the work. */
enum mpm_status follow_to_rest(struct measurement *measurement, struct mpm_simulation *simulation,
                               double end, bool *finished, struct mpm_error *error);

/* Adds what was run so far to the particle-steps of the variant: once, at the end. */
void follow_count_work(struct measurement *measurement, const struct mpm_simulation *simulation);

/* What a program does with a scene and its simulation. */
typedef enum mpm_status follow_measure(void *context, struct measurement *measurement,
                                       const struct mpm_scene *scene,
                                       struct mpm_simulation *simulation, struct mpm_error *error);

/* Reads the variant's scene with `count` more settings, creates its simulation, has it measured,
 * and frees both. */
enum mpm_status follow_scene(struct measurement *measurement, const char *const *settings,
                             size_t count, follow_measure *measure, void *context,
                             struct mpm_error *error);

/* Rows of numbers that a sample function collects for measurement_series; the first failure
 * to grow is stored, and later rows are dropped. Start from zeros with `columns` set. */
struct follow_rows {
    size_t columns, count, capacity;
    double *values;
    bool out_of_memory;
};
void follow_rows_add(struct follow_rows *rows, const double *row);
void follow_rows_free(struct follow_rows *rows);
/* MPM_ENVIRONMENT_FAILED if a row was dropped. */
enum mpm_status follow_rows_check(const struct follow_rows *rows, struct mpm_error *error);

/* Reports what every method is compared by: energy_drift (%), reached (time), finished (1 or 0);
 * and for free bodies, `arm` > 0, momentum_drift and angular_momentum_drift (conservation.h). */
void follow_report(struct measurement *measurement, const struct follow_result *result, double arm);

#endif
