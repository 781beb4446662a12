/* Files of results.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/common/output.h"

#include "mpm_file.h"

#include <errno.h>
#include <glib.h>
#include <string.h>

enum mpm_status output_write(const char *folder, const char *name, const char *text,
                             struct mpm_error *error)
{
    char *path = g_build_filename(folder, name, NULL);
    const enum mpm_status status =
        mpm_file_save(path, text, strlen(text)) == 0 ? MPM_OK : mpm_file_failed(path, errno, error);
    g_free(path);
    return status;
}
