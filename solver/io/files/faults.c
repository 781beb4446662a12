/* Faults on purpose, in builds with MPM_FAULTS alone: the n-th call of a program that concerns a
 * file fails, and the sequence of calls is written down. The environment has
 *
 *     MPM_FAULT_COUNTER=FD    an open file whose position counts the calls; needed for the others.
 *                             Processes that a program forks have it in common
 *     MPM_FAULT_LOG=FD        a line for each call: its number, its name, the fault or "-", the
 *                             faults that it can have, its path; tabs are between them
 *     MPM_FAULT=KIND@N        call N fails with ENOSPC, EIO or EINTR, or reads or writes half
 *                             (short); KIND@N+: all calls from N on do so that can
 *
 * A call that fails has done nothing; only one that closes a file has closed it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#define _DEFAULT_SOURCE /* NOLINT */
#ifndef MPM_FAULTS
#define MPM_FAULTS
#endif
#include "io/files/calls.h"

#include <errno.h>
#include <limits.h>
#include <string.h>

/* ------------------------------------------------------------ what can go wrong */

enum fault { NO_FAULT = 0, DISK_FULL = 1, DISK_BROKEN = 2, INTERRUPTED = 4, SHORT = 8 };

static const struct {
    const char *name;
    enum fault fault;
    int reason; /* errno */
} faults[] = {{"ENOSPC", DISK_FULL, ENOSPC},
              {"EIO", DISK_BROKEN, EIO},
              {"EINTR", INTERRUPTED, EINTR},
              {"short", SHORT, 0}};
enum { FAULT_COUNT = sizeof faults / sizeof faults[0] };

enum call {
    CALL_OPEN,
    CALL_CREATE,
    CALL_CLOSE,
    CALL_FSTAT,
    CALL_READ,
    CALL_PREAD,
    CALL_WRITE,
    CALL_PWRITE,
    CALL_FTRUNCATE,
    CALL_FSYNC,
    CALL_FLOCK,
    CALL_FCNTL,
    CALL_STAT,
    CALL_LSTAT,
    CALL_ACCESS,
    CALL_RENAME,
    CALL_SYMLINK,
    CALL_UNLINK,
    CALL_MKDIR,
    CALL_MKDTEMP,
    CALL_RMDIR,
    CALL_OPENDIR,
    CALL_READDIR
};

/* What POSIX and file systems allow. */
static const struct {
    const char *name;
    unsigned possible; /* faults */
} calls[] = {
    [CALL_OPEN] = {"open", DISK_BROKEN | INTERRUPTED},
    [CALL_CREATE] = {"create", DISK_FULL | DISK_BROKEN | INTERRUPTED},
    [CALL_CLOSE] = {"close", DISK_FULL | DISK_BROKEN | INTERRUPTED},
    [CALL_FSTAT] = {"fstat", DISK_BROKEN},
    [CALL_READ] = {"read", DISK_BROKEN | INTERRUPTED | SHORT},
    [CALL_PREAD] = {"pread", DISK_BROKEN | INTERRUPTED | SHORT},
    [CALL_WRITE] = {"write", DISK_FULL | DISK_BROKEN | INTERRUPTED | SHORT},
    [CALL_PWRITE] = {"pwrite", DISK_FULL | DISK_BROKEN | INTERRUPTED | SHORT},
    [CALL_FTRUNCATE] = {"ftruncate", DISK_FULL | DISK_BROKEN | INTERRUPTED},
    [CALL_FSYNC] = {"fsync", DISK_FULL | DISK_BROKEN | INTERRUPTED},
    [CALL_FLOCK] = {"flock", DISK_BROKEN | INTERRUPTED},
    [CALL_FCNTL] = {"fcntl", DISK_BROKEN | INTERRUPTED},
    [CALL_STAT] = {"stat", DISK_BROKEN},
    [CALL_LSTAT] = {"lstat", DISK_BROKEN},
    [CALL_ACCESS] = {"access", DISK_BROKEN},
    [CALL_RENAME] = {"rename", DISK_FULL | DISK_BROKEN},
    [CALL_SYMLINK] = {"symlink", DISK_FULL | DISK_BROKEN},
    [CALL_UNLINK] = {"unlink", DISK_BROKEN},
    [CALL_MKDIR] = {"mkdir", DISK_FULL | DISK_BROKEN},
    [CALL_MKDTEMP] = {"mkdtemp", DISK_FULL | DISK_BROKEN},
    [CALL_RMDIR] = {"rmdir", DISK_BROKEN},
    [CALL_OPENDIR] = {"opendir", DISK_BROKEN},
    [CALL_READDIR] = {"readdir", DISK_BROKEN},
};

