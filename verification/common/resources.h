/* Where the suite's own files are: in the repository, or installed.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_COMMON_RESOURCES_H
#define VERIFICATION_COMMON_RESOURCES_H

/* The catalogue: verification/catalogue below the current folder, or three folders above
 * the executable's (build/<variant>/bin), or <prefix>/share/touchstone/catalogue. NULL
 * if there is none; g_free. */
char *resources_catalogue(const char *executable);

/* The folder of style.gp, page.html and report.css, searched in the same places. */
char *resources_reports(const char *executable);
#define RESOURCES_NO_REPORTS                                                                       \
    "the report's style is found neither in reports/ nor beside the program"

/* The folder of the benchmarks' scenes/, searched in the same places. */
char *resources_benchmarks(const char *executable);

/* The folder of what others computed, reference_data, searched in the same places. */
char *resources_reference_data(const char *executable);

/* The program `name` beside the running one; g_free. */
char *resources_program(const char *executable, const char *name);

/* build/reports/verify in the repository, ./verify-report elsewhere; g_free. And the same for
 * scores. */
char *resources_output(void);
char *resources_score_output(void);

#endif
