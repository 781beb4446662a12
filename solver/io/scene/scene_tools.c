/* Tools for building scenes: places of keys, numbers, memory.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/scene/scene_build.h"

#include "base/expression.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A value under the node that a --set gave: it is what made several keys disagree. */
static const struct mpm_tree_node *set_below(const struct mpm_tree_node *node)
{
    if (node->origin.setting > 0)
        return node;
    for (size_t i = 0; i < node->count; i++) {
        const struct mpm_tree_node *found = set_below(node->entries[i].value);
        if (found != NULL)
            return found;
    }
    return NULL;
}

enum mpm_status mpm_reading_fault(const struct mpm_reading *reading, const char *path,
                                  const char *format, ...)
{
    char message[MPM_MESSAGE_SIZE];
    va_list arguments;
    va_start(arguments, format);
    (void)vsnprintf(message, sizeof message, format, arguments);
    va_end(arguments);
    const struct mpm_tree_node *nearest = reading->root;
    (void)mpm_tree_find(reading->root, path, &nearest);
    const struct mpm_tree_node *set = set_below(nearest);
    const struct mpm_source source = mpm_scene_source(reading->scene);
    return mpm_tree_fault(reading->error, &source, (set != NULL ? set : nearest)->origin, path,
                          "%s", message);
}

bool mpm_reading_given(const struct mpm_reading *reading, const char *path)
{
    const struct mpm_tree_node *node = mpm_tree_find(reading->root, path, NULL);
    return node != NULL && node->origin.setting != MPM_FROM_DEFAULT;
}

int mpm_reading_line(const struct mpm_reading *reading, const char *path)
{
    const struct mpm_tree_node *node = mpm_tree_find(reading->root, path, NULL);
    return node != NULL ? node->origin.line : 0;
}

const char *mpm_path_join(const char *path, const char *key, char buffer[MPM_PATH_SIZE])
{
    (void)snprintf(buffer, MPM_PATH_SIZE, "%s.%s", path, key);
    return buffer;
}

const char *mpm_path_entry(const char *list, size_t position, char buffer[MPM_PATH_SIZE])
{
    (void)snprintf(buffer, MPM_PATH_SIZE, "%s.%zu", list, position);
    return buffer;
}

double mpm_raw_double(const char *text)
{
    double value = 0.0;
    if (text != NULL)
        (void)mpm_number_parse(text, &value);
    return value;
}

void *mpm_reading_allocate(const struct mpm_reading *reading, size_t count, size_t size,
                           const char *what)
{
    void *memory = calloc(count > 0 ? count : 1, size);
    if (memory == NULL)
        (void)mpm_error_memory(reading->error, count * size, what);
    return memory;
}

enum mpm_status mpm_reading_copy(const struct mpm_reading *reading, const char *text, char **copy)
{
    *copy = strdup(text);
    return *copy != NULL ? MPM_OK : mpm_error_memory(reading->error, strlen(text) + 1, "a text");
}

enum mpm_status mpm_reading_index(const struct mpm_reading *reading, const char *list, size_t count,
                                  const char *first, size_t stride, struct mpm_indexed_name **names)
{
    *names = NULL;
    struct mpm_indexed_name *index = mpm_reading_allocate(reading, count, sizeof *index, "names");
    if (index == NULL)
        return MPM_ENVIRONMENT_FAILED;
    for (size_t i = 0; i < count; i++)
        index[i] = (struct mpm_indexed_name){.text = first + i * stride, .index = i};
    mpm_names_sort(index, count);
    size_t earlier = 0, later = 0;
    if (!mpm_names_repeat(index, count, &earlier, &later)) {
        *names = index;
        return MPM_OK;
    }
    free(index);
    char path[MPM_PATH_SIZE], name[MPM_EXCERPT_SIZE];
    (void)snprintf(path, sizeof path, "%s.%zu.name", list, later);
    return mpm_reading_fault(reading, path,
                             "name repeated, got %s as in %s.%zu; allowed: a name of its own",
                             mpm_excerpt(first + later * stride, name), list, earlier);
}
