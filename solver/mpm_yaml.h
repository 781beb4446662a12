/* YAML files by tables of keys: a file becomes a tree that knows the line of each value, the tree
 * is checked against the table, and the values go to C structs. Scenes are read in this way, and
 * the case files of the verification suite. The second header of the public interface; mpm.h does
 * not need it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_YAML_H
#define MPM_YAML_H

#include "mpm.h"

MPM_API_BEGIN

/* ---------------------------------------------------------------- mistakes */

/* The first mistakes of a file, sorted by line: of a --set before those of the file. */
enum { MPM_FAULTS_MAX = 10 };
struct mpm_faults {
    size_t count; /* of all; those beyond MPM_FAULTS_MAX are counted only */
    struct mpm_error list[MPM_FAULTS_MAX];
};

/* As mpm_scene_read, with all mistakes of one kind: of the settings; else of keys and values by
 * themselves; else of grid, time and method together; else of materials, bodies and boundaries; and
 * so on with what needs those before. */
enum mpm_status mpm_scene_read_all(const char *path, const char *const *settings,
                                   size_t setting_count, struct mpm_scene **scene,
                                   struct mpm_faults *faults);

/* -------------------------------------------------------------------- tree */

enum { MPM_TREE_DEPTH_MAX = 64 };

/* Where a value is: a line of the file, the n-th --set, or the default of its key. */
enum { MPM_FROM_FILE = 0, MPM_FROM_DEFAULT = -1 };
struct mpm_origin {
    int setting; /* MPM_FROM_FILE, MPM_FROM_DEFAULT, or 1-based index of a --set */
    int line;    /* 1-based line of the file; 0 if it is from elsewhere */
};

enum mpm_tree_kind { MPM_TREE_SCALAR, MPM_TREE_LIST, MPM_TREE_MAPPING };

struct mpm_tree_entry {
    char *key; /* NULL in lists */
    struct mpm_tree_node *value;
};

struct mpm_tree_node {
    enum mpm_tree_kind kind;
    struct mpm_origin origin; /* of the key, for a value in a mapping */
    bool quoted;              /* scalar in quotes or block style: never a number */
    char *text;               /* scalar */
    struct mpm_tree_entry *entries;
    size_t count, capacity;
};

/* Reads a file of one YAML document. MPM_BAD_INPUT "path:line: message": what is no regular file,
 * larger than 16 MiB, no UTF-8 or no YAML; an empty document, a second one, aliases, anchors, tags,
 * null characters, keys that are no scalars or occur twice, nesting past MPM_TREE_DEPTH_MAX. On
 * failure *root is NULL. O(length log length). */
enum mpm_status mpm_tree_read(const char *path, struct mpm_tree_node **root,
                              struct mpm_error *error);
void mpm_tree_free(struct mpm_tree_node *node);

/* The file of a scene, read again, with the settings of the scene and the defaults of all keys that
 * are missing. Fails as mpm_scene_read if the file has changed. */
enum mpm_status mpm_scene_tree(const struct mpm_scene *scene, struct mpm_tree_node **root,
                               struct mpm_error *error);

/* The node at a path of keys and positions ("bodies.0.region"), or NULL. With `nearest`
 * not NULL also the deepest node on the way. */
const struct mpm_tree_node *mpm_tree_find(const struct mpm_tree_node *root, const char *path,
                                          const struct mpm_tree_node **nearest);

/* -------------------------------------------------------------------- keys */

enum mpm_key_shape {
    MPM_KEY_ONE,    /* a value */
    MPM_KEY_PAIR,   /* two values */
    MPM_KEY_VALUES, /* a list of values */
    MPM_KEY_POINTS, /* a list of pairs */
    MPM_KEY_CHOICE, /* one of some names */
    MPM_KEY_GROUP,  /* a mapping of keys */
    MPM_KEY_LIST,   /* a list of groups */
};

enum mpm_key_where { MPM_ANYWHERE, MPM_ONLY_PLANAR, MPM_ONLY_AXISYMMETRIC };

struct mpm_range {
    double low, high;
    bool low_open, high_open; /* the end itself is not allowed */
};

struct mpm_choice {
    const char *name;
    int value; /* of the enum */
};

struct mpm_key;

enum mpm_stored { MPM_STORED_TEXT, MPM_STORED_INTEGER, MPM_STORED_BOOLEAN };

/* A kind of values. */
struct mpm_value_kind {
    const char *name;           /* in lists of keys: "number" */
    const char *one, *two;      /* in messages: "number", "2 numbers" */
    bool ranged;                /* the key's range bounds the value */
    const char *allowed;        /* another requirement: "up to 64 characters"; may be NULL */
    const char *(*names)(void); /* if only some names are values: "a, b"; may be NULL */
    /* What is wrong with the scalar, or NULL. */
    const char *(*fault)(const struct mpm_key *key, const struct mpm_tree_node *node);
    enum mpm_stored stored;
};

/* A number stays a text in the struct, with its range checked; an integer is an int64_t. A text has
 * a character at least, unless the key's default is empty. */
extern const struct mpm_value_kind mpm_kind_number, mpm_kind_integer, mpm_kind_boolean,
    mpm_kind_text, mpm_kind_name;

/* One key of a table, which ends at name NULL. What it stores at `offset` of the struct of its
 * group, nothing (NULL, 0, false) if it is missing:
 *   ONE     char *, int64_t or bool, as the kind of the value has it
 *   PAIR    an array of two of these
 *   VALUES  a pointer to an array of these, and how many as unsigned at count_offset
 *   POINTS  the same of arrays of two
 *   CHOICE  the value of the choice, an enum as large as int
 *   GROUP   a pointer to a struct of `size` bytes
 *   LIST    a pointer to an array of these, and how many at count_offset */
struct mpm_key {
    const char *name;
    const struct mpm_value_kind *value; /* NULL for CHOICE, GROUP and LIST */
    enum mpm_key_shape shape;
    enum mpm_key_where where; /* geometry of scenes that the key belongs to */
    struct mpm_range range;   /* of values; for VALUES, POINTS and LIST how many */
    const char *fallback;     /* YAML used for a missing key, or NULL */
    const char *help;
    const struct mpm_key *children; /* of a GROUP or of a LIST's entries */
    const struct mpm_choice *choices;
    size_t choice_count;
    size_t offset, count_offset, size;
    struct mpm_dimension dimension;
    bool required;
};

/* Reads a file by a table: `root` is a GROUP, *data a struct of root->size bytes. MPM_BAD_INPUT as
 * mpm_tree_read, and with the path of the key: unknown and missing keys, values of another kind,
 * out of range, or none of the choices. A key `format` is judged before the others. *data is NULL
 * on failure. */
enum mpm_status mpm_keys_read(const char *path, const struct mpm_key *root, void **data,
                              struct mpm_error *error);

/* Frees what mpm_keys_read made, all of it memory of malloc; `data` may be NULL. */
void mpm_keys_free(const struct mpm_key *root, void *data);

MPM_API_END

#endif
