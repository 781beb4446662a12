/* Artificial viscosity of von Neumann and Richtmyer, with Landshoff's linear part: a pressure that
 * spreads shocks over some cells, in compression alone. With the rate of volume D = tr D, the mean
 * ln(J'/J)/dt of a step, h the size of a cell and c the speed of waves,
 *
 *   q = rho h |D| (A_1 c + A_2 h |D|) where D < 0, else 0.
 *
 * h is that of the grid, which does not move with the material, and of cells that are not square
 * the smaller side. Kirchhoff's over the initial density is q J/rho_0 = h |D| (A_1 c + A_2 h |D|).
 * Its work q |D| J dt/rho_0 per mass is never negative.
 *
 * Stable steps: a change of D changes q by rho nu dD, nu = h (A_1 c + 2 A_2 h |D|). A mode of the
 * nodes with frequency w and wave number k has the damping ratio xi = nu k^2/(2 w); stress and
 * viscosity of the step before allow w dt <= 2 (sqrt(1 + xi^2) - xi). The highest mode has k = 2/h,
 * w = c k, and xi = Q/c, Q = A_1 c + 2 A_2 h |D|: the step shrinks as if waves had the speed
 *
 *   c' = Q + sqrt(Q^2 + c^2).
 *
 * (J. von Neumann, R. D. Richtmyer, J. Appl. Phys. 21 (1950) 232-237; R. Landshoff, LA-1930, 1955;
 * T. Belytschko et al., Nonlinear Finite Elements, Wiley 2000, 6.2.)
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_MODEL_VISCOSITY_H
#define MPM_MODEL_VISCOSITY_H

#include <stdbool.h>

/* Of a material. */
struct mpm_viscosity {
    bool given;
    double linear, quadratic; /* A_1 and A_2, at least 0 */
};

/* q J/rho_0, for the cell size h, the speed of waves squared and D. */
double mpm_viscous_pressure(const struct mpm_viscosity *viscosity, double h, double wave_squared,
                            double rate);

/* c'^2; A_1 counts in expansion too, which the next step may end. */
double mpm_viscous_wave_squared(const struct mpm_viscosity *viscosity, double h,
                                double wave_squared, double rate);

#endif
