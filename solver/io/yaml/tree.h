/* Trees of YAML: parsing, editing, checking, messages.
 *
 * libyaml parses; the tree is built from its events, because aliases, tags and the
 * lines of keys are gone in its document. `--set` edits the tree, and the checks walk it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_IO_YAML_TREE_H
#define MPM_IO_YAML_TREE_H

#include "mpm_yaml.h"

enum { MPM_EXCERPT_SIZE = 80, MPM_SOURCE_SIZE_MAX = 16 * 1024 * 1024 };

/* What messages call the places of values by. */
struct mpm_source {
    const char *path, *what;     /* "scene file" */
    const char *const *settings; /* texts of --set; NULL if there are none */
};

struct mpm_bytes {
    char *data;
    size_t length;
};

/* Reads all of a file, or of standard input for the path "-"; the caller frees bytes->data, also on
 * failure. */
enum mpm_status mpm_source_read(const struct mpm_source *source, struct mpm_bytes *bytes,
                                struct mpm_error *error);

/* Parses one YAML document, as mpm_tree_read says. `origin.setting` marks all nodes; with
 * MPM_FROM_FILE they get their lines. */
enum mpm_status mpm_tree_parse(const struct mpm_source *source, struct mpm_origin origin,
                               const char *bytes, size_t length, struct mpm_tree_node **root,
                               struct mpm_error *error);

/* An empty list or mapping; NULL without memory. */
struct mpm_tree_node *mpm_tree_new(enum mpm_tree_kind kind, struct mpm_origin origin);

/* Takes `value` over, also on failure; copies `key` (NULL for a list). False without memory. */
bool mpm_tree_append(struct mpm_tree_node *parent, const char *key, struct mpm_tree_node *value);

/* Takes away and frees the entry with that value. */
void mpm_tree_remove(struct mpm_tree_node *parent, const struct mpm_tree_node *value);

/* The entry of a mapping, or NULL. */
struct mpm_tree_entry *mpm_tree_entry(const struct mpm_tree_node *mapping, const char *key);

/* MPM_BAD_INPUT "path:line: key: message" or "path: --set TEXT: key: message". An empty
 * key is left out. */
enum mpm_status mpm_tree_fault(struct mpm_error *error, const struct mpm_source *source,
                               struct mpm_origin origin, const char *key, const char *format, ...)
    __attribute__((format(printf, 5, 6)));

/* Whether to go on after `status`: a mistake of the input is added to `faults`, and MPM_OK is
 * returned; any other failure is returned. */
enum mpm_status mpm_faults_note(struct mpm_faults *faults, enum mpm_status status,
                                const struct mpm_error *error);
/* What comes of it in the end: the first mistake, if there is one. */
enum mpm_status mpm_faults_status(const struct mpm_faults *faults, struct mpm_error *error);

/* A value for messages, in quotes, cut to the buffer at whole characters. */
const char *mpm_excerpt(const char *text, char buffer[MPM_EXCERPT_SIZE]);

/* The same for a node: lists and mappings are named, not quoted. */
const char *mpm_tree_excerpt(const struct mpm_tree_node *node, char buffer[MPM_EXCERPT_SIZE]);

#endif
