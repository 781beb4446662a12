/* Riemann's problem of an ideal gas: two constant states that meet at x = 0, t = 0. The solution is
 * one of x/t: a wave to each side, shock or fan, and a contact between them (E. F. Toro, Riemann
 * Solvers and Numerical Methods for Fluid Dynamics, Springer 2009, chapter 4). With c^2 = gamma
 * p/rho, the velocity behind a wave into the state k is v_k -+ f_k(p), f_k zero at p_k:
 *
 *   shock, p > p_k:  f = (p - p_k) sqrt(A/(p + B)),  A = 2/((gamma + 1) rho_k),
 *                    B = (gamma - 1)/(gamma + 1) p_k
 *   fan, p <= p_k:   f = 2 c_k/(gamma - 1) ((p/p_k)^((gamma - 1)/(2 gamma)) - 1)
 *
 * p between the waves is the root of f_L(p) + f_R(p) + v_R - v_L. Sod's tube is one such problem
 * (G. A. Sod, J. Comput. Phys. 27 (1978) 1-31); with mirrored states it is a gas that hits a wall:
 * Noh's problem in the plane (W. F. Noh, J. Comput. Phys. 72 (1987) 78-120).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_EXACT_RIEMANN_H
#define VERIFICATION_EXACT_RIEMANN_H

struct riemann_state {
    double density, velocity, pressure;
};

struct riemann {
    double index;                 /* gamma > 1 */
    struct riemann_state side[2]; /* left and right; density and pressure above 0 */
    double pressure, velocity;    /* between the waves; of riemann_solve */
};

/* Finds pressure and velocity between the waves. NaN where the states part so fast that vacuum is
 * left between them. */
void riemann_solve(struct riemann *problem);

/* The state at x/t. */
struct riemann_state riemann_sample(const struct riemann *problem, double speed);

/* Velocity of the wave into `side` (0, 1) where it meets that side's own state. */
double riemann_front(const struct riemann *problem, int side);

#endif
