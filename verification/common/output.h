/* Files of results, written whole or not at all.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_COMMON_OUTPUT_H
#define VERIFICATION_COMMON_OUTPUT_H

#include "verification/common/failure.h"

/* Writes <folder>/<name> through a temporary file, synced and renamed. */
enum mpm_status output_write(const char *folder, const char *name, const char *text,
                             struct mpm_error *error);

#endif
