/* The field that a picture shows, computed from what particles carry.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_SUITE_PICTURE_FIELD_H
#define VERIFICATION_SUITE_PICTURE_FIELD_H

#include "verification/cases/catalogue.h"

#include <jansson.h>

struct picture_field_info {
    const char *name, *title; /* "von_mises", "von Mises stress" */
    struct mpm_dimension dimension;
    bool is_signed; /* zero is its middle: pressure is, speed is not */
};
const struct picture_field_info *picture_field_describe(enum picture_field field);

/* What matters to the scene's laws: plastic strain, the pressure of an equation of state, a
 * temperature or concentration that is asked for, or else the von Mises stress. */
enum picture_field picture_field_by_law(const struct mpm_scene *scene);

/* The values of all particles by id, in `values`; `start` has their positions at t = 0. */
void picture_field_values(const struct mpm_simulation *simulation, enum picture_field field,
                          const double *start, double *values);

/* The unit in the scene's own units: "MPa" of mm, g and ms, else as "g mm⁻¹ ms⁻²"; "1" for none.
 * g_free. `units` is the mapping of the scene. */
char *picture_field_unit(const json_t *units, struct mpm_dimension dimension);

#endif
