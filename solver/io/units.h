/* Names of units, made of the scene's own units.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_IO_UNITS_H
#define MPM_IO_UNITS_H

#include "model/scene.h"

/* Room for four names of units with their exponents. */
enum { MPM_UNIT_SIZE = 4 * (MPM_NAME_SIZE + 16) };

/* The unit of a dimension as text, mass first: stress in mm, g, ms gives "g mm^-1 ms^-2"; no
 * dimension gives "1". A unit that the scene does not name is called "length", "mass", "time" or
 * "temperature". */
void mpm_unit_text(const struct mpm_scene *scene, struct mpm_dimension dimension,
                   char text[MPM_UNIT_SIZE]);

/* A dimension as text: "mass/(length time^2)", "1/time"; "" for none. */
void mpm_dimension_text(struct mpm_dimension dimension, char text[MPM_UNIT_SIZE]);

#endif
