/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "support/transfer_block.h"

#include <math.h>
#include <stdlib.h>

/* Its edges are on grid lines and within cells. */
static const char BLOCK[] = TEST_RUBBER_BLOCK("[8.5, 8]");

const char *const block_orders[BLOCK_ORDERS] = {"stress_update: usl", "stress_update: musl",
                                                "stress_update: usf", "stress_update: usavg",
                                                "stress_update: usavg, extrapolate: false"};

struct test_run block_open(struct settings *settings, int threads)
{
    const struct test_run run = test_run_open(BLOCK, settings->texts, threads);
    settings_clear(settings);
    return run;
}

void block_add_method(struct settings *settings, const char *shape, const char *order,
                      const char *transfer)
{
    settings_add_formatted(settings, "method={shape: %s, %s, transfer: %s}", shape, order,
                           transfer);
}

/* The largest difference of two fields of two runs. */
double test_run_difference(const struct test_run *one, const struct test_run *other,
                           enum mpm_field field)
{
    size_t n;
    double largest = 0.0;
    double *const a = test_run_field(one, field, &n), *const b = test_run_field(other, field, NULL);
    for (size_t k = 0; k < n * mpm_field_describe(field)->components; k++)
        largest = fmax(largest, fabs(a[k] - b[k]));
    free(a);
    free(b);
    return largest;
}
