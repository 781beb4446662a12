/* The elastoplastic law, driven along given paths of F: exact curves and angles, energy, rotations.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/exponential.h"
#include "base/spectral.h"
#include "model/material.h"
#include "model/particles.h"
#include "suites.h"
#include "support/near.h"

#include <float.h>

static const double DENSITY = 1.7, BULK = 150.0, SHEAR = 60.0, YIELD = 0.9;
enum { PLASTIC = 4 }; /* the equivalent plastic strain among the state variables */

/* Steep, flat, rising, and constant beyond 1.2; it begins at YIELD. */
static double points[][2] = {{0.0, 0.9}, {0.01, 1.3}, {0.2, 1.3}, {0.5, 2.1}, {1.2, 2.2}};
static double integrals[sizeof points / sizeof points[0]];
static const struct mpm_property table = {sizeof points / sizeof points[0], points, integrals};

static const struct hardening {
    const char *name;
    double modulus, strain, exponent, kinematic;
    const struct mpm_property *table;
} hardenings[] = {
    {"perfect", 0.0, 0.0, 0.0, 0.0, NULL},       {"linear", 7.0, 0.0, 0.0, 0.0, NULL},
    {"power", 0.0, 0.002, 0.3, 0.0, NULL},       {"kinematic", 0.0, 0.0, 0.0, 5.0, NULL},
    {"mixed", 3.0, 0.01, 0.5, 4.0, NULL},        {"tabulated", 0.0, 0.0, 0.0, 0.0, &table},
    {"table and kinematic", 0, 0, 0, 5, &table},
};
enum { HARDENINGS = sizeof hardenings / sizeof hardenings[0] };

struct point {
    double parameter[MPM_PARAMETER_COUNT];
    struct mpm_material material;
    double f[MPM_GRADIENT_SIZE], state[MPM_LAW_STATES], tau[MPM_SYMMETRIC_SIZE], wave;
};

static void begin(struct point *point, const struct hardening *hardening)
{
    for (int k = 0; k < MPM_PARAMETER_COUNT; k++)
        point->parameter[k] = (double)NAN;
    point->parameter[MPM_PARAMETER_BULK] = BULK;
    point->parameter[MPM_PARAMETER_SHEAR] = SHEAR;
    point->parameter[MPM_PARAMETER_YIELD_STRESS] = YIELD;
    point->parameter[MPM_PARAMETER_HARDENING_MODULUS] = hardening->modulus;
    point->parameter[MPM_PARAMETER_HARDENING_STRAIN] = hardening->strain;
    point->parameter[MPM_PARAMETER_HARDENING_EXPONENT] = hardening->exponent;
    point->parameter[MPM_PARAMETER_KINEMATIC_MODULUS] = hardening->kinematic;
    point->material =
        mpm_material_make(&mpm_von_mises, DENSITY, point->parameter, hardening->table);
    mpm_property_prepare(&table);
    for (size_t k = 0; k < mpm_von_mises.variable_count; k++)
        point->state[k] = mpm_von_mises.variables[k].start;
    const double unit[MPM_GRADIENT_SIZE] = {1, 0, 0, 1, 1};
    memcpy(point->f, unit, sizeof unit);
    memset(point->tau, 0, sizeof point->tau);
}

static bool move(struct point *point, const double f[MPM_GRADIENT_SIZE])
{
    double old[MPM_GRADIENT_SIZE];
    memcpy(old, point->f, sizeof old);
    memcpy(point->f, f, sizeof old);
    const struct mpm_law_step step = {old,         point->f, 0.1,        (double)NAN,
                                      (double)NAN, 0.0,      (double)NAN};
    return mpm_von_mises.update(&point->material, &step, point->state, point->tau, &point->wave);
}

/* To the logarithmic strains along the axes. */
static void stretch(struct point *point, double xx, double yy, double zz)
{
    const double f[MPM_GRADIENT_SIZE] = {exp(xx), 0, 0, exp(yy), exp(zz)};
    ck_assert(move(point, f));
}

/* By a walk along the points. */
static double read_off(double plastic)
{
    size_t k = 0;
    while (k < table.count && points[k][0] < plastic)
        k++;
    if (k == 0 || k == table.count)
        return points[k == 0 ? 0 : k - 1][1];
    const double part = (plastic - points[k - 1][0]) / (points[k][0] - points[k - 1][0]);
    return (1.0 - part) * points[k - 1][1] + part * points[k][1];
}