/* ------------------------------------------------------------------ environment */

static struct {
    int read; /* yes, once */
    int counter, log;
    int kind; /* of `faults`, or below 0 */
    long from, to;
} plan = {.counter = -1, .log = -1, .kind = -1};

static int descriptor(const char *name)
{
    const char *const text = getenv(name);
    return text != NULL ? (int)strtol(text, NULL, 10) : -1;
}

static void read_plan(void)
{
    const char *const text = getenv("MPM_FAULT"), *at = text != NULL ? strchr(text, '@') : NULL;
    plan.read = 1;
    plan.counter = descriptor("MPM_FAULT_COUNTER");
    plan.log = descriptor("MPM_FAULT_LOG");
    for (int i = 0; at != NULL && i < FAULT_COUNT; i++)
        if (strncmp(text, faults[i].name, (size_t)(at - text)) == 0 &&
            strlen(faults[i].name) == (size_t)(at - text)) {
            char *end;
            plan.kind = i;
            plan.from = strtol(at + 1, &end, 10);
            plan.to = *end == '+' ? LONG_MAX : plan.from;
        }
}

/* ------------------------------------------------------------------------ calls */

static void write_line(long number, enum call call, enum fault fault, unsigned possible,
                       const char *path)
{
    char line[PATH_MAX * 2 + 256];
    const char *name = "-";
    for (int i = 0; i < FAULT_COUNT; i++)
        name = faults[i].fault == fault ? faults[i].name : name;
    int length = snprintf(line, sizeof line, "%ld\t%s\t%s\t", number, calls[call].name, name);
    for (int i = 0; i < FAULT_COUNT; i++)
        if ((possible & (unsigned)faults[i].fault) != 0)
            length += snprintf(line + length, sizeof line - (size_t)length, "%s,", faults[i].name);
    length += snprintf(line + length, sizeof line - (size_t)length, "\t%s\n", path);
    (void)!write(plan.log, line, (size_t)length);
}

/* Counts a call; returns the fault that it has, with errno set. `size`: of what it reads or
 * writes, or 2. */
static enum fault next(enum call call, const char *path, size_t size)
{
    if (!plan.read)
        read_plan();
    if (plan.counter < 0)
        return NO_FAULT;
    const int reason = errno;
    const long number = (long)lseek(plan.counter, 1, SEEK_CUR);
    const unsigned possible = calls[call].possible & (size > 1 ? ~0U : ~(unsigned)SHORT);
    enum fault fault = NO_FAULT;
    if (plan.kind >= 0 && number >= plan.from && number <= plan.to &&
        (possible & (unsigned)faults[plan.kind].fault) != 0)
        fault = faults[plan.kind].fault;
    if (plan.log >= 0)
        write_line(number, call, fault, possible, path);
    errno = fault != NO_FAULT && fault != SHORT ? faults[plan.kind].reason : reason;
    return fault;
}

static int fails(enum call call, const char *path)
{
    return next(call, path, 2) != NO_FAULT;
}

/* The call, and what it is done to, from an open file. */
static enum fault next_of_file(enum call call, int file, size_t size)
{
    char link[64], path[PATH_MAX];
    (void)snprintf(link, sizeof link, "/proc/self/fd/%d", file);
    const int reason = errno;
    const ssize_t length = readlink(link, path, sizeof path - 1);
    path[length > 0 ? length : 0] = '\0';
    errno = reason;
    return next(call, path, size);
}

static enum fault next_of_two(enum call call, const char *from, const char *to)
{
    char both[PATH_MAX * 2 + 8];
    (void)snprintf(both, sizeof both, "%s\t%s", from, to);
    return next(call, both, 2);
}

