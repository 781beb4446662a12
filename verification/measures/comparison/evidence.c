/* What a check rests on.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/measures/comparison/evidence.h"

const char *evidence_name(enum case_evidence evidence)
{
    static const char *const names[EVIDENCE_COUNT] = {
        [EVIDENCE_NOT_STATED] = "",
        [EVIDENCE_QUADRATURE] = "quadrature",
        [EVIDENCE_EXACT] = "exact",
        [EVIDENCE_MANUFACTURED] = "manufactured",
        [EVIDENCE_INVARIANT] = "invariant",
        [EVIDENCE_CROSS_VARIANT] = "cross-variant",
        [EVIDENCE_REFERENCE_DATA] = "reference-data",
    };
    return names[evidence];
}
