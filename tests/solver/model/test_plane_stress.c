/* Plane stress of laws of the path: exact states of uniaxial and equibiaxial stress, the elastic
 * law, rotations, thickness without a step, laws without an answer.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "model/laws/plane_stress.h"
#include "model/particles.h"
#include "suites.h"
#include "support/near.h"

#include <math.h>
#include <string.h>

static const double DENSITY = 1.7, BULK = 150.0, SHEAR = 60.0, YIELD = 0.9;
static const double PI = 3.14159265358979323846;
enum { PLASTIC = 4 }; /* the equivalent plastic strain among the state variables */

static double points[][2] = {{0.0, 0.9}, {0.02, 1.4}, {0.3, 1.5}};
static double integrals[sizeof points / sizeof points[0]];
static const struct mpm_property table = {sizeof points / sizeof points[0], points, integrals};

static const struct kind {
    const char *name;
    const struct mpm_material_law *law;
    double modulus, strain, exponent, coefficient, kinematic;
    const struct mpm_property *table;
} kinds[] = {
    {"perfect", &mpm_von_mises, 0, 0, 0, 0, 0, NULL},
    {"linear", &mpm_von_mises, 7, 0, 0, 0, 0, NULL},
    {"power", &mpm_von_mises, 0, 0.002, 0.3, 0, 0, NULL},
    {"kinematic", &mpm_von_mises, 0, 0, 0, 0, 5, NULL},
    {"mixed", &mpm_von_mises, 3, 0.01, 0.5, 0, 4, NULL},
    {"table", &mpm_von_mises, 0, 0, 0, 0, 0, &table},
    {"Johnson and Cook", &mpm_johnson_cook, 0, 0, 0.4, 1.1, 0, NULL},
};
enum { KINDS = sizeof kinds / sizeof kinds[0] };

struct sheet {
    double parameter[MPM_PARAMETER_COUNT];
    struct mpm_material material;
    double f[MPM_GRADIENT_SIZE], state[MPM_LAW_STATES], tau[MPM_SYMMETRIC_SIZE], wave;
};

static void begin(struct sheet *sheet, const struct kind *kind)
{
    static const double unit[MPM_GRADIENT_SIZE] = {1, 0, 0, 1, 1};
    for (int k = 0; k < MPM_PARAMETER_COUNT; k++)
        sheet->parameter[k] = 0.0;
    sheet->parameter[MPM_PARAMETER_BULK] = BULK;
    sheet->parameter[MPM_PARAMETER_SHEAR] = SHEAR;
    sheet->parameter[MPM_PARAMETER_YIELD_STRESS] = YIELD;
    sheet->parameter[MPM_PARAMETER_HARDENING_MODULUS] = kind->modulus;
    sheet->parameter[MPM_PARAMETER_HARDENING_STRAIN] = kind->strain;
    sheet->parameter[MPM_PARAMETER_HARDENING_EXPONENT] = kind->exponent;
    sheet->parameter[MPM_PARAMETER_HARDENING_COEFFICIENT] = kind->coefficient;
    sheet->parameter[MPM_PARAMETER_KINEMATIC_MODULUS] = kind->kinematic;
    sheet->material = mpm_material_make(kind->law, DENSITY, sheet->parameter, kind->table);
    mpm_property_prepare(&table);
    mpm_material_start(&sheet->material, sheet->state);
    memcpy(sheet->f, unit, sizeof unit);
    memset(sheet->tau, 0, sizeof sheet->tau);
}

/* To the plane part of `f`. */
static bool move(struct sheet *sheet, const double f[MPM_GRADIENT_SIZE], double duration)
{
    double old_f[MPM_GRADIENT_SIZE], old[MPM_LAW_STATES];
    memcpy(old_f, sheet->f, sizeof old_f);
    memcpy(old, sheet->state, sizeof old);
    memcpy(sheet->f, f, sizeof old_f);
    sheet->f[MPM_ZZ] = old_f[MPM_ZZ];
    const struct mpm_law_step step = {old_f,       sheet->f, duration,   (double)NAN,
                                      (double)NAN, 0.0,      (double)NAN};
    return mpm_plane_stress_update(&sheet->material, &step, sheet->f, old, sheet->state, sheet->tau,
                                   &sheet->wave);
}

static bool stretch(struct sheet *sheet, double xx, double yy)
{
    const double f[MPM_GRADIENT_SIZE] = {exp(xx), 0, 0, exp(yy), 1};
    return move(sheet, f, 0.1);
}

