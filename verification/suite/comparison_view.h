/* The table of a comparison page, from the records of a run.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_SUITE_COMPARISON_VIEW_H
#define VERIFICATION_SUITE_COMPARISON_VIEW_H

#include "verification/measures/comparison.h"
#include "verification/suite/records.h"

#include <glib.h>

struct comparison_view {
    struct comparison_table table; /* rows in alphabetical order */
    const json_t **variants;       /* records of the rows */
    const json_t *declared;        /* of the comparison */
    /* memory of the table */
    const char **names;
    struct comparison_column *columns;
    struct comparison_cell *cells;
    GPtrArray *reasons;
};

/* `entry` is an object of the run's cases with a comparison. */
struct comparison_view comparison_view_make(const struct records *records, const json_t *entry);
void comparison_view_clear(struct comparison_view *view);

/* The comparison that a case declares; NULL if there is none. */
const json_t *comparison_declared(const json_t *entry);

/* Place of the column of a quantity; COMPARISON_NONE if there is none. */
size_t comparison_view_column(const struct comparison_view *view, const char *quantity);

#endif
