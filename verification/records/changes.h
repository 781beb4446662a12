/* What changed from one run of the suite to another: gathered once, printed by mpm-verify compare
 * and shown on the report's front page.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_RECORDS_CHANGES_H
#define VERIFICATION_RECORDS_CHANGES_H

#include "verification/measures/comparison/run_change.h"
#include "verification/records/records.h"

#include <glib.h>

struct changes {
    /* objects with texts: section ("Statuses", ...), change (changes_word), name, text, and of a
     * check its case; in the order of the sections */
    json_t *lines;
    size_t worse, better, other;
    size_t unselected; /* checks of the first run that the second did not select */
};

/* Gathers statuses that changed, checks that appeared or vanished, and values that changed by more
 * than the relative `change`. Both runs must outlive the call only. */
struct changes changes_gather(const struct records *before, const struct records *after,
                              double change);
void changes_clear(struct changes *changes);

/* "better", "worse", "changed"; "" for none. */
const char *changes_word(enum run_change change);

/* The changes with what the two runs were, as the object of changes.json (see reports/README.md).
 */
json_t *changes_record(const struct changes *changes, const json_t *before, const json_t *after,
                       double change);

#endif
