/* Tools for building scenes: places of keys, numbers, memory.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/scene/scene_build.h"

#include "base/status.h"
#include "io/yaml/names.h"
#include "mpm_expression.h"

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

enum mpm_status mpm_reading_note(const struct mpm_reading *reading, enum mpm_status status)
{
    return mpm_faults_note(reading->faults, status, reading->error);
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

struct mpm_path mpm_path_join(const char *path, const char *key)
{
    struct mpm_path joined;
    (void)snprintf(joined.text, sizeof joined.text, "%s.%s", path, key);
    return joined;
}

struct mpm_path mpm_path_entry(const char *list, size_t position)
{
    struct mpm_path joined;
    (void)snprintf(joined.text, sizeof joined.text, "%s.%zu", list, position);
    return joined;
}

double mpm_raw_double(const char *text)
{
    double value = 0.0;
    if (text != NULL)
        (void)mpm_number_parse(text, &value);
    return value;
}

enum mpm_status mpm_reading_allocate(const struct mpm_reading *reading, size_t count, size_t size,
                                     const char *what, void *array)
{
    void *const memory = calloc(count > 0 ? count : 1, size);
    memcpy(array, &memory, sizeof memory);
    /* cppcheck-suppress memleak ; the caller's pointer has it */
    return memory != NULL ? MPM_OK : mpm_error_memory(reading->error, count * size, what);
}

enum mpm_status mpm_reading_copy(const struct mpm_reading *reading, const char *text, char **copy)
{
    *copy = strdup(text);
    return *copy != NULL ? MPM_OK : mpm_error_memory(reading->error, strlen(text) + 1, "a text");
}

enum mpm_status mpm_reading_check_names(const struct mpm_reading *reading, const char *list,
                                        size_t count, const char *first, size_t stride)
{
    struct mpm_indexed_name *names;
    MPM_TRY(mpm_reading_allocate(reading, count, sizeof *names, "names", &names));
    for (size_t i = 0; i < count; i++)
        names[i] = (struct mpm_indexed_name){.text = first + i * stride, .index = i};
    size_t earlier, later;
    const bool repeated = mpm_names_repeat(names, count, &earlier, &later);
    free(names);
    if (!repeated)
        return MPM_OK;
    char name[MPM_EXCERPT_SIZE];
    return mpm_reading_fault(reading, mpm_path_join(mpm_path_entry(list, later).text, "name").text,
                             "name repeated, got %s as in %s.%zu; allowed: a name of its own",
                             mpm_excerpt(first + later * stride, name), list, earlier);
}
