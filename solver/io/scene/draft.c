/* Drafts of scenes: a text and settings. The tree of both is kept to judge each setting at once;
 * the scene is read from the text and the settings, as by `mpm run --set`.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/status.h"
#include "io/scene/scene_schema.h"
#include "io/scene/scene_settings.h"

#include <glib.h>
#include <inttypes.h>
#include <math.h>
#include <string.h>

struct mpm_draft {
    char *name, *text;
    size_t length;
    GPtrArray *settings; /* texts PATH=VALUE */
    struct mpm_tree_node *tree;
    struct mpm_error failure; /* of the first setter that failed without *error */
};

static struct mpm_source source_of(const struct mpm_draft *draft)
{
    return (struct mpm_source){.path = draft->name,
                               .what = "scene",
                               .settings = (const char *const *)draft->settings->pdata};
}

enum mpm_status mpm_draft_create(const char *name, const char *text, size_t length,
                                 struct mpm_draft **draft, struct mpm_error *error)
{
    struct mpm_draft *const made = g_new0(struct mpm_draft, 1);
    const struct mpm_origin origin = {.setting = MPM_FROM_FILE};
    *draft = NULL;
    made->name = g_strdup(name);
    made->text = g_malloc(length + 3);
    made->length = text != NULL ? length : 2;
    memcpy(made->text, text != NULL ? text : "{}", made->length);
    made->settings = g_ptr_array_new_with_free_func(g_free);
    const struct mpm_source source = source_of(made);
    const enum mpm_status status =
        mpm_tree_parse(&source, origin, made->text, made->length, &made->tree, error);
    if (status != MPM_OK) {
        mpm_draft_free(made);
        return status;
    }
    *draft = made;
    return MPM_OK;
}

void mpm_draft_free(struct mpm_draft *draft)
{
    if (draft == NULL)
        return;
    mpm_tree_free(draft->tree);
    g_ptr_array_free(draft->settings, TRUE);
    g_free(draft->text);
    g_free(draft->name);
    g_free(draft);
}

/* ----------------------------------------------------------------- settings */

/* The key at a path that has been found to be right. */
static struct mpm_key key_at(const char *path)
{
    char **const segments = g_strsplit(path, ".", -1);
    struct mpm_key key = mpm_scene_root;
    for (size_t k = 0; segments[k] != NULL; k++)
        key = key.shape == MPM_KEY_GROUP ? *mpm_key_find(&key, segments[k]) : mpm_key_entry(&key);
    g_strfreev(segments);
    return key;
}

/* Of a key that is a value, or a list of values, at once; groups are judged when all is there. */
static enum mpm_status check_value(const struct mpm_source *source, size_t index, const char *path,
                                   const char *value, struct mpm_error *error)
{
    const struct mpm_key key = key_at(path);
    const struct mpm_origin origin = {.setting = (int)index + 1};
    struct mpm_tree_node *tree = NULL;
    struct mpm_faults faults = {.count = 0};
    if (value[0] == '\0' || key.shape == MPM_KEY_GROUP || key.shape == MPM_KEY_LIST)
        return MPM_OK;
    MPM_TRY(mpm_tree_parse(source, origin, value, strlen(value), &tree, error));
    const enum mpm_status status = mpm_tree_check(source, &key, tree, &faults, error);
    mpm_tree_free(tree);
    return status;
}

static enum mpm_status refuse_path(const struct mpm_draft *draft, const char *path,
                                   struct mpm_error *error)
{
    char excerpt[MPM_EXCERPT_SIZE];
    return mpm_error_set(error, MPM_BAD_INPUT,
                         "%s: not a path, got %s; allowed: keys joined by points, without '='",
                         draft->name, mpm_excerpt(path, excerpt));
}

/* A setting that was refused may have left entries and groups on its way: the tree is made again,
 * of what has been parsed and applied before. */
static enum mpm_status make_tree_again(struct mpm_draft *draft, struct mpm_error *error)
{
    const struct mpm_origin origin = {.setting = MPM_FROM_FILE};
    const struct mpm_source source = source_of(draft);
    struct mpm_tree_node *tree = NULL;
    struct mpm_faults faults = {.count = 0};
    MPM_TRY(mpm_tree_parse(&source, origin, draft->text, draft->length, &tree, error));
    mpm_tree_free(draft->tree);
    draft->tree = tree;
    return mpm_tree_apply_settings(&source, draft->settings->len, tree, &faults, error);
}

