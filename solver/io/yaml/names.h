/* Finding names among many: an index sorted by text, for repeats and look-up.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_IO_YAML_NAMES_H
#define MPM_IO_YAML_NAMES_H

#include <stdbool.h>
#include <stddef.h>

struct mpm_indexed_name {
    const char *text; /* not owned */
    size_t index;
};

/* Sorts by text, equal texts by index. O(n log n). */
void mpm_names_sort(struct mpm_indexed_name *names, size_t count);

/* In a sorted index: does a text occur twice? Gives the indices of the first such pair. */
bool mpm_names_repeat(const struct mpm_indexed_name *names, size_t count, size_t *first,
                      size_t *second);

/* In a sorted index: the index of a text. O(log n). */
bool mpm_names_find(const struct mpm_indexed_name *names, size_t count, const char *text,
                    size_t *index);

#endif
