/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/yaml/names.h"

#include <stdlib.h>
#include <string.h>

static int by_text_and_index(const void *left, const void *right)
{
    const struct mpm_indexed_name *a = left, *b = right;
    const int order = strcmp(a->text, b->text);
    return order != 0 ? order : (a->index > b->index) - (a->index < b->index);
}

bool mpm_names_repeat(struct mpm_indexed_name *names, size_t count, size_t *first, size_t *second)
{
    if (count > 1)
        qsort(names, count, sizeof names[0], by_text_and_index);
    for (size_t i = 1; i < count; i++) {
        if (strcmp(names[i - 1].text, names[i].text) != 0)
            continue;
        *first = names[i - 1].index;
        *second = names[i].index;
        return true;
    }
    return false;
}
