/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/results/file_write.h"

#include <errno.h>
#include <glib.h>
#include <stdlib.h>
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

enum mpm_status mpm_file_write_json(const char *folder, const char *name, const json_t *root,
                                    size_t indent, struct mpm_error *error)
{
    char *text = root != NULL ? json_dumps(root, JSON_INDENT(indent)) : NULL;
    if (text == NULL)
        return mpm_error_memory(error, 0, name);
    char *path = g_build_filename(folder, name, NULL);
    GError *failure = NULL;
    enum mpm_status status = MPM_OK;
    if (!g_file_set_contents(path, text, -1, &failure))
        status = mpm_error_set(error, MPM_ENVIRONMENT_FAILED, "%s", failure->message);
    g_clear_error(&failure);
    g_free(path);
    free(text);
    return status;
}
