/* Properties that every constitutive law has, table by table.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "model/material.h"
#include "suites.h"
#include "support/near.h"

#include <float.h>

static const struct mpm_material_law *const laws[] = {&mpm_neo_hookean, &mpm_linear_elastic};
enum { LAWS = sizeof laws / sizeof laws[0] };

static const double DENSITY = 1.7, BULK = 23.0, SHEAR = 9.0;
static const double constants[] = {[MPM_PARAMETER_BULK] = 23.0, [MPM_PARAMETER_SHEAR] = 9.0};

/* Stretch, shear, rotation and compression, all with det F > 0. */
static const double states[][MPM_GRADIENT_SIZE] = {
    {1, 0, 0, 1, 1},
    {1.1, 0, 0, 0.95, 1.02},
    {1.2, 0.3, -0.1, 0.9, 0.8},
    {0.5, -0.4, 0.6, 0.7, 1.3},
    {0.1, -1.1, 0.9, 0.2, 1},
    {0.3, 0, 0, 0.3, 0.3},
};
enum { STATES = sizeof states / sizeof states[0] };

static struct mpm_material material_of(const struct mpm_material_law *law)
{
    return mpm_material_make(law, DENSITY, constants, NULL);
}

START_TEST(a_law_is_found_by_its_name_and_no_other_is)
{
    for (int l = 0; l < LAWS; l++) {
        ck_assert_ptr_eq(mpm_material_law_find(laws[l]->name), laws[l]);
        ck_assert_ptr_nonnull(strstr(mpm_material_law_names(), laws[l]->name));
    }
    ck_assert_ptr_null(mpm_material_law_find("rubber"));
}
END_TEST

/* tau = (dW/dF) F^T; W and tau are both over rho_0. */
START_TEST(stress_is_the_derivative_of_energy)
{
    static const double STEP = 1e-6, TRUNCATION = 2e-8; /* of central differences, W'''/6 h^2 */
    for (int l = 0; l < LAWS; l++)
        for (int s = 0; s < STATES; s++) {
            const struct mpm_material m = material_of(laws[l]);
            double p[MPM_GRADIENT_SIZE], tau[MPM_SYMMETRIC_SIZE], unused;
            for (int k = 0; k < MPM_GRADIENT_SIZE; k++) {
                double high[MPM_GRADIENT_SIZE], low[MPM_GRADIENT_SIZE];
                memcpy(high, states[s], sizeof high);
                memcpy(low, states[s], sizeof low);
                high[k] += STEP;
                low[k] -= STEP;
                p[k] = (m.law->energy(&m, high, NULL) - m.law->energy(&m, low, NULL)) / (2 * STEP);
            }
            const double *const f = states[s];
            m.law->stress(&m, f, tau, &unused);
            const double xx = p[MPM_XX] * f[MPM_XX] + p[MPM_XY] * f[MPM_XY];
            const double xy = p[MPM_XX] * f[MPM_YX] + p[MPM_XY] * f[MPM_YY];
            const double yx = p[MPM_YX] * f[MPM_XX] + p[MPM_YY] * f[MPM_XY];
            const double yy = p[MPM_YX] * f[MPM_YX] + p[MPM_YY] * f[MPM_YY];
            const double scale = 1.0 + 100.0 * m.bulk;
            ck_assert_near(tau[MPM_SYM_XX], xx, TRUNCATION * scale);
            ck_assert_near(tau[MPM_SYM_XY], xy, TRUNCATION * scale);
            ck_assert_near(tau[MPM_SYM_XY], yx, TRUNCATION * scale);
            ck_assert_near(tau[MPM_SYM_YY], yy, TRUNCATION * scale);
            ck_assert_near(tau[MPM_SYM_ZZ], p[MPM_ZZ] * f[MPM_ZZ], TRUNCATION * scale);
        }
}
END_TEST

static void rotate(double angle, double f[MPM_GRADIENT_SIZE])
{
    const double r[MPM_GRADIENT_SIZE] = {cos(angle), -sin(angle), sin(angle), cos(angle), 1};
    mpm_deformation_compose(r, f);
}

START_TEST(a_rotation_turns_the_stress_and_keeps_the_energy)
{
    static const double ROUND_OFF = 1e-13;
    for (int l = 0; l < LAWS; l++)
        for (int s = 0; s < STATES; s++)
            for (double angle = -3.0; angle < 3.2; angle += 0.7) {
                const struct mpm_material m = material_of(laws[l]);
                double f[MPM_GRADIENT_SIZE], tau[MPM_SYMMETRIC_SIZE], turned[MPM_SYMMETRIC_SIZE];
                double speed, turned_speed;
                memcpy(f, states[s], sizeof f);
                m.law->stress(&m, f, tau, &speed);
                const double energy = m.law->energy(&m, f, NULL);
                rotate(angle, f);
                m.law->stress(&m, f, turned, &turned_speed);
                const double c = cos(angle), n = sin(angle), scale = 20.0 * m.bulk;
                ck_assert_near(turned[MPM_SYM_XX],
                               c * c * tau[MPM_SYM_XX] - 2 * c * n * tau[MPM_SYM_XY] +
                                   n * n * tau[MPM_SYM_YY],
                               ROUND_OFF * scale);
                ck_assert_near(turned[MPM_SYM_XY],
                               c * n * (tau[MPM_SYM_XX] - tau[MPM_SYM_YY]) +
                                   (c * c - n * n) * tau[MPM_SYM_XY],
                               ROUND_OFF * scale);
                ck_assert_near(turned[MPM_SYM_ZZ], tau[MPM_SYM_ZZ], ROUND_OFF * scale);
                ck_assert_near(m.law->energy(&m, f, NULL), energy, ROUND_OFF * scale);
                ck_assert_near(turned_speed, speed, ROUND_OFF * scale);
            }
}
END_TEST

