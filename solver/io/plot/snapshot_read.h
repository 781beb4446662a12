/* One snapshot read for a picture: outlines of the particles' domains, and a value of each.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_IO_SNAPSHOT_READ_H
#define MPM_IO_SNAPSHOT_READ_H

#include "mpm.h"

#include <glib.h>

struct mpm_picture {
    size_t count;
    double (*corners)[4][2]; /* of the domains, around them */
    double *values;
    double time;
    char *title, *unit, *unit_length, *unit_time;
    bool axisymmetric;
};

/* Reads `field` of the snapshot at `path`. MPM_BAD_INPUT: no snapshot of `mpm run`, no such field;
 * the message has those allowed. The caller frees what there is, also on failure. */
enum mpm_status mpm_picture_read(const char *path, const char *field, struct mpm_picture *picture,
                                 struct mpm_error *error);
/* Adds the names that mpm_picture_read takes of the snapshot at `path`, a line each: fields or
 * their components, and what is computed from them. Names that are more than letters, digits and
 * '_' are left out: shells read the list. MPM_BAD_INPUT: no snapshot. */
enum mpm_status mpm_picture_names(const char *path, GString *names, struct mpm_error *error);
/* A line for each component in "xx, yy" that has none yet, after the name of the field. */
void mpm_component_names(const char *field, const char *components, GString *names);
void mpm_picture_free(struct mpm_picture *picture);

/* What is computed from fields of snapshots: its name, the field that it is of, and how. */
struct mpm_derived_field {
    const char *name, *field, *description;
    double (*value)(const double *components);
};
extern const struct mpm_derived_field mpm_derived_fields[];
extern const size_t mpm_derived_field_count;

#endif
