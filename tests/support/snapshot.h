/* Reading a snapshot back, as a user of the files would.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TESTS_SUPPORT_SNAPSHOT_H
#define TESTS_SUPPORT_SNAPSHOT_H

#include "mpm.h"

#include <hdf5.h>

struct test_snapshot {
    double time;
    int64_t step;
    size_t count;                    /* particles */
    double *fields[MPM_FIELD_COUNT]; /* count * components values; NULL: not in the file */
};

/* Fails the test if the file or anything in it is missing or of a wrong shape. */
struct test_snapshot test_snapshot_read(const char *path);
void test_snapshot_free(struct test_snapshot *snapshot);

/* Numbers of a whole dataset as doubles; *count is how many. g_free. */
double *test_dataset_read(hid_t file, const char *path, size_t *count);

/* A scalar text attribute of variable length; g_free. */
char *test_attribute_text(hid_t file, const char *object, const char *name);

#endif
