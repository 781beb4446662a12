/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/status.h"

#include <stdarg.h>
#include <stdio.h>

enum mpm_status mpm_error_set(struct mpm_error *error, enum mpm_status status, const char *format,
                              ...)
{
    if (error == NULL)
        return status;
    va_list arguments;
    va_start(arguments, format);
    (void)vsnprintf(error->message, sizeof error->message, format, arguments);
    va_end(arguments);
    for (char *c = error->message; *c != '\0'; c++)
        if ((unsigned char)*c < 0x20 || *c == 0x7f)
            *c = '?';
    error->status = status;
    return status;
}

enum mpm_status mpm_error_memory(struct mpm_error *error, size_t bytes, const char *what)
{
    return mpm_error_set(error, MPM_ENVIRONMENT_FAILED, "out of memory: %zu bytes for %s", bytes,
                         what);
}
