/* Names of units, made of the scene's own units.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_IO_UNITS_H
#define MPM_IO_UNITS_H

#include "model/scene.h"

/* Room for three names of units with their exponents. */
enum { MPM_UNIT_SIZE = 3 * (MPM_NAME_SIZE + 16) };

/* The unit mass^m length^l time^t as text, mass first: exponents -1, 1, -2 in mm,
 * g, ms give "g mm^-1 ms^-2"; all exponents zero give "1". A unit that the scene
 * does not name is called "length", "mass" or "time". */
void mpm_unit_text(const struct mpm_scene *scene, int length, int mass, int time,
                   char text[MPM_UNIT_SIZE]);

#endif
