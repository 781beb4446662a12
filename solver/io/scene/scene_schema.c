/* The schema of scenes as data.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/scene/scene_schema.h"

#include "model/material.h"

#include <cyaml/cyaml.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* ----------------------------------------------------------------- choices */

#define CHOICE_ROW(text, number)       {.name = (text), .value = (number)},
#define CYAML_CHOICE_ROW(text, number) {.str = (text), .val = (number)},
#define CHOICE_TABLES(list)                                                                        \
    static const struct mpm_choice choices_##list[] = {CHOICES_##list(CHOICE_ROW)};                \
    static const cyaml_strval_t cyaml_choices_##list[] = {CHOICES_##list(CYAML_CHOICE_ROW)};
MPM_CHOICE_LISTS(CHOICE_TABLES)

/* ---------------------------------------------------------- libcyaml's view */

static const cyaml_schema_value_t cyaml_text = {
    CYAML_VALUE_STRING(CYAML_FLAG_POINTER, char, 0, CYAML_UNLIMITED)};
static const cyaml_schema_value_t cyaml_whole = {CYAML_VALUE_INT(CYAML_FLAG_DEFAULT, int64_t)};
static const cyaml_schema_value_t cyaml_point = {
    CYAML_VALUE_SEQUENCE_FIXED(CYAML_FLAG_POINTER, char *, &cyaml_text, 2)};

#define CYAML_NEED_REQUIRED CYAML_FLAG_DEFAULT
#define CYAML_NEED_OPTIONAL CYAML_FLAG_OPTIONAL

#define CYAML_COMPONENT_NUMBER     cyaml_text
#define CYAML_COMPONENT_EXPRESSION cyaml_text
#define CYAML_COMPONENT_DRIVE      cyaml_text
#define CYAML_COMPONENT_INTEGER    cyaml_whole

