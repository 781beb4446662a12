/* Checks a tree against a table of keys and fills in the defaults.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/status.h"
#include "io/yaml/keys.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { PATH_SIZE = 320 };

struct checking {
    const struct mpm_source *source;
    struct mpm_faults *faults;
    struct mpm_error *error; /* the mistake in hand */
    bool geometry_known;
    enum mpm_geometry geometry;
    char path[PATH_SIZE]; /* of the key in hand, for messages */
};

/* Appends ".name" to the path; returns the length to go back to. */
static size_t enter(struct checking *checking, const char *name)
{
    const size_t length = strlen(checking->path);
    (void)snprintf(checking->path + length, PATH_SIZE - length, "%s%s", length > 0 ? "." : "",
                   name);
    return length;
}

static size_t enter_position(struct checking *checking, size_t position)
{
    char digits[24];
    (void)snprintf(digits, sizeof digits, "%zu", position);
    return enter(checking, digits);
}

static void leave(struct checking *checking, size_t length)
{
    checking->path[length] = '\0';
}

/* A mistake is noted, and the check goes on with the next value. */
static enum mpm_status note(const struct checking *checking, enum mpm_status status)
{
    return mpm_faults_note(checking->faults, status, checking->error);
}

static enum mpm_status no_memory(struct checking *checking)
{
    return mpm_error_memory(checking->error, sizeof(struct mpm_tree_node), "the defaults of keys");
}

/* "WHAT, got VALUE; allowed: ...; did you mean ...?" */
static enum mpm_status refuse(struct checking *checking, const struct mpm_key *key,
                              const struct mpm_tree_node *node, const char *what)
{
    char value[MPM_EXCERPT_SIZE], allowed[MPM_ALLOWED_SIZE], hint[MPM_HINT_SIZE];
    const char *const word = node->kind == MPM_TREE_SCALAR ? node->text : "";
    return mpm_tree_fault(checking->error, checking->source, node->origin, checking->path,
                          "%s, got %s; allowed: %s%s", what, mpm_tree_excerpt(node, value),
                          mpm_key_allowed(key, allowed), mpm_choice_hint(key, word, hint));
}

/* ------------------------------------------------------------------ shapes */

typedef enum mpm_status shape_check(struct checking *checking, const struct mpm_key *key,
                                    struct mpm_tree_node *node);
static enum mpm_status check_node(struct checking *checking, const struct mpm_key *key,
                                  struct mpm_tree_node *node);

static enum mpm_status check_scalar(struct checking *checking, const struct mpm_key *key,
                                    struct mpm_tree_node *node)
{
    const char *wrong = NULL;
    if (node->kind != MPM_TREE_SCALAR)
        wrong = "not a single value";
    else if (key->shape == MPM_KEY_ONE)
        wrong = key->value->fault(key, node);
    else if (mpm_key_choice(key, node->text) == NULL)
        wrong = "unknown choice";
    return wrong == NULL ? MPM_OK : refuse(checking, key, node, wrong);
}

/* What is wrong with a list as a whole, or NULL. */
static const char *list_fault(const struct mpm_key *key, const struct mpm_tree_node *node)
{
    const bool list = node->kind == MPM_TREE_LIST, points = key->shape == MPM_KEY_POINTS;
    if (key->shape == MPM_KEY_PAIR)
        return list && node->count == 2 ? NULL : "not a pair of values";
    if (!list)
        return points ? "not a list of points" : "not a list";
    if (node->count == 0 && key->required && !points)
        return "empty, one entry is needed at least";
    if (mpm_range_holds(&key->range, (double)node->count))
        return NULL;
    return points ? "wrong number of points" : "wrong number of entries";
}

