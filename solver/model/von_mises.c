/* Von Mises elastoplasticity at finite strain.
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
 *   |dev tau - beta| <= sqrt(2/3) s(p),   s(p) = Y (1 + p/p_0)^n + H p,   dp = sqrt(2/3) dg,
 *
 * with the equivalent plastic strain p. The back stress has an energy too, of the logarithmic
 * plastic strain, H_k/3 |ln U_p|^2: turned into the deformed body by the rotation R_e of F_e = V_e
 * R_e it is
 *
 *   beta = 2/3 H_k R_e ln(U_p) R_e^T = H_k/3 ln(V_e^-1 F F^T V_e^-1),
 *
 * which needs no state of its own. In simple shear it has one maximum, at a shear of 3, as Hencky's
 * elasticity, and does not oscillate as that of Jaumann's rate.
 * N is (dev tau - beta)/|dev tau - beta| of the trial state: the same as that of the end where axes
 * do not turn in the step, and within O(dt) of it elsewhere.
 *
 * Conjugate to the flow is tau - beta: s(p) dp is dissipated, whatever part of it is hardening.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "model/material.h"

#include "base/exponential.h"
#include "base/spectral.h"

#include <math.h>

/* State variables. */
enum { INVERSE = 0, PLASTIC = MPM_SYMMETRIC_SIZE, VARIABLES };

static const double ROOT_TWO_THIRDS = 0.81649658092772603273;

/* -------------------------------------------------------------------- hardening */

static double over_density(const struct mpm_material *m, enum mpm_parameter which)
{
    return m->parameter[which] / m->density;
}

/* (1 + p/p_0)^exponent; 1 without hardening by a power */
static double power_of(const struct mpm_material *m, double plastic, double exponent)
{
    const double scale = m->parameter[MPM_PARAMETER_HARDENING_STRAIN];
    return scale > 0.0 ? mpm_exponential(exponent * mpm_logarithm(1.0 + plastic / scale)) : 1.0;
}

/* s(p) and ds/dp over rho_0 */
static double yield_stress(const struct mpm_material *m, double plastic, double *slope)
{
    const double yield = over_density(m, MPM_PARAMETER_YIELD_STRESS);
    const double modulus = over_density(m, MPM_PARAMETER_HARDENING_MODULUS);
    const double scale = m->parameter[MPM_PARAMETER_HARDENING_STRAIN];
    const double exponent = m->parameter[MPM_PARAMETER_HARDENING_EXPONENT];
    const double stress = yield * power_of(m, plastic, exponent);
    *slope = modulus + (scale > 0.0 ? exponent * stress / (scale + plastic) : 0.0);
    return stress + modulus * plastic;
}

/* Integral of s from 0 to p, over rho_0. */
static double dissipation(const struct mpm_material *m, const double *state)
{
    const double plastic = state[PLASTIC];
    const double yield = over_density(m, MPM_PARAMETER_YIELD_STRESS);
    const double modulus = over_density(m, MPM_PARAMETER_HARDENING_MODULUS);
    const double scale = m->parameter[MPM_PARAMETER_HARDENING_STRAIN];
    const double exponent = m->parameter[MPM_PARAMETER_HARDENING_EXPONENT] + 1.0;
    const double powers =
        scale > 0.0 ? scale / exponent * (power_of(m, plastic, exponent) - 1.0) : plastic;
    return yield * powers + 0.5 * modulus * plastic * plastic;
}

/* ------------------------------------------------------------------- kinematics */

/* F X F^T of a symmetric X */
static void push(const double f[MPM_GRADIENT_SIZE], const double x[MPM_SYMMETRIC_SIZE],
                 double out[MPM_SYMMETRIC_SIZE])
{
    const double xx = f[MPM_XX] * x[MPM_SYM_XX] + f[MPM_XY] * x[MPM_SYM_XY];
    const double xy = f[MPM_XX] * x[MPM_SYM_XY] + f[MPM_XY] * x[MPM_SYM_YY];
    const double yx = f[MPM_YX] * x[MPM_SYM_XX] + f[MPM_YY] * x[MPM_SYM_XY];
    const double yy = f[MPM_YX] * x[MPM_SYM_XY] + f[MPM_YY] * x[MPM_SYM_YY];
    out[MPM_SYM_XX] = xx * f[MPM_XX] + xy * f[MPM_XY];
    out[MPM_SYM_XY] = xx * f[MPM_YX] + xy * f[MPM_YY];
    out[MPM_SYM_YY] = yx * f[MPM_YX] + yy * f[MPM_YY];
    out[MPM_SYM_ZZ] = f[MPM_ZZ] * x[MPM_SYM_ZZ] * f[MPM_ZZ];
}

