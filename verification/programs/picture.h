/* Pictures of particles for the figures of a case: a field of the moment as a matrix of pixels,
 * which gnuplot draws `matrix with image`, and the points of the cracks.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_PROGRAMS_PICTURE_H
#define VERIFICATION_PROGRAMS_PICTURE_H

#include "verification/programs/programs.h"

struct picture {
    double from[2], to[2], pixel;
    bool axisymmetric; /* set by the caller, as is: width of particles over height at t = 0, 0: 1 */
    double aspect;
};

/* The variant's parameter `picture`, "x y x y pixel": lower left and upper right corner and the
 * side of a pixel; *asked: whether there is one. MPM_BAD_INPUT: it is something else. */
enum mpm_status picture_read(const struct measurement *measurement, struct picture *picture,
                             bool *asked, struct mpm_error *error);

/* Writes the series <name> (a row of numbers for each row of pixels, upwards; RASTER_EMPTY where
 * there is no particle) of a component of a field, and, in scenes with cracks, <name>-cracks (x, y,
 * crack). Of axisymmetric scenes and planar ones with thickness 1. */
enum mpm_status picture_write(struct measurement *measurement, const struct picture *picture,
                              const struct mpm_simulation *simulation, enum mpm_field field,
                              size_t component, const char *name, struct mpm_error *error);

#endif
