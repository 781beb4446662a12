/* Points: what is measured. A list is built, measured (timing.h) and freed with
 * g_array_unref.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef BENCHMARKS_MEASURING_POINTS_H
#define BENCHMARKS_MEASURING_POINTS_H

#include "mpm.h"

#include <glib.h>
#include <jansson.h>

/* One timing. */
struct bench_sample {
    double work;      /* particle-steps, or what the probe counts */
    double cpu, wall; /* seconds that it took: of all threads; of the clock */
};

/* Something else than steps of a simulation to be timed in the same rounds. It does its own
 * preparation and times (bench_clock_*) what is to be counted. */
typedef enum mpm_status bench_probe(const void *context, struct bench_sample *sample,
                                    struct mpm_error *error);

enum bench_clock {
    BENCH_CLOCK_AUTO, /* CPU time for one thread, wall clock for more */
    BENCH_CLOCK_CPU,
    BENCH_CLOCK_WALL,
};

struct bench_point {
    char *name;       /* unique in its group */
    json_t *settings; /* what varies: of the lines of bench.jsonl */
    char *against;    /* name of an earlier or later point of the list to compare with, or NULL */
    enum bench_clock clock;

    /* steps of a simulation ... */
    char *scene;    /* path */
    GPtrArray *set; /* texts PATH=VALUE */
    struct mpm_simulation_options simulation;
    unsigned warm_up; /* steps before the timed ones */
    unsigned steps;   /* timed ones; 0: chosen so that a timing is long enough and short enough */
    bool phases;      /* record the phases of a step and the bytes a particle as well */
    unsigned runs;    /* 2 and more: as many simulations of the scene side by side, without phases;
                         their work together, by the wall clock (side_by_side.h) */

    /* ... or a probe, if not NULL */
    bench_probe *probe;
    const void *probe_context;
    const char *quantity, *unit; /* what sample.work / seconds is */
};

/* An empty list of struct bench_point. */
GArray *bench_points_new(void);

/* Adds a point that steps a scene (path) with these options, or one that runs a probe. Valid
 * until the next one is added. The name is printed from the format. */
struct bench_point *bench_points_add(GArray *points, const char *scene,
                                     const struct mpm_simulation_options *options,
                                     const char *format, ...) __attribute__((format(printf, 4, 5)));
struct bench_point *bench_points_add_probe(GArray *points, bench_probe *probe, const void *context,
                                           const char *quantity, const char *unit,
                                           const char *name);

/* PATH=VALUE for the scene; the last wins. */
void bench_point_set(struct bench_point *point, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* A setting for the lines. */
void bench_point_text(struct bench_point *point, const char *key, const char *text);
void bench_point_number(struct bench_point *point, const char *key, double number);

/* PATH=VALUE for the scene and, under the last name of PATH, a setting for the lines:
 * "method.shape", "ugimp". */
void bench_point_vary(struct bench_point *point, const char *path, const char *value);

#endif
