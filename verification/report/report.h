/* The report: everything a person or a CI reads, rendered from an output folder.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_REPORT_REPORT_H
#define VERIFICATION_REPORT_REPORT_H

#include "verification/pages/figure.h"
#include "verification/records/records.h"

#include <glib.h>

/* Where the report's own files are: a folder of results may come from anywhere, so that nothing in
 * it is run and no page is filled into what lies there. */
struct report_sources {
    const char *reports;   /* style, templates, scripts of comparisons */
    const char *catalogue; /* scripts of the cases' figures; NULL: none are drawn */
};

/* Renders index.html, the cases' pages, comparisons and figures, summary.md, junit.xml and
 * results.tap of `folder` from its checks.jsonl and
 * measurements.jsonl. The figures' data are those in the folder, their scripts those of the
 * sources. `place` is where the report is to lie: pages link to benchmarks beside it. The same
 * folder and sources give the same bytes. MPM_BAD_INPUT: no such results, or a link or anything
 * else but files where they should be. MPM_ENVIRONMENT_FAILED: a file cannot be written.
 * MPM_RUN_FAILED: gnuplot is missing or a script failed; all else is there, and the place of a
 * missing figure states why. */
enum mpm_status report_render(const char *folder, const char *place,
                              const struct report_sources *sources, struct mpm_error *error);

/* Whether a folder has results that report_render() would take; MPM_BAD_INPUT else. */
enum mpm_status report_check(const char *folder, struct mpm_error *error);

/* The exit status for that of report_render: a figure that cannot be drawn is the environment's
 * fault. */
enum mpm_status report_status(enum mpm_status rendered);

/* The parts, each a whole file's text; g_free. */
char *report_markdown(const struct records *records);
char *report_junit(const struct records *records);
char *report_tap(const struct records *records);

struct report_site; /* report_site.h */

/* The page of the comparison that `entry` declares, and its numbers as CSV. */
struct comparison_view;
char *comparison_page(const struct report_site *site, const json_t *entry,
                      const struct comparison_view *view, const struct figure_result *picture);
char *comparison_csv(const struct comparison_view *view);

/* The page of `entry`, an object of the run's cases, whose figures `figures` belongs to; its tables
 * go to checks.csv and runs.csv in the folder of the case. `scene` is HTML with the pictures of its
 * scene, `files` are names in that folder that the page offers. */
char *report_case(struct report_site *site, const json_t *entry, const char *scene,
                  const struct figure_result *figures, const GPtrArray *files);

#endif
