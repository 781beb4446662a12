/* How much a bundle's criteria depend on the time that results are of.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_SCORE_LATENESS_H
#define VERIFICATION_SCORE_LATENESS_H

#include "verification/measures/comparison/agreement.h"
#include "verification/score/lattice.h"
#include "verification/score/references.h"

struct lateness {
    const struct reference_problem *problem;
    const struct lattice *lattice;
    double end, late;
    size_t instants;
};

/* The agreement with the reference of the reference at times that are later by `late`, over the
 * lattice and the instants. */
double lateness_agreement(const struct lateness *lateness, const enum score_column *columns,
                          size_t count, enum agreement_norm norm);

#endif
