/* Stress intensity of a crack in the shape of a disk of radius a, across the axis of a long
 * cylinder of radius b under tension sigma.
 *
 * In an infinite body (I. N. Sneddon, Proc. R. Soc. A 187 (1946) 229-260):
 *     K_I = 2 sigma sqrt(a/pi).
 * In the cylinder it is that times
 *     F = (1 + x/2 - 5 x^2/8 + 0.421 x^3) sqrt(1 - x)/(1 - x^2),   x = a/b,
 * an interpolation between the limits of small and large cracks, better than 1 % (J. P. Benthem, W.
 * T. Koiter, in: G. C. Sih (ed.), Methods of Analysis and Solutions of Crack Problems, Noordhoff
 * 1973, 131-178; Tada, Paris and Irwin, Handbook, sec. 27.1).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_EXACT_PENNY_CRACK_H
#define VERIFICATION_EXACT_PENNY_CRACK_H

struct penny_crack {
    double radius, outer; /* a, b */
    double stress;        /* sigma */
};

double penny_crack_infinite(const struct penny_crack *crack);
double penny_crack_cylinder(const struct penny_crack *crack);

#endif
