/* The calls of the system that concern files, for solver/io/files/ alone: they themselves, or, in a
 * build with MPM_FAULTS, those that may fail on purpose.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_IO_FILES_CALLS_H
#define MPM_IO_FILES_CALLS_H

#include <dirent.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/types.h>
#include <unistd.h>

#ifndef MPM_FAULTS

/* NOLINTBEGIN(readability-identifier-naming) */
#define system_open                   open
#define system_close                  close
#define system_fstat                  fstat
#define system_read                   read
#define system_pread                  pread
#define system_write                  write
#define system_pwrite                 pwrite
#define system_ftruncate              ftruncate
#define system_fsync                  fsync
#define system_flock                  flock
#define system_fcntl_lock(file, lock) fcntl(file, F_SETLK, lock)
#define system_stat                   stat
#define system_lstat                  lstat
#define system_access                 access
#define system_rename                 rename
#define system_symlink                symlink
#define system_unlink                 unlink
#define system_mkdir                  mkdir
#define system_mkdtemp                mkdtemp
#define system_rmdir                  rmdir
#define system_opendir                opendir
#define system_readdir                readdir
/* NOLINTEND(readability-identifier-naming) */

#else

int system_open(const char *path, int flags, mode_t mode);
int system_close(int file);
int system_fstat(int file, struct stat *facts);
ssize_t system_read(int file, void *data, size_t size);
ssize_t system_pread(int file, void *data, size_t size, off_t offset);
ssize_t system_write(int file, const void *data, size_t size);
ssize_t system_pwrite(int file, const void *data, size_t size, off_t offset);
int system_ftruncate(int file, off_t size);
int system_fsync(int file);
int system_flock(int file, int operation);
int system_fcntl_lock(int file, struct flock *lock);
int system_stat(const char *path, struct stat *facts);
int system_lstat(const char *path, struct stat *facts);
int system_access(const char *path, int rights);
int system_rename(const char *from, const char *to);
int system_symlink(const char *target, const char *path);
int system_unlink(const char *path);
int system_mkdir(const char *path, mode_t mode);
char *system_mkdtemp(char *path);
int system_rmdir(const char *path);
DIR *system_opendir(const char *path);
struct dirent *system_readdir(DIR *folder);

#endif

#endif
