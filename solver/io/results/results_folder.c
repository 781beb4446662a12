/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/results/results_folder.h"

#include "io/results/file_write.h"
#include "io/results/history.h"
#include "io/results/run_record.h"
#include "io/results/series.h"

#include <errno.h>
#include <glib.h>
#include <glib/gstdio.h>
#include <string.h>
#include <unistd.h>

/* particles-123456.hdf, with as many digits as it likes. */
static bool is_snapshot_name(const char *name)
{
    if (!g_str_has_prefix(name, MPM_SERIES_PREFIX))
        return false;
    const char *number = name + strlen(MPM_SERIES_PREFIX);
    const size_t digits = strspn(number, "0123456789");
    return digits > 0 && strcmp(number + digits, MPM_SERIES_SUFFIX) == 0;
}

/* Also what an interrupted run may leave: the name with MPM_PARTIAL_SUFFIX. */
static bool is_result_name(const char *name)
{
    static const char *const names[] = {MPM_RUN_RECORD_NAME, MPM_HISTORY_NAME, MPM_SERIES_LIST,
                                        "checkpoint.h5"};
    char *whole = g_strdup(name);
    if (g_str_has_suffix(whole, MPM_PARTIAL_SUFFIX))
        whole[strlen(whole) - strlen(MPM_PARTIAL_SUFFIX)] = '\0';
    bool is_result = is_snapshot_name(whole);
    for (size_t i = 0; i < G_N_ELEMENTS(names); i++)
        is_result = is_result || strcmp(whole, names[i]) == 0;
    g_free(whole);
    return is_result;
}

/* The name of a result file in the folder (g_free), or NULL. */
static char *find_result(const char *folder, GError **failure)
{
    GDir *directory = g_dir_open(folder, 0, failure);
    if (directory == NULL)
        return NULL;
    const char *name = g_dir_read_name(directory);
    while (name != NULL && !is_result_name(name))
        name = g_dir_read_name(directory);
    char *found = g_strdup(name);
    g_dir_close(directory);
    return found;
}

enum mpm_status mpm_results_folder_check(const char *folder, bool overwrite,
                                         struct mpm_error *error)
{
    if (folder[0] == '\0')
        return mpm_error_set(error, MPM_BAD_INPUT, "output: the name of the folder is empty");
    if (!g_file_test(folder, G_FILE_TEST_EXISTS))
        return MPM_OK;
    if (!g_file_test(folder, G_FILE_TEST_IS_DIR))
        return mpm_error_set(error, MPM_BAD_INPUT, "output: '%s' is a file; a folder is needed",
                             folder);
    GError *failure = NULL;
    char *name = find_result(folder, &failure);
    enum mpm_status status = MPM_OK;
    if (failure != NULL)
        status = mpm_error_set(error, MPM_ENVIRONMENT_FAILED, "output: %s", failure->message);
    else if (name != NULL && !overwrite)
        status = mpm_error_set(error, MPM_BAD_INPUT,
                               "output: '%s' holds results (%s); name another folder or allow "
                               "--overwrite",
                               folder, name);
    g_clear_error(&failure);
    g_free(name);
    return status;
}

static enum mpm_status remove_results(const char *folder, struct mpm_error *error)
{
    enum mpm_status status = MPM_OK;
    for (char *name; status == MPM_OK && (name = find_result(folder, NULL)) != NULL; g_free(name)) {
        char *path = g_build_filename(folder, name, NULL);
        if (g_unlink(path) != 0)
            status = mpm_error_set(error, MPM_ENVIRONMENT_FAILED, "%s: cannot be removed: %s", path,
                                   g_strerror(errno));
        g_free(path);
    }
    return status;
}

enum mpm_status mpm_results_folder_prepare(const char *folder, struct mpm_error *error)
{
    if (g_mkdir_with_parents(folder, 0777) != 0)
        return mpm_error_set(error, MPM_ENVIRONMENT_FAILED,
                             "output: folder '%s' cannot be made: %s", folder, g_strerror(errno));
    if (g_access(folder, W_OK | X_OK) != 0)
        return mpm_error_set(error, MPM_ENVIRONMENT_FAILED,
                             "output: folder '%s' cannot be written to: %s", folder,
                             g_strerror(errno));
    return remove_results(folder, error);
}
