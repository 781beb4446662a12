/* Error against run time: one pass for the errors, then rounds for the times.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "benchmarks/groups/accuracy.h"

#include "benchmarks/common/findings.h"
#include "benchmarks/groups/variants.h"
#include "benchmarks/measuring/timing.h"
#include "verification/common/failure.h"

#include <math.h>

/* Short runs are repeated until a timing is this long. */
static const double SHORTEST = 0.02;
enum { ROUNDS = BENCH_ROUNDS_MIN, REPEATS_MAX = 16, QUICK_LADDER = 2 };

static const struct accuracy_problem *const problems[] = {
    &accuracy_compression,     &accuracy_bars[0],         &accuracy_bars[1],
    &accuracy_manufactured[0], &accuracy_manufactured[1], &accuracy_manufactured[2],
};

const struct accuracy_problem *const *accuracy_problems(size_t *count)
{
    *count = G_N_ELEMENTS(problems);
    return problems;
}

void accuracy_set(GPtrArray *settings, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    g_ptr_array_add(settings, g_strdup_vprintf(format, arguments));
    va_end(arguments);
}

/* A run: one problem, variant and grid. */
struct run {
    const struct accuracy_problem *problem;
    char *name;
    json_t *settings;
    struct mpm_scene *scene;
    bool failed;
    unsigned repeats; /* within a timing */
    double errors[ACCURACY_ERRORS_MAX], seconds[ROUNDS];
};

static void clear_run(void *item)
{
    struct run *run = item;
    g_free(run->name);
    json_decref(run->settings);
    mpm_scene_free(run->scene);
}

/* ------------------------------------------------------------------ the runs */

static void describe(struct run *run, const struct bench_variant *variant, unsigned cells)
{
    run->name = g_strdup_printf("%s/%s/%s%s%s/%u", run->problem->name, variant->shape,
                                variant->stress_update, *variant->change == '\0' ? "" : "/",
                                variant->change, cells);
    run->settings = json_object();
    json_object_set_new(run->settings, "problem", json_string(run->problem->name));
    json_object_set_new(run->settings, "shape", json_string(variant->shape));
    json_object_set_new(run->settings, "stress_update", json_string(variant->stress_update));
    if (*variant->change != '\0')
        json_object_set_new(run->settings, "change", json_string(variant->change));
    json_object_set_new(run->settings, "cells", json_integer(cells));
}

static enum mpm_status add_run(struct bench_context *context, GArray *runs,
                               const struct accuracy_problem *problem,
                               const struct bench_variant *variant, unsigned cells,
                               struct mpm_error *error)
{
    struct run run = {.problem = problem, .repeats = 1};
    GPtrArray *settings = g_ptr_array_new_with_free_func(g_free);
    char *path = problem->scene(context);
    describe(&run, variant, cells);
    accuracy_set(settings, "method.shape=%s", variant->shape);
    accuracy_set(settings, "method.stress_update=%s", variant->stress_update);
    if (variant->setting != NULL)
        accuracy_set(settings, "%s", variant->setting);
    accuracy_set(settings, "time.end=%.17g", problem->end);
    problem->set(settings, cells);
    const enum mpm_status status = mpm_scene_read(path, (const char *const *)settings->pdata,
                                                  settings->len, &run.scene, error);
    g_array_append_val(runs, run);
    g_free(path);
    g_ptr_array_unref(settings);
    return status;
}

/* The finest grid costs as much as all others together, four times that without fast kernels:
 * variants of transfer and form do without it. */
static unsigned ladder_of(const struct bench_context *context,
                          const struct accuracy_problem *problem,
                          const struct bench_variant *variant)
{
    unsigned count = 0;
    while (count < ACCURACY_LADDER_MAX && problem->cells[count] > 0)
        count++;
    if (*variant->change != '\0')
        count--;
    return context->tier == BENCH_QUICK && count > QUICK_LADDER ? QUICK_LADDER : count;
}

static enum mpm_status add_ladder(struct bench_context *context, GArray *runs,
                                  const struct accuracy_problem *problem,
                                  const struct bench_variant *variant, struct mpm_error *error)
{
    const unsigned count = ladder_of(context, problem, variant);
    for (unsigned i = 0; i < count; i++)
        TRY(add_run(context, runs, problem, variant, problem->cells[i], error));
    return MPM_OK;
}

static enum mpm_status add_all(struct bench_context *context, GArray *runs, struct mpm_error *error)
{
    for (size_t p = 0; p < G_N_ELEMENTS(problems); p++)
        for (size_t v = 0; v < bench_variants_count(); v++) {
            const struct bench_variant variant = bench_variant(v);
            if (*variant.change == '\0' || problems[p]->begin == NULL)
                TRY(add_ladder(context, runs, problems[p], &variant, error));
        }
    return MPM_OK;
}

/* ---------------------------------------------------------------- the errors */

/* A simulation at its start; freed by close_simulation. */
struct begun {
    struct mpm_simulation *simulation;
    void *own; /* of the problem */
};

static void close_simulation(const struct run *run, struct begun *begun)
{
    mpm_simulation_free(begun->simulation);
    if (begun->own != NULL)
        run->problem->finish(begun->own);
}

static enum mpm_status open_simulation(const struct bench_context *context, const struct run *run,
                                       struct begun *begun, struct mpm_error *error)
{
    *begun = (struct begun){0};
    TRY(mpm_simulation_create(run->scene, &context->simulation, &begun->simulation, error));
    if (run->problem->begin == NULL)
        return MPM_OK;
    begun->own = run->problem->begin(begun->simulation, run->scene, error);
    if (begun->own != NULL)
        return MPM_OK;
    close_simulation(run, begun);
    return error->status;
}

