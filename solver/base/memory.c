/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/memory.h"

#include <unistd.h>

enum mpm_status mpm_memory_check(size_t bytes, struct mpm_error *error)
{
    const double machine = (double)sysconf(_SC_PHYS_PAGES) * (double)sysconf(_SC_PAGESIZE);
    if ((double)bytes > machine)
        return mpm_error_set(error, MPM_ENVIRONMENT_FAILED,
                             "memory: the scene needs %.3g GB, the machine has %.3g GB",
                             (double)bytes * 1e-9, machine * 1e-9);
    return MPM_OK;
}
