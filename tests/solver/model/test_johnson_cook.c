/* Johnson and Cook's law, driven along given paths of F: its strength against the formula, its heat
 * against an integration of its own.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "model/material.h"
#include "model/particles.h"
#include "suites.h"
#include "support/near.h"

static const double DENSITY = 8.9e-6, BULK = 140.0, SHEAR = 46.0, YIELD = 0.09;
enum { PLASTIC = 4, WORK = 5 };
static const double ROUND_OFF = 1e-12;

struct strength {
    const char *name;
    double hardening, exponent, rate, reference, softening, start;
};
static const double REFERENCE = 298.0, MELTING = 1356.0, CAPACITY = 383.0, QUINNEY = 0.9;

/* GPa, kg, mm, ms, K */
static const struct strength strengths[] = {
    {"yield alone", 0, 0, 0, 0, 0, 0},
    {"hardening", 0.292, 0.31, 0, 0, 0, 0},
    {"linear hardening", 0.292, 1, 0, 0, 0, 0},
    {"rate", 0.292, 0.31, 0.025, 1, 0, 0},
    {"softening", 0.292, 0.31, 0, 0, 1.09, 298},
    {"copper", 0.292, 0.31, 0.025, 1, 1.09, 298},
    {"hot copper", 0.292, 0.31, 0.025, 1, 1.09, 700},
    {"cold copper", 0.292, 0.31, 0.025, 1, 1.09, 100},
    {"steep", 0.9, 0.02, 0.3, 1e-3, 0.4, 298},
};
enum { STRENGTHS = sizeof strengths / sizeof strengths[0] };

struct point {
    double parameter[MPM_PARAMETER_COUNT];
    struct mpm_material material;
    double f[MPM_GRADIENT_SIZE], state[MPM_LAW_STATES], tau[MPM_SYMMETRIC_SIZE], wave;
};

static void set_parameters(const struct strength *s, double parameter[MPM_PARAMETER_COUNT])
{
    const bool thermal = s->softening > 0.0;
    for (int k = 0; k < MPM_PARAMETER_COUNT; k++)
        parameter[k] = (double)NAN;
    parameter[MPM_PARAMETER_BULK] = BULK;
    parameter[MPM_PARAMETER_SHEAR] = SHEAR;
    parameter[MPM_PARAMETER_YIELD_STRESS] = YIELD;
    parameter[MPM_PARAMETER_HARDENING_COEFFICIENT] = s->hardening;
    parameter[MPM_PARAMETER_HARDENING_EXPONENT] = s->exponent;
    parameter[MPM_PARAMETER_RATE_COEFFICIENT] = s->rate;
    parameter[MPM_PARAMETER_REFERENCE_RATE] = s->reference;
    parameter[MPM_PARAMETER_SOFTENING_EXPONENT] = s->softening;
    parameter[MPM_PARAMETER_START_TEMPERATURE] = s->start;
    parameter[MPM_PARAMETER_REFERENCE_TEMPERATURE] = thermal ? REFERENCE : 0.0;
    parameter[MPM_PARAMETER_MELTING_TEMPERATURE] = thermal ? MELTING : 0.0;
    parameter[MPM_PARAMETER_SPECIFIC_HEAT] = thermal ? CAPACITY : 0.0;
    parameter[MPM_PARAMETER_TAYLOR_QUINNEY] = thermal ? QUINNEY : 0.0;
}

static void begin(struct point *point, const struct strength *s)
{
    const double unit[MPM_GRADIENT_SIZE] = {1, 0, 0, 1, 1};
    set_parameters(s, point->parameter);
    point->material = mpm_material_make(&mpm_johnson_cook, DENSITY, point->parameter, NULL);
    for (size_t k = 0; k < mpm_johnson_cook.variable_count; k++)
        point->state[k] = mpm_johnson_cook.variables[k].start;
    memcpy(point->f, unit, sizeof unit);
}

/* To the logarithmic strains along the axes, within the duration. */
static bool stretch(struct point *point, double xx, double yy, double zz, double duration)
{
    double old[MPM_GRADIENT_SIZE];
    const double f[MPM_GRADIENT_SIZE] = {exp(xx), 0, 0, exp(yy), exp(zz)};
    memcpy(old, point->f, sizeof old);
    memcpy(point->f, f, sizeof f);
    const struct mpm_law_step step = {old,         point->f, duration,   (double)NAN,
                                      (double)NAN, 0.0,      (double)NAN};
    return mpm_johnson_cook.update(&point->material, &step, point->state, point->tau, &point->wave);
}

/* tau_yy - tau_xx of an isochoric stretch a along y */
static double pull(struct point *point, double a, double duration)
{
    ck_assert(stretch(point, -0.5 * a, a, -0.5 * a, duration));
    return DENSITY * (point->tau[MPM_SYM_YY] - point->tau[MPM_SYM_XX]);
}

static double temperature_of(const struct strength *s, double work)
{
    return s->start + QUINNEY * work / CAPACITY;
}