static enum mpm_status check_list(struct checking *checking, const struct mpm_key *key,
                                  struct mpm_tree_node *node)
{
    const char *wrong = list_fault(key, node);
    if (wrong != NULL)
        return refuse(checking, key, node, wrong);
    const struct mpm_key entry = mpm_key_entry(key);
    for (size_t i = 0; i < node->count; i++) {
        const size_t length = enter_position(checking, i);
        MPM_TRY(note(checking, check_node(checking, &entry, node->entries[i].value)));
        leave(checking, length);
    }
    return MPM_OK;
}

/* ------------------------------------------------------------------ groups */

static enum mpm_status check_known(struct checking *checking, const struct mpm_key *group,
                                   const struct mpm_tree_entry *entry)
{
    if (mpm_key_find(group, entry->key) == NULL) {
        char name[MPM_EXCERPT_SIZE], allowed[MPM_ALLOWED_SIZE], hint[MPM_HINT_SIZE];
        return mpm_tree_fault(checking->error, checking->source, entry->value->origin,
                              checking->path, "unknown key %s; allowed: %s%s",
                              mpm_excerpt(entry->key, name), mpm_key_children(group, allowed),
                              mpm_key_hint(group, entry->key, hint));
    }
    return MPM_OK;
}

static enum mpm_status refuse_geometry(struct checking *checking, const struct mpm_key *key,
                                       const struct mpm_tree_node *node)
{
    if (key->where == MPM_ANYWHERE || !checking->geometry_known)
        return MPM_OK;
    const bool axisymmetric = checking->geometry == MPM_AXISYMMETRIC;
    if (axisymmetric == (key->where == MPM_ONLY_AXISYMMETRIC))
        return MPM_OK;
    return mpm_tree_fault(checking->error, checking->source, node->origin, checking->path,
                          "not for this geometry, got geometry %s; allowed: only in %s scenes",
                          axisymmetric ? "axisymmetric" : "plane strain or stress",
                          axisymmetric ? "planar" : "axisymmetric");
}

enum mpm_status mpm_tree_default(const struct mpm_source *source, const struct mpm_key *key,
                                 struct mpm_tree_node **value, struct mpm_error *error)
{
    const struct mpm_origin origin = {.setting = MPM_FROM_DEFAULT};
    return mpm_tree_parse(source, origin, key->fallback, strlen(key->fallback), value, error);
}

static enum mpm_status check_missing(struct checking *checking, const struct mpm_key *key,
                                     struct mpm_tree_node *group)
{
    char allowed[MPM_ALLOWED_SIZE];
    if (key->required)
        return mpm_tree_fault(checking->error, checking->source, group->origin, checking->path,
                              "missing, the key is required; allowed: %s",
                              mpm_key_allowed(key, allowed));
    if (key->fallback == NULL)
        return MPM_OK;
    struct mpm_tree_node *value = NULL;
    MPM_TRY(mpm_tree_default(checking->source, key, &value, checking->error));
    if (!mpm_tree_append(group, key->name, value))
        return no_memory(checking);
    return check_node(checking, key, value);
}

/* A scene's geometry decides on other keys: noted as soon as it is checked. */
static void note_geometry(struct checking *checking, const struct mpm_key *key,
                          const struct mpm_tree_node *node)
{
    if (strcmp(checking->path, "geometry") != 0)
        return;
    checking->geometry = (enum mpm_geometry)mpm_key_choice(key, node->text)->value;
    checking->geometry_known = true;
}

static enum mpm_status check_key(struct checking *checking, const struct mpm_key *key,
                                 struct mpm_tree_node *group)
{
    const struct mpm_tree_entry *entry = mpm_tree_entry(group, key->name);
    if (entry == NULL)
        return check_missing(checking, key, group);
    MPM_TRY(refuse_geometry(checking, key, entry->value));
    MPM_TRY(check_node(checking, key, entry->value));
    note_geometry(checking, key, entry->value);
    return MPM_OK;
}

/* `region: all` is short for `region: {all: true}`: a group that has a boolean of that name. In
 * quotes it is the same word. */
