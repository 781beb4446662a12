/* Checks a scene's tree against the schema and fills in the defaults.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/scene/scene_check.h"

#include "base/expression.h"
#include "model/material.h"

#include <glib.h>
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { PATH_SIZE = 320 };

struct checking {
    const struct mpm_scene *scene;
    struct mpm_error *error;
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

static enum mpm_status no_memory(struct checking *checking)
{
    return mpm_error_memory(checking->error, sizeof(struct mpm_tree_node), "a scene's defaults");
}

/* "must be WHAT, got VALUE; allowed: ..." */
static enum mpm_status refuse(struct checking *checking, const struct mpm_key *key,
                              const struct mpm_tree_node *node, bool component, const char *what)
{
    char value[MPM_EXCERPT_SIZE], allowed[MPM_ALLOWED_SIZE];
    return mpm_tree_fault(checking->error, checking->scene, node->origin, checking->path,
                          "%s, got %s; allowed: %s", what, mpm_tree_excerpt(node, value),
                          mpm_key_allowed(key, component, allowed));
}

/* ----------------------------------------------------------------- scalars */

/* What is wrong with a scalar of some kind, or NULL. */
typedef const char *scalar_check(const struct mpm_key *key, struct mpm_tree_node *node);

static bool in_range(const struct mpm_range *range, double value)
{
    return (range->low_open ? value > range->low : value >= range->low) &&
           (range->high_open ? value < range->high : value <= range->high);
}

static const char *check_number(const struct mpm_key *key, struct mpm_tree_node *node)
{
    double value = 0.0;
    if (node->quoted || !mpm_number_parse(node->text, &value))
        return "not a number";
    return in_range(&key->range, value) ? NULL : "out of range";
}

static const char *check_integer(const struct mpm_key *key, struct mpm_tree_node *node)
{
    double value = 0.0;
    if (node->quoted || !mpm_number_parse(node->text, &value) || floor(value) != value)
        return "not an integer";
    if (!in_range(&key->range, value))
        return "out of range";
    /* libcyaml would take 010 for 8 and does not know 1e3. Ranges keep to 2^53. */
    char *digits = malloc(24);
    if (digits == NULL)
        return "out of memory";
    (void)snprintf(digits, 24, "%" PRId64, (int64_t)value);
    free(node->text);
    node->text = digits;
    return NULL;
}

static const char *check_boolean(const struct mpm_key *key, struct mpm_tree_node *node)
{
    (void)key;
    const bool plain = strcmp(node->text, "true") == 0 || strcmp(node->text, "false") == 0;
    return plain && !node->quoted ? NULL : "not a boolean";
}

static bool is_null(const struct mpm_tree_node *node)
{
    return !node->quoted && (node->text[0] == '\0' || strcmp(node->text, "~") == 0 ||
                             strcmp(node->text, "null") == 0);
}

static const char *check_text(const struct mpm_key *key, struct mpm_tree_node *node)
{
    (void)key;
    if (is_null(node))
        return "no text";
    return g_utf8_strlen(node->text, -1) <= MPM_TITLE_LENGTH_MAX ? NULL : "too long";
}

static const char *check_name(const struct mpm_key *key, struct mpm_tree_node *node)
{
    if (is_null(node) || (node->text[0] == '\0' && key->fallback == NULL))
        return "no name";
    for (const char *c = node->text; *c != '\0'; c++)
        if ((unsigned char)*c < 0x20 || *c == 0x7f)
            return "not a name: control characters";
    return g_utf8_strlen(node->text, -1) <= MPM_NAME_LENGTH_MAX ? NULL : "too long";
}

static const char *check_law(const struct mpm_key *key, struct mpm_tree_node *node)
{
    (void)key;
    return mpm_material_law_find(node->text) != NULL ? NULL : "unknown law";
}

/* Formulas are parsed later, when the names of the coordinates are known. */
static const char *check_expression(const struct mpm_key *key, struct mpm_tree_node *node)
{
    (void)key;
    if (is_null(node))
        return "no expression";
    return strcmp(node->text, "free") == 0 ? "a component cannot be free here" : NULL;
}

static const char *check_drive(const struct mpm_key *key, struct mpm_tree_node *node)
{
    (void)key;
    return is_null(node) ? "no expression" : NULL;
}

