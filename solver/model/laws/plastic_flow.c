/* Flow of metals at finite strain; see plastic_flow.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "model/laws/plastic_flow.h"

#include "base/exponential.h"
#include "base/spectral.h"

#include <math.h>

enum { INVERSE = MPM_PLASTIC_INVERSE, PLASTIC = MPM_PLASTIC_STRAIN };

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
static void driving_stress(const struct mpm_material *m, double kinematic,
                           const double f[MPM_GRADIENT_SIZE],
                           const double b_elastic[MPM_SYMMETRIC_SIZE],
                           double out[MPM_SYMMETRIC_SIZE])
{
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
    const struct mpm_plastic_model *model;
    const double *f;
    double plastic;                    /* p at the start of the step */
    double duration, softening;        /* of the step */
    double root[MPM_SYMMETRIC_SIZE];   /* V_e of the trial state */
    double normal[MPM_SYMMETRIC_SIZE]; /* N */
    double norm;                       /* |dev tau - beta| of the trial state */
    double stiffness;                  /* what it falls by, per slip */
    double yield, hardening;           /* s and ds/dp without slip */
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

static double softening_of(const struct mpm_material *m, const struct mpm_plastic_model *model,
                           double temperature)
{
    return model->softening == NULL ? 1.0 : model->softening(m, temperature);
}

/* s after the slip, and ds/dp */
static double strength(const struct flow *flow, double slip, double *slope)
{
    const double change = MPM_ROOT_TWO_THIRDS * slip;
    const struct mpm_plastic_point point = {flow->plastic + change, change, flow->duration,
                                            flow->softening};
    return flow->model->yield(flow->m, &point, slope);
}

/* |dev tau - beta| after the slip. Without back stress it is linear in it. */
static double norm_after(const struct flow *flow, double slip)
{
    double b_elastic[MPM_SYMMETRIC_SIZE], driving[MPM_SYMMETRIC_SIZE];
    if (flow->model->kinematic == 0.0)
        return flow->norm - flow->stiffness * slip;
    slipped(flow, slip, b_elastic);
    driving_stress(flow->m, flow->model->kinematic, flow->f, b_elastic, driving);
    return mpm_symmetric_norm(driving);
}

/* Of a bracket, by ratio where its ends are far apart. */
static double middle_of(double low, double high)
{
    return low < 1e-3 * high ? sqrt(fmax(low, MPM_PLASTIC_LEAST)) * sqrt(high) : 0.5 * (low + high);
}

/* Where yield is met on the way to the slip `high`, at which without back stress no stress is left.
 */
enum place { NOWHERE, AT_THE_END, BEFORE_THE_END };

static enum place place_of_end(const struct flow *flow, double high)
{
    const bool coaxial = flow->model->kinematic == 0.0;
    if (coaxial &&
        flow->yield > MPM_PLASTIC_FAINT * flow->norm) /* and strength does not fall in p */
        return BEFORE_THE_END;
    double slope;
    const double yield = strength(flow, high, &slope);
    const double rest = norm_after(flow, high) - MPM_ROOT_TWO_THIRDS * yield;
    if (yield > 0.0 && rest < 0.0)
        return BEFORE_THE_END;
    return coaxial && rest < MPM_PLASTIC_ROUND_OFF * flow->norm ? AT_THE_END : NOWHERE;
}

/* The slip at which the overstress, |dev tau - beta| - sqrt(2/3) s, is 0: Newton's steps in a
 * bracket, halved where they leave it, do not come closer by half, or where the slope is infinite.
 * It is found where the overstress is round-off or the bracket is closed: a small step of Newton's
 * is no sign of it, since powers of a small plastic strain are steep. A model without strength
 * slips until no stress is left. */
