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
void mpm_picture_free(struct mpm_picture *picture);

/* What is computed from fields of snapshots: its name, the field that it is of, and how. */
struct mpm_derived_field {
    const char *name, *field, *description;
    double (*value)(const double *components);
};
extern const struct mpm_derived_field mpm_derived_fields[];
extern const size_t mpm_derived_field_count;

#endif