static double formula(const struct strength *s, double plastic, double rate, double temperature)
{
    const double hardening = s->hardening > 0.0 ? s->hardening * pow(plastic, s->exponent) : 0.0;
    const double of_rate = s->rate > 0.0 ? 1.0 + s->rate * log(fmax(rate / s->reference, 1.0)) : 1;
    const double homologous = fmax(0.0, (temperature - REFERENCE) / (MELTING - REFERENCE));
    const double softened = s->softening > 0.0 ? 1.0 - pow(homologous, s->softening) : 1.0;
    return (YIELD + hardening) * of_rate * fmax(softened, 0.0);
}

/* -------------------------------------------------------------------- strength */

static const double durations[] = {1e6, 1.0, 1e-3, 1e-6};
enum { DURATIONS = sizeof durations / sizeof durations[0], STEPS = 40 };

/* Rates from 1e-8 to 1e4; q = 3 G (a - p) in tension. */
START_TEST(strength_is_the_formula_at_the_plastic_rate_and_the_start_s_temperature)
{
    const struct strength *const s = &strengths[_i % STRENGTHS];
    const double duration = durations[_i / STRENGTHS];
    struct point point;
    double p = 0.0;
    begin(&point, s);
    for (int k = 1; k <= STEPS; k++) {
        const double temperature = temperature_of(s, point.state[WORK]);
        const double a = 0.01 * k, q = pull(&point, a, duration), now = a - q / (3.0 * SHEAR);
        const double rate = (point.state[PLASTIC] - p) / duration;
        ck_assert_near(point.state[PLASTIC], now, ROUND_OFF);
        if (now > p + 1e-9)
            ck_assert_near(q, formula(s, point.state[PLASTIC], rate, temperature),
                           1e3 * ROUND_OFF * SHEAR);
        p = point.state[PLASTIC];
    }
    ck_assert_double_gt(p, 0.3);
}
END_TEST

/* A step beyond yield by one part in so many leaves a plastic strain so small that its power is
 * steep; the next one must find yield all the same. */
START_TEST(yield_is_found_after_a_step_that_hardly_flows)
{
    static const double excess[] = {1e-1, 1e-2, 1e-3, 1e-4, 1e-6, 1e-9, 1e-12};
    const struct strength *const s = &strengths[_i % STRENGTHS];
    const double duration = durations[_i / STRENGTHS];
    for (size_t k = 0; k < sizeof excess / sizeof excess[0]; k++) {
        struct point point;
        begin(&point, s);
        (void)pull(&point, YIELD / (3.0 * SHEAR) * (1.0 + excess[k]), duration);
        for (int step = 1; step <= 5; step++) {
            const double p = point.state[PLASTIC],
                         temperature = temperature_of(s, point.state[WORK]);
            const double q = pull(&point, 0.01 * step, duration);
            const double rate = (point.state[PLASTIC] - p) / duration;
            ck_assert_near(q, formula(s, point.state[PLASTIC], rate, temperature),
                           1e3 * ROUND_OFF * SHEAR);
        }
    }
}
END_TEST

START_TEST(an_elastic_step_has_no_strength_of_rates)
{
    struct point point;
    begin(&point, &strengths[5]);
    /* fast to just beyond yield: what flows is small, and slower than the reference rate */
    const double a = (YIELD / 3.0 / SHEAR) * (1.0 + 1e-9);
    (void)pull(&point, a, 1e-6);
    ck_assert_double_le(point.state[PLASTIC] / 1e-6, 1.0);
    ck_assert_double_gt(a / 1e-6, 100.0);
}
END_TEST

START_TEST(molten_metal_has_a_pressure_alone)
{
    struct strength s = strengths[5];
    struct point point;
    s.start = MELTING;
    begin(&point, &s);
    ck_assert(stretch(&point, 0.1, -0.3, 0.05, 1.0));
    const double mean = BULK / DENSITY * -0.15;
    for (int k = 0; k < 3; k++)
        ck_assert_near(point.tau[k], mean, ROUND_OFF * BULK / DENSITY);
    ck_assert_double_eq(point.state[WORK], 0.0);
}
END_TEST

/* Strength is round-off of the trial stress, and above 0. */
START_TEST(metal_next_to_melting_flows)
{
    enum { STRETCHES = 100 };
    struct strength s = strengths[5];
    s.start = nextafter(MELTING, 0.0);
    for (int k = 0; k < STRETCHES; k++) {
        const double xx = 0.1 + 0.003 * k, yy = -0.3 + 0.001 * k;
        struct point point;
        begin(&point, &s);
        ck_assert(stretch(&point, xx, yy, 0.05, 1.0));
        const double mean = BULK / DENSITY * (xx + yy + 0.05);
        for (int c = 0; c < 3; c++)
            ck_assert_near(point.tau[c], mean, ROUND_OFF * BULK / DENSITY);
    }
}
END_TEST

/* ------------------------------------------------------------------------- heat */

