/* What a report shows beside its own run: stored in its folder, so that the folder alone gives the
 * same report again. reports/README.md has the formats.
 *
 *     changes.json    what changed since a baseline
 *     headroom.json   the values of the same checks in runs of other builds
 *     history.json    the values of earlier runs
 *     mutants.json    which spoiled solvers the tests and the suite noticed
 *     api/            pages of the library's headers (api_pages.h)
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_REPORT_REPORT_STORED_H
#define VERIFICATION_REPORT_REPORT_STORED_H

#include "verification/common/failure.h"
#include "verification/common/record.h"

/* What to store; NULL leaves what the folder has. */
struct report_additions {
    const char *baseline;        /* folder of an earlier run */
    const char *mutants;         /* a file */
    const char *const *headroom; /* NAME=DIR, ended by NULL */
    const char *const *history;  /* folders of earlier runs, oldest first, ended by NULL */
    const char *api;             /* Doxygen's html folder */
};

/* Works them out for the run in `folder` and writes them there. MPM_BAD_INPUT: a folder without
 * results, an entry that is not NAME=DIR, a file of mutants that is not as described, a folder that
 * is not Doxygen's. */
enum mpm_status report_store(const char *folder, const struct report_additions *additions,
                             struct mpm_error *error);

struct report_stored {
    json_t *changes, *headroom, *mutants, *history; /* NULL: none stored */
};

/* MPM_BAD_INPUT: a file that is there and not as described. */
enum mpm_status report_stored_read(const char *folder, struct report_stored *stored,
                                   struct mpm_error *error);
void report_stored_clear(struct report_stored *stored);

/* Whether the object is as mutants.json is described; else what is wrong, with `path` before it. */
enum mpm_status mutants_check(const json_t *object, const char *path, struct mpm_error *error);

#endif
