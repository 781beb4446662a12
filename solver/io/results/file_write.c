/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/results/file_write.h"

#include "mpm_file.h"

#include <errno.h>
#include <glib.h>
#include <stdlib.h>
#include <string.h>

enum mpm_status mpm_file_write_json(const char *folder, const char *name, const json_t *root,
                                    size_t indent, struct mpm_error *error)
{
    char *text = root != NULL ? json_dumps(root, JSON_INDENT(indent)) : NULL;
    if (text == NULL)
        return mpm_error_memory(error, 0, name);
    char *path = g_build_filename(folder, name, NULL);
    const enum mpm_status status =
        mpm_file_save(path, text, strlen(text)) == 0 ? MPM_OK : mpm_file_failed(path, errno, error);
    g_free(path);
    free(text);
    return status;
}
