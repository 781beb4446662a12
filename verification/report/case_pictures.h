/* Pictures of the scene of a case, above all else on its page, and those of the index.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_REPORT_CASE_PICTURES_H
#define VERIFICATION_REPORT_CASE_PICTURES_H

#include "verification/records/records.h"

#include <glib.h>

struct report_site;

/* Draws picture-*.svg into the folder of the case `entry` of the run and appends its part of the
 * page: sketch, last state, motion; or why there are none. MPM_ENVIRONMENT_FAILED: a file cannot be
 * written. */
enum mpm_status case_pictures(const char *home, const json_t *entry, GString *html,
                              struct mpm_error *error);

/* The strip of the index: small pictures that lead to their cases. Call it once the cases' own are
 * drawn. */
void case_pictures_strip(GString *html, const struct records *records, const char *folder);

#endif
