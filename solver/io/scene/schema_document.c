/* The schema of scenes as JSON Schema, for editors, from the same descriptors that the checks use.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/scene/scene_schema.h"
#include "io/scene/schema.h"
#include "io/units.h"

#include <jansson.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static json_t *describe_key(const struct mpm_key *key);

/* ------------------------------------------------------------------- values */

/* A scalar of YAML, as JSON has it. */
static json_t *scalar(const struct mpm_tree_node *node)
{
    char *end = NULL;
    const double number = strtod(node->text, &end);
    const bool numeric = !node->quoted && end != node->text && *end == '\0';
    if (numeric && floor(number) == number && fabs(number) < 9e15)
        return json_integer((json_int_t)number);
    if (numeric)
        return json_real(number);
    if (!node->quoted && (strcmp(node->text, "true") == 0 || strcmp(node->text, "false") == 0))
        return json_boolean(node->text[0] == 't');
    return json_string(node->text);
}

static json_t *value_of(const struct mpm_tree_node *node)
{
    if (node->kind == MPM_TREE_SCALAR)
        return scalar(node);
    json_t *const value = node->kind == MPM_TREE_LIST ? json_array() : json_object();
    for (size_t i = 0; i < node->count; i++) {
        json_t *const entry = value_of(node->entries[i].value);
        if (node->kind == MPM_TREE_LIST)
            (void)json_array_append_new(value, entry);
        else
            (void)json_object_set_new(value, node->entries[i].key, entry);
    }
    return value;
}

static void add_default(json_t *schema, const struct mpm_key *key)
{
    const struct mpm_source source = {.path = key->name, .what = "default"};
    struct mpm_tree_node *tree = NULL;
    if (key->fallback == NULL || mpm_tree_default(&source, key, &tree, NULL) != MPM_OK)
        return;
    (void)json_object_set_new(schema, "default", value_of(tree));
    mpm_tree_free(tree);
}

static json_t *number(double value)
{
    return floor(value) == value && fabs(value) < 9e15 ? json_integer((json_int_t)value)
                                                       : json_real(value);
}

static void add_range(json_t *schema, const struct mpm_range *range)
{
    if (isfinite(range->low))
        (void)json_object_set_new(schema, range->low_open ? "exclusiveMinimum" : "minimum",
                                  number(range->low));
    if (isfinite(range->high))
        (void)json_object_set_new(schema, range->high_open ? "exclusiveMaximum" : "maximum",
                                  number(range->high));
}

/* Of "neo_hookean, linear_elastic". */
static json_t *names_in(const char *text)
{
    json_t *const names = json_array();
    for (const char *name = text; *name != '\0';) {
        const size_t length = strcspn(name, ",");
        (void)json_array_append_new(names, json_stringn(name, length));
        name += length;
        name += strspn(name, ", ");
    }
    return names;
}

/* A text may be any scalar: `name: 1` is the name "1". */
static json_t *describe_text(const struct mpm_key *key)
{
    const int longest = key->value == &mpm_kind_name ? MPM_NAME_LENGTH_MAX : MPM_TITLE_LENGTH_MAX;
    return json_pack("{s[sss] si si}", "type", "string", "number", "boolean", "minLength",
                     key->fallback == NULL ? 1 : 0, "maxLength", longest);
}

/* One value of the key's kind. */
static json_t *describe_value(const struct mpm_key *key)
{
    const struct mpm_value_kind *const kind = key->value;
    json_t *schema = NULL;
    if (kind->names != NULL)
        return json_pack("{so}", "enum", names_in(kind->names()));
    if (kind == &mpm_kind_text || kind == &mpm_kind_name)
        return describe_text(key);
    if (kind == &mpm_kind_boolean)
        return json_pack("{ss}", "type", "boolean");
    if (kind->ranged) {
        schema = json_pack("{ss}", "type", kind == &mpm_kind_integer ? "integer" : "number");
        add_range(schema, &key->range);
        return schema;
    }
    schema = json_pack("{s[ss] si}", "type", "number", "string", "minLength", 1);
    if (strcmp(kind->name, "drive") != 0)
        (void)json_object_set_new(schema, "not", json_pack("{ss}", "const", "free"));
    return schema;
}

static json_t *describe_choice(const struct mpm_key *key)
{
    json_t *const names = json_array();
    for (size_t i = 0; i < key->choice_count; i++)
        (void)json_array_append_new(names, json_string(key->choices[i].name));
    return json_pack("{so}", "enum", names);
}

/* --------------------------------------------------------- lists and groups */

