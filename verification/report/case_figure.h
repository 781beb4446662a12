/* The figures of a case.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_REPORT_CASE_FIGURE_H
#define VERIFICATION_REPORT_CASE_FIGURE_H

#include "verification/common/record.h"
#include "verification/pages/figure.h"

/* Draws <folder>/cases/<case>/figure-<name>.svg from the data files beside it. `entry`
 * and `figure` are objects of the run's record. */
struct figure_result figure_draw(const char *folder, const json_t *run, const json_t *entry,
                                 const json_t *figure);

#endif