static bool find_slip(const struct flow *flow, double *slip)
{
    double low = 0.0, high = flow->norm / flow->stiffness, last = HUGE_VAL;
    double yield = flow->yield, slope = flow->hardening;
    const enum place place = place_of_end(flow, high);
    *slip = place == AT_THE_END ? high : 0.0;
    if (place != BEFORE_THE_END)
        return place == AT_THE_END;
    for (int k = 0; k < MPM_PLASTIC_ITERATIONS; k++) {
        const double over = norm_after(flow, *slip) - MPM_ROOT_TWO_THIRDS * yield;
        const double change = over / (flow->stiffness + 2.0 / 3.0 * slope);
        const bool slow = fabs(over) > 0.5 * last;
        if (!isfinite(change))
            return false;
        if (fabs(over) <= MPM_PLASTIC_ROUND_OFF * flow->norm ||
            high - low <= MPM_PLASTIC_ROUND_OFF * high || high <= 2.0 * MPM_PLASTIC_LEAST)
            return true;
        *(over > 0.0 ? &low : &high) = *slip;
        *slip += change;
        if (slow || !(*slip > low && *slip < high))
            *slip = middle_of(low, high);
        last = fabs(over);
        yield = strength(flow, *slip, &slope);
    }
    return false;
}

/* Without back stress the flow has the axes of the trial state: b_e' = exp(ln b_e - 2 dg N). */
static void slip_along_axes(const double b_elastic[MPM_SYMMETRIC_SIZE],
                            const double normal[MPM_SYMMETRIC_SIZE], double slip,
                            double after[MPM_SYMMETRIC_SIZE])
{
    double flown[MPM_SYMMETRIC_SIZE];
    for (int k = 0; k < MPM_SYMMETRIC_SIZE; k++)
        flown[k] = -2.0 * slip * normal[k];
    mpm_symmetric_exponential(flown, flown);
    mpm_symmetric_product(b_elastic, flown, after);
}

/* Is b_e still positive? F and C_p^-1 of stretches far above 1e5 hold no elastic strain any more:
 * it is less than the round-off of their product. */
static bool holds_elastic_strain(const double f[MPM_GRADIENT_SIZE],
                                 const double inverse[MPM_SYMMETRIC_SIZE])
{
    double b_elastic[MPM_SYMMETRIC_SIZE], plane[2];
    push(f, inverse, b_elastic);
    mpm_plane_eigenvalues(b_elastic, plane);
    return plane[0] > 0.0 && b_elastic[MPM_SYM_ZZ] > 0.0;
}

/* Changes the state; `driving` is that of the trial state, and that of the end on output. False:
 * no way back to yield; no number in `driving`: no elastic strain. */
static bool flow_back(struct flow *flow, const double b_elastic[MPM_SYMMETRIC_SIZE],
                      double driving[MPM_SYMMETRIC_SIZE], double *state)
{
    double slip, after[MPM_SYMMETRIC_SIZE];
    const bool coaxial = flow->model->kinematic == 0.0;
    flow->norm = mpm_symmetric_norm(driving);
    for (int k = 0; k < MPM_SYMMETRIC_SIZE; k++)
        flow->normal[k] = driving[k] / flow->norm;
    if (!coaxial)
        mpm_symmetric_root(b_elastic, flow->root);
    if (!find_slip(flow, &slip))
        return false;
    if (coaxial)
        slip_along_axes(b_elastic, flow->normal, slip, after);
    else
        slipped(flow, slip, after);
    for (int k = 0; k < MPM_SYMMETRIC_SIZE; k++)
        driving[k] -= flow->stiffness * slip * flow->normal[k];
    pull(flow->f, after, state + INVERSE);
    state[PLASTIC] += MPM_ROOT_TWO_THIRDS * slip;
    if (holds_elastic_strain(flow->f, state + INVERSE))
        return true;
    for (int k = 0; k < MPM_SYMMETRIC_SIZE; k++)
        driving[k] = (double)NAN;
    return false;
}

/* -------------------------------------------------------------------- for laws */