/* s(p), by another way than the laws' */
static double hardened(const struct kind *kind, double p)
{
    if (kind->table != NULL && p < points[1][0])
        return points[0][1] + p * (points[1][1] - points[0][1]) / points[1][0];
    if (kind->table != NULL)
        return points[1][1] +
               (p - points[1][0]) * (points[2][1] - points[1][1]) / (points[2][0] - points[1][0]);
    const double power = kind->strain > 0.0 ? pow(1.0 + p / kind->strain, kind->exponent) : 1.0;
    return YIELD * power + kind->modulus * p + kind->coefficient * pow(p, kind->exponent);
}

/* Strains where the stress is `stress` times the principal values `along` (x, y, z) after the
 * plastic strain p along the deviator of `along`: e_i = (along_i - mean) q/(2 G) + mean q/(3 K) +
 * e_p,i. Values of `along` are 0 or 1. Monotone, so that what yields is s(p) plus back stress. */
static void strains_of(const struct kind *kind, const double along[3], double p, double *stress,
                       double strain[3])
{
    const double mean = (along[0] + along[1] + along[2]) / 3.0;
    *stress = hardened(kind, p) + kind->kinematic * p;
    for (int i = 0; i < 3; i++)
        strain[i] =
            (along[i] - mean) * (*stress / (2.0 * SHEAR) + 1.5 * p) + mean * *stress / (3.0 * BULK);
}

/* --------------------------------------------------------------------- exact states */

/* Uniaxial along each axis, and equibiaxial: the direction of flow stays, so that any steps are
 * exact. */
