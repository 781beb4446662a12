/* Flow of metals at finite strain: what the laws with plastic strain share.
 *
 * Kinematics: F = F_e F_p (Lee), elastic energy of the logarithmic strain e = ln V_e (Hencky), flow
 * by the exponential map F_p' = exp(dg N) F_p with a deviatoric N, so that det F_p = 1 exactly. The
 * state is C_p^-1 = (F_p^T F_p)^-1, which no rotation of the body changes, and from which
 *
 *   b_e = V_e^2 = F C_p^-1 F^T,   e = 1/2 ln b_e,   tau = K ln J I + 2 G dev e.
 *
 * No rate is integrated, so that rotations are exact, an elastic path leaves no trace, and
 * where the axes of strain do not turn, the return is that of small strains in e, to the last term
 * (Simo 1992; Weber and Anand 1990). Yield, in the Kirchhoff stress:
 *
 *   |dev tau - beta| <= sqrt(2/3) s,   dp = sqrt(2/3) dg,
 *
 * with the equivalent plastic strain p; the stress s(p, dp/dt, T) is the law's, and is taken at the
 * end of the step. The volumetric part K ln J is that of most laws; another pressure may take its
 * place, since plastic strain does not change J. The back stress has an energy too, of the
 * logarithmic plastic strain, H_k/3 |ln U_p|^2: turned into the deformed body by the rotation R_e
 * of F_e = V_e R_e it is
 *
 *   beta = 2/3 H_k R_e ln(U_p) R_e^T = H_k/3 ln(V_e^-1 F F^T V_e^-1),
 *
 * which needs no state of its own. In simple shear it has one maximum, at a shear of 3, as Hencky's
 * elasticity, and does not oscillate as that of Jaumann's rate.
 * N is (dev tau - beta)/|dev tau - beta| of the trial state: the same as that of the end where axes
 * do not turn in the step, and within O(dt) of it elsewhere.
 *
 * Conjugate to the flow is tau - beta: s dp is dissipated, whatever part of it is hardening.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_MODEL_PLASTIC_FLOW_H
#define MPM_MODEL_PLASTIC_FLOW_H

#include "model/material.h"

/* The first state variables of these laws: C_p^-1 and p. */
enum { MPM_PLASTIC_INVERSE = 0, MPM_PLASTIC_STRAIN = MPM_SYMMETRIC_SIZE, MPM_PLASTIC_VARIABLES };
#define MPM_PLASTIC_VARIABLE_ROWS                                                                  \
    {"inverse_plastic_xx", MPM_DIMENSION_NONE, 1.0, "C_p^-1, in the undeformed body"},             \
        {"inverse_plastic_yy", MPM_DIMENSION_NONE, 1.0, "the same"},                               \
        {"inverse_plastic_zz", MPM_DIMENSION_NONE, 1.0, "the same"},                               \
        {"inverse_plastic_xy", MPM_DIMENSION_NONE, 0.0, "the same"},                               \
    {                                                                                              \
        "plastic_strain", MPM_DIMENSION_NONE, 0.0, "equivalent plastic strain"                     \
    }

/* Of the search for the slip of a step. */
enum { MPM_PLASTIC_ITERATIONS = 200 };
static const double MPM_ROOT_TWO_THIRDS = 0.81649658092772603273;
static const double MPM_PLASTIC_ROUND_OFF = 1e-15;
/* slip: a power of a smaller one would be the same */
static const double MPM_PLASTIC_LEAST = 1e-300;
/* a strength of that part of the trial stress is none */
static const double MPM_PLASTIC_FAINT = 1e-12;
/* Of the shear wave: G ln(b/a) b/(b - a) <= G b/a, since ln x <= x - 1; and round-off. */
static const double MPM_PLASTIC_SHEAR_BOUND = 1.0 + 1e-6;

/* Where the yield stress is asked for: p, its change since the start of the step (p is after it),
 * the duration of the step, and the model's factor of the step's temperature. */
struct mpm_plastic_point {
    double plastic, change, duration, softening;
};

struct mpm_plastic_model {
    double kinematic; /* H_k over rho_0; 0: no back stress */
    /* A factor of s, of the temperature alone, which is found once a step; NULL: 1. */
    double (*softening)(const struct mpm_material *material, double temperature);
    /* s over rho_0, and its slope in p at a fixed start of the step; this may be infinite. Not
     * falling in p. 0: no strength, for models without back stress. */
    double (*yield)(const struct mpm_material *material, const struct mpm_plastic_point *point,
                    double *slope);
    /* Plastic work per mass of the step that ends at `point`: the integral of s over rho_0 in p. */
    double (*work)(const struct mpm_material *material, const struct mpm_plastic_point *point);
};

/* Takes C_p^-1 and p of `state` to the end of the step (leaves them with a duration of 0); dev tau
 * over rho_0 there. False: there is no way back to yield; `tau` is then dev tau - beta of the
 * trial state. */
bool mpm_plastic_return(const struct mpm_material *material, const struct mpm_plastic_model *model,
                        const struct mpm_law_step *step, double temperature, double *state,
                        double tau[MPM_SYMMETRIC_SIZE]);

/* The model's `work` of a step from the plastic strain `before` to `after`. */
double mpm_plastic_work(const struct mpm_material *material, const struct mpm_plastic_model *model,
                        const struct mpm_law_step *step, double temperature, double before,
                        double after);

/* tau + mean I */
void mpm_plastic_add_volumetric(double mean, double tau[MPM_SYMMETRIC_SIZE]);

/* Elastic waves. Along a principal direction with Kirchhoff stress t: rho_0 c^2 = K + 4/3 G - t of
 * the longitudinal one, K the slope of mean tau in ln J, here over rho_0; with b and a the
 * eigenvalues of b_e along and across, G ln(b/a) b/(b - a) of the shear wave. */
double mpm_plastic_wave_squared(const struct mpm_material *material, double bulk,
                                const double f[MPM_GRADIENT_SIZE], const double *state,
                                const double tau[MPM_SYMMETRIC_SIZE]);

/* G |dev e|^2 + H_k/3 |ln U_p|^2 over rho_0 */
double mpm_plastic_shear_energy(const struct mpm_material *material, double kinematic,
                                const double f[MPM_GRADIENT_SIZE], const double *state);

/* K/2 ln^2 J and the energy of shear, over rho_0 */
double mpm_plastic_energy(const struct mpm_material *material, double kinematic,
                          const double f[MPM_GRADIENT_SIZE], const double *state);

#endif
