/* Open files: calls that a signal interrupts are made again, parts are put together.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/files/calls.h"
#include "mpm_file.h"

#include <errno.h>
#include <fcntl.h>

int mpm_file_open(const char *path, int flags)
{
    int file;
    do {
        file = system_open(path, flags | O_CLOEXEC, 0666);
    } while (file < 0 && errno == EINTR);
    return file;
}

/* Linux closes what a signal interrupts; to close it again could take another file's number. */
int mpm_file_close(int file)
{
    return system_close(file) == 0 || errno == EINTR ? 0 : -1;
}

int mpm_file_facts(int file, struct stat *facts)
{
    return system_fstat(file, facts);
}

/* At `offset`, or where the file is if that is below 0. */
static ssize_t read_part(int file, char *data, size_t size, off_t offset)
{
    ssize_t got;
    do {
        got = offset < 0 ? system_read(file, data, size) : system_pread(file, data, size, offset);
    } while (got < 0 && errno == EINTR);
    return got;
}

static ssize_t write_part(int file, const char *data, size_t size, off_t offset)
{
    ssize_t put;
    do {
        put = offset < 0 ? system_write(file, data, size) : system_pwrite(file, data, size, offset);
    } while (put < 0 && errno == EINTR);
    if (put == 0) /* a disk that takes nothing and gives no reason */
        errno = ENOSPC;
    return put;
}

static ssize_t read_all(int file, char *data, size_t size, off_t offset)
{
    size_t done = 0;
    while (done < size) {
        const ssize_t got =
            read_part(file, data + done, size - done, offset < 0 ? offset : offset + (off_t)done);
        if (got < 0)
            return -1;
        if (got == 0)
            break;
        done += (size_t)got;
    }
    return (ssize_t)done;
}

static int write_all(int file, const char *data, size_t size, off_t offset)
{
    size_t done = 0;
    while (done < size) {
        const ssize_t put =
            write_part(file, data + done, size - done, offset < 0 ? offset : offset + (off_t)done);
        if (put <= 0)
            return -1;
        done += (size_t)put;
    }
    return 0;
}

ssize_t mpm_file_read(int file, void *data, size_t size)
{
    return read_all(file, data, size, -1);
}

ssize_t mpm_file_read_at(int file, void *data, size_t size, off_t offset)
{
    return read_all(file, data, size, offset);
}

int mpm_file_write(int file, const void *data, size_t size)
{
    return write_all(file, data, size, -1);
}

int mpm_file_write_at(int file, const void *data, size_t size, off_t offset)
{
    return write_all(file, data, size, offset);
}

int mpm_file_cut(int file, off_t size)
{
    int failed;
    do {
        failed = system_ftruncate(file, size);
    } while (failed != 0 && errno == EINTR);
    return failed;
}

int mpm_file_sync(int file)
{
    int failed;
    do {
        failed = system_fsync(file);
    } while (failed != 0 && errno == EINTR);
    return failed;
}

/* -------------------------------------------------------------------- locks */

static int close_failed(int file)
{
    const int reason = errno;
    (void)system_close(file);
    errno = reason;
    return -1;
}

/* Is the open file still the one of that name? 1, 0, or below 0. */
static int has_name(int file, const char *path)
{
    struct stat opened, named;
    if (system_fstat(file, &opened) != 0)
        return -1;
    if (system_stat(path, &named) != 0)
        return errno == ENOENT ? 0 : -1;
    return opened.st_ino == named.st_ino && opened.st_dev == named.st_dev;
}

/* Who had the lock before may have renamed or removed the file since it was opened here. */
int mpm_file_open_locked(const char *path, bool wait)
{
    for (;;) {
        const int file = mpm_file_open(path, O_RDWR | O_CREAT);
        if (file < 0)
            return -1;
        int failed;
        do {
            failed = system_flock(file, wait ? LOCK_EX : LOCK_EX | LOCK_NB);
        } while (failed != 0 && errno == EINTR);
        const int named = failed != 0 ? -1 : has_name(file, path);
        if (named > 0)
            return file;
        if (named < 0)
            return close_failed(file);
        (void)system_close(file);
    }
}

int mpm_file_lock(int file)
{
    struct flock whole = {.l_type = F_WRLCK, .l_whence = SEEK_SET};
    int failed;
    do {
        failed = system_fcntl_lock(file, &whole);
    } while (failed != 0 && errno == EINTR);
    return failed;
}
