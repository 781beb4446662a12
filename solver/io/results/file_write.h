/* Writing files, all or an error.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_IO_FILE_WRITE_H
#define MPM_IO_FILE_WRITE_H

#include "base/status.h"

#include <jansson.h>
#include <sys/types.h>

/* Ending of a file that is being written; a complete one loses it by a rename. */
#define MPM_PARTIAL_SUFFIX ".partial"

/* Writes `size` bytes at `offset` in as many calls as it takes. Returns 0 or the
 * errno of the call that failed; some of the bytes may then have been written. */
int mpm_file_write_at(int file, const void *data, size_t size, off_t offset);

/* MPM_ENVIRONMENT_FAILED: "<path>: cannot be written: <the system's reason>". */
enum mpm_status mpm_file_failed(const char *path, int error_number, struct mpm_error *error);

/* Brings the names of a folder to the disk. */
enum mpm_status mpm_folder_sync(const char *folder, struct mpm_error *error);

/* Writes the file `name` of a folder, whole or not at all, and syncs it: JSON, or NULL for one that
 * there was no memory for. MPM_ENVIRONMENT_FAILED names the file and the reason. */
enum mpm_status mpm_file_write_json(const char *folder, const char *name, const json_t *root,
                                    size_t indent, struct mpm_error *error);

#endif
