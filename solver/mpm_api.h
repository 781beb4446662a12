/* What each public header has at its start and its end, and the version of the interface. The
 * makefile takes the version from here; programs, library, touchstone.pc and documents have this
 * one.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_API_H
#define MPM_API_H

/* Until 1.0.0, programs have to be compiled again for another MINOR: the shared library's name
 * changes with it (libmpm.so.0.2). PATCH changes no declaration. */
#define MPM_VERSION_MAJOR 0
#define MPM_VERSION_MINOR 2
#define MPM_VERSION_PATCH 0
/* One number that grows, for `#if MPM_VERSION >= MPM_VERSION_NUMBER(0, 2, 0)`. */
#define MPM_VERSION_NUMBER(major, minor, patch) ((major)*10000 + (minor)*100 + (patch))
#define MPM_VERSION                             MPM_VERSION_NUMBER(MPM_VERSION_MAJOR, MPM_VERSION_MINOR, MPM_VERSION_PATCH)

/* Around all declarations of a public header: names of C in C++, and the only symbols that the
 * shared library shows. */
#ifdef __cplusplus
#define MPM_API_LINKAGE_BEGIN extern "C" {
#define MPM_API_LINKAGE_END   }
#else
#define MPM_API_LINKAGE_BEGIN
#define MPM_API_LINKAGE_END
#endif
/* clang-format off */
#define MPM_API_BEGIN _Pragma("GCC visibility push(default)") MPM_API_LINKAGE_BEGIN
#define MPM_API_END   MPM_API_LINKAGE_END _Pragma("GCC visibility pop")
/* clang-format on */

#endif
