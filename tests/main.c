/* Runs all unit tests; the last line is `N passed, N failed, N skipped`.
 *
 * The tests of a suite share a process: one for each test costs more than most tests do, most of
 * all under sanitizers. If one fails, ends the process (a signal, a sanitizer) or does not end, or
 * if memory has leaked, the suite runs again with a process for each test, where Check reports
 * which of them it was. The suite's counts are then those of the second run.
 *
 * Check's own environment variables hold: CK_RUN_SUITE and CK_RUN_CASE choose, CK_FORK=yes gives
 * each test its own process at once, CK_FORK=no keeps all tests in this one for a debugger,
 * CK_VERBOSITY=verbose lists.
 * MPM_TEST_PROCESSES=N: N suites run at a time; 1 without it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/skip.h"

#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

enum way { TOGETHER, APART, APART_AGAIN };

static const struct {
    Suite *(*create)(void);
    const char *name;
    enum way way;
} suites[] = {
#define SUITE_TOGETHER(name) {suite_##name, #name, TOGETHER},
#define SUITE_APART(name)    {suite_##name, #name, APART},
    SUITES(SUITE_TOGETHER, SUITE_APART)
#undef SUITE_TOGETHER
#undef SUITE_APART
};
enum { SUITE_COUNT = sizeof suites / sizeof *suites };

struct counts {
    int run, failed;
};

/* One suite, or all of them where Check is told which to run. */
struct job {
    size_t first, count;
    enum way way;
    pid_t process; /* 0: not running */
};

/* The counts of each job, written by its process. */
static FILE *counted;

/* Jobs are groups of their own: what ends this process has to be passed on to them. */
static volatile sig_atomic_t groups[SUITE_COUNT];

static const int passed_on[] = {SIGINT, SIGTERM, SIGHUP};

static void pass_on(int number)
{
    for (size_t i = 0; i < SUITE_COUNT; i++)
        if (groups[i] > 0)
            (void)kill(-(pid_t)groups[i], SIGTERM);
    _exit(128 + number);
}

static struct counts run_suites(size_t first, size_t count, enum fork_status forks)
{
    SRunner *runner = srunner_create(NULL);
    for (size_t i = first; i < first + count; i++)
        srunner_add_suite(runner, suites[i].create());
    srunner_set_fork_status(runner, forks);
    test_marks_wanted = forks == CK_FORK;
    srunner_run_all(runner, CK_ENV);
    const struct counts counts = {srunner_ntests_run(runner), srunner_ntests_failed(runner)};
    srunner_free(runner);
    return counts;
}

static long from_environment(const char *name, long otherwise)
{
    const char *const text = getenv(name);
    const long value = text != NULL ? strtol(text, NULL, 10) : 0;
    return value > 0 ? value : otherwise;
}

/* Check ends a test at its time-out where it has a process of its own. A suite has that of five
 * tests; the second run finds the one that hangs. */
static unsigned seconds_of_suite(void)
{
    return (unsigned)(5 * from_environment("CK_DEFAULT_TIMEOUT", 60) *
                      from_environment("CK_TIMEOUT_MULTIPLIER", 1));
}

/* A job is a group of processes: at its alarm, Check ends the group that it is in. */
static bool start(struct job *job)
{
    const struct counts none = {-1, -1};
    const off_t place = (off_t)(job->first * sizeof none);
    (void)fflush(NULL);
    if (pwrite(fileno(counted), &none, sizeof none, place) != (ssize_t)sizeof none)
        return false;
    job->process = fork();
    if (job->process != 0) {
        groups[job->first] = job->process;
        return job->process > 0;
    }
    for (size_t i = 0; i < sizeof passed_on / sizeof *passed_on; i++)
        (void)signal(passed_on[i], SIG_DFL);

    (void)setpgid(0, 0);
    test_skip_run((int)(2 * job->first) + (job->way == APART_AGAIN));
    if (job->way == TOGETHER)
        (void)alarm(seconds_of_suite());
    const struct counts counts =
        run_suites(job->first, job->count, job->way == TOGETHER ? CK_NOFORK : CK_FORK);
    exit(pwrite(fileno(counted), &counts, sizeof counts, place) == (ssize_t)sizeof counts
             ? EXIT_SUCCESS
             : EXIT_FAILURE); /* a leak sanitizer has a status of its own */
}