/* F^-1 X F^-T */
static void pull(const double f[MPM_GRADIENT_SIZE], const double x[MPM_SYMMETRIC_SIZE],
                 double out[MPM_SYMMETRIC_SIZE])
{
    const double area = f[MPM_XX] * f[MPM_YY] - f[MPM_XY] * f[MPM_YX];
    const double inverse[MPM_GRADIENT_SIZE] = {
        f[MPM_YY] / area, -f[MPM_XY] / area, -f[MPM_YX] / area, f[MPM_XX] / area, 1.0 / f[MPM_ZZ]};
    push(inverse, x, out);
}

/* dev ln A */
static void deviatoric_logarithm(const double a[MPM_SYMMETRIC_SIZE], double out[MPM_SYMMETRIC_SIZE])
{
    mpm_symmetric_logarithm(a, out);
    mpm_symmetric_deviate(out);
}

/* 2 ln of the plastic stretch, turned into the deformed body. */
static void plastic_logarithm(const double f[MPM_GRADIENT_SIZE],
                              const double b_elastic[MPM_SYMMETRIC_SIZE],
                              double out[MPM_SYMMETRIC_SIZE])
{
    double b[MPM_SYMMETRIC_SIZE], root[MPM_SYMMETRIC_SIZE], plastic[MPM_SYMMETRIC_SIZE];
    mpm_left_cauchy_green(f, b);
    mpm_symmetric_root(b_elastic, root);
    mpm_symmetric_inverse(root, root);
    mpm_symmetric_sandwich(root, b, plastic);
    deviatoric_logarithm(plastic, out);
}

/* dev tau - beta of b_e */
static void driving_stress(const struct mpm_material *m, const double f[MPM_GRADIENT_SIZE],
                           const double b_elastic[MPM_SYMMETRIC_SIZE],
                           double out[MPM_SYMMETRIC_SIZE])
{
    const double kinematic = over_density(m, MPM_PARAMETER_KINEMATIC_MODULUS);
    double strain[MPM_SYMMETRIC_SIZE];
    deviatoric_logarithm(b_elastic, strain);
    for (int k = 0; k < MPM_SYMMETRIC_SIZE; k++)
        out[k] = m->shear * strain[k];
    if (kinematic == 0.0)
        return;
    plastic_logarithm(f, b_elastic, strain);
    for (int k = 0; k < MPM_SYMMETRIC_SIZE; k++)
        out[k] -= kinematic / 3.0 * strain[k];
}

/* ----------------------------------------------------------------------- return */

/* A step from the trial state along N. */
struct flow {
    const struct mpm_material *m;
    const double *f;
    double plastic;                    /* p at the start of the step */
    double root[MPM_SYMMETRIC_SIZE];   /* V_e of the trial state */
    double normal[MPM_SYMMETRIC_SIZE]; /* N */
    double norm;                       /* |dev tau - beta| of the trial state */
    double stiffness;                  /* what it falls by, per slip */
};

/* b_e after the slip dg: V_e exp(-2 dg N) V_e */
static void slipped(const struct flow *flow, double slip, double b_elastic[MPM_SYMMETRIC_SIZE])
{
    double flown[MPM_SYMMETRIC_SIZE];
    for (int k = 0; k < MPM_SYMMETRIC_SIZE; k++)
        flown[k] = -2.0 * slip * flow->normal[k];
    mpm_symmetric_exponential(flown, flown);
    mpm_symmetric_sandwich(flow->root, flown, b_elastic);
}

