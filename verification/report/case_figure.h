/* The figures of a case.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_REPORT_CASE_FIGURE_H
#define VERIFICATION_REPORT_CASE_FIGURE_H

#include "verification/common/record.h"
#include "verification/pages/figure.h"
#include "verification/report/report.h"

/* Draws <folder>/cases/<case>/figure-<name>.svg from the data files beside it, by the script of
 * that case in the catalogue. `entry` and `figure` are objects of the run's record. WITHOUT_DATA if
 * a variant, the data, the case or its script is missing; the note states whether the script is the
 * one that the run had. */
struct figure_result figure_draw(const char *folder, const struct report_sources *sources,
                                 const json_t *run, const json_t *entry, const json_t *figure);

/* What the runs of a case left in its folder for others to use, in order; those that a report
 * writes are not among them. */
enum mpm_status case_data_files(const char *home, GPtrArray **files, struct mpm_error *error);

/* Whether the folders of a run's cases, and those files in them, are ordinary ones under names that
 * a run gives; MPM_BAD_INPUT else. */
enum mpm_status case_folders_check(const char *folder, const json_t *run, struct mpm_error *error);

#endif
