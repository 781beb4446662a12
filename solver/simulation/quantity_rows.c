/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "simulation/quantity_rows.h"

/* The place that `index` counts to, and how many there are before it or, past the last, at all. */
static struct mpm_quantity_place find(const struct mpm_quantity_rows *rows,
                                      const struct mpm_scene *scene, size_t index, size_t *counted)
{
    *counted = 0;
    for (size_t member = 0; member < rows->members; member++)
        for (size_t row = 0; row < rows->rows; row++) {
            if (!rows->has(scene, member, row))
                continue;
            if (*counted == index)
                return (struct mpm_quantity_place){member, row};
            ++*counted;
        }
    return (struct mpm_quantity_place){rows->members, rows->rows};
}

size_t mpm_quantity_rows_count(const struct mpm_quantity_rows *rows, const struct mpm_scene *scene)
{
    size_t counted;
    (void)find(rows, scene, SIZE_MAX, &counted);
    return counted;
}

struct mpm_quantity_place mpm_quantity_rows_place(const struct mpm_quantity_rows *rows,
                                                  const struct mpm_scene *scene, size_t index)
{
    size_t counted;
    return find(rows, scene, index, &counted);
}
