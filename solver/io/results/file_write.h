/* Writing bytes to an open file, all or an error.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_IO_FILE_WRITE_H
#define MPM_IO_FILE_WRITE_H

#include <stddef.h>
#include <sys/types.h>

/* Ending of a file that is being written; a complete one loses it by a rename. */
#define MPM_PARTIAL_SUFFIX ".partial"

/* Writes `size` bytes at `offset` in as many calls as it takes. Returns 0 or the
 * errno of the call that failed; some of the bytes may then have been written. */
int mpm_file_write_at(int file, const void *data, size_t size, off_t offset);

#endif
