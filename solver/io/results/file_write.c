/* Writing bytes to an open file, all or an error.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/results/file_write.h"

#include <errno.h>
#include <unistd.h>

int mpm_file_write_at(int file, const void *data, size_t size, off_t offset)
{
    const char *bytes = data;
    while (size > 0) {
        const ssize_t written = pwrite(file, bytes, size, offset);
        if (written < 0 && errno == EINTR)
            continue;
        if (written <= 0)
            return written < 0 ? errno : ENOSPC;
        bytes += written;
        size -= (size_t)written;
        offset += written;
    }
    return 0;
}
