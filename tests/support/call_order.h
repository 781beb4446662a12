/* The order of the calls that make files last: fsync and rename, as the code under test makes them.
 * Linux alone.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TESTS_SUPPORT_CALL_ORDER_H
#define TESTS_SUPPORT_CALL_ORDER_H

#include <stdbool.h>

/* From now on they are recorded; false: not on this system. */
bool test_call_order_start(void);
/* A line for each, "fsync NAME" or "rename OLD", without folders; g_free. */
char *test_call_order_end(void);

#endif
