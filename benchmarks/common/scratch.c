/* Folders for results that nobody keeps.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "benchmarks/common/scratch.h"

#include "verification/common/failure.h"

#include <glib.h>
#include <glib/gstdio.h>

enum mpm_status scratch_create(char **path, struct mpm_error *error)
{
    GError *failure = NULL;
    *path = g_dir_make_tmp("mpm-bench-XXXXXX", &failure);
    if (*path != NULL)
        return MPM_OK;
    (void)failure_set(error, MPM_ENVIRONMENT_FAILED, "no temporary folder: %s", failure->message);
    g_error_free(failure);
    return MPM_ENVIRONMENT_FAILED;
}

/* Depth is that of what the programs write: two or three. */
static void remove_all(const char *path) /* NOLINT(misc-no-recursion) */
{
    const bool folder =
        g_file_test(path, G_FILE_TEST_IS_DIR) && !g_file_test(path, G_FILE_TEST_IS_SYMLINK);
    GDir *directory = folder ? g_dir_open(path, 0, NULL) : NULL;
    for (const char *name; directory != NULL && (name = g_dir_read_name(directory)) != NULL;) {
        char *entry = g_build_filename(path, name, NULL);
        remove_all(entry);
        g_free(entry);
    }
    if (directory != NULL)
        g_dir_close(directory);
    (void)g_remove(path);
}

void scratch_remove(char *path)
{
    if (path != NULL)
        remove_all(path);
    g_free(path);
}