static json_t *describe_list(const struct mpm_key *key)
{
    const struct mpm_key entry = mpm_key_entry(key);
    const bool pair = key->shape == MPM_KEY_PAIR;
    json_t *const schema = json_pack("{ss so}", "type", "array", "items", describe_key(&entry));
    double least = pair ? 2 : key->range.low;
    const double most = pair ? 2 : key->range.high;
    if (key->required && key->shape == MPM_KEY_LIST && !(least >= 1))
        least = 1;
    if (isfinite(least) && least > 0)
        (void)json_object_set_new(schema, "minItems", number(least));
    if (isfinite(most))
        (void)json_object_set_new(schema, "maxItems", number(most));
    return schema;
}

/* Names of the booleans that may stand for the group: `region: all`. NULL where some key is needed
 * beside them. */
static json_t *short_forms(const struct mpm_key *group)
{
    json_t *const names = json_array();
    bool complete = true;
    for (const struct mpm_key *key = group->children; key->name != NULL; key++) {
        complete = complete && !key->required;
        if (key->value == &mpm_kind_boolean && key->shape == MPM_KEY_ONE)
            (void)json_array_append_new(names, json_string(key->name));
    }
    if (complete && json_array_size(names) > 0)
        return names;
    json_decref(names);
    return NULL;
}

static json_t *describe_group(const struct mpm_key *group)
{
    json_t *const keys = json_object(), *const required = json_array();
    for (const struct mpm_key *key = group->children; key->name != NULL; key++) {
        (void)json_object_set_new(keys, key->name, describe_key(key));
        if (key->required)
            (void)json_array_append_new(required, json_string(key->name));
    }
    json_t *const object = json_pack("{ss sb so so}", "type", "object", "additionalProperties", 0,
                                     "properties", keys, "required", required);
    json_t *const names = short_forms(group);
    if (names == NULL)
        return object;
    return json_pack("{s[o{so}]}", "anyOf", object, "enum", names);
}

static void add_help(json_t *schema, const struct mpm_key *key)
{
    static const char *const places[] = {
        [MPM_ANYWHERE] = "",
        [MPM_ONLY_PLANAR] = "; planar scenes only",
        [MPM_ONLY_AXISYMMETRIC] = "; axisymmetric scenes only",
    };
    char unit[MPM_UNIT_SIZE];
    mpm_dimension_text(key->dimension, unit);
    json_t *const help = json_sprintf("%s%s%s%s", key->help, unit[0] != '\0' ? "; unit: " : "",
                                      unit, places[key->where]);
    (void)json_object_set_new(schema, "description", help);
}

static json_t *describe_key(const struct mpm_key *key)
{
    json_t *schema = NULL;
    switch (key->shape) {
    case MPM_KEY_ONE:
        schema = describe_value(key);
        break;
    case MPM_KEY_CHOICE:
        schema = describe_choice(key);
        break;
    case MPM_KEY_GROUP:
        schema = describe_group(key);
        break;
    case MPM_KEY_PAIR:
    case MPM_KEY_VALUES:
    case MPM_KEY_POINTS:
    case MPM_KEY_LIST:
        schema = describe_list(key);
        break;
    }
    if (key->help != NULL) {
        add_help(schema, key);
        add_default(schema, key);
    }
    return schema;
}

/* ----------------------------------------------------------------- geometry */

/* The keys below a group that are for `where` alone are refused; NULL if there are none. */
static json_t *refuse_keys(const struct mpm_key *group, enum mpm_key_where where)
{
    json_t *const keys = json_object();
    for (const struct mpm_key *key = group->children; key->name != NULL; key++) {
        json_t *inner = NULL;
        if (key->where == where)
            (void)json_object_set_new(keys, key->name, json_false());
        else if (key->children != NULL && (inner = refuse_keys(key, where)) != NULL)
            (void)json_object_set_new(keys, key->name,
                                      key->shape == MPM_KEY_LIST ? json_pack("{so}", "items", inner)
                                                                 : inner);
    }
    if (json_object_size(keys) > 0)
        return json_pack("{so}", "properties", keys);
    json_decref(keys);
    return NULL;
}

char *mpm_schema_document(void)
{
    json_t *const schema =
        json_pack("{ss ss}", "$schema", "http://json-schema.org/draft-07/schema#", "title",
                  "A scene of mpm, the solver of Touchstone");
    json_t *const root = describe_group(&mpm_scene_root);
    (void)json_object_update(schema, root);
    json_decref(root);
    (void)json_object_set_new(schema, "if",
                              json_pack("{s{s{ss}} s[s]}", "properties", "geometry", "const",
                                        "axisymmetric", "required", "geometry"));
    (void)json_object_set_new(schema, "then", refuse_keys(&mpm_scene_root, MPM_ONLY_PLANAR));
    (void)json_object_set_new(schema, "else", refuse_keys(&mpm_scene_root, MPM_ONLY_AXISYMMETRIC));
    char *const text = json_dumps(schema, JSON_INDENT(1));
    json_decref(schema);
    return text;
}
