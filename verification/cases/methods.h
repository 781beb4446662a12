/* methods.yaml: the one list of algorithm variants that cases run, so that a method has
 * the same name in every case.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_CASES_METHODS_H
#define VERIFICATION_CASES_METHODS_H

#include "verification/cases/catalogue.h"

struct method {
    char *name, *group, *title;
    char **settings; /* of a scene: PATH=VALUE */
    unsigned settings_count;
};

/* A part of methods' names, between underscores. */
struct method_part {
    char *name; /* '?' stands for a digit */
    char *kind; /* shape, order, ... */
    char *title;
};

struct method_table {
    int64_t format;
    struct method_part *parts; /* none, or one for each part of each name */
    unsigned parts_count;
    struct method *methods;
    unsigned methods_count;
};

/* Reads and checks <folder>/methods.yaml; *table is NULL if there is no such file. */
enum mpm_status methods_load(const char *folder, struct method_table **table,
                             struct mpm_error *error);
void methods_free(struct method_table *table);

/* Appends the variants that the file's `methods` selects, in the table's order; the table
 * must outlive them. `path` is that of the case for messages. MPM_BAD_INPUT: a glob that
 * selects nothing, a name that another variant has, a case without a scene. */
enum mpm_status methods_add_variants(const char *path, const struct method_table *table,
                                     struct case_file *file, struct mpm_error *error);

#endif
