/* Workers share the items of a job: each item once, each worker one at a time.
 *
 * Helpers are counted from none, so each test has a process of its own (APART in suites.h).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/workers.h"

#include "suites.h"
#include "support/scene_files.h"

#include "base/strips.h"

#include <glib.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum { WORKERS_MAX = 5, ITEMS_MAX = 1000 };
static const int64_t counts[] = {0, 1, 2, 7, 64, ITEMS_MAX};
enum { COUNTS = sizeof counts / sizeof *counts };

/* No ck_assert outside the thread of the test: faults are counted. */
struct job {
    int visits[ITEMS_MAX]; /* plain numbers: an item has one worker */
    _Atomic bool busy[WORKERS_MAX];
    _Atomic int faults;
    int workers;
};

static void visit(void *context, int64_t item, int worker)
{
    struct job *const job = context;
    if (worker < 0 || worker >= job->workers || atomic_exchange(&job->busy[worker], true)) {
        job->faults++;
        return;
    }
    job->visits[item]++;
    atomic_store(&job->busy[worker], false);
}

/* Faults of one job. */
static int run_job(int64_t count, int workers)
{
    struct job job = {.workers = workers};
    mpm_workers_run(count, workers, visit, &job);
    int faults = job.faults;
    for (int64_t item = 0; item < ITEMS_MAX; item++)
        faults += job.visits[item] != (item < count);
    return faults;
}

/* Numbers of items and of workers in turn, over and over: helpers come late, sleep, wake up. */
static int run_jobs(void)
{
    enum { TURNS = 200 };
    int faults = 0;
    for (int turn = 0; turn < TURNS; turn++)
        for (int k = 0; k < COUNTS; k++)
            faults += run_job(counts[k], 1 + (turn + k) % WORKERS_MAX);
    return faults;
}

START_TEST(each_item_runs_once_and_each_worker_does_one_at_a_time)
{
    ck_assert_int_eq(run_jobs(), 0);
}
END_TEST

START_TEST(helpers_that_went_to_sleep_are_woken)
{
    const struct timespec pause = {.tv_nsec = 2000000}; /* 40 times what they wait for */
    for (int k = 0; k < 20; k++) {
        ck_assert_int_eq(run_job(ITEMS_MAX, WORKERS_MAX), 0);
        (void)nanosleep(&pause, NULL);
    }
}
END_TEST

/* An item of the job outside is a job of its own. */
static void run_job_within(void *context, int64_t item, int worker)
{
    const struct timespec moment = {.tv_nsec = 20000}; /* lets helpers take items as well */
    (void)worker;
    (void)nanosleep(&moment, NULL);
    *(_Atomic int *)context += run_job(counts[item % COUNTS], WORKERS_MAX);
    *(_Atomic int *)context += 1000000;
}

START_TEST(a_job_within_a_job_leaves_the_one_outside_alone)
{
    enum { ITEMS = 24 };
    for (int turn = 0; turn < 50; turn++) {
        _Atomic int done = 0;
        mpm_workers_run(ITEMS, 2 + turn % (WORKERS_MAX - 1), run_job_within, &done);
        ck_assert_int_eq(done, ITEMS * 1000000);
    }
    ck_assert_int_eq(run_jobs(), 0); /* and workers are shared again */
}
END_TEST

static void work_slowly(void *context, int64_t item, int worker)
{
    const struct timespec pause = {.tv_nsec = worker == 0 ? 200000 : 5000000};
    (void)item;
    (void)nanosleep(&pause, NULL);
    ++*(_Atomic int *)context;
}

START_TEST(a_job_is_over_when_its_slowest_item_is_done)
{
    for (int turn = 0; turn < 10; turn++) {
        _Atomic int done = 0;
        mpm_workers_run(12, WORKERS_MAX, work_slowly, &done);
        ck_assert_int_eq(done, 12);
    }
}
END_TEST

/* Each pause is 20 times as long as a helper looks for work; a busy machine may take many of them.
 */
START_TEST(helpers_without_work_go_to_sleep)
{
    enum { PAUSES = 10000 };
    const struct timespec pause = {.tv_nsec = 1000000};
    (void)unsetenv("OMP_WAIT_POLICY");
    ck_assert_int_eq(mpm_workers_asleep(), 0);
    ck_assert_int_eq(run_job(ITEMS_MAX, WORKERS_MAX), 0);
    for (int k = 0; k < PAUSES && mpm_workers_asleep() < WORKERS_MAX - 1; k++)
        (void)nanosleep(&pause, NULL);
    ck_assert_int_eq(mpm_workers_asleep(), WORKERS_MAX - 1);
}
END_TEST

static void *run_jobs_in_thread(void *faults)
{
    *(int *)faults = run_jobs();
    return NULL;
}

START_TEST(threads_that_call_at_the_same_time_have_helpers_of_their_own)
{
    enum { CALLERS = 3 };
    pthread_t callers[CALLERS];
    int faults[CALLERS];
    for (int k = 0; k < CALLERS; k++)
        ck_assert_int_eq(pthread_create(&callers[k], NULL, run_jobs_in_thread, &faults[k]), 0);
    for (int k = 0; k < CALLERS; k++) {
        ck_assert_int_eq(pthread_join(callers[k], NULL), 0);
        ck_assert_int_eq(faults[k], 0);
    }
}
END_TEST

