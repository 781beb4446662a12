/* Bundles of numbers: of cases without a field that is known everywhere, such as a J integral or a
 * balance of energy, which each solver finds in its own way.
 *
 * problem.json has `results: numbers` and criteria with a quantity in words, a unit and a band.
 * Results are CSV: the names number, value and, if one likes, unit, then a line for each number.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_SCORE_NUMBERS_H
#define VERIFICATION_SCORE_NUMBERS_H

#include "verification/score/bundle.h"

/* Writes the bundle of a case that has one of numbers, with its files, to <folder>/<case>/. Fails
 * as bundle_write does; MPM_BAD_INPUT also: a file of it is not in reference_data. */
enum mpm_status numbers_write(const struct catalogue_case *entry, const char *folder,
                              struct mpm_error *error);

/* Appends a row of rows.h for each criterion, with the value that the file of results has.
 * MPM_BAD_INPUT: it cannot be read, a number of the bundle is missing, twice there, not finite or
 * in another unit. Numbers that the bundle does not have are noted as not read. */
enum mpm_status numbers_rows(const struct bundle *bundle, const char *path, GString *rows,
                             struct mpm_error *error);

#endif
