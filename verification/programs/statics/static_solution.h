/* Exact states of rest that the program `statics` holds simulations against, by name.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_PROGRAMS_STATIC_SOLUTION_H
#define VERIFICATION_PROGRAMS_STATIC_SOLUTION_H

#include "verification/programs/programs.h"

enum { STATIC_AXES = 2, STATIC_STRESS = 4 };

/* At one place: displacement along both axes, and Cauchy stress xx yy zz xy or rr zz tt rz. */
struct static_state {
    double displacement[STATIC_AXES];
    double stress[STATIC_STRESS];
    double strain[STATIC_AXES]; /* F_xx - 1, F_yy - 1 */
};

struct static_solution {
    const char *name;                                      /* as in the parameter `solution` */
    double stress_scale, displacement_scale, strain_scale; /* what errors are divided by */
    double numbers[7];                                     /* what the solution was read from */
    double centre[STATIC_AXES];                            /* of a body that nothing holds */
    struct static_state (*at)(const struct static_solution *solution, const double start[2]);
};

/* Reads the parameter `solution` and those that it needs:
 *   end_load     bulk, shear, traction, power; length
 *   rim_load     bulk, shear, traction; length (radius)
 *   plane        the same and centre_x, centre_y: a plane body loaded all around
 *   lame         inner, outer, inner_pressure, outer_pressure, young, poisson
 *   self_weight  height, weight, modulus
 *   thermal      inner, outer, young, poisson, expansion, rise, geometry: thermal_disk.h, around
 *                the origin
 * MPM_BAD_INPUT: no such solution, or none in the range of its root finder. */
enum mpm_status static_solution_read(const struct measurement *measurement,
                                     struct static_solution *solution, struct mpm_error *error);

#endif
