/* Where something is in a YAML file.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/cases/yaml_place.h"

#include "mpm_yaml.h"
#include "verification/common/failure.h"

#include <glib.h>
#include <stdarg.h>

unsigned yaml_place_line(const char *file, const char *path)
{
    struct mpm_tree_node *root;
    if (mpm_tree_read(file, &root, NULL) != MPM_OK)
        return 0;
    const struct mpm_tree_node *nearest = root;
    (void)mpm_tree_find(root, path, &nearest);
    const unsigned line = (unsigned)nearest->origin.line;
    mpm_tree_free(root);
    return line;
}

enum mpm_status yaml_refuse(const char *file, struct mpm_error *error, const char *place,
                            const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    char *text = g_strdup_vprintf(format, arguments);
    va_end(arguments);
    failure_set(error, MPM_BAD_INPUT, "%s:%u: %s: %s", file, yaml_place_line(file, place), place,
                text);
    g_free(text);
    return MPM_BAD_INPUT;
}
