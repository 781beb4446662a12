/* What a scene may use, off and on: the table of the group `overhead`.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef BENCHMARKS_GROUPS_OVERHEAD_FEATURES_H
#define BENCHMARKS_GROUPS_OVERHEAD_FEATURES_H

#include <stdbool.h>
#include <stddef.h>

enum { OVERHEAD_SETTINGS = 4 };

/* One way to run the block of scenes/free_block.yaml. */
struct overhead_feature {
    const char *name;
    const char *against; /* name of the row without the feature; NULL: such a row */
    bool writes;         /* timed is a whole run with its files, not steps alone */
    const char *scene;   /* of benchmarks/scenes */
    const char *settings[OVERHEAD_SETTINGS]; /* PATH=VALUE, beside those that all rows share */
    const char *expectation;                 /* one sentence: what it should cost, and why */
};

extern const struct overhead_feature overhead_features[];
extern const size_t overhead_feature_count;

/* The row of that name, which must be there. */
size_t overhead_feature_find(const char *name);

#endif
