/* Stress intensity factors of a crack's tip by an interaction integral: J. F. Yau, S. S. Wang,
 * H. T. Corten, J. Appl. Mech. 47 (1980) 335-341, as an integral over an area (C. F. Shih,
 * R. J. Asaro, J. Appl. Mech. 55 (1988) 299-316).
 *
 * At small strain J is quadratic in the field around the tip. So the J of the sum of two fields has
 * a mixed term M beside the J of each. The one field is that of the body: displacement u, stress s.
 * The other, auxiliary one is known: the static field of a tip with the factors A_I and A_II (M. L.
 * Williams, J. Appl. Mech. 24 (1957) 109-114), displacement a, stress t. With J = (K_I^2 +
 * K_II^2)/E', that gives M = 2 (K_I A_I + K_II A_II)/E', for each mode on its own. As an integral
 * along a contour that shrinks to the tip, which has the normal n,
 *     M = lim int [ s_kl a_k,l n_1 - s_ik n_k a_i,1 - t_ik n_k u_i,1 ] dS,
 * 1 being the direction of the crack and 2 on the left of it. Let q be 1 at the tip and 0 on the
 * edge of an area around it. The divergence of q times the bracket has these parts:
 *     s_ik,k = rho (v' - b)_i, v' acceleration, b body force;   t_ik,k = 0;
 *     s_ik a_i,1k + t_ik u_i,1k = (s_kl a_k,l),1, both fields having the same moduli.
 * So
 *     M = int { [ s_ik a_i,1 + t_ik u_i,1 - s_lm a_l,m delta_1k ] q,k + rho (v' - b)_i a_i,1 q } dA
 *         - int_faces s_ik n_k a_i,1 q dS,
 * whatever q and the area are. Kinetic energy has no mixed term, since a does not move. So M is
 * that of the field at the tip while waves pass, too, as long as the tip does not move: near a
 * tip that moves, the body's field is another one than Williams', by the order of (speed of the
 * tip over that of shear waves)^2. A tip that grows by increments rests between them.
 *
 * rho (v' - b) is the internal force of the nodes over their mass, as for J (j_integral.h). That
 * force is the weak form of the divergence, which has the tractions on the faces in it, so that
 * their integral is included: M holds for faces in contact and for cohesive ones. With `dynamic:
 * false` both are left out.
 *
 * Axisymmetry: in the plane of r and z, a and t are those of plane strain, per length of the front
 * at the radius R_0; t_33 is along the hoop. With R and e_R for the radius of the undeformed body
 * and its direction, the divergence of R q times the bracket has
 *     (R s_ik),k = R rho (v' - b)_i + s_tt (e_R)_i,   (R t_ik),k = t_iR,
 *     t_ik u_i,k1 - s_ik,1 a_i,k = -t_33 (u_R/R),1,
 * the last since the hoop strain u_R/R belongs to s alone. So
 *     R_0 M = int { R [...] q,k + q ( R rho (v' - b)_i a_i,1 + s_tt a_R,1 + t_iR u_i,1
 *             - t_33 (u_R,1 - (e_R)_1 u_R/R) - (e_R)_1 s_ik a_i,k ) } dA.
 *
 * Free strain e that varies from place to place belongs to s alone, s = C (u_(k,l) - e delta_kl),
 * so that t_ik u_i,1k - s_ik,1 a_i,k = t_kk e,1, with t_33, and M has, in axisymmetry with R,
 *     + int t_kk e,1 q dA.
 * In mode II t_kk jumps across the crack: a particle whose domain reaches beyond has it with the
 * parts of both sides.
 *
 * Integrals are sums over particles; u_i,1 is F - I. A body that has turned as a whole (planar) is
 * turned back by the rotation of the mean of F, with the weights q. q is 1 near the tip and falls
 * to 0 within J's rectangle, at the same distance on both sides of the tip; on each axis, with s
 * the distance from the tip over that one,
 *     q = f(s_x) f(s_y),   f = 1 - w^3 (10 - 15 w + 6 w^2),   w = (s - 1/4)/(3/4) within [0, 1].
 * Its second derivatives are continuous, which sums over a lattice of particles need: with the
 * exact field of a tip they are off by 0.3 % on a contour of 4 cells, with a cubic f by 1.5 %. The
 * field of the body next to the tip, which is known least, is in the terms without q,k alone. A
 * particle closer to the tip than half of its size takes the field at that distance. One on the
 * crack is on neither side, and takes the mean of both.
 *
 * t_11 jumps across the crack, somewhere between two particles. In the sum it jumps midway, which
 * is an error of the first order in the cell where u_1,1 is not 0. Now forces of t on any closed
 * line balance, so that u_1,1 may be u_1,1 - c with any constant c. It is the mean of u_1,1 on the
 * faces, of the particles within a cell of them, with the weights |q,1|/sqrt(r) of that error that
 * fall to 0 at the distance of a cell: what is left is of the second order.
 *
 * Where the crack bends, a and t have their jump on the bent crack, but are not free of tractions
 * there. What that adds is known as well as a field with an edge knows its values there, from nodes
 * on both sides:
 *     int_faces [ s_lm a_l,m n_1 - t_ik n_k u_i,1 ] q dS,   n out of the body.
 * Strains are small.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_STRESS_INTENSITY_H
#define MPM_METHOD_STRESS_INTENSITY_H

#include "method/cracks/j_contour.h"

enum { MPM_MODES = 2 };

/* What the sum over particles needs to know of a tip. */
struct mpm_tip_frame {
    const struct mpm_j_contour *contour;
    double place[2];             /* of the tip, now */
    double axes[2][2];           /* 1 and 2, in the undeformed body */
    double turned[2][2];         /* the same, with the body */
    double width[2];             /* where q is 0, from the tip, along x and y */
    double near;                 /* a cell, for the faces */
    double shear, kappa, factor; /* G; 3 - 4 nu or (3 - nu)/(1 + nu); E'/2, over R_0 */
    bool curved;
};

/* Sums over particles, with their areas. */
struct mpm_intensity_sums {
    double body[MPM_MODES];      /* M, or R_0 M, of the body's field, c = 0 */
    double constant[MPM_MODES];  /* its part in t for u_1,1 = 1 */
    double weight[2], strain[2]; /* by face: of the mean of u_1,1 */
};

/* `bulk` and `shear` of the material. Cost: a test of each particle, F of those in the area. */
struct mpm_tip_frame mpm_tip_frame_of(const struct mpm_j_contour *contour, double bulk,
                                      double shear);

/* Adds a particle. `force`: v' - b there, or 0; `expansion`: e,k in the undeformed body. Cost: some
 * square roots, and a test of the crack; next to nothing where q is 0. */
void mpm_stress_intensity_add(const struct mpm_tip_frame *frame,
                              const struct mpm_j_particle *particle, const double force[2],
                              const double expansion[2], struct mpm_intensity_sums *sums);

/* Adds the faces of a bent crack: those of all segments but the tip's. Cost: four nodes for each
 * quarter of a cell. */
void mpm_stress_intensity_add_faces(const struct mpm_tip_frame *frame,
                                    struct mpm_intensity_sums *sums);

/* K_I and K_II. */
void mpm_stress_intensity_find(const struct mpm_tip_frame *frame,
                               const struct mpm_intensity_sums *sums, double intensity[MPM_MODES]);

#endif