static scalar_check *const scalar_checks[] = {
    [MPM_VALUE_NUMBER] = check_number,   [MPM_VALUE_EXPRESSION] = check_expression,
    [MPM_VALUE_DRIVE] = check_drive,     [MPM_VALUE_TEXT] = check_text,
    [MPM_VALUE_NAME] = check_name,       [MPM_VALUE_LAW] = check_law,
    [MPM_VALUE_INTEGER] = check_integer, [MPM_VALUE_BOOLEAN] = check_boolean,
};

static enum mpm_status check_scalar(struct checking *checking, const struct mpm_key *key,
                                    struct mpm_tree_node *node, bool component)
{
    const char *wrong =
        node->kind != MPM_TREE_SCALAR ? "not a single value" : scalar_checks[key->value](key, node);
    return wrong == NULL ? MPM_OK : refuse(checking, key, node, component, wrong);
}

/* ------------------------------------------------------------------ shapes */

typedef enum mpm_status shape_check(struct checking *checking, const struct mpm_key *key,
                                    struct mpm_tree_node *node);
static enum mpm_status check_node(struct checking *checking, const struct mpm_key *key,
                                  struct mpm_tree_node *node);

static enum mpm_status check_one(struct checking *checking, const struct mpm_key *key,
                                 struct mpm_tree_node *node)
{
    return check_scalar(checking, key, node, false);
}

static enum mpm_status check_pair(struct checking *checking, const struct mpm_key *key,
                                  struct mpm_tree_node *node)
{
    if (node->kind != MPM_TREE_LIST || node->count != 2)
        return refuse(checking, key, node, false, "not a pair of values");
    for (size_t i = 0; i < 2; i++) {
        const size_t length = enter_position(checking, i);
        MPM_TRY(check_scalar(checking, key, node->entries[i].value, true));
        leave(checking, length);
    }
    return MPM_OK;
}

static enum mpm_status check_points(struct checking *checking, const struct mpm_key *key,
                                    struct mpm_tree_node *node)
{
    if (node->kind != MPM_TREE_LIST)
        return refuse(checking, key, node, false, "not a list of points");
    if (!in_range(&key->range, (double)node->count))
        return refuse(checking, key, node, false, "wrong number of points");
    struct mpm_key point = *key;
    point.shape = MPM_KEY_PAIR;
    point.range = (struct mpm_range){.low = -HUGE_VAL, .high = HUGE_VAL};
    for (size_t i = 0; i < node->count; i++) {
        const size_t length = enter_position(checking, i);
        MPM_TRY(check_pair(checking, &point, node->entries[i].value));
        leave(checking, length);
    }
    return MPM_OK;
}

static enum mpm_status check_choice(struct checking *checking, const struct mpm_key *key,
                                    struct mpm_tree_node *node)
{
    if (node->kind != MPM_TREE_SCALAR)
        return refuse(checking, key, node, false, "not a single value");
    for (size_t i = 0; i < key->choice_count; i++)
        if (strcmp(node->text, key->choices[i].name) == 0)
            return MPM_OK;
    return refuse(checking, key, node, false, "unknown choice");
}

static enum mpm_status check_list(struct checking *checking, const struct mpm_key *key,
                                  struct mpm_tree_node *node)
{
    if (node->kind != MPM_TREE_LIST)
        return refuse(checking, key, node, false, "not a list");
    if (node->count == 0 && key->required)
        return refuse(checking, key, node, false, "empty, one entry is needed at least");
    struct mpm_key entry = *key;
    entry.shape = MPM_KEY_GROUP;
    for (size_t i = 0; i < node->count; i++) {
        const size_t length = enter_position(checking, i);
        MPM_TRY(check_node(checking, &entry, node->entries[i].value));
        leave(checking, length);
    }
    return MPM_OK;
}

/* ------------------------------------------------------------------ groups */

