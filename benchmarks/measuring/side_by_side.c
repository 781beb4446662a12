/* Runs side by side.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "benchmarks/measuring/side_by_side.h"

#include "benchmarks/measuring/timing.h"
#include "verification/common/failure.h"

/* Nobody passes before all have come. */
struct gate {
    GMutex mutex;
    GCond all_came;
    unsigned awaited;
};

static void gate_pass(struct gate *gate)
{
    g_mutex_lock(&gate->mutex);
    gate->awaited--;
    if (gate->awaited == 0)
        g_cond_broadcast(&gate->all_came);
    while (gate->awaited > 0)
        g_cond_wait(&gate->all_came, &gate->mutex);
    g_mutex_unlock(&gate->mutex);
}

struct lane {
    const struct bench_runs *runs;
    struct gate *gate;
    struct mpm_simulation *simulation;
    GThread *thread;
    double start, end, cpu; /* of the timed steps */
    enum mpm_status status;
    struct mpm_error error;
};

/* A run that fails comes to the gate as well: the others wait there for it. */
static void *step(void *item)
{
    struct lane *lane = item;
    lane->status = bench_advance(lane->simulation, lane->runs->warm_up, &lane->error);
    gate_pass(lane->gate);
    const double cpu = bench_clock_thread();
    lane->start = bench_clock_wall();
    if (lane->status == MPM_OK)
        lane->status = bench_advance(lane->simulation, lane->runs->steps, &lane->error);
    lane->end = bench_clock_wall();
    lane->cpu = bench_clock_thread() - cpu;
    return NULL;
}

static void step_all(struct lane *lanes, unsigned count)
{
    struct gate gate = {.awaited = count};
    g_mutex_init(&gate.mutex);
    g_cond_init(&gate.all_came);
    for (unsigned k = 0; k < count; k++) {
        lanes[k].gate = &gate;
        lanes[k].thread = g_thread_new("run", step, &lanes[k]);
    }
    for (unsigned k = 0; k < count; k++)
        (void)g_thread_join(lanes[k].thread);
    g_cond_clear(&gate.all_came);
    g_mutex_clear(&gate.mutex);
}

static enum mpm_status collect(const struct bench_runs *runs, const struct lane *lanes,
                               struct bench_sample *sample, struct mpm_error *error)
{
    double start = lanes[0].start, end = lanes[0].end;
    *sample = (struct bench_sample){0, 0, 0};
    for (unsigned k = 0; k < runs->count; k++) {
        if (lanes[k].status != MPM_OK)
            return failure_set(error, lanes[k].status, "%s", lanes[k].error.message);
        start = MIN(start, lanes[k].start);
        end = MAX(end, lanes[k].end);
        sample->work += runs->steps;
        sample->cpu += lanes[k].cpu;
    }
    sample->wall = end - start;
    return MPM_OK;
}

enum mpm_status bench_side_by_side(const struct bench_runs *runs, struct bench_sample *sample,
                                   struct mpm_error *error)
{
    struct lane *lanes = g_new0(struct lane, runs->count);
    enum mpm_status status = MPM_OK;
    for (unsigned k = 0; k < runs->count && status == MPM_OK; k++) {
        lanes[k].runs = runs;
        status = mpm_simulation_create(runs->scene, runs->options, &lanes[k].simulation, error);
    }
    if (status == MPM_OK) {
        step_all(lanes, runs->count);
        status = collect(runs, lanes, sample, error);
    }
    for (unsigned k = 0; k < runs->count; k++)
        mpm_simulation_free(lanes[k].simulation);
    g_free(lanes);
    return status;
}