bool mpm_plastic_return(const struct mpm_material *m, const struct mpm_plastic_model *model,
                        const struct mpm_law_step *step, double temperature, double *state,
                        double tau[MPM_SYMMETRIC_SIZE])
{
    double b_elastic[MPM_SYMMETRIC_SIZE], driving[MPM_SYMMETRIC_SIZE];
    push(step->f, state + INVERSE, b_elastic);
    if (step->duration > 0.0) {
        struct flow flow = {.m = m,
                            .model = model,
                            .f = step->f,
                            .plastic = state[PLASTIC],
                            .duration = step->duration,
                            .softening = softening_of(m, model, temperature),
                            .stiffness = 2.0 * m->shear + 2.0 / 3.0 * model->kinematic};
        driving_stress(m, model->kinematic, step->f, b_elastic, driving);
        flow.yield = strength(&flow, 0.0, &flow.hardening);
        if (!(mpm_symmetric_norm(driving) <= MPM_ROOT_TWO_THIRDS * flow.yield) &&
            !flow_back(&flow, b_elastic, driving, state)) {
            for (int k = 0; k < MPM_SYMMETRIC_SIZE; k++)
                tau[k] = driving[k];
            return false;
        }
        if (model->kinematic == 0.0) {
            for (int k = 0; k < MPM_SYMMETRIC_SIZE; k++)
                tau[k] = driving[k];
            return true;
        }
        push(step->f, state + INVERSE, b_elastic);
    }
    deviatoric_logarithm(b_elastic, tau);
    for (int k = 0; k < MPM_SYMMETRIC_SIZE; k++)
        tau[k] *= m->shear;
    return true;
}

double mpm_plastic_work(const struct mpm_material *m, const struct mpm_plastic_model *model,
                        const struct mpm_law_step *step, double temperature, double before,
                        double after)
{
    if (!(after > before))
        return 0.0;
    const struct mpm_plastic_point end = {after, after - before, step->duration,
                                          softening_of(m, model, temperature)};
    return model->work(m, &end);
}

void mpm_plastic_add_volumetric(double mean, double tau[MPM_SYMMETRIC_SIZE])
{
    tau[MPM_SYM_XX] += mean;
    tau[MPM_SYM_YY] += mean;
    tau[MPM_SYM_ZZ] += mean;
}

double mpm_plastic_wave_squared(const struct mpm_material *m, double bulk,
                                const double f[MPM_GRADIENT_SIZE], const double *state,
                                const double tau[MPM_SYMMETRIC_SIZE])
{
    double b_elastic[MPM_SYMMETRIC_SIZE], elastic[2], stress[2];
    push(f, state + INVERSE, b_elastic);
    mpm_plane_eigenvalues(b_elastic, elastic);
    mpm_plane_eigenvalues(tau, stress);
    const double longitudinal = bulk + 4.0 / 3.0 * m->shear - stress[0];
    if (elastic[0] > 0.0 &&
        m->shear * MPM_PLASTIC_SHEAR_BOUND * (elastic[1] / elastic[0]) < longitudinal)
        return longitudinal;
    const double part = (elastic[1] - elastic[0]) / elastic[1];
    const double transverse =
        m->shear * (part > 1e-8 ? mpm_logarithm(elastic[1] / elastic[0]) / part : 1.0);
    return longitudinal > transverse ? longitudinal : transverse;
}

double mpm_plastic_shear_energy(const struct mpm_material *m, double kinematic,
                                const double f[MPM_GRADIENT_SIZE], const double *state)
{
    double b_elastic[MPM_SYMMETRIC_SIZE], strain[MPM_SYMMETRIC_SIZE];
    push(f, state + INVERSE, b_elastic);
    deviatoric_logarithm(b_elastic, strain);
    const double elastic = mpm_symmetric_norm(strain);
    double sum = 0.25 * m->shear * elastic * elastic;
    if (kinematic > 0.0) {
        plastic_logarithm(f, b_elastic, strain);
        const double plastic = mpm_symmetric_norm(strain);
        sum += kinematic / 12.0 * plastic * plastic;
    }
    return sum;
}

double mpm_plastic_energy(const struct mpm_material *m, double kinematic,
                          const double f[MPM_GRADIENT_SIZE], const double *state)
{
    const double volumetric = mpm_logarithm(mpm_determinant(f));
    return 0.5 * m->bulk * volumetric * volumetric +
           mpm_plastic_shear_energy(m, kinematic, f, state);
}