static enum mpm_status refuse_unknown(struct checking *checking, const struct mpm_key *group,
                                      const struct mpm_tree_node *node)
{
    for (size_t i = 0; i < node->count; i++) {
        const struct mpm_tree_entry *entry = &node->entries[i];
        if (mpm_key_find(group, entry->key) != NULL)
            continue;
        char name[MPM_EXCERPT_SIZE], allowed[MPM_ALLOWED_SIZE];
        return mpm_tree_fault(checking->error, checking->scene, entry->value->origin,
                              checking->path, "unknown key %s; allowed: %s",
                              mpm_excerpt(entry->key, name), mpm_key_children(group, allowed));
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
    return mpm_tree_fault(checking->error, checking->scene, node->origin, checking->path,
                          "not for this geometry, got geometry %s; allowed: only in %s scenes",
                          axisymmetric ? "axisymmetric" : "plane strain or stress",
                          axisymmetric ? "planar" : "axisymmetric");
}

enum mpm_status mpm_tree_default(const struct mpm_scene *scene, const struct mpm_key *key,
                                 struct mpm_tree_node **value, struct mpm_error *error)
{
    const struct mpm_origin origin = {.setting = MPM_FROM_DEFAULT};
    return mpm_tree_parse(scene, origin, key->fallback, strlen(key->fallback), value, error);
}

static enum mpm_status check_missing(struct checking *checking, const struct mpm_key *key,
                                     struct mpm_tree_node *group)
{
    char allowed[MPM_ALLOWED_SIZE];
    if (key->required)
        return mpm_tree_fault(checking->error, checking->scene, group->origin, checking->path,
                              "missing, the key is required; allowed: %s",
                              mpm_key_allowed(key, false, allowed));
    if (key->fallback == NULL)
        return MPM_OK;
    struct mpm_tree_node *value = NULL;
    MPM_TRY(mpm_tree_default(checking->scene, key, &value, checking->error));
    if (!mpm_tree_append(group, key->name, value))
        return no_memory(checking);
    return check_node(checking, key, value);
}

/* The scene's geometry decides on other keys: noted as soon as it is checked. */
static void note_geometry(struct checking *checking, const struct mpm_key *key,
                          const struct mpm_tree_node *node)
{
    if (strcmp(checking->path, "geometry") != 0)
        return;
    for (size_t i = 0; i < key->choice_count; i++)
        if (strcmp(node->text, key->choices[i].name) == 0)
            checking->geometry = (enum mpm_geometry)key->choices[i].value;
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

/* `region: all` is short for `region: {all: true}`: a group that has a boolean of that name. */
static enum mpm_status expand_short_form(struct checking *checking, const struct mpm_key *group,
                                         struct mpm_tree_node *node)
{
    if (node->kind != MPM_TREE_SCALAR)
        return MPM_OK;
    const struct mpm_key *key = mpm_key_find(group, node->text);
    if (key == NULL || key->value != MPM_VALUE_BOOLEAN || node->quoted)
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

static enum mpm_status check_group(struct checking *checking, const struct mpm_key *group,
                                   struct mpm_tree_node *node)
{
    MPM_TRY(expand_short_form(checking, group, node));
    if (node->kind != MPM_TREE_MAPPING) {
        char value[MPM_EXCERPT_SIZE], allowed[MPM_ALLOWED_SIZE];
        return mpm_tree_fault(checking->error, checking->scene, node->origin, checking->path,
                              "not a mapping, got %s; allowed: a mapping with keys %s",
                              mpm_tree_excerpt(node, value), mpm_key_children(group, allowed));
    }
    MPM_TRY(refuse_unknown(checking, group, node));
    for (const struct mpm_key *key = group->children; key->name != NULL; key++) {
        const size_t length = enter(checking, key->name);
        MPM_TRY(check_key(checking, key, node));
        leave(checking, length);
    }
    return MPM_OK;
}

static enum mpm_status check_node(struct checking *checking, const struct mpm_key *key,
                                  struct mpm_tree_node *node)
{
    static shape_check *const checks[] = {
        [MPM_KEY_ONE] = check_one,       [MPM_KEY_PAIR] = check_pair,
        [MPM_KEY_POINTS] = check_points, [MPM_KEY_CHOICE] = check_choice,
        [MPM_KEY_GROUP] = check_group,   [MPM_KEY_LIST] = check_list,
    };
    return checks[key->shape](checking, key, node);
}

enum mpm_status mpm_tree_check(const struct mpm_scene *scene, struct mpm_tree_node *root,
                               struct mpm_error *error)
{
    struct checking checking = {.scene = scene, .error = error};
    /* Another format would have other keys: say so before calling them unknown. */
    const struct mpm_tree_entry *format = mpm_tree_entry(root, "format");
    if (format != NULL) {
        const size_t length = enter(&checking, "format");
        MPM_TRY(check_node(&checking, mpm_key_find(&mpm_scene_root, "format"), format->value));
        leave(&checking, length);
    }
    return check_node(&checking, &mpm_scene_root, root);
}