/* |dev tau - beta| - sqrt(2/3) s after the slip. Without back stress the former is linear in it. */
static double overstress(const struct flow *flow, double slip, double *slope)
{
    double norm = flow->norm - flow->stiffness * slip, hardening;
    if (flow->m->parameter[MPM_PARAMETER_KINEMATIC_MODULUS] > 0.0) {
        double b_elastic[MPM_SYMMETRIC_SIZE], driving[MPM_SYMMETRIC_SIZE];
        slipped(flow, slip, b_elastic);
        driving_stress(flow->m, flow->f, b_elastic, driving);
        norm = mpm_symmetric_norm(driving);
    }
    const double yield = yield_stress(flow->m, flow->plastic + ROOT_TWO_THIRDS * slip, &hardening);
    *slope = -(flow->stiffness + 2.0 / 3.0 * hardening);
    return norm - ROOT_TWO_THIRDS * yield;
}

enum { ITERATIONS = 200 };
static const double ROUND_OFF = 1e-15;

/* The slip at which the overstress is 0: Newton's steps in a bracket, halved where they leave it or
 * do not come closer by half. */
static bool find_slip(const struct flow *flow, double *slip)
{
    double low = 0.0, high = flow->norm / flow->stiffness, slope, last = HUGE_VAL;
    if (!(overstress(flow, high, &slope) < 0.0))
        return false;
    *slip = 0.0;
    for (int k = 0; k < ITERATIONS; k++) {
        const double over = overstress(flow, *slip, &slope);
        const double change = -over / slope;
        const bool slow = fabs(over) > 0.5 * last;
        if (!isfinite(change))
            return false;
        if (fabs(change) <= ROUND_OFF * high || high - low <= ROUND_OFF * high)
            return true;
        *(over > 0.0 ? &low : &high) = *slip;
        *slip += change;
        if (slow || !(*slip > low && *slip < high))
            *slip = 0.5 * (low + high);
        last = fabs(over);
    }
    return false;
}

/* Changes the state; `driving` is that of the trial state. */
static bool flow_back(const struct mpm_material *m, const struct mpm_law_step *step,
                      const double b_elastic[MPM_SYMMETRIC_SIZE],
                      const double driving[MPM_SYMMETRIC_SIZE], double *state)
{
    struct flow flow = {
        .m = m,
        .f = step->f,
        .plastic = state[PLASTIC],
        .norm = mpm_symmetric_norm(driving),
        .stiffness = 2.0 * m->shear + 2.0 / 3.0 * over_density(m, MPM_PARAMETER_KINEMATIC_MODULUS),
    };
    double slip, after[MPM_SYMMETRIC_SIZE];
    for (int k = 0; k < MPM_SYMMETRIC_SIZE; k++)
        flow.normal[k] = driving[k] / flow.norm;
    mpm_symmetric_root(b_elastic, flow.root);
    if (!find_slip(&flow, &slip))
        return false;
    slipped(&flow, slip, after);
    pull(step->f, after, state + INVERSE);
    state[PLASTIC] += ROOT_TWO_THIRDS * slip;
    return true;
}

/* ---------------------------------------------------------------------- the law */

/* Elastic waves. Along a principal direction with Kirchhoff stress t: rho_0 c^2 = K + 4/3 G - t of
 * the longitudinal one; with b and a the eigenvalues of b_e along and across, G ln(b/a) b/(b - a)
 * of the shear wave. */
static double wave_speed_squared(const struct mpm_material *m,
                                 const double b_elastic[MPM_SYMMETRIC_SIZE],
                                 const double tau[MPM_SYMMETRIC_SIZE])
{
    double elastic[2], stress[2];
    mpm_plane_eigenvalues(b_elastic, elastic);
    mpm_plane_eigenvalues(tau, stress);
    const double longitudinal = m->bulk + 4.0 / 3.0 * m->shear - stress[0];
    const double part = (elastic[1] - elastic[0]) / elastic[1];
    const double transverse =
        m->shear * (part > 1e-8 ? mpm_logarithm(elastic[1] / elastic[0]) / part : 1.0);
    return longitudinal > transverse ? longitudinal : transverse;
}

