/* Names that occur twice among many.
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

/* Does a text occur twice? Gives the indices of the first such pair in the order of the texts;
 * sorts the names. O(n log n). */
bool mpm_names_repeat(struct mpm_indexed_name *names, size_t count, size_t *first, size_t *second);

#endif
