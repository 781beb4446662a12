/* Status and error idiom: functions that can fail return a status and fill the
 * caller's error; MPM_TRY passes a failure up.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_BASE_STATUS_H
#define MPM_BASE_STATUS_H

#include "mpm.h"

/* Fills *error (if not NULL) with a printf-style message, returns `status`.
 * Control characters in the text become '?', so that a message is one line. */
enum mpm_status mpm_error_set(struct mpm_error *error, enum mpm_status status, const char *format,
                              ...) __attribute__((format(printf, 3, 4)));

/* The same for MPM_RUN_FAILED with its cause. */
enum mpm_status mpm_error_fail(struct mpm_error *error, enum mpm_cause cause, const char *format,
                               ...) __attribute__((format(printf, 3, 4)));

/* Puts the cause in words, step and time in front of the message of a run that failed. */
void mpm_error_locate(struct mpm_error *error, uint64_t step, double time);

/* "out of memory: N bytes for WHAT" */
enum mpm_status mpm_error_memory(struct mpm_error *error, size_t bytes, const char *what);

#define MPM_TRY(call)                                                                              \
    do {                                                                                           \
        const enum mpm_status mpm_try_status_ = (call);                                            \
        if (mpm_try_status_ != MPM_OK)                                                             \
            return mpm_try_status_;                                                                \
    } while (0)

#endif