static bool update(const struct mpm_material *m, const struct mpm_law_step *step, double *state,
                   double tau[MPM_SYMMETRIC_SIZE], double *wave)
{
    double b_elastic[MPM_SYMMETRIC_SIZE], driving[MPM_SYMMETRIC_SIZE], slope;
    push(step->f, state + INVERSE, b_elastic);
    if (step->duration > 0.0) {
        driving_stress(m, step->f, b_elastic, driving);
        const double radius = ROOT_TWO_THIRDS * yield_stress(m, state[PLASTIC], &slope);
        if (!(mpm_symmetric_norm(driving) <= radius) &&
            !flow_back(m, step, b_elastic, driving, state)) {
            for (int k = 0; k < MPM_SYMMETRIC_SIZE; k++)
                tau[k] = driving[k];
            return false;
        }
        push(step->f, state + INVERSE, b_elastic);
    }
    const double pressure = m->bulk * mpm_logarithm(mpm_determinant(step->f));
    deviatoric_logarithm(b_elastic, tau);
    for (int k = 0; k < MPM_SYMMETRIC_SIZE; k++)
        tau[k] *= m->shear;
    tau[MPM_SYM_XX] += pressure;
    tau[MPM_SYM_YY] += pressure;
    tau[MPM_SYM_ZZ] += pressure;
    *wave = wave_speed_squared(m, b_elastic, tau);
    return true;
}

/* K/2 ln^2 J + G |dev e|^2 + H_k/3 |ln U_p|^2 */
static double energy(const struct mpm_material *m, const double f[MPM_GRADIENT_SIZE],
                     const double *state)
{
    const double kinematic = over_density(m, MPM_PARAMETER_KINEMATIC_MODULUS);
    const double volumetric = mpm_logarithm(mpm_determinant(f));
    double b_elastic[MPM_SYMMETRIC_SIZE], strain[MPM_SYMMETRIC_SIZE];
    push(f, state + INVERSE, b_elastic);
    deviatoric_logarithm(b_elastic, strain);
    const double elastic = mpm_symmetric_norm(strain);
    double sum = 0.5 * m->bulk * volumetric * volumetric + 0.25 * m->shear * elastic * elastic;
    if (kinematic > 0.0) {
        plastic_logarithm(f, b_elastic, strain);
        const double plastic = mpm_symmetric_norm(strain);
        sum += kinematic / 12.0 * plastic * plastic;
    }
    return sum;
}

static const char *fault(const double *parameter)
{
    return (parameter[MPM_PARAMETER_HARDENING_STRAIN] > 0.0) ==
                   (parameter[MPM_PARAMETER_HARDENING_EXPONENT] > 0.0)
               ? NULL
               : "hardening by a power requires hardening_strain and hardening_exponent; allowed: "
                 "both or none";
}

static const struct mpm_law_parameter parameters[] = {
    {.which = MPM_PARAMETER_BULK},
    {.which = MPM_PARAMETER_SHEAR},
    {.which = MPM_PARAMETER_YIELD_STRESS},
    {.which = MPM_PARAMETER_HARDENING_MODULUS, .optional = true},
    {.which = MPM_PARAMETER_HARDENING_STRAIN, .optional = true},
    {.which = MPM_PARAMETER_HARDENING_EXPONENT, .optional = true},
    {.which = MPM_PARAMETER_KINEMATIC_MODULUS, .optional = true},
};
static const struct mpm_law_variable variables[VARIABLES] = {
    {"inverse_plastic_xx", MPM_DIMENSION_NONE, 1.0, "C_p^-1, in the undeformed body"},
    {"inverse_plastic_yy", MPM_DIMENSION_NONE, 1.0, "the same"},
    {"inverse_plastic_zz", MPM_DIMENSION_NONE, 1.0, "the same"},
    {"inverse_plastic_xy", MPM_DIMENSION_NONE, 0.0, "the same"},
    {"plastic_strain", MPM_DIMENSION_NONE, 0.0, "equivalent plastic strain"},
};

const struct mpm_material_law mpm_von_mises = {
    .name = "von_mises",
    .description = "tau = K ln J I + 2 G dev ln V_e, F = F_e F_p; yields at |dev tau - beta| = "
                   "sqrt(2/3) s(p), s = Y (1 + p/p_0)^n + H p",
    .parameters = parameters,
    .parameter_count = sizeof parameters / sizeof *parameters,
    .fault = fault,
    .variables = variables,
    .variable_count = VARIABLES,
    .update = update,
    .energy = energy,
    .dissipation = dissipation,
    .plastic_strain = PLASTIC,
};
