/* Checks a scene's tree against the schema and fills in the defaults.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_IO_SCENE_CHECK_H
#define MPM_IO_SCENE_CHECK_H

#include "io/scene/scene_schema.h"
#include "io/scene/scene_tree.h"

/* Walks the tree with the schema: unknown and missing keys, kinds of values, ranges,
 * keys of the other geometry. Then every optional key with a default is there, and every
 * integer is written in plain digits. Errors are MPM_BAD_INPUT with place and what is
 * allowed. O(nodes). */
enum mpm_status mpm_tree_check(const struct mpm_scene *scene, struct mpm_tree_node *root,
                               struct mpm_error *error);

/* The default of a key as a tree, marked MPM_FROM_DEFAULT. The key must have one. */
enum mpm_status mpm_tree_default(const struct mpm_scene *scene, const struct mpm_key *key,
                                 struct mpm_tree_node **value, struct mpm_error *error);

#endif
