/* Rows of tables of keys for the suite's YAML files (struct mpm_key).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_CASES_YAML_READ_H
#define VERIFICATION_CASES_YAML_READ_H

#include "mpm_yaml.h"

#include <math.h>
#include <stddef.h>

enum { YAML_LIST_MAX = 1000 };

#define YAML_RANGE(from, to) .range = {.low = (from), .high = (to)}
#define YAML_KEY(key, form, must, type, member, ...)                                               \
    {                                                                                              \
        .name = (key), .shape = MPM_KEY_##form, .required = (must),                                \
        .offset = offsetof(struct type, member), __VA_ARGS__                                       \
    }
#define YAML_KIND(kind) .value = &mpm_kind_##kind, YAML_RANGE(-HUGE_VAL, HUGE_VAL)

/* A text of at least one character, a number as text, and where they may be left out. */
#define YAML_TEXT(key, type, member) YAML_KEY(key, ONE, true, type, member, YAML_KIND(text))
#define YAML_OPTIONAL_TEXT(key, type, member)                                                      \
    YAML_KEY(key, ONE, false, type, member, YAML_KIND(text))
#define YAML_NUMBER(key, type, member) YAML_KEY(key, ONE, true, type, member, YAML_KIND(number))
#define YAML_OPTIONAL_NUMBER(key, type, member)                                                    \
    YAML_KEY(key, ONE, false, type, member, YAML_KIND(number))
#define YAML_TWO_NUMBERS(key, type, member)                                                        \
    YAML_KEY(key, PAIR, true, type, member, YAML_KIND(number))

/* Whole numbers from low to high; the second form may be left out and is 0 then. */
#define YAML_INTEGER(key, type, member, low, high)                                                 \
    YAML_KEY(key, ONE, true, type, member, .value = &mpm_kind_integer, YAML_RANGE(low, high))
#define YAML_OPTIONAL_INTEGER(key, type, member, low, high)                                        \
    YAML_KEY(key, ONE, false, type, member, .value = &mpm_kind_integer, YAML_RANGE(low, high))
#define YAML_TWO_INTEGERS(key, type, member, low, high)                                            \
    YAML_KEY(key, PAIR, true, type, member, .value = &mpm_kind_integer, YAML_RANGE(low, high))

/* True or false, or left out, which is false. */
#define YAML_FLAG(key, type, member) YAML_KEY(key, ONE, false, type, member, YAML_KIND(boolean))

/* One of a table of struct mpm_choice. */
#define YAML_CHOICE(key, must, type, member, table)                                                \
    YAML_KEY(key, CHOICE, must, type, member, .choices = (table),                                  \
             .choice_count = sizeof(table) / sizeof(table)[0])

/* A list of at least so many texts, or groups; it may be left out if that is 0. */
#define YAML_TEXTS(key, type, member, least)                                                       \
    YAML_KEY(key, VALUES, (least) > 0, type, member, .value = &mpm_kind_text,                      \
             .count_offset = offsetof(struct type, member##_count),                                \
             YAML_RANGE(least, YAML_LIST_MAX))
#define YAML_LIST(key, type, member, entry, keys, least)                                           \
    YAML_KEY(key, LIST, (least) > 0, type, member, .children = (keys),                             \
             .size = sizeof(struct entry), .count_offset = offsetof(struct type, member##_count),  \
             YAML_RANGE(least, YAML_LIST_MAX))

/* A group that may be left out. */
#define YAML_GROUP(key, type, member, entry, keys)                                                 \
    YAML_KEY(key, GROUP, false, type, member, .children = (keys), .size = sizeof(struct entry))

#define YAML_END                                                                                   \
    {                                                                                              \
        .name = NULL                                                                               \
    }

/* A whole file. */
#define YAML_FILE(entry, keys)                                                                     \
    {                                                                                              \
        .name = "", .shape = MPM_KEY_GROUP, .children = (keys), .size = sizeof(struct entry)       \
    }

#endif
