/* The section of problem.md on how to get from what codes commonly write to what a bundle takes.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_SCORE_BUNDLE_CONVERT_H
#define VERIFICATION_SCORE_BUNDLE_CONVERT_H

#include <glib.h>
#include <jansson.h>

/* What applies to the columns (of fields), the geometry and the kind of results in problem.json;
 * `late`: a time by which results may be off, of the bundle's unit. */
void bundle_words_of_conversion(GString *text, const json_t *json, double late);

#endif
