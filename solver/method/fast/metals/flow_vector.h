/* The flow of metals for four particles: the vector twin of model/laws/plastic_flow.c without back
 * stress, to the same bits. Equations stand in plastic_flow.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_FAST_FLOW_VECTOR_H
#define MPM_METHOD_FAST_FLOW_VECTOR_H

#include "method/fast/metals/metal.h"
#include "method/fast/metals/spectral_vector.h"

/* Four particles in a step. */
struct metal_points {
    mpm_vector old_f[MPM_GRADIENT_SIZE], f[MPM_GRADIENT_SIZE];
    mpm_vector inverse[MPM_SYMMETRIC_SIZE]; /* C_p^-1 */
    mpm_vector plastic, energy, work;       /* p, e, w */
    mpm_vector softening;                   /* of the step */
    mpm_vector b_elastic[MPM_SYMMETRIC_SIZE];
    mpm_vector tau[MPM_SYMMETRIC_SIZE], wave_squared;
    mpm_vector viscous[2]; /* q J/rho_0, its work per mass since t = 0 */
    mpm_mask found;        /* has the step an end in these equations? */
};

/* F X F^T of a symmetric X */
MPM_INLINE void push_vector(const mpm_vector f[MPM_GRADIENT_SIZE],
                            const mpm_vector x[MPM_SYMMETRIC_SIZE],
                            mpm_vector out[MPM_SYMMETRIC_SIZE])
{
    const mpm_vector xx = f[MPM_XX] * x[MPM_SYM_XX] + f[MPM_XY] * x[MPM_SYM_XY];
    const mpm_vector xy = f[MPM_XX] * x[MPM_SYM_XY] + f[MPM_XY] * x[MPM_SYM_YY];
    const mpm_vector yx = f[MPM_YX] * x[MPM_SYM_XX] + f[MPM_YY] * x[MPM_SYM_XY];
    const mpm_vector yy = f[MPM_YX] * x[MPM_SYM_XY] + f[MPM_YY] * x[MPM_SYM_YY];
    out[MPM_SYM_XX] = xx * f[MPM_XX] + xy * f[MPM_XY];
    out[MPM_SYM_XY] = xx * f[MPM_YX] + xy * f[MPM_YY];
    out[MPM_SYM_YY] = yx * f[MPM_YX] + yy * f[MPM_YY];
    out[MPM_SYM_ZZ] = f[MPM_ZZ] * x[MPM_SYM_ZZ] * f[MPM_ZZ];
}

/* F^-1 X F^-T */
MPM_INLINE void pull_vector(const mpm_vector f[MPM_GRADIENT_SIZE],
                            const mpm_vector x[MPM_SYMMETRIC_SIZE],
                            mpm_vector out[MPM_SYMMETRIC_SIZE])
{
    const mpm_vector area = f[MPM_XX] * f[MPM_YY] - f[MPM_XY] * f[MPM_YX];
    const mpm_vector inverse[MPM_GRADIENT_SIZE] = {
        f[MPM_YY] / area, -f[MPM_XY] / area, -f[MPM_YX] / area, f[MPM_XX] / area, 1.0 / f[MPM_ZZ]};
    push_vector(inverse, x, out);
}

MPM_INLINE void select_symmetric(mpm_mask mask, const mpm_vector yes[MPM_SYMMETRIC_SIZE],
                                 mpm_vector target[MPM_SYMMETRIC_SIZE])
{
    for (int k = 0; k < MPM_SYMMETRIC_SIZE; k++)
        target[k] = mpm_select(mask, yes[k], target[k]);
}

MPM_INLINE mpm_vector middle_vector(mpm_vector low, mpm_vector high)
{
    const mpm_vector least = mpm_larger(low, mpm_splat(MPM_PLASTIC_LEAST));
    return mpm_select(mpm_less(low, 1e-3 * high), mpm_square_root(least) * mpm_square_root(high),
                      0.5 * (low + high));
}

/* Of the particles in *flowing, with the strength `yield` and its slope at no slip. Takes those out
 * of *flowing for which there is none. */
MPM_INLINE mpm_vector find_slip_vector(struct metal_law law, const struct metal *metal,
                                       const struct metal_points *points, mpm_vector norm,
                                       mpm_vector yield, mpm_vector slope, mpm_mask *flowing)
{
    const double stiffness = 2.0 * metal->shear;
    mpm_vector low = mpm_splat(0.0), high = norm / stiffness, last = mpm_splat(HUGE_VAL);
    mpm_vector slip = low;
    mpm_mask moving = *flowing;
    for (int k = 0; k < MPM_PLASTIC_ITERATIONS && mpm_any(moving); k++) {
        const mpm_vector over = norm - stiffness * slip - MPM_ROOT_TWO_THIRDS * yield;
        const mpm_vector change = over / (stiffness + 2.0 / 3.0 * slope);
        const mpm_vector size = mpm_absolute(over);
        const mpm_mask finite = mpm_at_most(mpm_absolute(change), mpm_splat(DBL_MAX));
        *flowing &= finite | ~moving;
        moving &= finite;
        moving &= ~(mpm_at_most(size, MPM_PLASTIC_ROUND_OFF * norm) |
                    mpm_at_most(high - low, MPM_PLASTIC_ROUND_OFF * high) |
                    mpm_at_most(high, mpm_splat(2.0 * MPM_PLASTIC_LEAST)));
        if (!mpm_any(moving))
            break;
        const mpm_mask above = mpm_less(mpm_splat(0.0), over);
        low = mpm_select(moving & above, slip, low);
        high = mpm_select(moving & ~above, slip, high);
        mpm_vector next = slip + change;
        const mpm_mask halve =
            mpm_less(0.5 * last, size) | ~(mpm_less(low, next) & mpm_less(next, high));
        if (mpm_any(halve & moving))
            next = mpm_select(halve, middle_vector(low, high), next);
        slip = mpm_select(moving, next, slip);
        last = size;
        const mpm_vector strain = MPM_ROOT_TWO_THIRDS * slip;
        yield =
            metal_strength(law, metal, points->plastic + strain, strain, points->softening, &slope);
    }
    *flowing &= ~moving;
    return slip;
}

