/* Takes the pictures of a case while its program runs: it observes the simulations that the program
 * makes, whatever the program is.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_SUITE_PICTURE_TAKE_H
#define VERIFICATION_SUITE_PICTURE_TAKE_H

#include "verification/cases/catalogue.h"

/* The most that a file holds: particles of one state, and of all states of a motion together. More
 * are thinned out, one of n by n neighbours being drawn as large as they all. */
enum { PICTURE_PARTICLES = 3600, PICTURE_MOTION = 8000 };

struct picture_taker;

/* For the variant of a case whose run is shown; NULL for all others. */
struct picture_taker *picture_taker_new(const struct catalogue_case *entry,
                                        const struct case_variant *variant);
void picture_taker_free(struct picture_taker *taker);

/* What the options of the program's simulations are to have; NULL stays NULL. */
const struct mpm_monitor *picture_taker_monitor(const struct picture_taker *taker);

/* Name of the file, picture-<variant>.json; g_free. */
char *picture_file_name(const char *variant);

/* Writes what was taken: the scene with all its settings, the field, and the states that were
 * asked for. MPM_RUN_FAILED: the program made no such simulation, so that there is nothing to
 * show. */
enum mpm_status picture_taker_write(struct picture_taker *taker, const char *folder,
                                    struct mpm_error *error);

#endif
