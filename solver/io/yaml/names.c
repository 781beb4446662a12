/* Finding names among many. SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/yaml/names.h"

#include <stdlib.h>
#include <string.h>

static int by_text(const void *left, const void *right)
{
    const struct mpm_indexed_name *a = left, *b = right;
    return strcmp(a->text, b->text);
}

static int by_text_and_index(const void *left, const void *right)
{
    const struct mpm_indexed_name *a = left, *b = right;
    const int order = by_text(left, right);
    return order != 0 ? order : (a->index > b->index) - (a->index < b->index);
}

void mpm_names_sort(struct mpm_indexed_name *names, size_t count)
{
    if (count > 1)
        qsort(names, count, sizeof names[0], by_text_and_index);
}

bool mpm_names_repeat(const struct mpm_indexed_name *names, size_t count, size_t *first,
                      size_t *second)
{
    for (size_t i = 1; i < count; i++) {
        if (strcmp(names[i - 1].text, names[i].text) != 0)
            continue;
        *first = names[i - 1].index;
        *second = names[i].index;
        return true;
    }
    return false;
}

bool mpm_names_find(const struct mpm_indexed_name *names, size_t count, const char *text,
                    size_t *index)
{
    if (count == 0)
        return false;
    const struct mpm_indexed_name wanted = {.text = text};
    const struct mpm_indexed_name *found = bsearch(&wanted, names, count, sizeof names[0], by_text);
    if (found == NULL)
        return false;
    *index = found->index;
    return true;
}
