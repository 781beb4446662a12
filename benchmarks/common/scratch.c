/* Folders for results that nobody keeps.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "benchmarks/common/scratch.h"

#include "mpm_file.h"
#include "verification/common/failure.h"

#include <errno.h>
#include <glib.h>

enum mpm_status scratch_create(char **path, struct mpm_error *error)
{
    *path = g_build_filename(g_get_tmp_dir(), "mpm-bench-XXXXXX", NULL);
    if (mpm_folder_make_new(*path) == 0)
        return MPM_OK;
    (void)failure_set(error, MPM_ENVIRONMENT_FAILED, "%s: cannot be made: %s", *path,
                      g_strerror(errno));
    g_free(*path);
    *path = NULL;
    return MPM_ENVIRONMENT_FAILED;
}

void scratch_remove(char *path)
{
    if (path != NULL)
        (void)mpm_folder_remove_all(path, NULL);
    g_free(path);
}
