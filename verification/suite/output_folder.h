/* The output folder: what of it is ours, and made ready for a run.
 *
 *     checks.jsonl   measurements.jsonl   index.html   summary.md   junit.xml   results.tap
 *     limits.html    headroom.html   mutants.html   glossary.html   table-*.csv
 *     changes.json   headroom.json   mutants.json   (see reports/README.md)
 *     cases/<case>/  index.html, figure-<name>.svg, and per variant rows-*.jsonl,
 *                    log-*.txt, data-*-<name>.dat; checks.csv, runs.csv,
 *                    comparison.html, comparison.csv and
 *                    its data-*.dat where a comparison is declared
 *
 * Files that are not of this list are never touched; a folder that holds one of these
 * names but no .mpm-verify is refused.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_SUITE_OUTPUT_FOLDER_H
#define VERIFICATION_SUITE_OUTPUT_FOLDER_H

#include "verification/suite/plan.h"

/* Creates the folder, removes what an earlier run left, and keeps the folder for this
 * process until *lock is released. MPM_BAD_INPUT: a file, a folder with files that are
 * not ours or that another run writes to; MPM_ENVIRONMENT_FAILED: cannot be written. */
enum mpm_status output_prepare(const char *folder, const struct plan *plan, int *lock,
                               struct mpm_error *error);
void output_release(int lock);

#endif
