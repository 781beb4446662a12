/* From a checked tree to C structs, by libcyaml.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_IO_SCENE_LOAD_H
#define MPM_IO_SCENE_LOAD_H

#include "io/scene/scene_schema.h"
#include "io/scene/scene_tree.h"

/* Writes the tree as YAML and loads it with the schema of scene_keys.h. After
 * mpm_tree_check only memory can be wanting. */
enum mpm_status mpm_raw_load(const struct mpm_scene *scene, const struct mpm_tree_node *root,
                             struct mpm_raw_scene **raw, struct mpm_error *error);
void mpm_raw_free(struct mpm_raw_scene *raw);

#endif
