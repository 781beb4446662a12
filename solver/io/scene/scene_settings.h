/* `--set PATH=VALUE`: edits of a scene's tree before it is checked.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_IO_SCENE_SETTINGS_H
#define MPM_IO_SCENE_SETTINGS_H

#include "io/yaml/tree.h"

/* Applies the source's `count` settings in order. A path is keys joined by points; entries of lists
 * are named by position (from 0) or by their `name`, and + is a new one at the end. A valid key
 * that the scene does not have is added; a path that the schema does not know, or an entry that the
 * list does not have, is MPM_BAD_INPUT, the first of all in `faults`. The value is YAML; without
 * one the key or entry is taken out. */
enum mpm_status mpm_tree_apply_settings(const struct mpm_source *source, size_t count,
                                        struct mpm_tree_node *root, struct mpm_faults *faults,
                                        struct mpm_error *error);
/* The one of that index alone. On failure, parts of its path may have been added. */
enum mpm_status mpm_tree_apply_setting(const struct mpm_source *source, size_t index,
                                       struct mpm_tree_node *root, struct mpm_error *error);

#endif
