/* Hertz: a smooth elastic sphere of radius R pressed by the force F against a rigid plane, or, by
 * symmetry, against a sphere like it (each of both then comes nearer to the plane between them by
 * the indentation).
 *
 * Surface of a half-space under p(s) = p0 sqrt(1 - s^2/a^2), s < a, by superposition of
 * Boussinesq's point loads, with M = E/(1 - nu^2):
 *     u(r) = 1/(pi M) int p dA/|x - x'| = pi p0 (2 a^2 - r^2)/(4 M a),   r <= a.
 * A sphere that the plane has flattened over r <= a needs u = delta - r^2/(2 R) there, so that
 *     p0 = 2 a M/(pi R),  delta = a^2/R,  F = 2/3 pi a^2 p0 = 4/3 M sqrt(R) delta^(3/2).
 * On the axis, at the depth z, int 3 p z^3/(2 pi rho^5) dA gives sigma_z = -p0/(1 + z^2/a^2).
 *
 * A half-space stands for the sphere: errors are of the order of a/R. The force on the far side is
 * one of them: between two plates, F at the other pole presses the surface by what it does to a
 * half-space at the depth 2 R, (1 + nu)(3 - 2 nu) F/(4 pi E R), so that the indentation is
 *     delta = a^2/R - (1 + nu)(3 - 2 nu) F/(4 pi E R)
 * (as Y. Tatara, J. Eng. Mater. Technol. 113 (1991) 285-291, has it; an estimate, since the
 * half-space has no free sides).
 *
 * Impact at the speed v, slow against the waves in the sphere, so that F(delta) holds at all times:
 * m v^2/2 = 8/15 M sqrt(R) delta_m^(5/2) gives the largest indentation
 *     delta_m = (15 m v^2/(16 M sqrt(R)))^(2/5),
 * and dt = d delta/(v sqrt(1 - (delta/delta_m)^(5/2))) the duration
 *     T = 2 delta_m/v int_0^1 dx/sqrt(1 - x^(5/2)) = 4/5 B(2/5, 1/2) delta_m/v = 2.9433 delta_m/v.
 * The sphere leaves with v.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_EXACT_HERTZ_H
#define VERIFICATION_EXACT_HERTZ_H

struct hertz {
    double radius, young, poisson;
    double mass, speed; /* of an impact */
};

double hertz_modulus(const struct hertz *hertz); /* M, E star of handbooks */

/* At an indentation >= 0. */
double hertz_radius(const struct hertz *hertz, double indentation); /* a */
double hertz_force(const struct hertz *hertz, double indentation);
double hertz_pressure(const struct hertz *hertz, double indentation); /* p0 */

/* The same force between two plates: how near each is to the centre less R, in size. */
double hertz_plates_indentation(const struct hertz *hertz, double radius_of_contact);
/* The other way round, by bisection; for indentations below a tenth of the radius. */
double hertz_plates_radius(const struct hertz *hertz, double indentation);

/* Of an impact. */
double hertz_deepest(const struct hertz *hertz);
double hertz_duration(const struct hertz *hertz);

/* The indentation at a time after first contact, by Runge and Kutta's method with `steps` steps; 0
 * after the duration. */
double hertz_indentation_at(const struct hertz *hertz, double time, unsigned steps);

#endif
