/* P = dW/dF of the solver's laws, on slopes: with F and Grad F go in P and Grad P come out.
 * Written from the energies W, not from the solver's stress:
 *
 *     neo_hookean      W = K/2 [(J^2 - 1)/2 - ln J] + G/2 (J^(-2/3) tr B - 3),
 *                      P = [K/2 (J - 1/J) - G J^(-2/3) tr B / (3 J)] cof F + G J^(-2/3) F,
 *     linear_elastic   W = G |U - I|^2 + lambda/2 tr(U - I)^2,
 *                      P = 2 G (F - R) + lambda (tr U - 3) R,
 *
 * from dJ/dF = cof F, d tr B/dF = 2 F and d tr U/dF = R, the rotation of F.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_EXACT_MANUFACTURED_STRESS_H
#define VERIFICATION_EXACT_MANUFACTURED_STRESS_H

#include "verification/exact/manufactured/jet.h"
#include "verification/exact/manufactured/manufactured.h"

enum { P_XX, P_XY, P_YX, P_YY, P_ZZ, P_SIZE };

LANES_INLINE struct slope stress_plane_determinant(const struct slope f[P_SIZE])
{
    return slope_subtract(slope_multiply(f[P_XX], f[P_YY]), slope_multiply(f[P_XY], f[P_YX]));
}

LANES_INLINE void stress_neo_hookean(const struct manufactured_problem *m,
                                     const struct slope f[P_SIZE], struct slope p[P_SIZE])
{
    const struct slope plane = stress_plane_determinant(f), j = slope_multiply(plane, f[P_ZZ]);
    const struct slope inverse = slope_inverse(j), third = slope_scale(1.0 / 3, inverse);
    const struct slope shear = slope_scale(m->shear, slope_power_minus_two_thirds(j, inverse));
    struct slope trace = slope_square(f[0]);
    for (int k = 1; k < P_SIZE; k++)
        trace = slope_add(trace, slope_square(f[k]));
    const struct slope pressure = slope_scale(0.5 * m->bulk, slope_subtract(j, inverse));
    const struct slope volume =
        slope_subtract(pressure, slope_multiply(shear, slope_multiply(trace, third)));
    const struct slope turned = slope_multiply(volume, f[P_ZZ]);
    const struct slope cofactor[P_SIZE] = {
        slope_multiply(turned, f[P_YY]), slope_scale(-1.0, slope_multiply(turned, f[P_YX])),
        slope_scale(-1.0, slope_multiply(turned, f[P_XY])), slope_multiply(turned, f[P_XX]),
        slope_multiply(volume, plane)};
    for (int k = 0; k < P_SIZE; k++)
        p[k] = slope_add(cofactor[k], slope_multiply(shear, f[k]));
}

LANES_INLINE void stress_linear_elastic(const struct manufactured_problem *m,
                                        const struct slope f[P_SIZE], struct slope p[P_SIZE])
{
    /* tr U of the plane and R = (F + cof F) / tr U, by Cayley and Hamilton */
    const struct slope sum = slope_add(f[P_XX], f[P_YY]);
    const struct slope turn = slope_subtract(f[P_YX], f[P_XY]);
    const struct slope trace = slope_root(slope_add(slope_square(sum), slope_square(turn)));
    const struct slope inverse = slope_inverse(trace);
    const struct slope c = slope_multiply(sum, inverse), s = slope_multiply(turn, inverse);
    const struct slope one = {.f = lanes_splat(1.0)};
    const struct slope rotation[P_SIZE] = {c, slope_scale(-1.0, s), s, c, one};
    struct slope strain = slope_add(trace, f[P_ZZ]);
    strain.f -= 3.0;
    const struct slope volume = slope_scale(m->lame, strain);
    for (int k = 0; k < P_SIZE; k++)
        p[k] = slope_add(slope_scale(2.0 * m->shear, slope_subtract(f[k], rotation[k])),
                         slope_multiply(volume, rotation[k]));
}

/* Hooke's law of small strain: what the others are near F = I. */
LANES_INLINE void stress_hooke(const struct manufactured_problem *m, const struct slope f[P_SIZE],
                               struct slope p[P_SIZE])
{
    struct slope e[P_SIZE] = {f[P_XX], f[P_XY], f[P_YX], f[P_YY], f[P_ZZ]};
    e[P_XX].f -= 1.0;
    e[P_YY].f -= 1.0;
    e[P_ZZ].f -= 1.0;
    if (m->geometry == MPM_PLANE_STRESS)
        e[P_ZZ] = slope_scale(-m->lame / (m->lame + 2.0 * m->shear), slope_add(e[P_XX], e[P_YY]));
    const struct slope volume =
        slope_scale(m->lame, slope_add(slope_add(e[P_XX], e[P_YY]), e[P_ZZ]));
    const struct slope shear = slope_scale(m->shear, slope_add(e[P_XY], e[P_YX]));
    for (int k = 0; k < P_SIZE; k++)
        p[k] =
            k == P_XY || k == P_YX ? shear : slope_add(slope_scale(2.0 * m->shear, e[k]), volume);
}

LANES_INLINE void stress_of_law(const struct manufactured_problem *m, const struct slope f[P_SIZE],
                                struct slope p[P_SIZE])
{
    if (m->law == MANUFACTURED_NEO_HOOKEAN)
        stress_neo_hookean(m, f, p);
    else
        stress_linear_elastic(m, f, p);
}

/* Plane stress: sets F_zz so that P_zz = 0, by Newton's method with the derivative along F_zz in
 * the place of one along X; then its gradient, from that of P_zz at a fixed F_zz. */
LANES_INLINE void stress_free_thickness(const struct manufactured_problem *m,
                                        struct slope f[P_SIZE])
{
    struct slope alone[P_SIZE], p[P_SIZE];
    lanes rate = lanes_splat(1.0);
    for (int k = 0; k < P_SIZE; k++)
        alone[k] = (struct slope){.f = f[k].f};
    alone[P_ZZ] = (struct slope){.f = lanes_splat(1.0), .x = lanes_splat(1.0)};
    lanes_mask open = rate > 0.0; /* lanes that are done wait for others */
    for (int turn = 0; turn < 60 && lanes_any(open); turn++) {
        stress_of_law(m, alone, p);
        rate = lanes_select(open, p[P_ZZ].x, rate);
        const lanes old = alone[P_ZZ].f, wanted = old - p[P_ZZ].f / p[P_ZZ].x;
        const lanes next = lanes_select(wanted > 0.1 * old, wanted, 0.1 * old);
        alone[P_ZZ].f = lanes_select(open, next, old);
        open &= (next - old > 4e-16 * old) | (old - next > 4e-16 * old);
    }
    f[P_ZZ] = (struct slope){.f = alone[P_ZZ].f};
    stress_of_law(m, f, p);
    f[P_ZZ].x = -p[P_ZZ].x / rate;
    f[P_ZZ].y = -p[P_ZZ].y / rate;
}

#endif