/* What a job whose process has ended adds to the sum; it runs again where it does not. */
static bool add_counts(struct job *job, int status, struct counts *sum)
{
    struct counts counts = {0, 0};
    const ssize_t size =
        pread(fileno(counted), &counts, sizeof counts, (off_t)(job->first * sizeof counts));
    /* A test that calls exit(0) leaves the count as start() wrote it. */
    const bool ended = status == 0 && size == (ssize_t)sizeof counts && counts.run >= 0;
    const char *const name = job->count == 1 ? suites[job->first].name : "chosen";
    job->process = 0;
    groups[job->first] = 0;
    if (job->way == TOGETHER && (!ended || counts.failed > 0)) {
        (void)printf("suite %s: runs again, with a process for each test\n", name);
        test_skip_ignore((int)(2 * job->first));
        job->way = APART_AGAIN;
        return false;
    }
    if (!ended) {
        (void)printf("suite %s: its process ended before it reported\n", name);
        counts = (struct counts){1, 1};
    } else if (job->way == APART_AGAIN && counts.failed == 0) {
        (void)printf("suite %s: fails in one process, passes with a process for each test\n", name);
        counts = (struct counts){counts.run + 1, 1};
    }
    sum->run += counts.run;
    sum->failed += counts.failed;
    return true;
}

/* Every job has to report: one that cannot be started counts as a failure. */
static struct counts run_jobs(struct job *jobs, size_t count, long processes)
{
    struct counts sum = {0, 0};
    size_t next = 0;
    for (long working = 0; working > 0 || next < count;) {
        if (working < processes && next < count) {
            const bool started = start(&jobs[next++]);
            working += started;
            sum.run += !started;
            sum.failed += !started;
            continue;
        }
        int status = 0;
        const pid_t process = wait(&status);
        size_t at = 0;
        while (at < next && jobs[at].process != process)
            at++;
        if (at == next) /* not a job */
            continue;
        if (!add_counts(&jobs[at], status, &sum)) {
            if (start(&jobs[at]))
                continue;
            sum = (struct counts){sum.run + 1, sum.failed + 1};
        }
        working--;
    }
    return sum;
}

/* A case can be one of any suite. */
static enum way way_of_choice(const char *suite)
{
    for (size_t i = 0; suite != NULL && i < SUITE_COUNT; i++)
        if (strcmp(suites[i].name, suite) == 0)
            return suites[i].way;
    return suite != NULL ? TOGETHER : APART;
}

static struct counts run_all(void)
{
    const char *const forks = getenv("CK_FORK"), *const suite = getenv("CK_RUN_SUITE");
    if (forks != NULL && strcmp(forks, "no") == 0)
        return run_suites(0, SUITE_COUNT, CK_NOFORK);
    for (size_t i = 0; i < sizeof passed_on / sizeof *passed_on; i++)
        (void)signal(passed_on[i], pass_on);
    if (suite != NULL || getenv("CK_RUN_CASE") != NULL) {
        struct job all = {0, SUITE_COUNT, forks != NULL ? APART : way_of_choice(suite), 0};
        return run_jobs(&all, 1, 1);
    }
    struct job jobs[SUITE_COUNT];
    for (size_t i = 0; i < SUITE_COUNT; i++)
        jobs[i] = (struct job){i, 1, forks != NULL ? APART : suites[i].way, 0};
    return run_jobs(jobs, SUITE_COUNT, from_environment("MPM_TEST_PROCESSES", 1));
}

int main(void)
{
    /* Check's 4 s are short on a busy machine; 60 s still end a hang. */
    (void)setenv("CK_DEFAULT_TIMEOUT", "60", 0);
    (void)setenv("CK_VERBOSITY", "normal", 0);
    counted = tmpfile();
    /* Lines of several processes stay whole. */
    if (counted == NULL || setvbuf(stdout, NULL, _IOLBF, 0) != 0 || !test_skip_open()) {
        (void)fprintf(stderr, "mpm-tests: cannot create a temporary file\n");
        return 4;
    }
    const struct counts counts = run_all();
    const int skipped = test_skip_report(stdout);
    if (counts.run == 0)
        (void)printf("no test ran: no such suite or case\n");
    (void)printf("%d passed, %d failed, %d skipped\n", counts.run - counts.failed - skipped,
                 counts.failed, skipped);
    return counts.run > 0 && counts.failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
