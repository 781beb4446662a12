/* Runs all unit tests; the last line is `N passed, N failed, N skipped`.
 *
 * Check's own environment variables hold: CK_RUN_SUITE and CK_RUN_CASE choose,
 * CK_FORK=no keeps tests in this process for a debugger, CK_VERBOSITY=verbose lists.
 * MPM_TEST_PROCESSES=N: suites are handed out to N processes; 1 without it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/skip.h"

#include <limits.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

static Suite *(*const suites[])(void) = {
#define SUITE_ROW(name) suite_##name,
    SUITES(SUITE_ROW)
#undef SUITE_ROW
};
enum { SUITE_COUNT = sizeof suites / sizeof *suites };

struct counts {
    int run, failed;
};

static struct counts run_suites(size_t first, size_t count)
{
    SRunner *runner = srunner_create(NULL);
    for (size_t i = first; i < first + count; i++)
        srunner_add_suite(runner, suites[i]());
    srunner_run_all(runner, CK_ENV);
    const struct counts counts = {srunner_ntests_run(runner), srunner_ntests_failed(runner)};
    srunner_free(runner);
    return counts;
}

/* Takes one suite after the other from `queue`, a byte each, and sends what it counted. */
static void work(int queue, int results)
{
    unsigned char suite;
    while (read(queue, &suite, 1) == 1) {
        const struct counts counts = run_suites(suite, 1);
        if (write(results, &counts, sizeof counts) != (ssize_t)sizeof counts)
            exit(EXIT_FAILURE);
    }
    exit(EXIT_SUCCESS);
}

/* Every suite has to report: one that took its process with it counts as a failure. */
static struct counts share_out(int processes)
{
    _Static_assert(SUITE_COUNT <= UCHAR_MAX, "a suite's number is sent as a byte");
    enum { OUT, IN };
    int queue[2], results[2];
    if (pipe(queue) != 0 || pipe(results) != 0)
        return (struct counts){1, 1};
    for (size_t i = 0; i < SUITE_COUNT; i++)
        (void)!write(queue[IN], &(unsigned char){(unsigned char)i}, 1);
    (void)close(queue[IN]);
    for (int k = 0; k < processes; k++)
        if (fork() == 0)
            work(queue[OUT], results[IN]);
    (void)close(queue[OUT]);
    (void)close(results[IN]);

    struct counts sum = {SUITE_COUNT, SUITE_COUNT}, one;
    while (read(results[OUT], &one, sizeof one) == (ssize_t)sizeof one) {
        sum.run += one.run - 1;
        sum.failed += one.failed - 1;
    }
    while (wait(NULL) > 0)
        continue;
    return sum;
}

/* A choice of suites is run, and reported, in one piece. */
static int processes_asked(void)
{
    const char *const text = getenv("MPM_TEST_PROCESSES");
    const bool whole = getenv("CK_RUN_SUITE") == NULL && getenv("CK_RUN_CASE") == NULL &&
                       getenv("CK_FORK") == NULL;
    const long processes = text != NULL && whole ? strtol(text, NULL, 10) : 1;
    return processes > 1 && processes < SUITE_COUNT ? (int)processes : 1;
}

int main(void)
{
    /* Check's 4 s are short on a busy machine; 60 s still end a hang. */
    (void)setenv("CK_DEFAULT_TIMEOUT", "60", 0);
    (void)setenv("CK_VERBOSITY", "normal", 0);
    /* Lines of several processes stay whole. */
    if (setvbuf(stdout, NULL, _IOLBF, 0) != 0 || !test_skip_open()) {
        (void)fprintf(stderr, "mpm-tests: cannot create a temporary file\n");
        return 4;
    }
    const int processes = processes_asked();
    const struct counts counts = processes > 1 ? share_out(processes) : run_suites(0, SUITE_COUNT);
    const int skipped = test_skip_report(stdout);
    if (counts.run == 0)
        (void)printf("no test ran: no such suite or case\n");
    (void)printf("%d passed, %d failed, %d skipped\n", counts.run - counts.failed - skipped,
                 counts.failed, skipped);
    return counts.run > 0 && counts.failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
