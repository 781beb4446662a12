/* Kinds of values: what one scalar may be.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/status.h"
#include "io/yaml/keys.h"
#include "mpm_expression.h"

#include <glib.h>
#include <math.h>
#include <string.h>

bool mpm_tree_is_null(const struct mpm_tree_node *scalar)
{
    return !scalar->quoted && (scalar->text[0] == '\0' || strcmp(scalar->text, "~") == 0 ||
                               strcmp(scalar->text, "null") == 0);
}

static const char *number_fault(const struct mpm_key *key, const struct mpm_tree_node *node)
{
    double value = 0.0;
    if (node->quoted || !mpm_number_parse(node->text, &value))
        return "not a number";
    return mpm_range_holds(&key->range, value) ? NULL : "out of range";
}

/* Ranges keep to 2^53. */
static const char *integer_fault(const struct mpm_key *key, const struct mpm_tree_node *node)
{
    double value = 0.0;
    if (node->quoted || !mpm_number_parse(node->text, &value) || floor(value) != value)
        return "not an integer";
    return mpm_range_holds(&key->range, value) ? NULL : "out of range";
}

static const char *boolean_fault(const struct mpm_key *key, const struct mpm_tree_node *node)
{
    (void)key;
    const bool plain = strcmp(node->text, "true") == 0 || strcmp(node->text, "false") == 0;
    return plain && !node->quoted ? NULL : "not a boolean";
}

/* Only a key whose default is empty may be given as empty. */
static bool is_empty(const struct mpm_key *key, const struct mpm_tree_node *node)
{
    return mpm_tree_is_null(node) || (node->text[0] == '\0' && key->fallback == NULL);
}

static const char *text_fault(const struct mpm_key *key, const struct mpm_tree_node *node)
{
    if (is_empty(key, node))
        return "no text";
    return g_utf8_strlen(node->text, -1) <= MPM_TITLE_LENGTH_MAX ? NULL : "too long";
}

static const char *name_fault(const struct mpm_key *key, const struct mpm_tree_node *node)
{
    if (is_empty(key, node))
        return "no name";
    for (const char *c = node->text; *c != '\0'; c++)
        if ((unsigned char)*c < 0x20 || *c == 0x7f)
            return "not a name: control characters";
    return g_utf8_strlen(node->text, -1) <= MPM_NAME_LENGTH_MAX ? NULL : "too long";
}

const struct mpm_value_kind mpm_kind_number = {
    .name = "number", .one = "number", .two = "2 numbers", .ranged = true, .fault = number_fault};
const struct mpm_value_kind mpm_kind_integer = {.name = "integer",
                                                .one = "integer",
                                                .two = "2 integers",
                                                .ranged = true,
                                                .fault = integer_fault,
                                                .stored = MPM_STORED_INTEGER};
const struct mpm_value_kind mpm_kind_boolean = {.name = "boolean",
                                                .one = "boolean",
                                                .two = "2 booleans",
                                                .allowed = "true | false",
                                                .fault = boolean_fault,
                                                .stored = MPM_STORED_BOOLEAN};
const struct mpm_value_kind mpm_kind_text = {.name = "text",
                                             .one = "text",
                                             .two = "2 texts",
                                             .allowed = "up to 4096 characters",
                                             .fault = text_fault};
const struct mpm_value_kind mpm_kind_name = {.name = "name",
                                             .one = "name",
                                             .two = "2 names",
                                             .allowed = "up to 64 characters",
                                             .fault = name_fault};
