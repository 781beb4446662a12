/* Parameters of the family S; see program_shape_kind.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/suite/program_shape_kind.h"

#include <math.h>
#include <string.h>

struct choice {
    const char *name;
    int value;
};

static const struct choice SHAPES[] = {{"classic", MPM_CLASSIC},   {"ugimp", MPM_UGIMP},
                                       {"cpdi", MPM_CPDI},         {"bspline2", MPM_BSPLINE2},
                                       {"bspline3", MPM_BSPLINE3}, {NULL, 0}};
static const struct choice GEOMETRIES[] = {{"plane_strain", MPM_PLANE_STRAIN},
                                           {"plane_stress", MPM_PLANE_STRESS},
                                           {"axisymmetric", MPM_AXISYMMETRIC},
                                           {NULL, 0}};
static const struct choice AXES[] = {{"truncated", MPM_TRUNCATED},
                                     {"untruncated", MPM_UNTRUNCATED},
                                     {"planar", MPM_PLANAR},
                                     {NULL, 0}};

static enum mpm_status choice_read(const struct measurement *measurement, const char *parameter,
                                   const struct choice *choices, int *value,
                                   struct mpm_error *error)
{
    const char *text = NULL;
    TRY(measurement_text(measurement, parameter, &text, error));
    for (; choices->name != NULL; choices++) {
        if (strcmp(text, choices->name) == 0) {
            *value = choices->value;
            return MPM_OK;
        }
    }
    return failure_set(error, MPM_BAD_INPUT, "case %s, variant %s: no such %s: \"%s\"",
                       measurement_case(measurement), measurement_variant(measurement), parameter,
                       text);
}

enum mpm_status shape_family_read(const struct measurement *measurement, enum mpm_shape *shape,
                                  struct mpm_error *error)
{
    int value = 0;
    TRY(choice_read(measurement, "shape", SHAPES, &value, error));
    *shape = (enum mpm_shape)value;
    return MPM_OK;
}

enum mpm_status shape_kind_read(const struct measurement *measurement,
                                struct mpm_shape_query *query, struct mpm_error *error)
{
    enum mpm_shape shape;
    int geometry = 0, axis = MPM_TRUNCATED;
    TRY(shape_family_read(measurement, &shape, error));
    TRY(choice_read(measurement, "geometry", GEOMETRIES, &geometry, error));
    if (geometry == MPM_AXISYMMETRIC) {
        TRY(choice_read(measurement, "axis", AXES, &axis, error));
    }
    *query = (struct mpm_shape_query){
        .shape = shape, .geometry = (enum mpm_geometry)geometry, .axis = (enum mpm_axis)axis};
    return MPM_OK;
}

enum mpm_status shape_count_read(const struct measurement *measurement, const char *name,
                                 size_t *count, struct mpm_error *error)
{
    double value = 0;
    TRY(measurement_number(measurement, name, &value, error));
    if (!(value >= 1 && value <= 1e9) || value > floor(value)) {
        return failure_set(error, MPM_BAD_INPUT,
                           "case %s, variant %s: %s is %g, allowed is a whole number 1 to 1e9",
                           measurement_case(measurement), measurement_variant(measurement), name,
                           value);
    }
    *count = (size_t)value;
    return MPM_OK;
}
