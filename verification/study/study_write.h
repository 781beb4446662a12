/* The tables and pictures of a study, in <output>/study/: study.md, study.csv, study.jsonl,
 * data-<measure>-{cell,time}.dat and error-<measure>-{cell,time}.svg.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_STUDY_STUDY_WRITE_H
#define VERIFICATION_STUDY_STUDY_WRITE_H

#include "verification/study/study_results.h"

#include <stdio.h>

char *study_markdown(const struct study_results *results, bool pictures);  /* g_free */
char *study_csv(const struct study_results *results);                      /* g_free */
char *study_jsonl(const struct study_results *results, const json_t *run); /* g_free */

/* Draws the pictures of a measure; MPM_ENVIRONMENT_FAILED. Those with fewer than two errors are
 * left out, and removed. */
enum mpm_status study_pictures(const struct study_results *results, const char *folder,
                               const char *reports, const char *stamp, struct mpm_error *error);
/* Has the measure a picture? */
bool study_has_picture(const struct study_results *results, unsigned k);

/* Reads the study and the records in `output`, writes all of it and prints the tables. *holds: each
 * run came to its end, and each order lies in its interval. */
enum mpm_status study_write(const char *output, const char *reports, FILE *out, bool *holds,
                            struct mpm_error *error);

#endif
