/* One run of a measuring program: the inner side of programs.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_SUITE_MEASUREMENT_H
#define VERIFICATION_SUITE_MEASUREMENT_H

#include "verification/cases/catalogue.h"

struct measurement_setup {
    const struct catalogue_case *entry;
    const struct case_variant *variant;
    const char *data_folder; /* for data-<variant>-<name>.dat */
    struct mpm_simulation_options simulation;
    int rows;               /* file descriptor that the rows are written to */
    const char *unfinished; /* measurement_unfinished(); may be NULL */
};

/* Runs the program of the case for the variant and writes its rows. A failure's message
 * is a row as well. */
enum mpm_status measurement_run(const struct measurement_setup *setup, struct mpm_error *error);

#endif
