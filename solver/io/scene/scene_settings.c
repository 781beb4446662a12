/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/scene/scene_settings.h"

#include "base/status.h"
#include "io/scene/scene_schema.h"

#include <stdlib.h>
#include <string.h>

enum { PATH_SIZE = 512 };

/* As a segment of a path: one entry more of a list. */
static const char new_entry[] = "+";

struct setting {
    const struct mpm_source *source;
    struct mpm_error *error;
    struct mpm_origin origin;
    char path[PATH_SIZE];
    char *segments; /* what is left of the path, in `path` */
};

static enum mpm_status no_memory(const struct setting *setting)
{
    return mpm_error_memory(setting->error, sizeof(struct mpm_tree_node), "a --set");
}

/* The next segment of the path, or NULL at its end. */
static char *next_segment(struct setting *setting)
{
    char *segment = setting->segments;
    if (segment == NULL)
        return NULL;
    char *point = strchr(segment, '.');
    setting->segments = point != NULL ? point + 1 : NULL;
    if (point != NULL)
        *point = '\0';
    return segment;
}

static bool has_name(const struct mpm_tree_node *node, const char *name)
{
    const struct mpm_tree_entry *entry = mpm_tree_entry(node, "name");
    return entry != NULL && entry->value->kind == MPM_TREE_SCALAR &&
           strcmp(entry->value->text, name) == 0;
}

/* The slot of a list's entry, or NULL. */
static struct mpm_tree_node **entry_slot(const struct mpm_tree_node *list, const char *segment)
{
    const size_t digits = strspn(segment, "0123456789");
    if (digits > 0 && digits < 10 && segment[digits] == '\0') {
        const size_t position = (size_t)strtoul(segment, NULL, 10);
        if (position < list->count)
            return &list->entries[position].value;
    }
    for (size_t i = 0; i < list->count; i++)
        if (has_name(list->entries[i].value, segment))
            return &list->entries[i].value;
    return NULL;
}

static const char *entry_hint(const struct mpm_tree_node *list, const char *segment,
                              char hint[MPM_HINT_SIZE])
{
    struct mpm_nearest nearest = {.word = segment};
    for (size_t i = 0; i < list->count; i++) {
        const struct mpm_tree_entry *name = mpm_tree_entry(list->entries[i].value, "name");
        if (name != NULL && name->value->kind == MPM_TREE_SCALAR)
            mpm_nearest_offer(&nearest, name->value->text);
    }
    return mpm_nearest_hint(&nearest, hint);
}

/* The slot of an entry that there is; NULL: a mistake. `more`: what else is allowed. */
static struct mpm_tree_node **known_entry(const struct setting *setting,
                                          const struct mpm_tree_node *list, const char *segment,
                                          const char *more)
{
    char name[MPM_EXCERPT_SIZE], hint[MPM_HINT_SIZE];
    struct mpm_tree_node **const slot =
        list->kind == MPM_TREE_LIST ? entry_slot(list, segment) : NULL;
    if (slot != NULL)
        return slot;
    if (list->kind != MPM_TREE_LIST)
        (void)mpm_tree_fault(setting->error, setting->source, setting->origin, "",
                             "%s names an entry, but the scene has no list there",
                             mpm_excerpt(segment, name));
    else
        (void)mpm_tree_fault(setting->error, setting->source, setting->origin, "",
                             "no entry %s in the list of %zu; allowed: a position from 0, or the "
                             "`name` of an entry%s%s",
                             mpm_excerpt(segment, name), list->count, more,
                             entry_hint(list, segment, hint));
    return NULL;
}

/* A new entry at the end: an empty mapping until it has its value. */
static enum mpm_status append_entry(const struct setting *setting, struct mpm_tree_node *list,
                                    struct mpm_tree_node ***slot)
{
    if (!mpm_tree_append(list, NULL, mpm_tree_new(MPM_TREE_MAPPING, setting->origin)))
        return no_memory(setting);
    *slot = &list->entries[list->count - 1].value;
    return MPM_OK;
}

