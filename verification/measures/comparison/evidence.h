/* What a check rests on.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_MEASURES_EVIDENCE_H
#define VERIFICATION_MEASURES_EVIDENCE_H

/* What a check rests on: what the solver's number is compared with. */
enum case_evidence {
    EVIDENCE_NOT_STATED,
    EVIDENCE_QUADRATURE,     /* the definition, integrated numerically */
    EVIDENCE_EXACT,          /* a solution in closed form, or to all digits */
    EVIDENCE_MANUFACTURED,   /* a chosen motion with the forces that it needs */
    EVIDENCE_INVARIANT,      /* what must not change, or be the same from both sides */
    EVIDENCE_CROSS_VARIANT,  /* the solver against itself: other method, order, path */
    EVIDENCE_REFERENCE_DATA, /* numbers of a paper, or of another program */
    EVIDENCE_COUNT
};

/* The word of case.yaml and of records; "" where none is stated. */
const char *evidence_name(enum case_evidence evidence);

#endif
