/* Numbers in the prose of a page, and what they come from.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TESTS_SUPPORT_PROSE_H
#define TESTS_SUPPORT_PROSE_H

#include <stdbool.h>

/* A number of the prose that the page shows nowhere: computed from numbers that it shows, or of
 * the literature. */
struct test_prose_claim {
    const char *page;
    const char *number; /* as written, with " %" if that follows */
    const char *from; /* an expression of numbers that `in`.md or its scene has; NULL: literature */
    const char *in;   /* NULL: the page itself; of literature, what has it */
};

/* What is written is the value, rounded to the digits that are written; signs are left out. */
bool test_number_rounds(const char *written, double value);

/* Every number of the prose with a decimal point is one, rounded, that output, comparisons or
 * quotes of the page or its scene have; every percentage is one of the comparisons; or a claim has
 * it. Every claim about the page is met in it. NULL, or what is wrong; g_free it. `folder` has
 * NAME.md and NAME.yaml. */
char *test_prose_judge(const char *folder, const char *page, const struct test_prose_claim *claims,
                       unsigned count);

#endif
