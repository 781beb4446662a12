/* What the measuring programs of family S have in common: the variant's family, geometry
 * and axis.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_PROGRAMS_SHAPES_PROGRAM_SHAPE_KIND_H
#define VERIFICATION_PROGRAMS_SHAPES_PROGRAM_SHAPE_KIND_H

#include "verification/programs/programs.h"

/* Fills shape, geometry and axis of *query from the parameters `shape` (classic, ugimp,
 * cpdi, bspline2, bspline3), `geometry` (plane_strain, plane_stress, axisymmetric) and `axis`
 * (truncated, untruncated, planar; axisymmetric only). Any other name is MPM_BAD_INPUT. */
enum mpm_status shape_kind_read(const struct measurement *measurement,
                                struct mpm_shape_query *query, struct mpm_error *error);

/* The parameter `shape` alone. */
enum mpm_status shape_family_read(const struct measurement *measurement, enum mpm_shape *shape,
                                  struct mpm_error *error);

enum { SHAPE_COUNT_MAX = 1000000000 }; /* of samples, say */

#endif
