/* A scene's YAML as a tree that knows where each value comes from.
 *
 * libyaml parses; the tree is built from its events, because aliases, tags and the
 * lines of keys are gone in its document. `--set` edits the tree, the checks walk it,
 * and what is left goes to libcyaml as text.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_IO_SCENE_TREE_H
#define MPM_IO_SCENE_TREE_H

#include "model/scene.h"

enum { MPM_TREE_DEPTH_MAX = 64, MPM_EXCERPT_SIZE = 80 };

/* Where a value stands: a line of the file, the n-th --set, or the schema's default. */
enum { MPM_FROM_FILE = 0, MPM_FROM_DEFAULT = -1 };
struct mpm_origin {
    int setting; /* MPM_FROM_FILE, MPM_FROM_DEFAULT, or 1-based index of a --set */
    int line;    /* 1-based line of the file; 0 if it is from elsewhere */
};

enum mpm_tree_kind { MPM_TREE_SCALAR, MPM_TREE_LIST, MPM_TREE_MAPPING };

struct mpm_tree_node;

struct mpm_tree_entry {
    char *key; /* NULL in lists */
    struct mpm_tree_node *value;
};

struct mpm_tree_node {
    enum mpm_tree_kind kind;
    struct mpm_origin origin; /* of the key, for a value in a mapping */
    bool quoted;              /* scalar in quotes or block style: never a number */
    char *text;               /* scalar */
    struct mpm_tree_entry *entries;
    size_t count, capacity;
};

/* Parses one YAML document. `origin.setting` marks all nodes; with MPM_FROM_FILE they get
 * their lines. Refuses, with position: what is no UTF-8 or YAML, an empty text, a second
 * document, aliases, anchors, tags, keys that are no scalars or stand twice, nesting past
 * MPM_TREE_DEPTH_MAX. O(length log length). On failure *root is NULL. */
enum mpm_status mpm_tree_parse(const struct mpm_scene *scene, struct mpm_origin origin,
                               const char *bytes, size_t length, struct mpm_tree_node **root,
                               struct mpm_error *error);
void mpm_tree_free(struct mpm_tree_node *node);

/* An empty list or mapping; NULL without memory. */
struct mpm_tree_node *mpm_tree_new(enum mpm_tree_kind kind, struct mpm_origin origin);

/* Takes `value` over, also on failure; copies `key` (NULL for a list). False without memory. */
bool mpm_tree_append(struct mpm_tree_node *parent, const char *key, struct mpm_tree_node *value);

/* The entry of a mapping, or NULL. */
struct mpm_tree_entry *mpm_tree_entry(const struct mpm_tree_node *mapping, const char *key);

/* The node at a path of keys and positions ("bodies.0.region"), or NULL. With `nearest`
 * not NULL also the deepest node on the way. */
const struct mpm_tree_node *mpm_tree_find(const struct mpm_tree_node *root, const char *path,
                                          const struct mpm_tree_node **nearest);

/* MPM_BAD_INPUT "path:line: key: message" or "path: --set TEXT: key: message". An empty
 * key is left out. */
enum mpm_status mpm_tree_fault(struct mpm_error *error, const struct mpm_scene *scene,
                               struct mpm_origin origin, const char *key, const char *format, ...)
    __attribute__((format(printf, 5, 6)));

/* A value for messages, in quotes, cut to the buffer at whole characters. */
const char *mpm_excerpt(const char *text, char buffer[MPM_EXCERPT_SIZE]);

/* The same for a node: lists and mappings are named, not quoted. */
const char *mpm_tree_excerpt(const struct mpm_tree_node *node, char buffer[MPM_EXCERPT_SIZE]);

#endif
