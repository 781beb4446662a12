/* A YAML file as JSON.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_COMMON_SCENE_JSON_H
#define VERIFICATION_COMMON_SCENE_JSON_H

#include "mpm_yaml.h"

#include <jansson.h>

/* A tree: mappings as objects, lists as arrays, plain numbers and true and false as such, all else
 * as text. json_decref. */
json_t *scene_json_of(const struct mpm_tree_node *node);

/* The same of a whole file, an object. MPM_BAD_INPUT if it cannot be read. */
enum mpm_status scene_json_read(const char *path, json_t **json, struct mpm_error *error);

#endif
