/* Tables of keys: checks of a tree, structs from it, and words for messages and lists.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_IO_YAML_KEYS_H
#define MPM_IO_YAML_KEYS_H

#include "io/yaml/tree.h"
#include "mpm_words.h"

enum {
    MPM_TITLE_LENGTH_MAX = 4096,
    MPM_NAME_LENGTH_MAX = 64, /* characters */
    MPM_ALLOWED_SIZE = 512,
};

/* Checks a tree against the table, or a value against its key, and fills in the defaults.
 * MPM_BAD_INPUT with the place of the key, the first of all in `faults`: keys that are unknown,
 * missing or of another geometry, values of another kind or out of range. */
enum mpm_status mpm_tree_check(const struct mpm_source *source, const struct mpm_key *root,
                               struct mpm_tree_node *tree, struct mpm_faults *faults,
                               struct mpm_error *error);

/* The default of a key as a tree. */
enum mpm_status mpm_tree_default(const struct mpm_source *source, const struct mpm_key *key,
                                 struct mpm_tree_node **value, struct mpm_error *error);

/* A struct of root->size bytes from a checked tree, for mpm_keys_free; texts are copies. NULL
 * without memory. */
void *mpm_keys_fill(const struct mpm_key *root, const struct mpm_tree_node *tree);

/* The key of that name in a group or a list's entries, or NULL. */
const struct mpm_key *mpm_key_find(const struct mpm_key *group, const char *name);

/* The choice of that name, or NULL. */
const struct mpm_choice *mpm_key_choice(const struct mpm_key *key, const char *name);

/* The name of the key of a group that a word is near to, or NULL. */
const char *mpm_key_nearest(const struct mpm_key *group, const char *word);

/* "; did you mean NAME?" of the keys of a group, or of the names that a key's value may be; ""
 * where none is near. */
const char *mpm_key_hint(const struct mpm_key *group, const char *word, char hint[MPM_HINT_SIZE]);
const char *mpm_choice_hint(const struct mpm_key *key, const char *word, char hint[MPM_HINT_SIZE]);

/* What an entry of a list is: a GROUP of a LIST, a PAIR of POINTS, ONE value of the others. */
struct mpm_key mpm_key_entry(const struct mpm_key *list);

/* "2 numbers", "choice", "list": the column `type` of `mpm schema`. */
const char *mpm_key_type(const struct mpm_key *key);

/* "above 0", "classic | ugimp | cpdi", "" if anything goes: the column `range`. */
const char *mpm_key_range(const struct mpm_key *key, char buffer[MPM_ALLOWED_SIZE]);

/* Both in one phrase, for messages: "2 numbers above 0". */
const char *mpm_key_allowed(const struct mpm_key *key, char buffer[MPM_ALLOWED_SIZE]);

/* "a, b, c": the names of a group's keys. */
const char *mpm_key_children(const struct mpm_key *group, char buffer[MPM_ALLOWED_SIZE]);

bool mpm_range_holds(const struct mpm_range *range, double value);

/* Is the scalar YAML's null: nothing, ~ or null without quotes? */
bool mpm_tree_is_null(const struct mpm_tree_node *scalar);

#endif
