/* Exact solutions as the references of bundles.
 *
 * A reference is one entry of the list in references.c: its name, the parameters that it takes (of
 * the bundle, or else of the case), the columns that it has, and their values at a material point.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_SCORE_REFERENCES_H
#define VERIFICATION_SCORE_REFERENCES_H

#include "verification/cases/catalogue.h"
#include "verification/exact/manufactured/manufactured.h"
#include "verification/score/columns.h"

enum { REFERENCE_NUMBERS = 8 };

struct reference;

/* A reference with its parameters. */
struct reference_problem {
    const struct reference *reference;
    double number[REFERENCE_NUMBERS];         /* in the order of `parameters` */
    struct manufactured_problem manufactured; /* of that reference alone */
};

struct reference {
    const char *name;
    const char *parameters[REFERENCE_NUMBERS]; /* NULL ends them */
    enum score_column columns[SCORE_COLUMNS];  /* SCORE_TIME ends them */
    /* What more there is to open; may be NULL. */
    enum mpm_status (*open)(struct reference_problem *problem, const struct catalogue_case *entry,
                            struct mpm_error *error);
    /* Sets values[column] for the columns above. */
    void (*evaluate)(const struct reference_problem *problem, const double place[2], double time,
                     double values[SCORE_COLUMNS]);
};

/* The reference that the case's bundle names. MPM_BAD_INPUT: there is none of that name, or a
 * parameter is missing or no number. */
enum mpm_status reference_open(const struct catalogue_case *entry,
                               struct reference_problem *problem, struct mpm_error *error);

bool reference_has(const struct reference *reference, enum score_column column);

/* A parameter of the bundle, or else of the case; NULL if it is in neither. */
const char *reference_parameter(const struct catalogue_case *entry, const char *name);

extern const struct reference reference_manufactured;

#endif
