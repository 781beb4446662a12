/* case.yaml: from text to a checked struct.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_CASES_CASE_FILE_H
#define VERIFICATION_CASES_CASE_FILE_H

#include "verification/cases/catalogue.h"

/* Reads one case.yaml by its schema: unknown and repeated keys, wrong types and
 * numbers with trailing text are refused. */
enum mpm_status case_file_load(const char *path, struct case_file **file, struct mpm_error *error);

/* Rules that no schema can express: names, globs that match nothing, bands, duplicates. */
enum mpm_status case_file_check(const char *path, const struct case_file *file,
                                struct mpm_error *error);

void case_file_free(struct case_file *file);

#endif