START_TEST(a_child_of_fork_has_helpers_of_its_own)
{
    ck_assert_int_eq(run_jobs(), 0);
    const pid_t child = fork();
    if (child == 0)
        _exit(run_jobs() == 0 ? 0 : 1);
    int status;
    ck_assert_int_eq(waitpid(child, &status, 0), child);
    ck_assert(WIFEXITED(status));
    ck_assert_int_eq(WEXITSTATUS(status), 0);
    ck_assert_int_eq(run_jobs(), 0);
}
END_TEST

/* ------------------------------------------------------------------- strips */

enum { STRIPS = 41 };
struct strips {
    _Atomic int done[2]; /* per colour */
    _Atomic int visits[STRIPS];
    _Atomic int faults;
};

static void visit_strip(void *context, int64_t strip, int worker)
{
    struct strips *const strips = context;
    (void)worker;
    strips->faults += strip % 2 == 1 && strips->done[0] < STRIPS / 2 + 1;
    strips->visits[strip]++;
    strips->done[strip % 2]++;
}

START_TEST(odd_strips_wait_for_all_even_ones)
{
    for (int turn = 0; turn < 500; turn++) {
        struct strips strips = {.faults = 0};
        mpm_strips_run(STRIPS, 1 + turn % WORKERS_MAX, visit_strip, &strips);
        ck_assert_int_eq(strips.faults, 0);
        for (int strip = 0; strip < STRIPS; strip++)
            ck_assert_int_eq(strips.visits[strip], 1);
    }
}
END_TEST

/* ------------------------------------------------------------------ threads */

static const struct {
    int columns, rows, allowed, expected; /* cells with four particles each */
    const char *reason;
} plans[] = {
    {100, 100, 1, 1, "as many as are allowed"},
    {100, 100, 5, 5, "as many as are allowed"},
    {32, 31, 4, 1, "of 4 allowed: 3968 particles, one more thread for each 4096"},
    {32, 32, 4, 2, "of 4 allowed: 4096 particles, one more thread for each 4096"},
    {2000, 8, 4, 1, "of 4 allowed: strips of 8 rows of cells with particles: 1, "},
    {2000, 24, 4, 2, "of 4 allowed: strips of 8 rows of cells with particles: 3, "},
};

START_TEST(threads_are_as_many_as_particles_and_strips_give_work)
{
    char *text = g_strdup_printf(
        "format: 1\ngeometry: plane_strain\ngrid: {cell: [1, 1], cells: [%d, %d]}\n"
        "time: {end: 1}\nmaterials:\n"
        "  - {name: rubber, law: neo_hookean, density: 1, bulk: 100, shear: 50}\nbodies:\n"
        "  - {name: block, material: rubber, particles_per_cell: [2, 2],\n"
        "     region: {rectangle: {from: [0, 0], to: [%d, %d]}}}\n",
        plans[_i].columns + 1, plans[_i].rows + 40, plans[_i].columns, plans[_i].rows);
    struct mpm_scene *scene = test_scene_read_text(text);
    const struct mpm_simulation_options options = {.threads = plans[_i].allowed};
    struct mpm_plan plan;
    struct mpm_simulation *simulation = NULL;
    ck_assert_int_eq(mpm_scene_plan(scene, &options, &plan, NULL), MPM_OK);
    ck_assert_int_eq(plan.threads, plans[_i].expected);
    test_contains(plan.threads_reason, plans[_i].reason);
    ck_assert_int_eq(mpm_simulation_create(scene, &options, &simulation, NULL), MPM_OK);
    ck_assert_int_eq(mpm_simulation_threads(simulation), plans[_i].expected);
    mpm_simulation_free(simulation);
    mpm_scene_free(scene);
    g_free(text);
}
END_TEST

Suite *suite_workers(void)
{
    Suite *suite = suite_create("workers");
    TCase *workers = tcase_create("workers");
    tcase_add_test(workers, each_item_runs_once_and_each_worker_does_one_at_a_time);
    tcase_add_test(workers, helpers_that_went_to_sleep_are_woken);
    tcase_add_test(workers, a_job_within_a_job_leaves_the_one_outside_alone);
    tcase_add_test(workers, a_job_is_over_when_its_slowest_item_is_done);
    tcase_add_test(workers, helpers_without_work_go_to_sleep);
    tcase_add_test(workers, threads_that_call_at_the_same_time_have_helpers_of_their_own);
    tcase_add_test(workers, a_child_of_fork_has_helpers_of_its_own);
    tcase_add_test(workers, odd_strips_wait_for_all_even_ones);
    tcase_add_loop_test(workers, threads_are_as_many_as_particles_and_strips_give_work, 0,
                        (int)G_N_ELEMENTS(plans));
    suite_add_tcase(suite, workers);
    return suite;
}
