/* Quantities of the history in rows of a table, each of which is a column for every member of a
 * group (pairs in contact, cracks) that has it: member by member, in the order of the table.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_SIMULATION_QUANTITY_ROWS_H
#define MPM_SIMULATION_QUANTITY_ROWS_H

#include "simulation/simulation.h"

struct mpm_quantity_rows {
    size_t members, rows;
    bool (*has)(const struct mpm_scene *scene, size_t member, size_t row);
};

/* Where a column comes from. */
struct mpm_quantity_place {
    size_t member, row;
};

/* The number of columns. */
size_t mpm_quantity_rows_count(const struct mpm_quantity_rows *rows, const struct mpm_scene *scene);

/* Of the column `index`, which must be less than that number. */
struct mpm_quantity_place mpm_quantity_rows_place(const struct mpm_quantity_rows *rows,
                                                  const struct mpm_scene *scene, size_t index);

#endif
