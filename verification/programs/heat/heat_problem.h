/* What program_heat holds temperatures against: an exact field and its parameters.
 *
 * With v one of the fields of heat.h, at the place (x - origin)/length along an axis or from a
 * centre:
 *
 *   driven   T = scale v(frequency)                           NAFEMS T3
 *   held     T = start + scale v                              a surface held at start + scale
 *   flux     T = start + scale v                              scale = q a/k
 *   wave     T = scale sin(p x + q y + phase) exp(-decay t)   manufactured, by the scene's source
 *   product  T = scale cos(p x) cos(q y) exp(-decay t)        manufactured, insulated at whole p, q
 *   ramp     T = scale (phase + p x + q y) exp(-decay t)      manufactured, linear
 *   convection  T = start + scale v(b)                     heat_edges.h
 *   radiation   T = v(start, rate)                         a body of one temperature
 *   mode     T = scale v                                      first mode of a sphere
 *   spot     T = start + scale v                              a hot spot, in material coordinates:
 *                                                             of the place at t = 0
 *   passing  T = scale v(speed)                               a rod through a held place
 *   steady   T = start + scale v                              linear in the place
 *   kept     T = that of the particle at t = 0
 *
 * With `table`, points "T k T k ..." of a conductivity, T - start above is the rise of Kirchhoff's
 * theta over that of start, and T follows from it (kirchhoff.h).
 *
 * With `material`: 1, places above are those at t = 0: of a body that moves.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_PROGRAMS_HEAT_PROBLEM_H
#define VERIFICATION_PROGRAMS_HEAT_PROBLEM_H

#include "verification/exact/heat/heat.h"
#include "verification/exact/kirchhoff.h"
#include "verification/programs/programs.h"

enum { HEAT_AXES = 2 };

enum heat_kind {
    HEAT_DRIVEN,
    HEAT_HELD,
    HEAT_FLUX,
    HEAT_CONVECTION,
    HEAT_RADIATION,
    HEAT_WAVE,
    HEAT_PRODUCT,
    HEAT_RAMP,
    HEAT_MODE,
    HEAT_SPOT,
    HEAT_PASSING,
    HEAT_STEADY,
    HEAT_KEPT,
    HEAT_KINDS
};

struct heat_problem {
    enum heat_kind kind;
    enum heat_body body;
    double scale, start, length, origin, diffusivity;
    double frequency;    /* over pi */
    double p, q, phase;  /* over pi, but for a ramp */
    double decay, probe; /* probe over the length */
    double center[HEAT_AXES], width, second,
        angle; /* of a spot; diffusivity along its other axis */
    double speed, cell;
    double b, rate;  /* of convection, of radiation */
    double material; /* not 0: fields are in the places at t = 0 */
    double from, to; /* of places at t = 0 */
    unsigned along;
    struct kirchhoff table; /* without points: none */
};

enum mpm_status heat_problem_read(const struct measurement *measurement,
                                  struct heat_problem *problem, struct mpm_error *error);

/* x/a or r/a */
double heat_problem_place(const struct heat_problem *problem, const double position[HEAT_AXES]);

/* The temperature that a particle should have; at_start: what it had at t = 0. */
double heat_problem_exact(const struct heat_problem *problem, const double start[HEAT_AXES],
                          const double position[HEAT_AXES], double time, double at_start);

#endif
