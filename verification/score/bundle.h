/* A bundle: a case as another solver gets it.
 *
 * problem.md: the problem in words. problem.json: the same for programs; geometry, units, material,
 * bodies, conditions, criteria, and of fields the points and times of the reference and its
 * columns.
 *
 * Of fields: reference.csv, the reference at those points and times, in the layout of results;
 * body_force.csv, where the problem has one that the scene does not state: per unit mass, at the
 * same points, and four times as often. Of numbers (numbers.h): the tables that they are computed
 * from.
 *
 * All that `mpm-verify score` needs is in the bundle.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_SCORE_BUNDLE_H
#define VERIFICATION_SCORE_BUNDLE_H

#include "verification/cases/catalogue.h"
#include "verification/score/lattice.h"
#include "verification/score/table.h"

#include <jansson.h>

enum { CRITERION_COLUMNS = 5 };

struct bundle_criterion {
    struct case_check check; /* texts are the bundle's */
    enum score_column columns[CRITERION_COLUMNS];
    size_t column_count;
    enum agreement_norm norm;
};

struct bundle {
    char *folder;
    json_t *json; /* problem.json */
    char *words;  /* problem.md */
    bool numbers; /* are judged, see numbers.h, not fields; then there are but the criteria below */
    struct score_format format;
    struct lattice lattice;
    double end;
    size_t instants; /* that are scored: all but t = 0; 1 at rest */
    bool rest;
    struct bundle_criterion *criteria;
    size_t criterion_count;
    struct score_table reference; /* by instant, 0 first unless at rest, then by point */
};

/* MPM_BAD_INPUT: file, key and what is allowed. */
enum mpm_status bundle_read(const char *folder, struct bundle *bundle, struct mpm_error *error);
void bundle_close(struct bundle *bundle);

/* The time of instant k = 0 .. instants; the end at rest. */
double bundle_time(const struct bundle *bundle, size_t instant);

/* The reference of a column at one instant: a value for each point of the lattice. */
const double *bundle_reference(const struct bundle *bundle, enum score_column column,
                               size_t instant);

/* Writes the bundle of a case that has one to <folder>/<case>/. MPM_ENVIRONMENT_FAILED: cannot be
 * written; MPM_BAD_INPUT: the case's bundle names what there is not, or the folder is there
 * and holds anything but a bundle of the case. */
enum mpm_status bundle_write(const struct catalogue_case *entry, const char *folder,
                             struct mpm_error *error);

extern const char *const agreement_norm_names[AGREEMENT_NORMS];

#endif
