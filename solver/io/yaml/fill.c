/* Structs from checked trees, by their table of keys.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/status.h"
#include "io/yaml/keys.h"
#include "mpm_expression.h"

#include <stdlib.h>
#include <string.h>

/* Where the members of a struct lie. */
static void *member_of(void *data, size_t offset)
{
    return (char *)data + offset;
}

static size_t bytes_of_value(const struct mpm_key *key)
{
    static const size_t bytes[] = {[MPM_STORED_TEXT] = sizeof(char *),
                                   [MPM_STORED_INTEGER] = sizeof(int64_t),
                                   [MPM_STORED_BOOLEAN] = sizeof(bool)};
    return bytes[key->value->stored];
}

/* Bytes of what a list has in a row. */
static size_t bytes_of_entry(const struct mpm_key *list)
{
    if (list->shape == MPM_KEY_LIST)
        return list->size;
    return (list->shape == MPM_KEY_POINTS ? 2 : 1) * bytes_of_value(list);
}

/* ------------------------------------------------------------------ filling */

static bool fill(const struct mpm_key *key, const struct mpm_tree_node *node, void *data,
                 void *place);
static bool fill_members(const struct mpm_key *group, const struct mpm_tree_node *node, void *data);

static bool fill_value(const struct mpm_key *key, const struct mpm_tree_node *node, void *place)
{
    double number = 0.0;
    switch (key->value->stored) {
    case MPM_STORED_TEXT:
        *(char **)place = strdup(node->text);
        return *(char **)place != NULL;
    case MPM_STORED_INTEGER:
        (void)mpm_number_parse(node->text, &number);
        *(int64_t *)place = (int64_t)number;
        return true;
    case MPM_STORED_BOOLEAN:
        *(bool *)place = node->text[0] == 't';
        return true;
    }
    return false;
}

/* Entries in a row: of a list, or the two of a pair. */
static bool fill_row(const struct mpm_key *entry, const struct mpm_tree_node *node, size_t bytes,
                     void *first)
{
    for (size_t i = 0; i < node->count; i++) {
        void *const place = (char *)first + i * bytes;
        const struct mpm_tree_node *const value = node->entries[i].value;
        if (entry->shape == MPM_KEY_GROUP ? !fill_members(entry, value, place)
                                          : !fill(entry, value, NULL, place))
            return false;
    }
    return true;
}

static bool fill_list(const struct mpm_key *list, const struct mpm_tree_node *node, void *data,
                      void *place)
{
    if (node->count == 0)
        return true;
    const size_t bytes = bytes_of_entry(list);
    void *const first = calloc(node->count, bytes);
    if (first == NULL)
        return false;
    *(void **)place = first;
    *(unsigned *)member_of(data, list->count_offset) = (unsigned)node->count;
    const struct mpm_key entry = mpm_key_entry(list);
    return fill_row(&entry, node, bytes, first);
}

/* The members of a struct. */
static bool fill_members(const struct mpm_key *group, const struct mpm_tree_node *node, void *data)
{
    for (const struct mpm_key *key = group->children; key->name != NULL; key++) {
        const struct mpm_tree_entry *const entry = mpm_tree_entry(node, key->name);
        if (entry != NULL && !fill(key, entry->value, data, member_of(data, key->offset)))
            return false;
    }
    return true;
}

/* `place` in the struct `data`, which lists put their counts into. */
static bool fill(const struct mpm_key *key, const struct mpm_tree_node *node, void *data,
                 void *place)
{
    switch (key->shape) {
    case MPM_KEY_ONE:
        return fill_value(key, node, place);
    case MPM_KEY_PAIR: {
        const struct mpm_key entry = mpm_key_entry(key);
        return fill_row(&entry, node, bytes_of_value(key), place);
    }
    case MPM_KEY_VALUES:
    case MPM_KEY_POINTS:
    case MPM_KEY_LIST:
        return fill_list(key, node, data, place);
    case MPM_KEY_CHOICE:
        *(int *)place = mpm_key_choice(key, node->text)->value;
        return true;
    case MPM_KEY_GROUP:
        *(void **)place = calloc(1, key->size);
        return *(void **)place != NULL && fill_members(key, node, *(void **)place);
    }
    return false;
}

void *mpm_keys_fill(const struct mpm_key *root, const struct mpm_tree_node *tree)
{
    void *const data = calloc(1, root->size);
    if (data == NULL || fill_members(root, tree, data))
        return data;
    mpm_keys_free(root, data);
    return NULL;
}

/* ------------------------------------------------------------------ freeing */

static void free_members(const struct mpm_key *group, void *data);

/* What the entries in a row hold. */
static void free_row(const struct mpm_key *key, size_t count, void *first)
{
    for (size_t i = 0; i < count; i++)
        if (key->shape == MPM_KEY_LIST)
            free_members(key, (char *)first + i * key->size);
        else if (key->value->stored == MPM_STORED_TEXT)
            free(((char **)first)[i]);
}

static void free_list(const struct mpm_key *list, size_t count, void *first)
{
    free_row(list, list->shape == MPM_KEY_POINTS ? 2 * count : count, first);
    free(first);
}

static void free_key(const struct mpm_key *key, void *data, void *place)
{
    switch (key->shape) {
    case MPM_KEY_ONE:
    case MPM_KEY_PAIR:
        free_row(key, key->shape == MPM_KEY_PAIR ? 2 : 1, place);
        return;
    case MPM_KEY_VALUES:
    case MPM_KEY_POINTS:
    case MPM_KEY_LIST:
        free_list(key, *(unsigned *)member_of(data, key->count_offset), *(void **)place);
        return;
    case MPM_KEY_CHOICE:
        return;
    case MPM_KEY_GROUP:
        mpm_keys_free(key, *(void **)place);
        return;
    }
}

static void free_members(const struct mpm_key *group, void *data)
{
    for (const struct mpm_key *key = group->children; key->name != NULL; key++)
        free_key(key, data, member_of(data, key->offset));
}

void mpm_keys_free(const struct mpm_key *root, void *data)
{
    if (data != NULL)
        free_members(root, data);
    free(data);
}