/* T at the end of a stretch to 0.5 in n steps */
static double heated(const struct strength *s, int steps, double rate)
{
    struct point point;
    begin(&point, s);
    for (int k = 1; k <= steps; k++)
        (void)pull(&point, 0.5 * k / steps, 0.5 / steps / rate);
    ck_assert_double_eq(mpm_johnson_cook.dissipation(&point.material, point.state),
                        point.state[WORK]);
    return mpm_johnson_cook.temperature(&point.material, point.f, point.state);
}

/* dT = chi s dp / (rho c) at a given plastic rate, Heun's rule; p from 0 to the strain less q/3G.
 * Rates of elastic strain, 1 % of the rate, are left out: 0.025 ln 1.01 of the strength. */
static double integrated(const struct strength *s, double rate)
{
    enum { PARTS = 200000 };
    const double scale = QUINNEY / (CAPACITY * DENSITY);
    double temperature = s->start, end = 0.5;
    for (int pass = 0; pass < 20; pass++) {
        temperature = s->start;
        for (int k = 0; k < PARTS; k++) {
            /* p = end u^4 smooths the power at 0 */
            const double u = (double)k / PARTS, v = (double)(k + 1) / PARTS;
            const double p = end * u * u * u * u, next = end * v * v * v * v;
            const double one = formula(s, p, rate, temperature);
            const double other = formula(s, next, rate, temperature + scale * one * (next - p));
            temperature += 0.5 * scale * (one + other) * (next - p);
        }
        end = 0.5 - formula(s, end, rate, temperature) / (3.0 * SHEAR);
    }
    return temperature;
}

START_TEST(plastic_work_heats_as_an_integration_of_its_own_to_first_order)
{
    const struct strength *const s = &strengths[_i == 0 ? 4 : 5];
    static const double RATE = 1e4;
    const double reference = integrated(s, RATE) - s->start;
    const double coarse = heated(s, 200, RATE) - s->start, fine = heated(s, 400, RATE) - s->start;
    const double finest = heated(s, 20000, RATE) - s->start;
    const double order = log2((coarse - finest) / (fine - finest));
    ck_assert_near(finest / reference, 1.0, 5e-4);
    ck_assert_near(order, 1.0, 0.1);
    ck_assert_double_gt(reference, 20.0);
}
END_TEST

/* ------------------------------------------------------------------- bad input */

/* In a scene that conducts no heat. */
static const char *fault_of(const double *parameter)
{
    const char *const fault = mpm_johnson_cook.fault(parameter);
    return fault != NULL ? fault : mpm_johnson_cook.fault_without_heat(parameter);
}

START_TEST(parameters_come_in_groups)
{
    static const enum mpm_parameter lonely[] = {
        MPM_PARAMETER_HARDENING_COEFFICIENT, MPM_PARAMETER_HARDENING_EXPONENT,
        MPM_PARAMETER_RATE_COEFFICIENT,      MPM_PARAMETER_REFERENCE_RATE,
        MPM_PARAMETER_SOFTENING_EXPONENT,    MPM_PARAMETER_REFERENCE_TEMPERATURE,
        MPM_PARAMETER_MELTING_TEMPERATURE,   MPM_PARAMETER_START_TEMPERATURE,
        MPM_PARAMETER_SPECIFIC_HEAT,         MPM_PARAMETER_TAYLOR_QUINNEY};
    double parameter[MPM_PARAMETER_COUNT];
    set_parameters(&strengths[0], parameter);
    ck_assert_ptr_null(fault_of(parameter));
    for (size_t k = 0; k < sizeof lonely / sizeof lonely[0]; k++) {
        set_parameters(&strengths[5], parameter);
        ck_assert_ptr_null(fault_of(parameter));
        parameter[lonely[k]] = 0.0; /* one of a group is missing */
        ck_assert_ptr_nonnull(fault_of(parameter));
    }
    set_parameters(&strengths[5], parameter);
    parameter[MPM_PARAMETER_MELTING_TEMPERATURE] = REFERENCE;
    ck_assert_ptr_nonnull(fault_of(parameter));
}
END_TEST

Suite *suite_johnson_cook(void)
{
    Suite *suite = suite_create("johnson_cook");
    TCase *strength = tcase_create("strength");
    tcase_add_loop_test(strength,
                        strength_is_the_formula_at_the_plastic_rate_and_the_start_s_temperature, 0,
                        STRENGTHS * DURATIONS);
    tcase_add_loop_test(strength, yield_is_found_after_a_step_that_hardly_flows, 0,
                        STRENGTHS * DURATIONS);
    tcase_add_test(strength, an_elastic_step_has_no_strength_of_rates);
    tcase_add_test(strength, molten_metal_has_a_pressure_alone);
    tcase_add_test(strength, metal_next_to_melting_flows);
    suite_add_tcase(suite, strength);
    TCase *heat = tcase_create("heat");
    tcase_add_loop_test(heat, plastic_work_heats_as_an_integration_of_its_own_to_first_order, 0, 2);
    suite_add_tcase(suite, heat);
    TCase *input = tcase_create("input");
    tcase_add_test(input, parameters_come_in_groups);
    suite_add_tcase(suite, input);
    return suite;
}