static enum mpm_status find_entry(const struct setting *setting, struct mpm_tree_node *list,
                                  const char *segment, struct mpm_tree_node ***slot)
{
    if (list->kind == MPM_TREE_LIST && strcmp(segment, new_entry) == 0)
        return append_entry(setting, list, slot);
    *slot = known_entry(setting, list, segment, ", or + for a new one at the end");
    return *slot != NULL ? MPM_OK : MPM_BAD_INPUT;
}

/* A key that the scene does not have is made: the last of the path by the value itself,
 * others from their default, or as an empty mapping. */
static enum mpm_status add_missing(const struct setting *setting, const struct mpm_key *key,
                                   struct mpm_tree_node *group)
{
    struct mpm_tree_node *value = NULL;
    if (setting->segments == NULL || key->shape == MPM_KEY_GROUP)
        value = mpm_tree_new(MPM_TREE_MAPPING, setting->origin);
    else if (setting->segments[0] == new_entry[0])
        value = mpm_tree_new(MPM_TREE_LIST, setting->origin);
    else if (key->fallback != NULL)
        MPM_TRY(mpm_tree_default(setting->source, key, &value, setting->error));
    else
        return mpm_tree_fault(setting->error, setting->source, setting->origin, "",
                              "the scene has no %s whose part could be set; allowed: setting it "
                              "as a whole",
                              key->name);
    return mpm_tree_append(group, key->name, value) ? MPM_OK : no_memory(setting);
}

/* The key of the table, where the scene has a mapping, or nothing (NULL); NULL: a mistake. */
static const struct mpm_key *known_key(const struct setting *setting, const struct mpm_key *group,
                                       const struct mpm_tree_node *node, const char *segment)
{
    char name[MPM_EXCERPT_SIZE], allowed[MPM_ALLOWED_SIZE], hint[MPM_HINT_SIZE];
    const struct mpm_key *const key = mpm_key_find(group, segment);
    const bool is_mapping = node == NULL || node->kind == MPM_TREE_MAPPING;
    if (key != NULL && is_mapping)
        return key;
    if (key == NULL)
        (void)mpm_tree_fault(setting->error, setting->source, setting->origin, "",
                             "unknown key %s; allowed: %s%s", mpm_excerpt(segment, name),
                             mpm_key_children(group, allowed), mpm_key_hint(group, segment, hint));
    else
        (void)mpm_tree_fault(setting->error, setting->source, setting->origin, "",
                             "%s names a key, but the scene has no mapping there",
                             mpm_excerpt(segment, name));
    return NULL;
}

static enum mpm_status find_key(const struct setting *setting, struct mpm_key *group,
                                struct mpm_tree_node *node, const char *segment,
                                struct mpm_tree_node ***slot)
{
    const struct mpm_key *const key = known_key(setting, group, node, segment);
    if (key == NULL)
        return MPM_BAD_INPUT;
    if (mpm_tree_entry(node, segment) == NULL)
        MPM_TRY(add_missing(setting, key, node));
    *slot = &mpm_tree_entry(node, segment)->value;
    *group = *key;
    return MPM_OK;
}

static enum mpm_status refuse_part(const struct setting *setting, const struct mpm_key *key,
                                   const char *segment)
{
    char name[MPM_EXCERPT_SIZE];
    return mpm_tree_fault(setting->error, setting->source, setting->origin, "",
                          "%s is one value and has no part %s", key->name,
                          mpm_excerpt(segment, name));
}

static bool has_parts(const struct mpm_key *key)
{
    return key->shape != MPM_KEY_ONE && key->shape != MPM_KEY_CHOICE;
}