enum mpm_status mpm_draft_set(struct mpm_draft *draft, const char *path, const char *value,
                              struct mpm_error *error)
{
    struct mpm_error own = {.status = MPM_OK};
    const size_t index = draft->settings->len;
    g_ptr_array_add(draft->settings, g_strconcat(path, "=", value, NULL));
    const struct mpm_source source = source_of(draft);
    enum mpm_status status = strchr(path, '=') != NULL
                                 ? refuse_path(draft, path, &own)
                                 : mpm_tree_apply_setting(&source, index, draft->tree, &own);
    if (status == MPM_OK)
        status = check_value(&source, index, path, value, &own);
    if (status == MPM_OK)
        return MPM_OK;
    g_ptr_array_remove_index(draft->settings, (guint)index);
    if (make_tree_again(draft, &draft->failure) != MPM_OK)
        own = draft->failure; /* of memory */
    if (error != NULL)
        *error = own;
    else if (draft->failure.status == MPM_OK)
        draft->failure = own;
    return status;
}

/* --------------------------------------------------------------- typed ones */

enum { NUMBER_SIZE = G_ASCII_DTOSTR_BUF_SIZE };

static void append_number(GString *text, double value)
{
    char digits[NUMBER_SIZE];
    g_string_append(text, isfinite(value) ? g_ascii_formatd(digits, sizeof digits, "%.17g", value)
                          : isnan(value)  ? ".nan"
                          : value > 0.0   ? ".inf"
                                          : "-.inf");
}

/* Sets the text, which it frees. */
static enum mpm_status set_string(struct mpm_draft *draft, const char *path, GString *text,
                                  struct mpm_error *error)
{
    const enum mpm_status status = mpm_draft_set(draft, path, text->str, error);
    g_string_free(text, TRUE);
    return status;
}

enum mpm_status mpm_draft_set_number(struct mpm_draft *draft, const char *path, double value,
                                     struct mpm_error *error)
{
    GString *const text = g_string_new(NULL);
    append_number(text, value);
    return set_string(draft, path, text, error);
}

enum mpm_status mpm_draft_set_integer(struct mpm_draft *draft, const char *path, int64_t value,
                                      struct mpm_error *error)
{
    GString *const text = g_string_new(NULL);
    g_string_printf(text, "%" PRId64, value);
    return set_string(draft, path, text, error);
}

enum mpm_status mpm_draft_set_boolean(struct mpm_draft *draft, const char *path, bool value,
                                      struct mpm_error *error)
{
    return mpm_draft_set(draft, path, value ? "true" : "false", error);
}

/* In double quotes: YAML has escapes for all that is no printable character there. */
enum mpm_status mpm_draft_set_text(struct mpm_draft *draft, const char *path, const char *value,
                                   struct mpm_error *error)
{
    GString *const text = g_string_new("\"");
    for (const char *at = value; *at != '\0'; at++)
        if (*at == '"' || *at == '\\')
            g_string_append_printf(text, "\\%c", *at);
        else if ((unsigned char)*at < ' ' || *at == 0x7f)
            g_string_append_printf(text, "\\x%02x", (unsigned)(unsigned char)*at);
        else
            g_string_append_c(text, *at);
    g_string_append_c(text, '"');
    return set_string(draft, path, text, error);
}

static void append_pair(GString *text, const double pair[2])
{
    g_string_append_c(text, '[');
    append_number(text, pair[0]);
    g_string_append(text, ", ");
    append_number(text, pair[1]);
    g_string_append_c(text, ']');
}

enum mpm_status mpm_draft_set_pair(struct mpm_draft *draft, const char *path, double first,
                                   double second, struct mpm_error *error)
{
    GString *const text = g_string_new(NULL);
    append_pair(text, (const double[2]){first, second});
    return set_string(draft, path, text, error);
}

enum mpm_status mpm_draft_set_points(struct mpm_draft *draft, const char *path,
                                     const double *values, size_t point_count,
                                     struct mpm_error *error)
{
    GString *const text = g_string_new("[");
    for (size_t k = 0; k < point_count; k++) {
        if (k > 0)
            g_string_append(text, ", ");
        append_pair(text, &values[2 * k]);
    }
    g_string_append_c(text, ']');
    return set_string(draft, path, text, error);
}

/* -------------------------------------------------------------------- scene */

enum mpm_status mpm_draft_build(const struct mpm_draft *draft, struct mpm_scene **scene,
                                struct mpm_error *error)
{
    *scene = NULL;
    if (draft->failure.status != MPM_OK)
        return mpm_error_set(error, draft->failure.status, "%s", draft->failure.message);
    return mpm_scene_parse(draft->name, draft->text, draft->length,
                           (const char *const *)draft->settings->pdata, draft->settings->len, scene,
                           error);
}
