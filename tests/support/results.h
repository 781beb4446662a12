/* What the tests of results share: one folder a test with a scene in it, runs of that
 * scene, and their files read back. All of it fails the test if something is wrong.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TESTS_SUPPORT_RESULTS_H
#define TESTS_SUPPORT_RESULTS_H

#include "support/snapshot.h"

#include <jansson.h>

/* The fixture; results go to `output`, which is not there at first. */
extern struct test_results {
    char *folder, *scene_path, *output;
    struct mpm_scene *scene;
} test_results;

void test_results_set_up(void);
void test_results_tear_down(void);

/* Takes another scene than TEST_BLOCKS. */
void test_results_scene(const char *text);

/* Runs the scene on one thread; the second expects it to go well. */
enum mpm_status test_results_run(bool overwrite, struct mpm_error *error);
void test_results_run_well(void);

/* A JSON file of the results; json_decref. */
json_t *test_results_json(const char *name);

/* The list of snapshots (json_decref) and the array in it. */
json_t *test_results_series(json_t **files);

/* Reads a listed snapshot, which must be of the time in the list. */
struct test_snapshot test_results_listed(const json_t *files, size_t index);

enum {
    TEST_HISTORY_COLUMNS = 12,
    TEST_HISTORY_TIME = 0,
    TEST_HISTORY_STEP = 1,
    TEST_HISTORY_TOTAL = 9
};

/* Rows of the history in `folder` as numbers, after a check of its two first lines;
 * g_free. */
double (*test_results_history(const char *folder, size_t *rows))[TEST_HISTORY_COLUMNS];

#endif
