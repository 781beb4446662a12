/* Files and folders: every call of the system that concerns one is made here, for the solver, the
 * suite and the benchmarks. A test build (`make VARIANT=faults`, tests/README.md) makes any of them
 * fail.
 *
 * As in POSIX, what returns an int is below 0 where it fails, and what returns a pointer is NULL;
 * errno has the reason, and no call that clears up afterwards changes it. A call that a signal
 * interrupts is made again; what the system reads or writes in part goes on until it is whole.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_FILE_H
#define MPM_FILE_H

#include "mpm.h"

#include <sys/stat.h>
#include <sys/types.h>

/* Ending of a file that is being written; a complete one loses it by a rename. */
#define MPM_PARTIAL_SUFFIX ".partial"

/* ------------------------------------------------------------------- open files */

/* A descriptor, closed on exec; a new file may be read and written as the umask allows. */
int mpm_file_open(const char *path, int flags);
/* The descriptor is gone, whatever the answer. */
int mpm_file_close(int file);
int mpm_file_facts(int file, struct stat *facts);

/* The number of bytes read: fewer than `size` only at the end of the file. */
ssize_t mpm_file_read(int file, void *data, size_t size);
ssize_t mpm_file_read_at(int file, void *data, size_t size, off_t offset);
/* All bytes; where it fails, some of them may have been written. */
int mpm_file_write(int file, const void *data, size_t size);
int mpm_file_write_at(int file, const void *data, size_t size, off_t offset);
int mpm_file_cut(int file, off_t size);
int mpm_file_sync(int file);

/* A descriptor with the lock on the file, which is made if it is not there: at once, errno being
 * EWOULDBLOCK where another has it, or after waiting for it. The lock ends with the descriptor,
 * and with the process. */
int mpm_file_open_locked(const char *path, bool wait);
/* A lock of the process, of fcntl: children do not have it. EAGAIN or EACCES: another has it. */
int mpm_file_lock(int file);

/* ------------------------------------------------------------------ whole files */

/* All of a file, with a zero byte after it (free, or g_free); `size` may be NULL. */
char *mpm_file_load(const char *path, size_t *size);
/* Replaces a file, whole or not at all: `path` with MPM_PARTIAL_SUFFIX is written, synced and
 * renamed. Another that saves the same file at this time waits. */
int mpm_file_save(const char *path, const void *data, size_t size);

/* "<path>: cannot be written: <reason>", with an errno: MPM_ENVIRONMENT_FAILED. */
enum mpm_status mpm_file_failed(const char *path, int reason, struct mpm_error *error);
/* "<path>: cannot be read: <reason>", and ": allowed is <allowed>" unless that is NULL.
 * MPM_ENVIRONMENT_FAILED where the system fails (disk, memory, descriptors), MPM_BAD_INPUT where
 * the name or the file is wrong. */
enum mpm_status mpm_file_unread(const char *path, int reason, const char *allowed,
                                struct mpm_error *error);

/* ------------------------------------------------------------------------ names */

/* Through links. Unknown: the system does not say, errno has the reason. */
enum mpm_path {
    MPM_PATH_UNKNOWN = -1,
    MPM_PATH_NONE,
    MPM_PATH_FILE,
    MPM_PATH_FOLDER,
    MPM_PATH_OTHER
};
enum mpm_path mpm_path_kind(const char *path);
/* Of the name itself: a link is MPM_PATH_OTHER. */
enum mpm_path mpm_path_own_kind(const char *path);
bool mpm_path_exists(const char *path);  /* so far as the system says */
bool mpm_path_is_file(const char *path); /* a regular one */
bool mpm_path_is_folder(const char *path);

/* May the process do it: R_OK, W_OK, X_OK? */
int mpm_path_access(const char *path, int rights);

int mpm_path_rename(const char *from, const char *to);
int mpm_path_link(const char *target, const char *path); /* a symbolic one */
int mpm_file_remove(const char *path);

/* Its parents included; one that is there is no failure. */
int mpm_folder_make(const char *path);
/* A new, empty folder in the system's folder for temporary files; the caller removes it
 * (mpm_folder_remove_all) and frees its path (g_free). On failure *path is NULL:
 * MPM_ENVIRONMENT_FAILED, with the path that cannot be made. */
enum mpm_status mpm_folder_make_temporary(char **path, struct mpm_error *error);
int mpm_folder_remove(const char *path); /* an empty one */
/* Brings its names to the disk. */
int mpm_folder_sync(const char *path);
/* What is in it, sorted by bytes, without . and ..; NULL at the end. */
char **mpm_folder_list(const char *path);
void mpm_folder_list_free(char **names);
/* A file, a link or a folder with all that is in it; goes on after failures, of which errno is the
 * first and `failed`, unless NULL, its path (g_free; NULL without failures). */
int mpm_folder_remove_all(const char *path, char **failed);

#endif
