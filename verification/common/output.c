/* Files of results.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/common/output.h"

#include <glib.h>

enum mpm_status output_write(const char *folder, const char *name, const char *text,
                             struct mpm_error *error)
{
    char *path = g_build_filename(folder, name, NULL);
    GError *failure = NULL;
    enum mpm_status status = MPM_OK;
    if (!g_file_set_contents_full(path, text, -1,
                                  G_FILE_SET_CONTENTS_CONSISTENT | G_FILE_SET_CONTENTS_DURABLE,
                                  0666, &failure)) {
        status = failure_set(error, MPM_ENVIRONMENT_FAILED, "%s", failure->message);
        g_error_free(failure);
    }
    g_free(path);
    return status;
}
