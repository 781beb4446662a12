/* The schema of scenes as data, made from scene_keys.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_IO_SCENE_SCHEMA_H
#define MPM_IO_SCENE_SCHEMA_H

#include "io/scene/scene_keys.h"
#include "model/scene.h"

enum {
    MPM_TITLE_LENGTH_MAX = 4096,
    MPM_NAME_LENGTH_MAX = 64, /* characters */
    MPM_POINTS_MAX = 10000,   /* crossing edges are looked for pair by pair */
    MPM_ALLOWED_SIZE = 512,
};

/* ----------------------------------------------------- what libcyaml fills */

/* Numbers stay texts: mpm_number_parse reads them, whatever the locale. A missing
 * OPTIONAL key without default is NULL or 0. */
#define MPM_RAW_NUMBER     char *
#define MPM_RAW_EXPRESSION char *
#define MPM_RAW_DRIVE      char *
#define MPM_RAW_TEXT       char *
#define MPM_RAW_NAME       char *
#define MPM_RAW_LAW        char *
#define MPM_RAW_INTEGER    int64_t
#define MPM_RAW_BOOLEAN    bool

/* NOLINTBEGIN(bugprone-macro-parentheses): declarations */
#define MPM_MEMBER_ONE(key, value)  MPM_RAW_##value key;
#define MPM_MEMBER_PAIR(key, value) MPM_RAW_##value key[2];
#define MPM_MEMBER_POINTS(key, value)                                                              \
    MPM_RAW_##value(**key)[2]; /* libcyaml steps by pointers over pairs */                         \
    unsigned key##_count;
#define MPM_MEMBER_CHOICE(key, value) int key;
#define MPM_MEMBER_GROUP(key, value)  struct mpm_raw_##value *key;
#define MPM_MEMBER_LIST(key, value)                                                                \
    struct mpm_raw_##value *key;                                                                   \
    unsigned key##_count;
/* NOLINTEND(bugprone-macro-parentheses) */
#define MPM_MEMBER(list, shape, key, value, where, need, unit, fallback, range, help)              \
    MPM_MEMBER_##shape(key, value)
#define MPM_RAW_STRUCT(list)                                                                       \
    struct mpm_raw_##list {                                                                        \
        KEYS_##list(MPM_MEMBER, list)                                                              \
    };
MPM_KEY_LISTS(MPM_RAW_STRUCT)

/* libcyaml's schema of a struct mpm_raw_scene. */
struct cyaml_schema_value;
extern const struct cyaml_schema_value mpm_scene_cyaml;

/* ------------------------------------------------------------- description */

enum mpm_key_shape {
    MPM_KEY_ONE,
    MPM_KEY_PAIR,
    MPM_KEY_POINTS,
    MPM_KEY_CHOICE,
    MPM_KEY_GROUP,
    MPM_KEY_LIST,
};

enum mpm_key_value {
    MPM_VALUE_NUMBER,
    MPM_VALUE_EXPRESSION,
    MPM_VALUE_DRIVE, /* an expression or `free` */
    MPM_VALUE_TEXT,
    MPM_VALUE_NAME,
    MPM_VALUE_LAW,
    MPM_VALUE_INTEGER,
    MPM_VALUE_BOOLEAN,
    MPM_VALUE_NONE, /* choices, groups, lists */
};

enum mpm_key_where { MPM_ANYWHERE, MPM_ONLY_PLANAR, MPM_ONLY_AXISYMMETRIC };

struct mpm_range {
    double low, high;
    bool low_open, high_open; /* the end itself is not allowed */
};

struct mpm_choice {
    const char *name;
    int value; /* of the enum it stands for */
};

struct mpm_key {
    const char *name;
    enum mpm_key_shape shape;
    enum mpm_key_value value;
    enum mpm_key_where where;
    bool required;
    struct mpm_dimension dimension;
    const char *fallback;   /* YAML, or NULL */
    struct mpm_range range; /* of values; for POINTS how many */
    const char *help;
    const struct mpm_key *children; /* of a GROUP or of a LIST's entries; ends at name NULL */
    const struct mpm_choice *choices;
    size_t choice_count;
};

/* The scene itself: a GROUP without name. */
extern const struct mpm_key mpm_scene_root;

/* The key of that name in a group or a list's entries, or NULL. */
const struct mpm_key *mpm_key_find(const struct mpm_key *group, const char *name);

/* "2 numbers", "choice", "list": the column `type` of `mpm schema`. */
const char *mpm_key_type(const struct mpm_key *key);

/* "above 0", "classic | ugimp | cpdi", "" if anything goes: the column `range`. */
const char *mpm_key_range(const struct mpm_key *key, char buffer[MPM_ALLOWED_SIZE]);

/* Both in one phrase, for messages: "2 numbers above 0". For a component of a pair:
 * "number above 0". */
const char *mpm_key_allowed(const struct mpm_key *key, bool component,
                            char buffer[MPM_ALLOWED_SIZE]);

/* "a, b, c": the names of a group's keys. */
const char *mpm_key_children(const struct mpm_key *group, char buffer[MPM_ALLOWED_SIZE]);

#endif