static enum mpm_status expand_short_form(struct checking *checking, const struct mpm_key *group,
                                         struct mpm_tree_node *node)
{
    if (node->kind != MPM_TREE_SCALAR)
        return MPM_OK;
    const struct mpm_key *key = mpm_key_find(group, node->text);
    if (key == NULL || key->value != &mpm_kind_boolean)
        return MPM_OK;
    struct mpm_tree_node *yes = mpm_tree_new(MPM_TREE_SCALAR, node->origin);
    if (yes != NULL)
        yes->text = strdup("true");
    if (yes == NULL || yes->text == NULL) {
        mpm_tree_free(yes);
        return no_memory(checking);
    }
    free(node->text);
    node->text = NULL;
    node->kind = MPM_TREE_MAPPING;
    return mpm_tree_append(node, key->name, yes) ? MPM_OK : no_memory(checking);
}

/* An unknown key that means this one is the mistake, not that this one is missing. */
static bool is_misspelt(const struct mpm_key *group, const struct mpm_key *key,
                        const struct mpm_tree_node *node)
{
    for (size_t i = 0; i < node->count; i++)
        if (mpm_key_find(group, node->entries[i].key) == NULL &&
            mpm_key_nearest(group, node->entries[i].key) == key->name)
            return true;
    return false;
}

static enum mpm_status check_group(struct checking *checking, const struct mpm_key *group,
                                   struct mpm_tree_node *node)
{
    MPM_TRY(expand_short_form(checking, group, node));
    if (node->kind != MPM_TREE_MAPPING) {
        char value[MPM_EXCERPT_SIZE], allowed[MPM_ALLOWED_SIZE];
        return mpm_tree_fault(checking->error, checking->source, node->origin, checking->path,
                              "not a mapping, got %s; allowed: a mapping with keys %s",
                              mpm_tree_excerpt(node, value), mpm_key_children(group, allowed));
    }
    for (size_t i = 0; i < node->count; i++)
        MPM_TRY(note(checking, check_known(checking, group, &node->entries[i])));
    for (const struct mpm_key *key = group->children; key->name != NULL; key++) {
        if (mpm_tree_entry(node, key->name) == NULL && is_misspelt(group, key, node))
            continue;
        const size_t length = enter(checking, key->name);
        MPM_TRY(note(checking, check_key(checking, key, node)));
        leave(checking, length);
    }
    return MPM_OK;
}

static enum mpm_status check_node(struct checking *checking, const struct mpm_key *key,
                                  struct mpm_tree_node *node)
{
    static shape_check *const checks[] = {
        [MPM_KEY_ONE] = check_scalar,    [MPM_KEY_PAIR] = check_list,
        [MPM_KEY_VALUES] = check_list,   [MPM_KEY_POINTS] = check_list,
        [MPM_KEY_CHOICE] = check_scalar, [MPM_KEY_GROUP] = check_group,
        [MPM_KEY_LIST] = check_list,
    };
    return checks[key->shape](checking, key, node);
}

enum mpm_status mpm_tree_check(const struct mpm_source *source, const struct mpm_key *root,
                               struct mpm_tree_node *tree, struct mpm_faults *faults,
                               struct mpm_error *error)
{
    struct mpm_error fault = {.status = MPM_OK};
    struct checking checking = {.source = source, .faults = faults, .error = &fault};
    /* Another format would have other keys: say so before calling them unknown. */
    const struct mpm_key *const format =
        root->shape == MPM_KEY_GROUP ? mpm_key_find(root, "format") : NULL;
    const struct mpm_tree_entry *const entry = mpm_tree_entry(tree, "format");
    enum mpm_status status = MPM_OK;
    if (format != NULL && entry != NULL) {
        const size_t length = enter(&checking, "format");
        status = note(&checking, check_node(&checking, format, entry->value));
        leave(&checking, length);
    }
    if (status == MPM_OK && faults->count == 0)
        status = note(&checking, check_node(&checking, root, tree));
    if (status == MPM_OK)
        return mpm_faults_status(faults, error);
    if (error != NULL)
        *error = fault;
    return status;
}
