/* The output folder: what of it is ours, and made ready for a run.
 *
 *     checks.jsonl   measurements.jsonl   index.html   summary.md   junit.xml   results.tap
 *     limits.html    headroom.html   mutants.html   glossary.html   table-*.csv
 *     changes.json   headroom.json   mutants.json   (see reports/README.md)
 *     api/           *.html, *.css, *.png: pages of the library's headers
 *     style/         style.gp, comparison.gp, report.css, page.html, table.js, glossary.md
 *     cases/<case>/  index.html, figure-<name>.svg, picture-*.svg, and per variant
 *                    rows-*.jsonl, log-*.txt, data-*-<name>.dat; picture-<variant>.json of the
 *                    one whose run is shown; checks.csv, runs.csv,
 *                    comparison.html, comparison.csv and
 *                    its data-*.dat where a comparison is declared
 *
 *     .mpm-verify    marks the folder; the process that writes to it holds a lock on this file
 *     .run/          run.json: what was selected; results/: what programs have left
 * (kept_result.h); unfinished/: checkpoints of programs that were killed; report/: the report that
 * is being made; publish: its files, while they are moved into their places
 *
 * Files that are not of this list are never touched; a folder that holds one of these
 * names but no .mpm-verify is refused. A new report is made in .run/report, beside the old one,
 * which stays until the new one is whole. Then each file is renamed into its place, and what the
 * new report does not have is removed. If that is cut short, the next process that opens the folder
 * ends it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_SUITE_OUTPUT_FOLDER_H
#define VERIFICATION_SUITE_OUTPUT_FOLDER_H

#include "verification/report/report.h"
#include "verification/suite/plan.h"

struct output_folder {
    char *folder;  /* as named */
    char *state;   /* .run */
    char *results; /* .run/results */
    char *stage;   /* .run/report */
    int lock;
};

/* The names alone: for those who read. Release with output_close. */
struct output_folder output_names(const char *folder);

/* Makes the folder, and keeps it for this process until output_close. MPM_BAD_INPUT: a file, a
 * folder with files that are not ours or that another run writes to; MPM_ENVIRONMENT_FAILED: cannot
 * be written. On failure nothing is to be closed. */
enum mpm_status output_open(const char *folder, struct output_folder *output,
                            struct mpm_error *error);
void output_close(struct output_folder *output);

/* An empty report/ with the folders that the programs of the plan write in. */
enum mpm_status output_stage(const struct output_folder *output, const struct plan *plan,
                             struct mpm_error *error);

/* Renders the report of the results in report/, and puts it in the place of the report before.
 * MPM_ENVIRONMENT_FAILED: a file cannot be written, and the report before stays; or a figure cannot
 * be drawn, and the new one is there without it. */
enum mpm_status output_report(const struct output_folder *output,
                              const struct report_sources *sources, struct mpm_error *error);

#endif
