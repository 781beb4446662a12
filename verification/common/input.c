/* Files that are read.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/common/input.h"

#include "verification/common/failure.h"

#include <errno.h>

enum mpm_status input_text(const char *path, const char *allowed, char **text, size_t *length,
                           struct mpm_error *error)
{
    *text = mpm_file_load(path, length);
    return *text != NULL ? MPM_OK : mpm_file_unread(path, errno, allowed, error);
}

enum mpm_status input_json(const char *path, size_t flags, json_t **json, struct mpm_error *error)
{
    char *text;
    size_t length;
    json_error_t fault;
    *json = NULL;
    TRY(input_text(path, NULL, &text, &length, error));
    *json = json_loadb(text, length, flags, &fault);
    g_free(text);
    return *json != NULL ? MPM_OK
                         : failure_set(error, MPM_BAD_INPUT, "%s:%d: %s", path, MAX(fault.line, 0),
                                       fault.text);
}

enum mpm_status input_kind(const char *path, enum mpm_path *kind, struct mpm_error *error)
{
    *kind = mpm_path_kind(path);
    return *kind != MPM_PATH_UNKNOWN ? MPM_OK : mpm_file_unread(path, errno, NULL, error);
}

enum mpm_status input_names(const char *folder, GPtrArray **names, struct mpm_error *error)
{
    char **const list = mpm_folder_list(folder);
    *names = NULL;
    if (list == NULL)
        return mpm_file_unread(folder, errno, NULL, error);
    *names = g_ptr_array_new_with_free_func(g_free);
    for (char **name = list; *name != NULL; name++)
        g_ptr_array_add(*names, g_strdup(*name));
    mpm_folder_list_free(list);
    return MPM_OK;
}