#define CYAML_ONE_STRING(raw, key, need)                                                           \
    CYAML_FIELD_STRING_PTR(#key, CYAML_FLAG_POINTER | (need), raw, key, 0, CYAML_UNLIMITED),
#define CYAML_ONE_NUMBER(raw, key, need)     CYAML_ONE_STRING(raw, key, need)
#define CYAML_ONE_EXPRESSION(raw, key, need) CYAML_ONE_STRING(raw, key, need)
#define CYAML_ONE_TEXT(raw, key, need)       CYAML_ONE_STRING(raw, key, need)
#define CYAML_ONE_NAME(raw, key, need)       CYAML_ONE_STRING(raw, key, need)
#define CYAML_ONE_LAW(raw, key, need)        CYAML_ONE_STRING(raw, key, need)
#define CYAML_ONE_INTEGER(raw, key, need)    CYAML_FIELD_INT(#key, need, raw, key),
#define CYAML_ONE_BOOLEAN(raw, key, need)    CYAML_FIELD_BOOL(#key, need, raw, key),

#define CYAML_SHAPE_ONE(raw, key, value, need) CYAML_ONE_##value(raw, key, need)
#define CYAML_SHAPE_PAIR(raw, key, value, need)                                                    \
    CYAML_FIELD_SEQUENCE_FIXED(#key, need, raw, key, &CYAML_COMPONENT_##value, 2),
#define CYAML_SHAPE_POINTS(raw, key, value, need)                                                  \
    CYAML_FIELD_SEQUENCE(#key, CYAML_FLAG_POINTER | (need), raw, key, &cyaml_point, 1,             \
                         MPM_POINTS_MAX),
#define CYAML_SHAPE_CHOICE(raw, key, value, need)                                                  \
    CYAML_FIELD_ENUM(#key, CYAML_FLAG_STRICT | (need), raw, key, cyaml_choices_##value,            \
                     CYAML_ARRAY_LEN(cyaml_choices_##value)),
#define CYAML_SHAPE_GROUP(raw, key, value, need)                                                   \
    CYAML_FIELD_MAPPING_PTR(#key, CYAML_FLAG_POINTER | (need), raw, key, cyaml_##value),
#define CYAML_SHAPE_LIST(raw, key, value, need)                                                    \
    CYAML_FIELD_SEQUENCE(#key, CYAML_FLAG_POINTER | (need), raw, key,                              \
                         (&(const cyaml_schema_value_t){CYAML_VALUE_MAPPING(                       \
                             CYAML_FLAG_DEFAULT, struct mpm_raw_##value, cyaml_##value)}),         \
                         0, CYAML_UNLIMITED),

#define CYAML_ROW(list, shape, key, value, where, need, unit, fallback, range, help)               \
    CYAML_SHAPE_##shape(struct mpm_raw_##list, key, value, CYAML_NEED_##need)
#define CYAML_TABLE(list)                                                                          \
    static const cyaml_schema_field_t cyaml_##list[] = {KEYS_##list(CYAML_ROW, list)               \
                                                            CYAML_FIELD_END};
MPM_KEY_LISTS(CYAML_TABLE)

const cyaml_schema_value_t mpm_scene_cyaml = {
    CYAML_VALUE_MAPPING(CYAML_FLAG_POINTER, struct mpm_raw_scene, cyaml_scene)};

/* ----------------------------------------------------------------- our view */

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

#define KEY_ONE(kind)    .value = MPM_VALUE_##kind
#define KEY_PAIR(kind)   .value = MPM_VALUE_##kind
#define KEY_POINTS(kind) .value = MPM_VALUE_##kind
#define KEY_CHOICE(list)                                                                           \
    .value = MPM_VALUE_NONE, .choices = choices_##list,                                            \
    .choice_count = CYAML_ARRAY_LEN(choices_##list)
#define KEY_GROUP(list) .value = MPM_VALUE_NONE, .children = keys_##list
#define KEY_LIST(list)  .value = MPM_VALUE_NONE, .children = keys_##list

#define KEY_ROW(list, form, key, content, place, need, units, stand_in, limits, text)              \
    {.name = #key,                                                                                 \
     .shape = MPM_KEY_##form,                                                                      \
     .where = WHERE_##place,                                                                       \
     .required = (need),                                                                           \
     .dimension = MPM_DIMENSION_##units,                                                           \
     .fallback = (stand_in),                                                                       \
     .range = RANGE limits,                                                                        \
     .help = (text),                                                                               \
     KEY_##form(content)},
#define KEY_TABLE(list)                                                                            \
    static const struct mpm_key keys_##list[] = {KEYS_##list(KEY_ROW, list){.name = NULL}};
MPM_KEY_LISTS(KEY_TABLE)

const struct mpm_key mpm_scene_root = {
    .name = "", .shape = MPM_KEY_GROUP, .value = MPM_VALUE_NONE, .children = keys_scene};

const struct mpm_key *mpm_key_find(const struct mpm_key *group, const char *name)
{
    for (const struct mpm_key *key = group->children; key->name != NULL; key++)
        if (strcmp(key->name, name) == 0)
            return key;
    return NULL;
}

/* ------------------------------------------------------------------ wording */

static const struct {
    const char *one, *pair;
} value_names[] = {
    [MPM_VALUE_NUMBER] = {"number", "2 numbers"},
    [MPM_VALUE_EXPRESSION] = {"expression", "2 expressions"},
    [MPM_VALUE_DRIVE] = {"expression or free", "2 expressions or free"},
    [MPM_VALUE_TEXT] = {"text", "2 texts"},
    [MPM_VALUE_NAME] = {"name", "2 names"},
    [MPM_VALUE_LAW] = {"choice", "2 choices"},
    [MPM_VALUE_INTEGER] = {"integer", "2 integers"},
    [MPM_VALUE_BOOLEAN] = {"boolean", "2 booleans"},
    [MPM_VALUE_NONE] = {"", ""},
};

const char *mpm_key_type(const struct mpm_key *key)
{
    switch (key->shape) {
    case MPM_KEY_ONE:
        return value_names[key->value].one;
    case MPM_KEY_PAIR:
        return value_names[key->value].pair;
    case MPM_KEY_POINTS:
        return "list of 2 numbers";
    case MPM_KEY_CHOICE:
        return "choice";
    case MPM_KEY_GROUP:
        return "mapping";
    case MPM_KEY_LIST:
        return "list of mappings";
    }
    return "";
}

/* Writes numbers as a person would: 2147483648, 0.5. */
static void range_text(const struct mpm_range *range, char *buffer, size_t size)
{
    if (isinf(range->low) && isinf(range->high))
        (void)snprintf(buffer, size, "%s", "");
    else if (range->low == range->high)
        (void)snprintf(buffer, size, "%.16g", range->low);
    else if (isinf(range->high))
        (void)snprintf(buffer, size, "%s %.16g", range->low_open ? "above" : "at least",
                       range->low);
    else if (range->high_open)
        (void)snprintf(buffer, size, "between %.16g and %.16g, both excluded", range->low,
                       range->high);
    else if (range->low_open)
        (void)snprintf(buffer, size, "above %.16g, up to %.16g", range->low, range->high);
    else
        (void)snprintf(buffer, size, "from %.16g to %.16g", range->low, range->high);
}

static void choices_text(const struct mpm_key *key, char *buffer, size_t size)
{
    size_t used = 0;
    for (size_t i = 0; i < key->choice_count && used < size; i++)
        used += (size_t)snprintf(buffer + used, size - used, "%s%s", i > 0 ? " | " : "",
                                 key->choices[i].name);
}

const char *mpm_key_range(const struct mpm_key *key, char buffer[MPM_ALLOWED_SIZE])
{
    buffer[0] = '\0';
    if (key->shape == MPM_KEY_CHOICE)
        choices_text(key, buffer, MPM_ALLOWED_SIZE);
    else if (key->shape == MPM_KEY_POINTS)
        (void)snprintf(buffer, MPM_ALLOWED_SIZE, "%.16g to %.16g points", key->range.low,
                       key->range.high);
    else if (key->value == MPM_VALUE_LAW)
        (void)snprintf(buffer, MPM_ALLOWED_SIZE, "%s", mpm_material_law_names());
    else if (key->value == MPM_VALUE_BOOLEAN)
        (void)snprintf(buffer, MPM_ALLOWED_SIZE, "true | false");
    else if (key->value == MPM_VALUE_NAME)
        (void)snprintf(buffer, MPM_ALLOWED_SIZE, "up to %d characters", MPM_NAME_LENGTH_MAX);
    else if (key->value == MPM_VALUE_TEXT)
        (void)snprintf(buffer, MPM_ALLOWED_SIZE, "up to %d characters", MPM_TITLE_LENGTH_MAX);
    else if (key->value == MPM_VALUE_NUMBER || key->value == MPM_VALUE_INTEGER)
        range_text(&key->range, buffer, MPM_ALLOWED_SIZE);
    return buffer;
}

const char *mpm_key_allowed(const struct mpm_key *key, bool component,
                            char buffer[MPM_ALLOWED_SIZE])
{
    char range[MPM_ALLOWED_SIZE];
    (void)mpm_key_range(key, range);
    const char *type = component ? value_names[key->value].one : mpm_key_type(key);
    if (strcmp(type, "choice") == 0 || key->value == MPM_VALUE_BOOLEAN)
        type = "";
    const char *between = type[0] != '\0' && range[0] != '\0' ? " " : "";
    (void)snprintf(buffer, MPM_ALLOWED_SIZE, "%s%s%.400s", type, between, range);
    return buffer;
}

const char *mpm_key_children(const struct mpm_key *group, char buffer[MPM_ALLOWED_SIZE])
{
    size_t used = 0;
    for (const struct mpm_key *key = group->children; key->name != NULL; key++)
        if (used < MPM_ALLOWED_SIZE)
            used += (size_t)snprintf(buffer + used, MPM_ALLOWED_SIZE - used, "%s%s",
                                     used > 0 ? ", " : "", key->name);
    return buffer;
}
