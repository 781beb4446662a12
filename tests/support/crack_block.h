/* The scene of the tests of cracks and planes of symmetry: a block of rubber.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TESTS_SUPPORT_CRACK_BLOCK_H
#define TESTS_SUPPORT_CRACK_BLOCK_H

#include "simulation/simulation.h"
#include "support/combinations.h"
#include "support/scenes.h"

/* 6 by 6 rows of cells; grid lines are at multiples of 0.8, one of them in its middle, 5.6. Wave
 * speed 12. */
extern const char CRACK_BLOCK[];

/* Four families of shape functions, and with each all orders of the stress update. */
enum { CRACK_BLOCK_FAMILIES = 4, CRACK_BLOCK_METHODS = CRACK_BLOCK_FAMILIES * TEST_ORDERS };

/* Families first, then orders, then all over again. */
struct settings crack_block_method(int index);

/* Transfers and the momentum form, each with both ways to move particles, added as keys of the
 * method. Returns which of the CRACK_BLOCK_TRANSFERS it is; the last is the momentum form. */
enum { CRACK_BLOCK_WAYS = 2, CRACK_BLOCK_APIC = 7, CRACK_BLOCK_FORM, CRACK_BLOCK_TRANSFERS };
enum { CRACK_BLOCK_EXCHANGES = CRACK_BLOCK_WAYS * CRACK_BLOCK_TRANSFERS };
int crack_block_add_exchange(struct settings *settings, int index);

/* Nodes of little mass at the edges make round-off grow without bound. */
bool crack_block_amplifies(int index);

/* The block with the settings, which are cleared. */
struct test_run crack_block_open(struct settings *settings);

const struct mpm_state *crack_block_state(const struct test_run *run);

/* What a run starts from: places tell particles from each other for good. */
struct crack_block_start {
    size_t count;
    double *place, *mass, *velocity;
};

struct crack_block_start crack_block_start(const struct test_run *run);

/* Momentum of the half that began above the middle, or below. */
void crack_block_momentum(const struct test_run *run, const struct crack_block_start *start,
                          bool above, double momentum[2]);
void crack_block_start_free(struct crack_block_start *start);

#endif
