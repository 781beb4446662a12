/* Quantities that programs measure and nothing checks.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_SUITE_UNCHECKED_H
#define VERIFICATION_SUITE_UNCHECKED_H

#include "verification/suite/plan.h"

#include <jansson.h>

/* Texts "PROGRAM QUANTITY", sorted, each once, of what the jobs of the plan measured (lines of
 * measurements.jsonl) and no case of the catalogue that runs that program checks or has as a column
 * of a comparison. Numbered quantities (`order_last_2`, `range_1`) count as one: a check of
 * any of them is one of all. Release with g_ptr_array_unref. */
GPtrArray *unchecked_quantities(const struct catalogue *catalogue, const struct plan *plan,
                                const json_t *measurements);

#endif