/* Those in `flowing`, of the trial stress `tau` and its norm: plastic strain, stress and b_e. */
MPM_INLINE void flow_back_vector(const struct metal *metal, mpm_mask flowing, mpm_vector norm,
                                 mpm_vector slip, struct metal_points *points)
{
    const double stiffness = 2.0 * metal->shear;
    mpm_vector normal[MPM_SYMMETRIC_SIZE], flown[MPM_SYMMETRIC_SIZE], tau[MPM_SYMMETRIC_SIZE];
    mpm_vector after[MPM_SYMMETRIC_SIZE], inverse[MPM_SYMMETRIC_SIZE], plane[2];
    for (int k = 0; k < MPM_SYMMETRIC_SIZE; k++) {
        normal[k] = points->tau[k] / norm;
        flown[k] = -2.0 * slip * normal[k];
        tau[k] = points->tau[k] - stiffness * slip * normal[k];
    }
    symmetric_exponential_vector(flown, flown);
    symmetric_product_vector(points->b_elastic, flown, after);
    pull_vector(points->f, after, inverse);
    push_vector(points->f, inverse, after);
    plane_eigenvalues_vector(after, plane);
    const mpm_vector zero = mpm_splat(0.0);
    points->found &= ~flowing | (mpm_less(zero, plane[0]) & mpm_less(zero, after[MPM_SYM_ZZ]));
    select_symmetric(flowing, tau, points->tau);
    select_symmetric(flowing, inverse, points->inverse);
    select_symmetric(flowing, after, points->b_elastic);
    points->plastic =
        mpm_select(flowing, points->plastic + MPM_ROOT_TWO_THIRDS * slip, points->plastic);
}

/* C_p^-1, p, b_e and the deviator of tau at the end of the step. */
MPM_INLINE void return_vector(struct metal_law law, const struct metal *metal,
                              struct metal_points *points)
{
    mpm_vector slope;
    push_vector(points->f, points->inverse, points->b_elastic);
    symmetric_logarithm_vector(points->b_elastic, points->tau);
    symmetric_deviate_vector(points->tau);
    for (int k = 0; k < MPM_SYMMETRIC_SIZE; k++)
        points->tau[k] = metal->shear * points->tau[k];
    const mpm_vector yield =
        metal_strength(law, metal, points->plastic, mpm_splat(0.0), points->softening, &slope);
    const mpm_vector norm = symmetric_norm_vector(points->tau);
    const mpm_mask beyond = ~mpm_at_most(norm, MPM_ROOT_TWO_THIRDS * yield);
    if (!mpm_any(beyond))
        return;
    /* without strength the way back has another end: particle by particle */
    mpm_mask flowing = beyond & mpm_less(MPM_PLASTIC_FAINT * norm, yield);
    const mpm_vector slip = find_slip_vector(law, metal, points, norm, yield, slope, &flowing);
    points->found &= flowing | ~beyond;
    flow_back_vector(metal, flowing, norm, slip, points);
}

/* See mpm_plastic_wave_squared. */
MPM_INLINE mpm_vector metal_wave_squared(const struct metal *metal, mpm_vector bulk,
                                         const struct metal_points *points)
{
    mpm_vector elastic[2], stress[2];
    plane_eigenvalues_vector(points->b_elastic, elastic);
    plane_eigenvalues_vector(points->tau, stress);
    const mpm_vector longitudinal = bulk + 4.0 / 3.0 * metal->shear - stress[0];
    const mpm_vector most = metal->shear * MPM_PLASTIC_SHEAR_BOUND * (elastic[1] / elastic[0]);
    const mpm_mask positive = mpm_less(mpm_splat(0.0), elastic[0]);
    if (!mpm_any(~(positive & mpm_less(most, longitudinal))))
        return longitudinal;
    const mpm_vector part = (elastic[1] - elastic[0]) / elastic[1];
    const mpm_vector ratio =
        mpm_select(mpm_less(mpm_splat(1e-8), part),
                   mpm_logarithm_vector(elastic[1] / elastic[0]) / part, mpm_splat(1.0));
    return mpm_larger(longitudinal, metal->shear * ratio);
}

#endif
