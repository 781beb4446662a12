/* The machine's memory.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_BASE_MEMORY_H
#define MPM_BASE_MEMORY_H

#include "base/status.h"

/* Has the machine so many bytes, used or not? MPM_ENVIRONMENT_FAILED: no; the message has both
 * numbers. */
enum mpm_status mpm_memory_check(size_t bytes, struct mpm_error *error);

#endif