static double hardened(const struct hardening *h, double plastic)
{
    if (h->table != NULL)
        return read_off(plastic);
    return YIELD * (h->strain > 0.0 ? pow(1.0 + plastic / h->strain, h->exponent) : 1.0) +
           h->modulus * plastic;
}

/* ---------------------------------------------------------------------- functions */

START_TEST(the_logarithm_is_that_of_the_library_and_of_nothing_below_zero)
{
    static const double UNITS = 4 * DBL_EPSILON;
    for (double x = -300.0; x < 300.0; x += 0.37) {
        const double y = exp(x);
        ck_assert_near(mpm_logarithm(y), log(y), UNITS * fmax(fabs(x), 1e-3));
    }
    for (double x = 1e-16; x < 0.5; x *= 1.9)
        ck_assert_near(mpm_logarithm(1.0 + x), log(1.0 + x), UNITS * x);
    ck_assert_double_eq(mpm_logarithm(1.0), 0.0);
    ck_assert(isnan(mpm_logarithm(0.0)) && isnan(mpm_logarithm(-1.0)));
    ck_assert(isnan(mpm_logarithm((double)INFINITY)) && isnan(mpm_logarithm((double)NAN)));
}
END_TEST

START_TEST(exponential_logarithm_root_and_inverse_of_tensors_fit_each_other)
{
    static const double ROUND_OFF = 1e-14;
    static const double list[][MPM_SYMMETRIC_SIZE] = {
        {0, 0, 0, 0},  {1e-9, -2e-9, 1e-9, 3e-9}, {0.3, 0.3, -0.1, 0}, {0.2, -0.5, 0.7, 0.4},
        {1, -1, 0, 2}, {1e-3, 1.1e-3, 0, 1e-8}};
    for (size_t i = 0; i < sizeof list / sizeof list[0]; i++) {
        double e[MPM_SYMMETRIC_SIZE], l[MPM_SYMMETRIC_SIZE], r[MPM_SYMMETRIC_SIZE];
        double n[MPM_SYMMETRIC_SIZE], unit[MPM_SYMMETRIC_SIZE];
        static const double identity[MPM_SYMMETRIC_SIZE] = {1, 1, 1, 0};
        mpm_symmetric_exponential(list[i], e);
        mpm_symmetric_logarithm(e, l);
        mpm_symmetric_root(e, r);
        mpm_symmetric_inverse(r, n);
        mpm_symmetric_sandwich(n, e, unit);
        const double scale = ROUND_OFF * (1.0 + exp(4.0 * mpm_symmetric_norm(list[i])));
        for (int k = 0; k < MPM_SYMMETRIC_SIZE; k++) {
            ck_assert_near(l[k], list[i][k], scale);
            ck_assert_near(unit[k], identity[k], scale);
        }
    }
}
END_TEST

/* -------------------------------------------------------------------- exact curves */

/* Isochoric, along y: q = tau_yy - tau_xx = 3 G (a - e), a the logarithmic strain and e its plastic
 * part. Where it yields, |q - H_k e| = s(p). Exact for any steps, as nothing turns. The axis is
 * each of the three. */
START_TEST(cyclic_tension_follows_each_hardening_along_each_axis)
{
    static const double ROUND_OFF = 1e-12, REVERSALS[] = {0.31, -0.2, 0.25, 0.0, 0.8};
    enum { STEPS = 37 };
    for (int h = 0; h < HARDENINGS; h++)
        for (int axis = 0; axis < 3; axis++) {
            static const int place[] = {MPM_SYM_XX, MPM_SYM_YY, MPM_SYM_ZZ};
            struct point point;
            double e = 0.0, p = 0.0, a = 0.0;
            begin(&point, &hardenings[h]);
            for (size_t leg = 0; leg < sizeof REVERSALS / sizeof REVERSALS[0]; leg++) {
                const double from = a;
                for (int k = 1; k <= STEPS; k++) {
                    double x[3];
                    a = from + (REVERSALS[leg] - from) * k / STEPS;
                    for (int i = 0; i < 3; i++)
                        x[i] = i == axis ? a : -0.5 * a;
                    stretch(&point, x[0], x[1], x[2]);
                    const double q =
                        DENSITY * (point.tau[place[axis]] - point.tau[place[(axis + 1) % 3]]);
                    const double now = a - q / (3.0 * SHEAR), scale = ROUND_OFF * SHEAR;
                    p += fabs(now - e);
                    ck_assert_near(point.state[PLASTIC], p, ROUND_OFF * STEPS);
                    const double driving = fabs(q - hardenings[h].kinematic * now);
                    if (fabs(now - e) > 1e-6)
                        ck_assert_near(driving, hardened(&hardenings[h], p), scale);
                    else
                        ck_assert_double_le(driving, hardened(&hardenings[h], p) + scale);
                    e = now;
                }
            }
            ck_assert_double_gt(p, 1.5);
        }
}
END_TEST

