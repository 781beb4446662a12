/* A YAML file as JSON.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/common/scene_json.h"

#include "verification/common/failure.h"
#include "verification/common/rows.h"

#include <math.h>
#include <string.h>

static json_t *scalar_json(const struct mpm_tree_node *node)
{
    const char *text = node->text;
    double number;
    if (!node->quoted) {
        if (strcmp(text, "true") == 0 || strcmp(text, "false") == 0)
            return json_boolean(*text == 't');
        if (row_number(text, &number) && isfinite(number))
            return floor(number) < number || fabs(number) > 1e15 ? json_real(number)
                                                                 : json_integer((json_int_t)number);
    }
    return json_string(text);
}

/* NOLINTNEXTLINE(misc-no-recursion): the file nests a few levels */
json_t *scene_json_of(const struct mpm_tree_node *node)
{
    if (node->kind == MPM_TREE_SCALAR)
        return scalar_json(node);
    json_t *json = node->kind == MPM_TREE_LIST ? json_array() : json_object();
    for (size_t i = 0; i < node->count; i++)
        if (node->kind == MPM_TREE_LIST)
            json_array_append_new(json, scene_json_of(node->entries[i].value));
        else
            json_object_set_new(json, node->entries[i].key, scene_json_of(node->entries[i].value));
    return json;
}

enum mpm_status scene_json_read(const char *path, json_t **json, struct mpm_error *error)
{
    struct mpm_tree_node *root;
    *json = NULL;
    TRY(mpm_tree_read(path, &root, error));
    *json = scene_json_of(root);
    mpm_tree_free(root);
    if (json_is_object(*json))
        return MPM_OK;
    json_decref(*json);
    *json = NULL;
    return failure_set(error, MPM_BAD_INPUT, "%s: is no YAML of keys and values", path);
}