START_TEST(stress_and_thickness_are_exact_in_uniaxial_and_equibiaxial_tension)
{
    static const double STRESS = 1e-13, STRAIN = 3e-14; /* round-off: of K; of strains */
    static const double ways[][3] = {{1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
    for (int k = 0; k < KINDS; k++)
        for (size_t w = 0; w < sizeof ways / sizeof ways[0]; w++)
            for (int steps = 1; steps <= 16; steps *= 4) {
                struct sheet sheet;
                begin(&sheet, &kinds[k]);
                for (int n = 1; n <= steps; n++) {
                    double stress, strain[3];
                    const double p = 0.25 * n / steps;
                    strains_of(&kinds[k], ways[w], p, &stress, strain);
                    ck_assert_msg(stretch(&sheet, strain[0], strain[1]), "%s", kinds[k].name);
                    const double scale = STRESS * BULK;
                    ck_assert_near(DENSITY * sheet.tau[MPM_SYM_XX], ways[w][0] * stress, scale);
                    ck_assert_near(DENSITY * sheet.tau[MPM_SYM_YY], ways[w][1] * stress, scale);
                    ck_assert_near(DENSITY * sheet.tau[MPM_SYM_ZZ], 0.0, scale);
                    ck_assert_near(sheet.state[PLASTIC], p, STRAIN);
                    ck_assert_near(log(sheet.f[MPM_ZZ]), strain[2], STRAIN);
                }
            }
}
END_TEST

/* A path that stretches and shears, at time t from 0 to 1. */
static void path(double t, double f[MPM_GRADIENT_SIZE])
{
    f[MPM_XX] = 1.0 + 0.2 * t;
    f[MPM_XY] = 0.9 * t;
    f[MPM_YX] = -0.15 * sin(3.0 * t);
    f[MPM_YY] = 1.0 - 0.1 * sin(7.0 * t);
    f[MPM_ZZ] = 1.0;
}

START_TEST(no_step_of_any_size_leaves_stress_across_the_plane_while_the_body_turns)
{
    static const double ROUND_OFF = 2e-13;
    for (int k = 0; k < KINDS; k++)
        for (int steps = 4; steps <= 400; steps *= 10) {
            struct sheet still, turned;
            begin(&still, &kinds[k]);
            begin(&turned, &kinds[k]);
            for (int n = 1; n <= steps; n++) {
                const double t = (double)n / steps, angle = 40.0 * PI * t;
                const double c = cos(angle), s = sin(angle);
                const double r[MPM_GRADIENT_SIZE] = {c, -s, s, c, 1};
                double f[MPM_GRADIENT_SIZE];
                path(t, f);
                ck_assert(move(&still, f, 0.1));
                mpm_deformation_compose(r, f);
                ck_assert(move(&turned, f, 0.1));
                ck_assert_near(DENSITY * still.tau[MPM_SYM_ZZ], 0.0, ROUND_OFF * BULK);
                ck_assert_near(DENSITY * turned.tau[MPM_SYM_ZZ], 0.0, ROUND_OFF * BULK);
                ck_assert_near(turned.f[MPM_ZZ], still.f[MPM_ZZ], 10 * ROUND_OFF);
                ck_assert_near(turned.state[PLASTIC], still.state[PLASTIC], 10 * ROUND_OFF);
            }
            ck_assert_double_gt(still.state[PLASTIC], 0.3);
            ck_assert_double_lt(still.f[MPM_ZZ], 1.0);
        }
}
END_TEST

/* Below yield: Hencky's sheet, tau = E/(1 - nu^2) (e + nu e'), e_zz = -nu/(1 - nu) (e + e'). Also
 * without a step, where the state has to stay as it is. */
START_TEST(below_yield_the_sheet_is_the_elastic_one_with_and_without_a_step)
{
    static const double DURATIONS[] = {0.1, 0.0};
    const double nu = (3.0 * BULK - 2.0 * SHEAR) / (2.0 * (3.0 * BULK + SHEAR));
    const double plane = 2.0 * SHEAR * (1.0 + nu) / (1.0 - nu * nu);
    for (int k = 0; k < KINDS; k++)
        for (int d = 0; d < 2; d++) {
            const double x = 0.003, y = -0.001;
            const double f[MPM_GRADIENT_SIZE] = {exp(x), 0, 0, exp(y), 1};
            struct sheet sheet, fresh;
            begin(&sheet, &kinds[k]);
            begin(&fresh, &kinds[k]);
            ck_assert(move(&sheet, f, DURATIONS[d]));
            ck_assert_near(DENSITY * sheet.tau[MPM_SYM_XX], plane * (x + nu * y), 1e-13 * BULK);
            ck_assert_near(DENSITY * sheet.tau[MPM_SYM_YY], plane * (y + nu * x), 1e-13 * BULK);
            ck_assert_near(log(sheet.f[MPM_ZZ]), -nu / (1.0 - nu) * (x + y), 1e-15);
            ck_assert_mem_eq(sheet.state, fresh.state, PLASTIC * sizeof(double));
        }
}
END_TEST

/* ------------------------------------------------------------------- no answer */

static bool press_always(const struct mpm_material *m, const struct mpm_law_step *step,
                         double *state, double tau[MPM_SYMMETRIC_SIZE], double *wave)
{
    (void)m;
    (void)step;
    (void)state;
    tau[MPM_SYM_XX] = tau[MPM_SYM_YY] = tau[MPM_SYM_ZZ] = -1.0;
    tau[MPM_SYM_XY] = 0.0;
    *wave = 1.0;
    return true;
}

static bool never(const struct mpm_material *m, const struct mpm_law_step *step, double *state,
                  double tau[MPM_SYMMETRIC_SIZE], double *wave)
{
    (void)press_always(m, step, state, tau, wave);
    return false;
}

START_TEST(a_law_without_an_answer_is_reported)
{
    static const struct mpm_material_law pressing = {.name = "pressing", .update = press_always};
    static const struct mpm_material_law refusing = {.name = "refusing", .update = never};
    static const double unit[MPM_GRADIENT_SIZE] = {1, 0, 0, 1, 1};
    struct sheet sheet;
    begin(&sheet, &kinds[0]);
    sheet.material.law = &pressing;
    ck_assert(!move(&sheet, unit, 0.1));
    ck_assert(isnan(sheet.f[MPM_ZZ]));
    begin(&sheet, &kinds[0]);
    sheet.material.law = &refusing;
    ck_assert(!move(&sheet, unit, 0.1));
    ck_assert_double_eq(sheet.f[MPM_ZZ], 1.0);
}
END_TEST

Suite *suite_plane_stress(void)
{
    Suite *const suite = suite_create("plane_stress");
    TCase *const tests = tcase_create("laws of the path");
    tcase_add_test(tests, stress_and_thickness_are_exact_in_uniaxial_and_equibiaxial_tension);
    tcase_add_test(tests, no_step_of_any_size_leaves_stress_across_the_plane_while_the_body_turns);
    tcase_add_test(tests, below_yield_the_sheet_is_the_elastic_one_with_and_without_a_step);
    tcase_add_test(tests, a_law_without_an_answer_is_reported);
    suite_add_tcase(suite, tests);
    return suite;
}