/* One segment further down; *node is NULL where the scene gives nothing. */
static enum mpm_status descend(const struct setting *setting, const char *segment,
                               struct mpm_key *key, struct mpm_tree_node **node)
{
    if (!has_parts(key))
        return refuse_part(setting, key, segment);
    if (key->shape == MPM_KEY_GROUP) {
        const struct mpm_key *const next = known_key(setting, key, *node, segment);
        if (next == NULL)
            return MPM_BAD_INPUT;
        const struct mpm_tree_entry *const given =
            *node != NULL ? mpm_tree_entry(*node, segment) : NULL;
        *node = given != NULL ? given->value : NULL;
        *key = *next;
        return MPM_OK;
    }
    if (*node != NULL) {
        struct mpm_tree_node *const *const entry = known_entry(setting, *node, segment, "");
        if (entry == NULL)
            return MPM_BAD_INPUT;
        *node = *entry;
    }
    *key = mpm_key_entry(key);
    return MPM_OK;
}

/* `PATH=`: takes the key, or the entry of a list, out of the scene. What the scene does not give
 * needs no taking out, but has to be a key. */
static enum mpm_status unset(struct setting *setting, struct mpm_tree_node *root)
{
    struct mpm_key key = mpm_scene_root;
    struct mpm_tree_node *node = root, *parent = NULL;
    for (char *segment = next_segment(setting); segment != NULL; segment = next_segment(setting)) {
        parent = node;
        MPM_TRY(descend(setting, segment, &key, &node));
    }
    if (node != NULL && parent != NULL)
        mpm_tree_remove(parent, node);
    return MPM_OK;
}

/* Walks the path down to the slot that the value goes to. */
static enum mpm_status find_slot(struct setting *setting, struct mpm_tree_node **slot,
                                 struct mpm_tree_node ***found)
{
    struct mpm_key key = mpm_scene_root;
    for (char *segment = next_segment(setting); segment != NULL; segment = next_segment(setting)) {
        if (key.shape == MPM_KEY_GROUP) {
            MPM_TRY(find_key(setting, &key, *slot, segment, &slot));
        } else if (!has_parts(&key)) {
            return refuse_part(setting, &key, segment);
        } else {
            MPM_TRY(find_entry(setting, *slot, segment, &slot));
            key = mpm_key_entry(&key);
        }
    }
    *found = slot;
    return MPM_OK;
}

static enum mpm_status apply(struct setting *setting, const char *text, struct mpm_tree_node **root)
{
    const char *equals = strchr(text, '=');
    const size_t length = equals != NULL ? (size_t)(equals - text) : 0;
    if (length == 0 || length >= PATH_SIZE)
        return mpm_tree_fault(
            setting->error, setting->source, setting->origin, "",
            "not a setting; allowed: PATH=VALUE, or PATH= to unset, with a path of up to %d "
            "characters, such as grid.refine=2",
            PATH_SIZE - 1);
    memcpy(setting->path, text, length);
    setting->path[length] = '\0';
    setting->segments = setting->path;
    if (equals[1] == '\0')
        return unset(setting, *root);
    struct mpm_tree_node **slot = root;
    struct mpm_tree_node *value = NULL;
    MPM_TRY(mpm_tree_parse(setting->source, setting->origin, equals + 1, strlen(equals + 1), &value,
                           setting->error));
    const enum mpm_status status = find_slot(setting, slot, &slot);
    if (status != MPM_OK) {
        mpm_tree_free(value);
        return status;
    }
    mpm_tree_free(*slot);
    *slot = value;
    return MPM_OK;
}

enum mpm_status mpm_tree_apply_setting(const struct mpm_source *source, size_t index,
                                       struct mpm_tree_node *root, struct mpm_error *error)
{
    struct setting setting = {
        .source = source, .error = error, .origin = {.setting = (int)index + 1}};
    return apply(&setting, source->settings[index], &root);
}

enum mpm_status mpm_tree_apply_settings(const struct mpm_source *source, size_t count,
                                        struct mpm_tree_node *root, struct mpm_faults *faults,
                                        struct mpm_error *error)
{
    for (size_t i = 0; i < count; i++)
        MPM_TRY(mpm_faults_note(faults, mpm_tree_apply_setting(source, i, root, error), error));
    return mpm_faults_status(faults, error);
}