int system_open(const char *path, int flags, mode_t mode)
{
    return fails((flags & O_CREAT) != 0 ? CALL_CREATE : CALL_OPEN, path) ? -1
                                                                         : open(path, flags, mode);
}

int system_close(int file)
{
    const enum fault fault = next_of_file(CALL_CLOSE, file, 2);
    const int reason = errno;
    const int failed = close(file);
    if (fault == NO_FAULT)
        return failed;
    errno = reason;
    return -1;
}

int system_fstat(int file, struct stat *facts)
{
    return next_of_file(CALL_FSTAT, file, 2) != NO_FAULT ? -1 : fstat(file, facts);
}

ssize_t system_read(int file, void *data, size_t size)
{
    const enum fault fault = next_of_file(CALL_READ, file, size);
    if (fault != NO_FAULT && fault != SHORT)
        return -1;
    return read(file, data, fault == SHORT ? size / 2 : size);
}

ssize_t system_pread(int file, void *data, size_t size, off_t offset)
{
    const enum fault fault = next_of_file(CALL_PREAD, file, size);
    if (fault != NO_FAULT && fault != SHORT)
        return -1;
    return pread(file, data, fault == SHORT ? size / 2 : size, offset);
}

ssize_t system_write(int file, const void *data, size_t size)
{
    const enum fault fault = next_of_file(CALL_WRITE, file, size);
    if (fault != NO_FAULT && fault != SHORT)
        return -1;
    return write(file, data, fault == SHORT ? size / 2 : size);
}

ssize_t system_pwrite(int file, const void *data, size_t size, off_t offset)
{
    const enum fault fault = next_of_file(CALL_PWRITE, file, size);
    if (fault != NO_FAULT && fault != SHORT)
        return -1;
    return pwrite(file, data, fault == SHORT ? size / 2 : size, offset);
}

int system_ftruncate(int file, off_t size)
{
    return next_of_file(CALL_FTRUNCATE, file, 2) != NO_FAULT ? -1 : ftruncate(file, size);
}

int system_fsync(int file)
{
    return next_of_file(CALL_FSYNC, file, 2) != NO_FAULT ? -1 : fsync(file);
}

int system_flock(int file, int operation)
{
    return next_of_file(CALL_FLOCK, file, 2) != NO_FAULT ? -1 : flock(file, operation);
}

int system_fcntl_lock(int file, struct flock *lock)
{
    return next_of_file(CALL_FCNTL, file, 2) != NO_FAULT ? -1 : fcntl(file, F_SETLK, lock);
}

int system_stat(const char *path, struct stat *facts)
{
    return fails(CALL_STAT, path) ? -1 : stat(path, facts);
}

int system_lstat(const char *path, struct stat *facts)
{
    return fails(CALL_LSTAT, path) ? -1 : lstat(path, facts);
}

int system_access(const char *path, int rights)
{
    return fails(CALL_ACCESS, path) ? -1 : access(path, rights);
}

int system_rename(const char *from, const char *to)
{
    return next_of_two(CALL_RENAME, from, to) != NO_FAULT ? -1 : rename(from, to);
}

int system_symlink(const char *target, const char *path)
{
    return next_of_two(CALL_SYMLINK, target, path) != NO_FAULT ? -1 : symlink(target, path);
}

int system_unlink(const char *path)
{
    return fails(CALL_UNLINK, path) ? -1 : unlink(path);
}

int system_mkdir(const char *path, mode_t mode)
{
    return fails(CALL_MKDIR, path) ? -1 : mkdir(path, mode);
}

char *system_mkdtemp(char *path)
{
    return fails(CALL_MKDTEMP, path) ? NULL : mkdtemp(path);
}

int system_rmdir(const char *path)
{
    return fails(CALL_RMDIR, path) ? -1 : rmdir(path);
}

DIR *system_opendir(const char *path)
{
    return fails(CALL_OPENDIR, path) ? NULL : opendir(path);
}

struct dirent *system_readdir(DIR *folder)
{
    const int reason = errno;
    const int failed = next_of_file(CALL_READDIR, dirfd(folder), 2) != NO_FAULT;
    if (failed)
        return NULL;
    errno = reason;
    return readdir(folder);
}
