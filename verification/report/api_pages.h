/* Pages of the library's headers, Doxygen's, beside a report: a copy in its folder api/, so that
 * the folder of the report can be moved whole.
 *
 * Doxygen's pages have scripts, and a folder of results may come from anywhere. Every page in api/
 * begins with a line that forbids scripts, and all that is loaded from elsewhere: a page without it
 * is refused. Beside pages api/ has style sheets and PNG pictures alone: an SVG picture may have
 * scripts too.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_REPORT_API_PAGES_H
#define VERIFICATION_REPORT_API_PAGES_H

#include "verification/common/failure.h"

#include <stdbool.h>

/* Whether `source` is Doxygen's html folder, without links; MPM_BAD_INPUT else. */
enum mpm_status api_pages_check(const char *source, struct mpm_error *error);

/* Copies pages, style sheets and pictures of `source` into <folder>/api, each whole or not at all,
 * the first page last; what is there of earlier pages is removed. */
enum mpm_status api_pages_copy(const char *source, const char *folder, struct mpm_error *error);

/* Whether <folder>/api has pages. MPM_BAD_INPUT: links, or files that no copy has; where the pages
 * are to be `replaced`, they may lack their first line. */
enum mpm_status api_pages_find(const char *folder, bool replaced, bool *there,
                               struct mpm_error *error);

#endif