/* Constant rate of deviatoric strain e' in fixed axes: the angle psi between s and e' has
 * tan(psi/2) = tan(psi_0/2) exp(-2 G |e'| t/R), as R psi' = -2 G |e'| sin(psi). A step of the
 * return has tan(psi') = R sin(psi)/(R cos(psi) + 2 G |e'| dt). */
START_TEST(the_angle_of_the_stress_follows_each_step_and_the_exact_solution_in_first_order)
{
    static const double START = 1.4, WAY = 1.6; /* angle; 2 G |e| / R in all */
    double last = 0.0;
    for (int steps = 20; steps <= 160; steps *= 2) {
        struct point point;
        begin(&point, &hardenings[0]);
        /* unit vectors in the deviatoric plane */
        const double u[3] = {sqrt(2.0 / 3), -sqrt(1.0 / 6), -sqrt(1.0 / 6)};
        const double v[3] = {0.0, sqrt(0.5), -sqrt(0.5)};
        const double radius = sqrt(2.0 / 3) * YIELD, size = radius / (2.0 * SHEAR);
        double e[3], psi = START;
        for (int i = 0; i < 3; i++)
            e[i] = size * (cos(START) * u[i] + sin(START) * v[i]);
        stretch(&point, e[0], e[1], e[2]);
        for (int k = 1; k <= steps; k++) {
            const double along = size * WAY * k / steps;
            stretch(&point, e[0] + along * u[0], e[1] + along * u[1], e[2] + along * u[2]);
            const double *const t = point.tau;
            const double c = t[MPM_SYM_XX] * u[0] + t[MPM_SYM_YY] * u[1] + t[MPM_SYM_ZZ] * u[2];
            const double s = t[MPM_SYM_XX] * v[0] + t[MPM_SYM_YY] * v[1] + t[MPM_SYM_ZZ] * v[2];
            psi = atan2(sin(psi), cos(psi) + WAY / steps);
            ck_assert_near(DENSITY * hypot(c, s), radius, 1e-12 * YIELD);
            ck_assert_near(atan2(s, c), psi, 1e-11);
        }
        const double error = fabs(psi - 2.0 * atan(tan(0.5 * START) * exp(-WAY)));
        ck_assert(steps == 20 || (error < 0.53 * last && error > 0.47 * last));
        last = error;
    }
}
END_TEST

/* ----------------------------------------------------------------------- invariance */

/* A path that stretches and shears, at time t from 0 to 1; its axes turn. */
static void path(double t, double f[MPM_GRADIENT_SIZE])
{
    f[MPM_XX] = 1.0 + 0.2 * t;
    f[MPM_XY] = 0.9 * t;
    f[MPM_YX] = -0.15 * sin(3.0 * t);
    f[MPM_YY] = 1.0 - 0.1 * t;
    f[MPM_ZZ] = 1.0 + 0.05 * sin(5.0 * t);
}

START_TEST(the_answer_is_the_same_while_the_body_turns_twenty_times)
{
    enum { STEPS = 400 };
    static const double ROUND_OFF = 2e-13, TURNS = 20.0, PI = 3.14159265358979323846;
    for (int h = 0; h < HARDENINGS; h++) {
        struct point still, turned;
        begin(&still, &hardenings[h]);
        begin(&turned, &hardenings[h]);
        for (int k = 1; k <= STEPS; k++) {
            const double t = (double)k / STEPS, angle = 2.0 * PI * TURNS * t;
            const double c = cos(angle), n = sin(angle);
            const double r[MPM_GRADIENT_SIZE] = {c, -n, n, c, 1};
            double f[MPM_GRADIENT_SIZE];
            path(t, f);
            ck_assert(move(&still, f));
            mpm_deformation_compose(r, f);
            ck_assert(move(&turned, f));
            const double *const a = still.tau, *const b = turned.tau;
            const double xx = a[MPM_SYM_XX], yy = a[MPM_SYM_YY], xy = a[MPM_SYM_XY];
            const double scale = ROUND_OFF * BULK;
            ck_assert_near(b[MPM_SYM_XX], c * c * xx - 2 * c * n * xy + n * n * yy, scale);
            ck_assert_near(b[MPM_SYM_XY], c * n * (xx - yy) + (c * c - n * n) * xy, scale);
            ck_assert_near(b[MPM_SYM_ZZ], a[MPM_SYM_ZZ], scale);
            for (size_t i = 0; i < mpm_von_mises.variable_count; i++)
                ck_assert_near(turned.state[i], still.state[i], 10 * ROUND_OFF);
        }
        ck_assert_double_gt(still.state[PLASTIC], 0.4);
    }
}
END_TEST

