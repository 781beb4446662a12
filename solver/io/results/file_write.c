/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/results/file_write.h"

#include <errno.h>
#include <fcntl.h>
#include <glib.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
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

enum mpm_status mpm_file_failed(const char *path, int error_number, struct mpm_error *error)
{
    return mpm_error_set(error, MPM_ENVIRONMENT_FAILED, "%s: cannot be written: %s", path,
                         g_strerror(error_number));
}

enum mpm_status mpm_folder_sync(const char *folder, struct mpm_error *error)
{
    const int file = open(folder, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    /* EINVAL: a file system whose folders need no sync */
    const int failure = file < 0 || (fsync(file) != 0 && errno != EINVAL) ? errno : 0;
    if (file >= 0)
        (void)close(file);
    return failure == 0 ? MPM_OK : mpm_file_failed(folder, failure, error);
}

/* 0 or an errno. */
static int write_synced(const char *path, const char *text)
{
    const int file = open(path, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (file < 0)
        return errno;
    int failure = mpm_file_write_at(file, text, strlen(text), 0);
    if (failure == 0 && fsync(file) != 0)
        failure = errno;
    if (close(file) != 0 && failure == 0)
        failure = errno;
    return failure;
}

enum mpm_status mpm_file_write_json(const char *folder, const char *name, const json_t *root,
                                    size_t indent, struct mpm_error *error)
{
    char *text = root != NULL ? json_dumps(root, JSON_INDENT(indent)) : NULL;
    if (text == NULL)
        return mpm_error_memory(error, 0, name);
    char *path = g_build_filename(folder, name, NULL);
    char *partial = g_strconcat(path, MPM_PARTIAL_SUFFIX, NULL);
    int failure = write_synced(partial, text);
    if (failure == 0 && rename(partial, path) != 0)
        failure = errno;
    if (failure != 0)
        (void)unlink(partial);
    const enum mpm_status status = failure == 0 ? MPM_OK : mpm_file_failed(path, failure, error);
    g_free(partial);
    g_free(path);
    free(text);
    return status;
}
