/* The scene of the tests of transfers and forms: one block with settings, and what runs of it
 * have in common or not.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TESTS_SUPPORT_TRANSFER_BLOCK_H
#define TESTS_SUPPORT_TRANSFER_BLOCK_H

#include "support/scenes.h"

#include <glib.h>

struct block_settings {
    char *texts[8];
    int count;
};

void block_add(struct block_settings *settings, const char *format, ...) G_GNUC_PRINTF(2, 3);
/* `order`: "stress_update: musl", with more keys of the method or without */
void block_add_method(struct block_settings *settings, const char *shape, const char *order,
                      const char *transfer);
/* Up to 0.4, from particle to particle. */
void block_set_wild_velocity(struct block_settings *settings, bool axisymmetric);

/* The block with the settings, which are freed. */
struct test_run block_open(struct block_settings *settings, int threads);

/* The largest difference of a field of two runs. */
double test_run_difference(const struct test_run *one, const struct test_run *other,
                           enum mpm_field field);

#endif
