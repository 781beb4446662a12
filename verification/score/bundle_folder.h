/* What bundles of fields and of numbers have in common, written.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_SCORE_BUNDLE_FOLDER_H
#define VERIFICATION_SCORE_BUNDLE_FOLDER_H

#include "verification/cases/catalogue.h"

#include <glib.h>
#include <jansson.h>

/* The beginning of problem.json: the case, what a solver has to do, geometry, units and problem as
 * its scene has them, formulas of its laws; `results`: what is to be written, fields or numbers.
 * json_decref. */
json_t *bundle_facts(const struct catalogue_case *entry, const json_t *scene, const char *about,
                     const char *results);

/* The beginning of problem.md, formulas of the laws that the problem has, and the end, after which
 * the text is the caller's (g_free). */
GString *bundle_words_begin(const struct catalogue_case *entry, const char *about);
void bundle_words_of_laws(GString *text, const json_t *json);
char *bundle_words_end(const struct catalogue_case *entry, GString *text);

/* Makes <folder>/<case>, *home (g_free). MPM_BAD_INPUT: it is there, and neither empty nor a bundle
 * of the case; MPM_ENVIRONMENT_FAILED: it cannot be made. */
enum mpm_status bundle_home(const struct catalogue_case *entry, const char *folder, char **home,
                            struct mpm_error *error);

/* Writes problem.md, then problem.json. */
enum mpm_status bundle_describe(const char *home, const char *words, const json_t *json,
                                struct mpm_error *error);

#endif
