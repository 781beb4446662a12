/* Error against run time: problems with an exact solution, run by every variant of the solver
 * on a ladder of grids.
 *
 * Lines of a run, point "<problem>/<shape>/<stress_update>[/<change>]/<cells>":
 *   value   "error_..."    root mean square over particles (and samples in time), relative;
 *                          null where the run failed
 *   result  "cpu_seconds"  processor time of the steps alone; none where the run failed
 * with the settings problem, shape, stress_update, change (variants.h; none if ""), cells,
 * particles, outcome ("done" or "failed") and reached, the part of the run's time that it got
 * through.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef BENCHMARKS_GROUPS_ACCURACY_H
#define BENCHMARKS_GROUPS_ACCURACY_H

#include "benchmarks/common/bench.h"
#include "verification/measures/particle_set.h"

#include <glib.h>

enum { ACCURACY_ERRORS_MAX = 4, ACCURACY_LADDER_MAX = 6 };

/* A mean of squares being added up. */
struct accuracy_sum {
    double squares, count;
};

struct accuracy_problem {
    const char *name;        /* of settings.problem; a word */
    const char *title;       /* heading of the report */
    const char *description; /* what is run and what the error is, for the report */
    const char *headline;    /* the error that pictures and tables show, one of `errors` */
    const char *errors[ACCURACY_ERRORS_MAX]; /* quantities; NULL ends them */
    const char *headline_words;              /* the headline in words */
    unsigned cells[ACCURACY_LADDER_MAX];     /* the ladder, along the body; 0 ends it */
    double end;                              /* time at which the run ends */
    double interval;                         /* between two samples; the last one is at the end */
    /* Path of the scene; g_free. */
    char *(*scene)(const struct bench_context *context);
    /* PATH=VALUE texts of a grid with so many cells. */
    void (*set)(GPtrArray *settings, unsigned cells);
    /* What a scene cannot state, or NULL: gives it to a simulation at its start, and returns what
     * belongs to it; NULL, with the error, if that fails. Problems that have it run with shapes and
     * orders alone, no other transfers and forms. */
    void *(*begin)(struct mpm_simulation *simulation, const struct mpm_scene *scene,
                   struct mpm_error *error);
    void (*finish)(void *begun);
    /* Adds the particles of the moment to the sums, one for each of `errors`. */
    void (*look)(const struct particle_set *particles, double time, struct accuracy_sum *sums);
};

/* All problems; *count of them. */
const struct accuracy_problem *const *accuracy_problems(size_t *count);

enum { ACCURACY_BARS = 2, ACCURACY_MANUFACTURED = 3 };
extern const struct accuracy_problem accuracy_compression, accuracy_bars[ACCURACY_BARS],
    accuracy_manufactured[ACCURACY_MANUFACTURED];

/* Adds a text PATH=VALUE, printed from the format. */
void accuracy_set(GPtrArray *settings, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

#endif
