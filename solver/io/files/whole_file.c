/* Files that are read or written whole.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/status.h"
#include "mpm_file.h"

#include <errno.h>
#include <fcntl.h>
#include <glib.h>
#include <stdlib.h>

/* ---------------------------------------------------------------------- reading */

enum { FIRST_SIZE = 4096 };

/* Reads to the end; files of /proc state no size. */
static char *read_to_end(int file, size_t size, size_t *length)
{
    size_t room = MAX(size, FIRST_SIZE) + 1;
    char *text = NULL;
    *length = 0;
    for (;;) {
        char *const more = realloc(text, room);
        if (more == NULL)
            break;
        text = more;
        const ssize_t got = mpm_file_read(file, text + *length, room - 1 - *length);
        if (got < 0)
            break;
        *length += (size_t)got;
        if (*length < room - 1) {
            text[*length] = '\0';
            return text;
        }
        room *= 2;
    }
    const int reason = errno;
    free(text);
    errno = reason;
    return NULL;
}

char *mpm_file_load(const char *path, size_t *size)
{
    struct stat facts;
    char *text = NULL;
    size_t length = 0;
    const int file = mpm_file_open(path, O_RDONLY);
    if (file < 0)
        return NULL;
    if (mpm_file_facts(file, &facts) == 0)
        text = read_to_end(file, (size_t)MAX(facts.st_size, 0), &length);
    const int reason = errno;
    (void)mpm_file_close(file);
    errno = reason;
    if (size != NULL)
        *size = length;
    return text;
}

enum mpm_status mpm_file_unread(const char *path, int reason, const char *allowed,
                                struct mpm_error *error)
{
    static const int environment[] = {EIO, ENOMEM, EMFILE, ENFILE, ENOSPC, ENOLCK};
    enum mpm_status status = MPM_BAD_INPUT;
    for (size_t i = 0; i < G_N_ELEMENTS(environment); i++)
        status = reason == environment[i] ? MPM_ENVIRONMENT_FAILED : status;
    return mpm_error_set(error, status, "%s: cannot be read: %s%s%s", path, g_strerror(reason),
                         allowed != NULL ? ": allowed is " : "", allowed != NULL ? allowed : "");
}

/* ---------------------------------------------------------------------- writing */

/* The partial file, for this writer alone; file systems without locks have none to wait for. */
static int open_partial(const char *partial)
{
    int file = mpm_file_open_locked(partial, true);
    if (file < 0 && (errno == ENOLCK || errno == EOPNOTSUPP || errno == ENOSYS))
        file = mpm_file_open(partial, O_RDWR | O_CREAT);
    return file;
}

static int write_partial(int file, const void *data, size_t size)
{
    return mpm_file_cut(file, 0) == 0 && mpm_file_write_at(file, data, size, 0) == 0 &&
                   mpm_file_sync(file) == 0
               ? 0
               : -1;
}

/* The lock is held until the file has its name, or is gone. */
int mpm_file_save(const char *path, const void *data, size_t size)
{
    char *const partial = g_strconcat(path, MPM_PARTIAL_SUFFIX, NULL);
    const int file = open_partial(partial);
    const bool good =
        file >= 0 && write_partial(file, data, size) == 0 && mpm_path_rename(partial, path) == 0;
    const int reason = errno;
    if (file >= 0 && !good)
        (void)mpm_file_remove(partial);
    if (file >= 0)
        (void)mpm_file_close(file); /* what is synced no failure takes away */
    g_free(partial);
    errno = reason;
    return good ? 0 : -1;
}

enum mpm_status mpm_file_failed(const char *path, int reason, struct mpm_error *error)
{
    return mpm_error_set(error, MPM_ENVIRONMENT_FAILED, "%s: cannot be written: %s", path,
                         g_strerror(reason));
}
