/* The pictures of a case: which run is shown, and how.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_CASES_CASE_PICTURE_H
#define VERIFICATION_CASES_CASE_PICTURE_H

#include "verification/cases/catalogue.h"

/* Rules that no schema can express: a case has pictures of its scene, or states why it has none. */
enum mpm_status case_picture_check(const char *path, const struct case_file *file,
                                   struct mpm_error *error);

/* The variant whose run is shown: the one that the case names, else its first of tier ci, else its
 * first. NULL: the case has no pictures. */
const struct case_variant *case_picture_variant(const struct case_file *file);

/* What the case states, or what stands for it; of a case with pictures. */
struct case_picture case_picture_of(const struct case_file *file);

#endif
