/* The J integral around the tip of a crack, and stress intensity factors: Guo and Nairn 2004, with
 * N&G 3.2 for axisymmetry; at finite deformation, of the undeformed body.
 *
 * What a tip gives off per area of growth, along an axis k of the undeformed body, is the integral
 * around it along a contour that starts and ends on the faces of the crack,
 *     J_k = int [ (W + K) N_k - P_iJ N_J u_i,k ] dS + int rho_0 [ (a - b)_i u_i,k - v_i v_i,k ] dA,
 * W strain energy and K kinetic energy per undeformed volume, P the first Piola stress, u_i,k =
 * F_ik - delta_ik, a acceleration, b body force, A what the contour surrounds. With N dS =
 * F^T n ds / J_2, J_2 the determinant of the plane part of F, and P = tau F^-T it is one along
 * grid lines in the deformed body,
 *     int [ e F_mk n_m - s_im n_m u_i,k ] ds,     e = (W + K)/J_2,     s = tau/J_2,
 * at any deformation, as long as the material is elastic and the same all around, the crack
 * straight where it was undeformed, and its faces free of tractions. J_1 is along the crack, and
 * does not depend on the contour. J_2, on the left of it, does where the energies of both faces
 * differ (mixed modes with a stress along the crack): what the faces add is not in it.
 *
 * rho_0 (a - b) is the divergence of the stress: the internal force of the nodes over their mass.
 * So it is there at t = 0 too, and loads need not be known. Without `dynamic`, K, a and v are 0.
 *
 * Axisymmetry, per length of the crack's front, at the radius a; R radii of the undeformed body,
 * P_tt and u/R in the hoop direction; any direction of the crack, k = R and Z, radial ones in the
 * papers. The divergence of [ ... ] in polar coordinates leaves area terms behind:
 *     Bergkvist and Huong 1977, a virtual growth by the same length everywhere inside:
 *       J_k = 1/a ( int R [...] dS - delta_kR int (W + K - P_tt u/R) dA + int R rho_0 [...] dA )
 *     Broberg 1999, p. 65, the planar integrand:
 *       J_k = int [...] dS - int 1/R (P_iR u_i,k - delta_kR P_tt u/R) dA + int rho_0 [...] dA
 * Both are exact; sums over particles and nodes make the difference.
 *
 * Free strain e that varies from place to place (law_state.h: W is that of F exp(-e)) is one more
 * thing that W depends on: dW/de = -tr tau at constant F, tau in all three directions, and the
 * divergence of [...] has -tr(tau) e,k. So J has, in every form, with the weight of the term with
 * rho_0 (W. K. Wilson, I.-W. Yu, Int. J. Fract. 15 (1979) 377-387, at small strain)
 *     + int tr(tau) e,k dA,   e,k along axes of the undeformed body,
 * at any deformation: e,k = F_mk de/dx_m, and that of means at the nodes, by the fields of the
 * step. With heat of deformation W is still the one at constant temperature.
 *
 * u_i,k in products with stress may be (F - C)_ik with any constant C, since forces on the contour,
 * inertia and body forces balance; in axisymmetry P_tt u/R delta_kR becomes P_tt (u/R delta_kR -
 * (C - I)_Rk) then. C is the mean of F on the contour, so that a body that turns as a whole is not
 * asked for a balance of forces far better than its stresses are. Axisymmetry without area terms
 * (form: contour) keeps C = I.
 *
 * The contour is a rectangle of grid lines, so many cells from the node nearest to the tip. Stress,
 * F - I and energy come to its nodes as means over particles with the weights A_p S_ip, by velocity
 * fields as the step has them: for each particle and node, from which side the crack is crossed.
 * Between two nodes values are linear; where the crack passes between them, those of the field
 * above meet there with their like, and so below. Area terms are sums over particles, each with the
 * part of its weights that lies inside (nodes on the contour count half).
 *
 * K_I and K_II are those of an interaction integral over the particles in the rectangle
 * (stress_intensity.h). J_1 = (K_I^2 + K_II^2)/E', E' = E in plane stress, else E/(1 - nu^2), holds
 * as well as both are known: a crack of nodes and particles acts as one that is longer by a part of
 * a cell, which J has in full; K is that of the field around the place where the chain ends.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_J_INTEGRAL_H
#define MPM_METHOD_J_INTEGRAL_H

#include "method/cracks/j_contour.h"
#include "method/state.h"

/* Scratch memory. */
struct mpm_j_scratch {
    struct mpm_j_node *nodes;     /* as many as the largest contour needs */
    struct mpm_crack_part *parts; /* per crack */
};
size_t mpm_j_nodes(const struct mpm_j_integral_spec *spec);

struct mpm_j_value {
    double j[2];
    double stress_intensity[2];
    size_t met; /* the crack because of which there is no value, or SIZE_MAX */
};

/* The rectangle that the contour is around a tip there. */
void mpm_j_contour_box(const struct mpm_state *state, const struct mpm_j_integral_spec *spec,
                       const double tip[2], struct mpm_crack_box *box);

/* MPM_RUN_FAILED, with the reason: the contour leaves the grid or the bodies, or reaches the axis;
 * there is more than one material in it; it meets or surrounds another crack, or meets its own
 * other than once; a particle of CPDI near it is longer than a cell to one side. Cost: a test of
 * each particle (CPDI: its corners); a stencil of each particle within the contour or six cells of
 * it, and another one where there is an area term. */
enum mpm_status mpm_j_evaluate(const struct mpm_state *state,
                               const struct mpm_j_integral_spec *spec, const struct mpm_j_tip *tip,
                               const struct mpm_j_scratch *scratch, struct mpm_j_value *value,
                               struct mpm_error *error);

#endif
