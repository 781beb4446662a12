/* Runs all unit tests; the last line is `N passed, N failed, N skipped`.
 *
 * Check's own environment variables hold: CK_RUN_SUITE and CK_RUN_CASE choose,
 * CK_FORK=no keeps tests in this process for a debugger, CK_VERBOSITY=verbose lists.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/skip.h"

#include <stdio.h>
#include <stdlib.h>

static Suite *(*const suites[])(void) = {
#define SUITE_ROW(name) suite_##name,
    SUITES(SUITE_ROW)
#undef SUITE_ROW
};

int main(void)
{
    /* Check's 4 s are short on a busy machine; 60 s still end a hang. */
    (void)setenv("CK_DEFAULT_TIMEOUT", "60", 0);
    (void)setenv("CK_VERBOSITY", "normal", 0);
    if (!test_skip_open()) {
        (void)fprintf(stderr, "mpm-tests: cannot create a temporary file\n");
        return 4;
    }
    SRunner *runner = srunner_create(NULL);
    for (size_t i = 0; i < sizeof suites / sizeof *suites; i++)
        srunner_add_suite(runner, suites[i]());
    srunner_run_all(runner, CK_ENV);

    const int run = srunner_ntests_run(runner);
    const int failed = srunner_ntests_failed(runner);
    const int skipped = test_skip_report(stdout);
    srunner_free(runner);
    if (run == 0)
        (void)printf("no test ran: no such suite or case\n");
    (void)printf("%d passed, %d failed, %d skipped\n", run - failed - skipped, failed, skipped);
    return run > 0 && failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
