/* The schema of scenes as a table of keys, made from scene_keys.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_IO_SCENE_SCHEMA_H
#define MPM_IO_SCENE_SCHEMA_H

#include "io/scene/scene_keys.h"
#include "io/yaml/keys.h"
#include "model/scene.h"

enum { MPM_POINTS_MAX = 10000 }; /* crossing edges are searched pair by pair */

/* ------------------------------------------------- what a scene's tree fills */

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
    MPM_RAW_##value(*key)[2];                                                                      \
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

/* The scene itself: a GROUP without name, a struct mpm_raw_scene. */
extern const struct mpm_key mpm_scene_root;

#endif
