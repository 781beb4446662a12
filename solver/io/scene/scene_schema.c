/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/scene/scene_schema.h"

#include "model/material.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

/* ----------------------------------------------------------------- choices */

#define CHOICE_ROW(text, number) {.name = (text), .value = (number)},
#define CHOICE_TABLE(list)                                                                         \
    static const struct mpm_choice choices_##list[] = {CHOICES_##list(CHOICE_ROW)};
MPM_CHOICE_LISTS(CHOICE_TABLE)

/* ------------------------------------------------- kinds of values of scenes */

static const char *law_fault(const struct mpm_key *key, const struct mpm_tree_node *node)
{
    (void)key;
    return mpm_material_law_find(node->text) != NULL ? NULL : "unknown law";
}

/* Formulas are parsed later, when the names of the coordinates are known. */
static const char *drive_fault(const struct mpm_key *key, const struct mpm_tree_node *node)
{
    (void)key;
    return mpm_tree_is_null(node) ? "no expression" : NULL;
}

static const char *expression_fault(const struct mpm_key *key, const struct mpm_tree_node *node)
{
    if (mpm_tree_is_null(node) || strcmp(node->text, "free") != 0)
        return drive_fault(key, node);
    return "a component cannot be free here";
}

static const struct mpm_value_kind laws = {.name = "law",
                                           .one = "choice",
                                           .two = "2 choices",
                                           .names = mpm_material_law_names,
                                           .fault = law_fault};
static const struct mpm_value_kind expressions = {
    .name = "expression", .one = "expression", .two = "2 expressions", .fault = expression_fault};
static const struct mpm_value_kind drives = {.name = "drive",
                                             .one = "expression or free",
                                             .two = "2 expressions or free",
                                             .fault = drive_fault};

/* -------------------------------------------------------------------- keys */

/* In parentheses, so that the commas stay together on their way through the lists. */
#define ANY            (-HUGE_VAL, HUGE_VAL, false, false)
#define ABOVE(a)       (a, HUGE_VAL, true, false)
#define AT_LEAST(a)    (a, HUGE_VAL, false, false)
#define ABOVE_TO(a, b) (a, b, true, false)
#define FROM_TO(a, b)  (a, b, false, false)
#define BETWEEN(a, b)  (a, b, true, true)
#define RANGE(from, to, from_open, to_open)                                                        \
    {                                                                                              \
        (from), (to), (from_open), (to_open)                                                       \
    }
#define REQUIRED           true
#define OPTIONAL           false
#define WHERE_ANYWHERE     MPM_ANYWHERE
#define WHERE_PLANAR       MPM_ONLY_PLANAR
#define WHERE_AXISYMMETRIC MPM_ONLY_AXISYMMETRIC

#define KIND_NUMBER     (&mpm_kind_number)
#define KIND_INTEGER    (&mpm_kind_integer)
#define KIND_BOOLEAN    (&mpm_kind_boolean)
#define KIND_TEXT       (&mpm_kind_text)
#define KIND_NAME       (&mpm_kind_name)
#define KIND_EXPRESSION (&expressions)
#define KIND_DRIVE      (&drives)
#define KIND_LAW        (&laws)

#define KEY_ONE(raw, key, kind)    .value = KIND_##kind
#define KEY_PAIR(raw, key, kind)   .value = KIND_##kind
#define KEY_POINTS(raw, key, kind) .value = KIND_##kind, .count_offset = offsetof(raw, key##_count)
#define KEY_CHOICE(raw, key, list)                                                                 \
    .choices = choices_##list, .choice_count = sizeof choices_##list / sizeof choices_##list[0]
#define KEY_GROUP(raw, key, list) .children = keys_##list, .size = sizeof(struct mpm_raw_##list)
#define KEY_LIST(raw, key, list)                                                                   \
    KEY_GROUP(raw, key, list), .count_offset = offsetof(raw, key##_count)

#define KEY_ROW(list, form, key, content, place, need, units, stand_in, limits, text)              \
    {.name = #key,                                                                                 \
     .shape = MPM_KEY_##form,                                                                      \
     .where = WHERE_##place,                                                                       \
     .required = (need),                                                                           \
     .dimension = MPM_DIMENSION_##units,                                                           \
     .fallback = (stand_in),                                                                       \
     .range = RANGE limits,                                                                        \
     .help = (text),                                                                               \
     .offset = offsetof(struct mpm_raw_##list, key),                                               \
     KEY_##form(struct mpm_raw_##list, key, content)},
#define KEY_TABLE(list)                                                                            \
    static const struct mpm_key keys_##list[] = {KEYS_##list(KEY_ROW, list){.name = NULL}};
MPM_KEY_LISTS(KEY_TABLE)

const struct mpm_key mpm_scene_root = {.name = "",
                                       .shape = MPM_KEY_GROUP,
                                       .children = keys_scene,
                                       .size = sizeof(struct mpm_raw_scene)};