START_TEST(small_strains_give_hookes_law)
{
    static const double STRAIN = 1e-6, QUADRATIC = 10.0; /* the error is of order strain^2 */
    for (int l = 0; l < LAWS; l++) {
        const struct mpm_material m = material_of(laws[l]);
        const double e[3] = {STRAIN, -0.4 * STRAIN, 0.3 * STRAIN}, shear = 0.5 * STRAIN;
        const double f[MPM_GRADIENT_SIZE] = {1 + e[0], shear, shear, 1 + e[1], 1 + e[2]};
        double tau[MPM_SYMMETRIC_SIZE], unused;
        m.law->stress(&m, f, tau, &unused);
        const double lame = (BULK - 2.0 / 3.0 * SHEAR) / DENSITY, g = SHEAR / DENSITY;
        const double volumetric = lame * (e[0] + e[1] + e[2]);
        const double tolerance = QUADRATIC * m.bulk * STRAIN * STRAIN;
        ck_assert_near(tau[MPM_SYM_XX], volumetric + 2 * g * e[0], tolerance);
        ck_assert_near(tau[MPM_SYM_YY], volumetric + 2 * g * e[1], tolerance);
        ck_assert_near(tau[MPM_SYM_ZZ], volumetric + 2 * g * e[2], tolerance);
        ck_assert_near(tau[MPM_SYM_XY], 2 * g * shear, tolerance);
    }
}
END_TEST

START_TEST(the_undeformed_body_is_free_of_stress_and_carries_elastic_waves)
{
    for (int l = 0; l < LAWS; l++) {
        const struct mpm_material m = material_of(laws[l]);
        double tau[MPM_SYMMETRIC_SIZE], speed_squared;
        m.law->stress(&m, states[0], tau, &speed_squared);
        for (int k = 0; k < MPM_SYMMETRIC_SIZE; k++)
            ck_assert_double_eq(tau[k], 0.0);
        ck_assert_double_eq(m.law->energy(&m, states[0], NULL), 0.0);
        ck_assert_near(speed_squared, (BULK + 4.0 / 3.0 * SHEAR) / DENSITY, 1e-14 * m.bulk);
    }
}
END_TEST

/* Waves along a principal direction n: rho_0 c^2 = l^2 W_ll, by differences of tau. */
START_TEST(the_wave_speed_bounds_longitudinal_waves_of_stretched_bodies)
{
    static const double STEP = 1e-5, TRUNCATION = 1e-6;
    for (int l = 0; l < LAWS; l++)
        for (int s = 0; s < STATES; s++)
            for (int direction = 0; direction < 2; direction++) {
                const struct mpm_material m = material_of(laws[l]);
                double f[MPM_GRADIENT_SIZE] = {0.2 + 0.3 * s, 0, 0, 1.4 - 0.2 * s, 0.5 + 0.1 * s};
                double tau[MPM_SYMMETRIC_SIZE], high[MPM_SYMMETRIC_SIZE], speed_squared, unused;
                const int k = direction == 0 ? MPM_XX : MPM_YY;
                m.law->stress(&m, f, tau, &speed_squared);
                f[k] *= 1 + STEP;
                m.law->stress(&m, f, high, &unused);
                /* l^2 W_ll = l d(tau)/dl - tau */
                const double modulus = (high[direction] - tau[direction]) / STEP - tau[direction];
                ck_assert_msg(modulus <= speed_squared * (1 + TRUNCATION) + 200.0 * STEP * m.bulk,
                              "%s: modulus %g above %g", m.law->name, modulus, speed_squared);
            }
}
END_TEST

START_TEST(plane_stress_leaves_no_stress_across_the_plane)
{
    static const double ROUND_OFF = 1e-13;
    for (int l = 0; l < LAWS; l++)
        for (int s = 0; s < 4; s++) {
            const struct mpm_material m = material_of(laws[l]);
            double f[MPM_GRADIENT_SIZE], tau[MPM_SYMMETRIC_SIZE], unused;
            memcpy(f, states[s], sizeof f);
            f[MPM_ZZ] = 1.0;
            f[MPM_ZZ] = m.law->thickness_stretch(&m, f);
            ck_assert(f[MPM_ZZ] > 0.0);
            m.law->stress(&m, f, tau, &unused);
            ck_assert_near(tau[MPM_SYM_ZZ], 0.0, ROUND_OFF * m.bulk);
        }
}
END_TEST

Suite *suite_material(void)
{
    Suite *const suite = suite_create("material");
    TCase *const tests = tcase_create("laws");
    tcase_add_test(tests, a_law_is_found_by_its_name_and_no_other_is);
    tcase_add_test(tests, stress_is_the_derivative_of_energy);
    tcase_add_test(tests, a_rotation_turns_the_stress_and_keeps_the_energy);
    tcase_add_test(tests, small_strains_give_hookes_law);
    tcase_add_test(tests, the_undeformed_body_is_free_of_stress_and_carries_elastic_waves);
    tcase_add_test(tests, the_wave_speed_bounds_longitudinal_waves_of_stretched_bodies);
    tcase_add_test(tests, plane_stress_leaves_no_stress_across_the_plane);
    suite_add_tcase(suite, tests);
    return suite;
}
