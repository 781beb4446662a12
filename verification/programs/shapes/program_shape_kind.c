/* Parameters of the family S; see program_shape_kind.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/programs/shapes/program_shape_kind.h"

#define NAME(name, shape) [shape] = (name),
static const char *const SHAPES[] = {MPM_SHAPES(NAME)};
#undef NAME
static const char *const AXES[] = {
    [MPM_TRUNCATED] = "truncated", [MPM_UNTRUNCATED] = "untruncated", [MPM_PLANAR] = "planar"};

enum mpm_status shape_family_read(const struct measurement *measurement, enum mpm_shape *shape,
                                  struct mpm_error *error)
{
    size_t place;
    TRY(measurement_choice(measurement, "shape", SHAPES, sizeof SHAPES / sizeof *SHAPES, &place,
                           error));
    *shape = (enum mpm_shape)place;
    return MPM_OK;
}

enum mpm_status shape_kind_read(const struct measurement *measurement,
                                struct mpm_shape_query *query, struct mpm_error *error)
{
    size_t axis = MPM_TRUNCATED;
    *query = (struct mpm_shape_query){.shape = MPM_CLASSIC};
    TRY(shape_family_read(measurement, &query->shape, error));
    TRY(measurement_geometry(measurement, &query->geometry, error));
    if (query->geometry == MPM_AXISYMMETRIC)
        TRY(measurement_choice(measurement, "axis", AXES, sizeof AXES / sizeof *AXES, &axis,
                               error));
    query->axis = (enum mpm_axis)axis;
    return MPM_OK;
}
