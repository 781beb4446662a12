/* Trees of YAML: building and searching, and messages about them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/yaml/tree.h"

#include "base/status.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { PATH_SHOWN_MAX = 400 };

/* ------------------------------------------------------------------- nodes */

struct mpm_tree_node *mpm_tree_new(enum mpm_tree_kind kind, struct mpm_origin origin)
{
    struct mpm_tree_node *node = calloc(1, sizeof *node);
    if (node == NULL)
        return NULL;
    node->kind = kind;
    node->origin = origin;
    return node;
}

void mpm_tree_free(struct mpm_tree_node *node)
{
    if (node == NULL)
        return;
    for (size_t i = 0; i < node->count; i++) { /* nesting is limited, so this ends */
        free(node->entries[i].key);
        mpm_tree_free(node->entries[i].value);
    }
    free(node->entries);
    free(node->text);
    free(node);
}

static bool grow(struct mpm_tree_node *parent)
{
    if (parent->count < parent->capacity)
        return true;
    const size_t capacity = parent->capacity == 0 ? 4 : 2 * parent->capacity;
    struct mpm_tree_entry *entries = realloc(parent->entries, capacity * sizeof *entries);
    if (entries == NULL)
        return false;
    parent->entries = entries;
    parent->capacity = capacity;
    return true;
}

void mpm_tree_remove(struct mpm_tree_node *parent, const struct mpm_tree_node *value)
{
    size_t at = 0;
    while (parent->entries[at].value != value)
        at++;
    free(parent->entries[at].key);
    mpm_tree_free(parent->entries[at].value);
    parent->count--;
    memmove(&parent->entries[at], &parent->entries[at + 1],
            (parent->count - at) * sizeof parent->entries[at]);
}

bool mpm_tree_append(struct mpm_tree_node *parent, const char *key, struct mpm_tree_node *value)
{
    char *copy = key != NULL ? strdup(key) : NULL;
    if (value == NULL || (key != NULL && copy == NULL) || !grow(parent)) {
        free(copy);
        mpm_tree_free(value);
        return false;
    }
    parent->entries[parent->count++] = (struct mpm_tree_entry){.key = copy, .value = value};
    return true;
}

/* ------------------------------------------------------------------ search */

struct mpm_tree_entry *mpm_tree_entry(const struct mpm_tree_node *mapping, const char *key)
{
    if (mapping->kind == MPM_TREE_MAPPING)
        for (size_t i = 0; i < mapping->count; i++)
            if (strcmp(mapping->entries[i].key, key) == 0)
                return &mapping->entries[i];
    return NULL;
}

static const struct mpm_tree_node *child(const struct mpm_tree_node *node, const char *segment)
{
    if (node->kind == MPM_TREE_LIST) {
        const size_t position = (size_t)strtoul(segment, NULL, 10);
        return position < node->count ? node->entries[position].value : NULL;
    }
    const struct mpm_tree_entry *entry = mpm_tree_entry(node, segment);
    return entry != NULL ? entry->value : NULL;
}

const struct mpm_tree_node *mpm_tree_find(const struct mpm_tree_node *root, const char *path,
                                          const struct mpm_tree_node **nearest)
{
    const struct mpm_tree_node *node = root;
    while (node != NULL && *path != '\0') {
        if (nearest != NULL)
            *nearest = node;
        char segment[MPM_EXCERPT_SIZE];
        const size_t length = strcspn(path, ".");
        (void)snprintf(segment, sizeof segment, "%.*s", (int)length, path);
        node = child(node, segment);
        path += length + (path[length] == '.');
    }
    if (nearest != NULL && node != NULL)
        *nearest = node;
    return node;
}

/* ---------------------------------------------------------------- messages */

static const char *source_name(const struct mpm_source *source)
{
    return strcmp(source->path, "-") == 0 ? "standard input" : source->path;
}

enum mpm_status mpm_tree_fault(struct mpm_error *error, const struct mpm_source *source,
                               struct mpm_origin origin, const char *key, const char *format, ...)
{
    char message[MPM_MESSAGE_SIZE], place[MPM_EXCERPT_SIZE + 32] = "", quoted[MPM_EXCERPT_SIZE];
    va_list arguments;
    va_start(arguments, format);
    (void)vsnprintf(message, sizeof message, format, arguments);
    va_end(arguments);
    /* The end of a long path says more than its start, and the message must fit. */
    const char *const name = source_name(source);
    const size_t length = strlen(name);
    const bool cut = length > PATH_SHOWN_MAX;
    if (origin.setting > 0)
        (void)snprintf(place, sizeof place, ": --set %s",
                       mpm_excerpt(source->settings[origin.setting - 1], quoted));
    else if (origin.line > 0)
        (void)snprintf(place, sizeof place, ":%d", origin.line);
    (void)mpm_error_set(error, MPM_BAD_INPUT, "%s%s%s: %s%s%s", cut ? "..." : "",
                        name + (cut ? length - PATH_SHOWN_MAX : 0), place, key,
                        *key != '\0' ? ": " : "", message);
    if (error != NULL)
        error->line = origin.setting > 0 ? 0 : origin.line;
    return MPM_BAD_INPUT;
}

enum mpm_status mpm_faults_note(struct mpm_faults *faults, enum mpm_status status,
                                const struct mpm_error *error)
{
    if (status != MPM_BAD_INPUT)
        return status;
    const size_t kept = faults->count < MPM_FAULTS_MAX ? faults->count : MPM_FAULTS_MAX;
    size_t place = kept;
    while (place > 0 && faults->list[place - 1].line > error->line)
        place--;
    for (size_t i = kept < MPM_FAULTS_MAX ? kept : MPM_FAULTS_MAX - 1; i > place; i--)
        faults->list[i] = faults->list[i - 1];
    if (place < MPM_FAULTS_MAX)
        faults->list[place] = *error;
    faults->count++;
    return MPM_OK;
}

enum mpm_status mpm_faults_status(const struct mpm_faults *faults, struct mpm_error *error)
{
    if (faults->count == 0)
        return MPM_OK;
    if (error != NULL)
        *error = faults->list[0];
    return MPM_BAD_INPUT;
}

const char *mpm_excerpt(const char *text, char buffer[MPM_EXCERPT_SIZE])
{
    const size_t room = MPM_EXCERPT_SIZE - 6; /* two quotes, three dots, the end */
    size_t length = strlen(text);
    const bool cut = length > room;
    if (cut)
        for (length = room; length > 0 && ((unsigned char)text[length] & 0xc0) == 0x80;)
            length--;
    (void)snprintf(buffer, MPM_EXCERPT_SIZE, "\"%.*s%s\"", (int)length, text, cut ? "..." : "");
    return buffer;
}

const char *mpm_tree_excerpt(const struct mpm_tree_node *node, char buffer[MPM_EXCERPT_SIZE])
{
    if (node->kind == MPM_TREE_SCALAR) {
        if (node->text[0] == '\0' && !node->quoted)
            return "nothing";
        return mpm_excerpt(node->text, buffer);
    }
    (void)snprintf(buffer, MPM_EXCERPT_SIZE, "%s of %zu",
                   node->kind == MPM_TREE_LIST ? "a list" : "a mapping", node->count);
    return buffer;
}
