/* Writing files, all or an error.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_IO_FILE_WRITE_H
#define MPM_IO_FILE_WRITE_H

#include "base/status.h"

#include <jansson.h>

/* Writes the file `name` of a folder, whole or not at all, and syncs it: JSON, or NULL for one that
 * there was no memory for. MPM_ENVIRONMENT_FAILED names the file and the reason. */
enum mpm_status mpm_file_write_json(const char *folder, const char *name, const json_t *root,
                                    size_t indent, struct mpm_error *error);

#endif