/* To that time; a guard that ends the run is a result. */
static enum mpm_status advance_to(struct run *run, struct mpm_simulation *simulation, double time,
                                  bool land, struct mpm_error *error)
{
    while (!run->failed && mpm_simulation_time(simulation) < time) {
        const enum mpm_status status =
            mpm_simulation_advance(simulation, land ? time : run->problem->end, error);
        run->failed = status == MPM_RUN_FAILED;
        if (status != MPM_OK && !run->failed)
            return status;
    }
    return MPM_OK;
}

/* Samples are taken at the first step at or after their time: the steps stay those of a run
 * without samples. */
static enum mpm_status follow(struct run *run, struct mpm_simulation *simulation,
                              struct particle_set *particles, struct mpm_error *error)
{
    const struct accuracy_problem *problem = run->problem;
    struct accuracy_sum sums[ACCURACY_ERRORS_MAX] = {{0, 0}};
    for (size_t k = 1; !run->failed && mpm_simulation_time(simulation) < problem->end; k++) {
        const double time = fmin(problem->interval * (double)k, problem->end);
        TRY(advance_to(run, simulation, time, false, error));
        particle_set_read(particles, simulation);
        problem->look(particles, mpm_simulation_time(simulation), sums);
    }
    for (size_t e = 0; e < ACCURACY_ERRORS_MAX; e++)
        run->errors[e] = run->failed ? (double)NAN : sqrt(sums[e].squares / sums[e].count);
    return MPM_OK;
}

static void note_facts(struct run *run, const struct mpm_simulation *simulation)
{
    const double reached = mpm_simulation_time(simulation) / run->problem->end;
    const json_int_t particles = (json_int_t)mpm_simulation_particle_count(simulation);
    json_object_set_new(run->settings, "particles", json_integer(particles));
    json_object_set_new(run->settings, "kernels", json_string(mpm_simulation_kernels(simulation)));
    json_object_set_new(run->settings, "outcome", json_string(run->failed ? "failed" : "done"));
    json_object_set_new(run->settings, "reached", json_real(reached));
}

static enum mpm_status measure_errors(struct bench_context *context, struct run *run,
                                      struct mpm_error *error)
{
    struct begun begun;
    struct particle_set particles;
    TRY(open_simulation(context, run, &begun, error));
    enum mpm_status status = particle_set_create(begun.simulation, 0, &particles, error);
    if (status == MPM_OK) {
        status = follow(run, begun.simulation, &particles, error);
        particle_set_free(&particles);
    }
    note_facts(run, begun.simulation);
    close_simulation(run, &begun);
    return status;
}

/* ----------------------------------------------------------------- the times */

static enum mpm_status time_once(struct bench_context *context, struct run *run, double *seconds,
                                 struct mpm_error *error)
{
    struct begun begun;
    TRY(open_simulation(context, run, &begun, error));
    const double start = bench_clock_cpu();
    const enum mpm_status status =
        advance_to(run, begun.simulation, run->problem->end, true, error);
    *seconds += bench_clock_cpu() - start;
    close_simulation(run, &begun);
    return status;
}

static enum mpm_status visit(struct bench_context *context, struct run *run, size_t round,
                             struct mpm_error *error)
{
    double seconds = 0;
    for (unsigned i = 0; i < run->repeats; i++)
        TRY(time_once(context, run, &seconds, error));
    run->seconds[round] = seconds / run->repeats;
    return MPM_OK;
}

/* The run for the errors warms up, and determines how often to repeat. */
static enum mpm_status rehearse(struct bench_context *context, struct run *run,
                                struct mpm_error *error)
{
    const double start = bench_clock_cpu();
    TRY(measure_errors(context, run, error));
    const double seconds = bench_clock_cpu() - start;
    run->repeats = (unsigned)fmin(REPEATS_MAX, ceil(SHORTEST / seconds));
    return MPM_OK;
}

/* ---------------------------------------------------------------- all of it */

static enum mpm_status named(const struct run *run, enum mpm_status status, struct mpm_error *error)
{
    const struct mpm_error cause = *error;
    return status == MPM_OK ? MPM_OK
                            : failure_set(error, status, "%s: %s", run->name, cause.message);
}

static enum mpm_status measure(struct bench_context *context, GArray *runs, struct mpm_error *error)
{
    const size_t count = runs->len, total = (ROUNDS + 1) * count;
    for (size_t v = 0; v < total; v++) {
        const size_t round = v / count, place = v % count;
        struct run *run =
            &g_array_index(runs, struct run, round % 2 == 0 ? place : count - 1 - place);
        bench_console_progress(context->console, v + 1, total, run->name);
        if (round == 0)
            TRY(named(run, rehearse(context, run, error), error));
        else if (!run->failed)
            TRY(named(run, visit(context, run, round - 1, error), error));
    }
    return MPM_OK;
}

static void write_lines(struct bench_context *context, const struct run *run)
{
    const struct bench_subject subject = {"accuracy", run->name, run->settings};
    for (size_t e = 0; e < ACCURACY_ERRORS_MAX && run->problem->errors[e] != NULL; e++)
        bench_value(context, &subject, run->problem->errors[e], "1", run->errors[e]);
    if (!run->failed)
        bench_result(context, &subject, "cpu_seconds", "s", run->seconds, ROUNDS);
}

enum mpm_status bench_accuracy(struct bench_context *context, struct mpm_error *error)
{
    GArray *runs = g_array_new(FALSE, TRUE, sizeof(struct run));
    g_array_set_clear_func(runs, clear_run);
    enum mpm_status status = add_all(context, runs, error);
    if (status == MPM_OK)
        status = measure(context, runs, error);
    for (size_t i = 0; status == MPM_OK && i < runs->len; i++)
        write_lines(context, &g_array_index(runs, struct run, i));
    g_array_unref(runs);
    return status;
}