START_TEST(a_return_ends_on_the_yield_surface_and_a_step_without_change_leaves_the_state)
{
    for (int h = 0; h < HARDENINGS; h++)
        for (int steps = 1; steps <= 100; steps *= 10) {
            struct point point;
            begin(&point, &hardenings[h]);
            for (int k = 1; k <= steps; k++) {
                double f[MPM_GRADIENT_SIZE], tau[MPM_SYMMETRIC_SIZE];
                path((double)k / steps, f);
                ck_assert(move(&point, f));
                const double plastic = point.state[PLASTIC];
                memcpy(tau, point.tau, sizeof tau);
                ck_assert(move(&point, f));
                ck_assert_near(point.state[PLASTIC], plastic, 1e-13);
                for (int i = 0; i < MPM_SYMMETRIC_SIZE; i++)
                    ck_assert_near(point.tau[i], tau[i], 1e-12 * SHEAR);
            }
        }
}
END_TEST

START_TEST(an_elastic_path_leaves_no_trace)
{
    struct point point;
    begin(&point, &hardenings[4]);
    for (int k = 0; k <= 1000; k++) {
        const double t = 0.002 * sin(0.1 * k);
        const double f[MPM_GRADIENT_SIZE] = {1 + t, 0.7 * t, -t, 1 - 0.3 * t, 1 + 0.2 * t};
        ck_assert(move(&point, f));
    }
    for (size_t k = 0; k < mpm_von_mises.variable_count; k++)
        ck_assert_double_eq(point.state[k], mpm_von_mises.variables[k].start);
}
END_TEST

/* ---------------------------------------------------------------------------- energy */

/* tau : (dF F^-1) of the mean stress, per mass, over a path in `steps` */
static double work_of_path(struct point *point, int steps)
{
    double work = 0.0;
    for (int k = 1; k <= steps; k++) {
        double f[MPM_GRADIENT_SIZE], middle[MPM_GRADIENT_SIZE], d[MPM_GRADIENT_SIZE];
        double tau[MPM_SYMMETRIC_SIZE];
        memcpy(tau, point->tau, sizeof tau);
        path((k - 1.0) / steps, middle);
        path((double)k / steps, f);
        for (int i = 0; i < MPM_GRADIENT_SIZE; i++) {
            d[i] = f[i] - middle[i];
            middle[i] = 0.5 * (f[i] + middle[i]);
        }
        ck_assert(move(point, f));
        const double *const m = middle;
        const double area = m[MPM_XX] * m[MPM_YY] - m[MPM_XY] * m[MPM_YX];
        const double xx = (d[MPM_XX] * m[MPM_YY] - d[MPM_XY] * m[MPM_YX]) / area;
        const double xy = (d[MPM_XY] * m[MPM_XX] - d[MPM_XX] * m[MPM_XY]) / area;
        const double yx = (d[MPM_YX] * m[MPM_YY] - d[MPM_YY] * m[MPM_YX]) / area;
        const double yy = (d[MPM_YY] * m[MPM_XX] - d[MPM_YX] * m[MPM_XY]) / area;
        for (int i = 0; i < MPM_SYMMETRIC_SIZE; i++)
            tau[i] = 0.5 * (tau[i] + point->tau[i]);
        work += tau[MPM_SYM_XX] * xx + tau[MPM_SYM_YY] * yy + tau[MPM_SYM_XY] * (xy + yx) +
                tau[MPM_SYM_ZZ] * d[MPM_ZZ] / middle[MPM_ZZ];
    }
    return work;
}

