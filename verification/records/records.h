/* Records: checks.jsonl and measurements.jsonl, the files that every report is rendered
 * from.
 *
 * The first line is an object of kind "run": provenance, what was selected, and for
 * each case its texts, figures and variants (time, work, notes, end of the log). Then
 * one object per declared check, in the order of the catalogue.
 *
 * measurements.jsonl holds every quantity that was reported, with a check or without: an
 * object of kind "run" (version, revision, tier, start), then `family, case, variant,
 * quantity, unit, value, reason` for each; the value is null with a reason if it is not
 * finite or could not be determined. Quantities of every variant are `particle_steps`,
 * `seconds` (of the wall clock), `cpu_seconds` and `peak_bytes`, the most memory that it had.
 *
 * A run that was interrupted has an object "incomplete" in its first line: `reason`, and how many
 * programs of how many have ended (`done`, `programs`).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_RECORDS_RECORDS_H
#define VERIFICATION_RECORDS_RECORDS_H

#include "verification/common/failure.h"
#include "verification/common/record.h"
#include "verification/measures/verdict.h"

#include <glib.h>

struct records {
    json_t *run;          /* object */
    json_t *checks;       /* array of objects */
    json_t *measurements; /* array of objects; NULL if the folder that was read has none */
};

void records_clear(struct records *records);

/* Writes <folder>/checks.jsonl and measurements.jsonl through temporary files. */
enum mpm_status records_write(const char *folder, const struct records *records,
                              struct mpm_error *error);

/* Reads them back. MPM_BAD_INPUT names file and line. */
enum mpm_status records_read(const char *folder, struct records *records, struct mpm_error *error);

/* ------------------------------------------------------------------- access */

/* VERDICT_STATUS_COUNT: no status has the name that the check gives. */
enum verdict_status record_status(const json_t *check);

/* "case/<what>/variant" of a line, for tables of lines; g_free. */
char *record_key(const json_t *line, const char *what);

/* Lines by that key, and the line with the key of another one; g_hash_table_unref. The lines belong
 * to their records. */
GHashTable *record_index(const json_t *lines, const char *what);
const json_t *record_find(GHashTable *index, const json_t *line, const char *what);

/* The object of a case; NULL if the run has none of that name. Whether it has a tag. */
const json_t *records_case(const struct records *records, const char *name);
bool record_has_tag(const json_t *entry, const char *tag);

/* What is missing of a run that was interrupted, as a sentence; NULL of a complete one. g_free. */
char *records_incomplete(const struct records *records);

/* Whether two records of one case come from one declared check. */
bool record_same_declaration(const json_t *one, const json_t *other);

struct record_counts {
    size_t of[VERDICT_STATUS_COUNT];
    size_t passed, failed, skipped; /* passed counts expected failures, too */
    size_t total;
    size_t mutations, mutations_red;
};

/* Counts the checks of a family and case (NULL: of all). */
struct record_counts records_count(const struct records *records, const char *family,
                                   const char *name);

/* The check of that case (NULL: of all) with the least margin; NULL if none has one. */
const json_t *records_worst(const struct records *records, const char *name);

#endif
