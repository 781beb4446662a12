/* Failures of the suite: the status and error of the public interface, filled and
 * passed up the same way as in the solver.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_COMMON_FAILURE_H
#define VERIFICATION_COMMON_FAILURE_H

#include "mpm.h"

/* Fills *error (if not NULL) with a printf-style message of one line (control
 * characters become '?'), returns `status`. */
enum mpm_status failure_set(struct mpm_error *error, enum mpm_status status, const char *format,
                            ...) __attribute__((format(printf, 3, 4)));

/* Passes a failure up to the caller. */
#define TRY(call)                                                                                  \
    do {                                                                                           \
        const enum mpm_status try_status_ = (call);                                                \
        if (try_status_ != MPM_OK)                                                                 \
            return try_status_;                                                                    \
    } while (0)

#endif