START_TEST(work_is_stored_or_dissipated_but_for_an_error_of_first_order)
{
    static const double FINEST = 1e-4; /* of the work, in 3200 steps */
    for (int h = 0; h < HARDENINGS; h++) {
        double last = 0.0;
        for (int steps = 800; steps <= 3200; steps *= 2) {
            struct point point;
            begin(&point, &hardenings[h]);
            const double work = work_of_path(&point, steps);
            const double energy = mpm_von_mises.energy(&point.material, point.f, point.state);
            const double dissipated = mpm_von_mises.dissipation(&point.material, point.state);
            const double error = fabs(work - energy - dissipated) / work;
            ck_assert_double_gt(dissipated, 0.0);
            ck_assert_msg(steps == 800 || error < 0.6 * last, "%s: %g after %g in %d steps",
                          hardenings[h].name, error, last, steps);
            last = error;
        }
        ck_assert_double_lt(last, FINEST);
    }
}
END_TEST

/* That of Hencky's energy: asinh(x)/sqrt(1 + x^2) of half the shear, x, with one maximum at 1.51,
 * where that of Jaumann's rate has sin(2 x). */
START_TEST(back_stress_does_not_oscillate_in_large_shear)
{
    static const double BEFORE = 2.8, AFTER = 3.4; /* the stress at yield turns a little */
    struct point point;
    double last = 0.0, top = 0.0;
    begin(&point, &hardenings[3]);
    for (int k = 1; k <= 400; k++) {
        const double shear = 0.02 * k;
        const double f[MPM_GRADIENT_SIZE] = {1, shear, 0, 1, 1};
        ck_assert(move(&point, f));
        const double now = point.tau[MPM_SYM_XY];
        ck_assert(shear > BEFORE || now > last);
        ck_assert(shear < AFTER || now < last);
        top = fmax(top, now);
        last = now;
    }
    ck_assert_double_gt(last, 0.5 * top);
}
END_TEST

/* ----------------------------------------------------------------------------- waves */

/* l d(tau)/dl - tau of an elastic step along each axis, and the undeformed body. */
START_TEST(the_wave_speed_is_that_of_elastic_waves_in_the_deformed_body)
{
    struct point point;
    static const double STEP = 1e-6;
    begin(&point, &hardenings[1]);
    ck_assert_near(mpm_material_start_wave(&point.material), (BULK + 4.0 / 3.0 * SHEAR) / DENSITY,
                   1e-13 * BULK);
    stretch(&point, -0.3, 0.1, 0.05);
    const double before = point.tau[MPM_SYM_XX], wave = point.wave;
    stretch(&point, -0.3 + STEP, 0.1, 0.05); /* back from yield: elastic */
    const double modulus = (point.tau[MPM_SYM_XX] - before) / STEP - before;
    ck_assert_near(wave, modulus, 1e-4 * modulus);
}
END_TEST

START_TEST(a_body_sheared_beyond_what_numbers_hold_has_no_return)
{
    struct point point;
    begin(&point, &hardenings[1]);
    const double f[MPM_GRADIENT_SIZE] = {1, 1e170, 0, 1, 1};
    ck_assert(!move(&point, f));
    ck_assert_double_eq(point.state[PLASTIC], 0.0);
}
END_TEST

Suite *suite_von_mises(void)
{
    Suite *const suite = suite_create("von_mises");
    TCase *const tests = tcase_create("paths");
    tcase_add_test(tests, the_logarithm_is_that_of_the_library_and_of_nothing_below_zero);
    tcase_add_test(tests, exponential_logarithm_root_and_inverse_of_tensors_fit_each_other);
    tcase_add_test(tests, cyclic_tension_follows_each_hardening_along_each_axis);
    tcase_add_test(tests,
                   the_angle_of_the_stress_follows_each_step_and_the_exact_solution_in_first_order);
    tcase_add_test(tests, the_answer_is_the_same_while_the_body_turns_twenty_times);
    tcase_add_test(tests,
                   a_return_ends_on_the_yield_surface_and_a_step_without_change_leaves_the_state);
    tcase_add_test(tests, an_elastic_path_leaves_no_trace);
    tcase_add_test(tests, work_is_stored_or_dissipated_but_for_an_error_of_first_order);
    tcase_add_test(tests, back_stress_does_not_oscillate_in_large_shear);
    tcase_add_test(tests, the_wave_speed_is_that_of_elastic_waves_in_the_deformed_body);
    tcase_add_test(tests, a_body_sheared_beyond_what_numbers_hold_has_no_return);
    suite_add_tcase(suite, tests);
    return suite;
}
