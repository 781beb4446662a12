/* Laws with an equation of state, driven along given paths of J: jumps of shocks, isentropes,
 * sound, temperature, the cut-off and the pole.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "model/laws/mie_gruneisen.h"
#include "suites.h"
#include "support/near.h"

#include <float.h>

/* SI; references.md P. */
static const struct metal {
    const char *name;
    double density, speed, slope, gamma;
} metals[] = {
    {"tungsten", 17600, 3980, 1.24, 1.54},
    {"copper", 8940, 3940, 1.489, 2.02},
    {"gamma of 0", 1000, 1500, 1.9, 0},
    {"s below 1", 1845, 7998, 0.8, 1.16},
};
static const struct gas {
    double density, index, pressure, stiffening;
} gases[] = {{1.0, 1.4, 1.0, 0.0}, {0.125, 5.0 / 3.0, 0.1, 0.0}, {1000.0, 4.4, 1e5, 6e8}};
enum {
    METALS = sizeof metals / sizeof metals[0],
    GASES = sizeof gases / sizeof gases[0],
    LAWS = METALS + GASES,
};
static const double HEAT_CAPACITY = 390.0, START = 300.0;

struct point {
    double parameter[MPM_PARAMETER_COUNT];
    struct mpm_material material;
    double j, energy, pressure, wave; /* the pressure over rho_0 */
};

static void set_stress(struct point *point, const double tau[MPM_SYMMETRIC_SIZE])
{
    point->pressure = -tau[MPM_SYM_XX] / point->j;
    ck_assert_double_eq(tau[MPM_SYM_XX], tau[MPM_SYM_YY]);
    ck_assert_double_eq(tau[MPM_SYM_XX], tau[MPM_SYM_ZZ]);
    ck_assert_double_eq(tau[MPM_SYM_XY], 0.0);
}

/* Along the three axes alike, or along one: the same J. */
static bool move(struct point *point, double j, double heat)
{
    const double old = cbrt(point->j), now = cbrt(j);
    const double from[MPM_GRADIENT_SIZE] = {old, 0, 0, old, old};
    const double to[MPM_GRADIENT_SIZE] = {now, 0, 0, now, now};
    const struct mpm_law_step step = {from, to, 0.1, (double)NAN, (double)NAN, heat, (double)NAN};
    double tau[MPM_SYMMETRIC_SIZE];
    point->j = j;
    if (!point->material.law->update(&point->material, &step, &point->energy, tau, &point->wave))
        return false;
    set_stress(point, tau);
    return true;
}

static void begin(struct point *point, int law)
{
    for (int k = 0; k < MPM_PARAMETER_COUNT; k++)
        point->parameter[k] = (double)NAN;
    double *const p = point->parameter;
    p[MPM_PARAMETER_SPECIFIC_HEAT] = HEAT_CAPACITY;
    if (law < METALS) {
        p[MPM_PARAMETER_SOUND_SPEED] = metals[law].speed;
        p[MPM_PARAMETER_HUGONIOT_SLOPE] = metals[law].slope;
        p[MPM_PARAMETER_GRUNEISEN] = metals[law].gamma;
        p[MPM_PARAMETER_PRESSURE_CUTOFF] = HUGE_VAL;
        p[MPM_PARAMETER_START_TEMPERATURE] = START;
        point->material = mpm_material_make(&mpm_mie_gruneisen, metals[law].density, p, NULL);
    } else {
        const struct gas *const gas = &gases[law - METALS];
        p[MPM_PARAMETER_ADIABATIC_INDEX] = gas->index;
        p[MPM_PARAMETER_START_PRESSURE] = gas->pressure;
        p[MPM_PARAMETER_STIFFENING_PRESSURE] = gas->stiffening;
        point->material = mpm_material_make(&mpm_stiffened_gas, gas->density, p, NULL);
    }
    point->j = 1.0;
    mpm_material_start(&point->material, &point->energy);
    point->wave = mpm_material_start_wave(&point->material);
}

static double temperature(const struct point *point)
{
    const double side = cbrt(point->j), f[MPM_GRADIENT_SIZE] = {side, 0, 0, side, side};
    return point->material.law->temperature(&point->material, f, &point->energy);
}

/* ------------------------------------------------------------------------- shocks */

/* U_s = c_0 + s u, p = rho_0 U_s u, J = 1 - u/U_s, e = u^2/2: one step is the jump. */
START_TEST(one_step_from_rest_is_the_jump_of_a_shock)
{
    static const double ROUND_OFF = 1e-12;
    for (int law = 0; law < METALS; law++)
        for (double u = 1.0; u < 3e3; u *= 3.0) {
            const double speed = metals[law].speed + metals[law].slope * u;
            struct point point;
            begin(&point, law);
            ck_assert(move(&point, 1.0 - u / speed, 0.0));
            ck_assert_near(point.pressure, speed * u, ROUND_OFF * speed * speed);
            ck_assert_near(point.energy, 0.5 * u * u, ROUND_OFF * speed * speed);
        }
}
END_TEST

/* A strong shock compresses an ideal gas by (gamma + 1)/(gamma - 1) and no further. */
START_TEST(one_step_of_a_gas_obeys_hugoniot)
{
    static const double ROUND_OFF = 1e-12;
    for (int k = 0; k < GASES; k++) {
        const double g = gases[k].index, inf = gases[k].stiffening / gases[k].density;
        for (double j = 0.98; j > (g - 1.0) / (g + 1.0) + 0.01; j -= 0.05) {
            struct point point;
            begin(&point, METALS + k);
            const double before = gases[k].pressure / gases[k].density + inf;
            const double after = before * ((g + 1.0) - (g - 1.0) * j) / ((g + 1.0) * j - (g - 1.0));
            ck_assert(move(&point, j, 0.0));
            ck_assert_near(point.pressure + inf, after, ROUND_OFF * after);
        }
    }
}
END_TEST

/* ---------------------------------------------------------------------- isentropes */

/* p/rho_0 on the isentrope, by Runge and Kutta's rule in many steps for Mie and Grueneisen's. */
static double slope_of(const struct point *point, double j, double energy)
{
    double unused;
    return -mpm_gruneisen_pressure(&point->material, j, energy, &unused);
}

static double isentropic(const struct point *point, int law, double j, double *energy)
{
    enum { STEPS = 4000 };
    const double h = (j - 1.0) / STEPS;
    double unused;
    *energy = 0.0;
    if (law >= METALS) {
        const struct gas *const gas = &gases[law - METALS];
        const double inf = gas->stiffening / gas->density;
        const double sum = (gas->pressure / gas->density + inf) * pow(j, -gas->index);
        *energy = (sum + (gas->index - 1.0) * inf) * j / (gas->index - 1.0);
        return sum - inf;
    }
    for (int k = 0; k < STEPS; k++) {
        const double x = 1.0 + k * h;
        const double a = slope_of(point, x, *energy);
        const double b = slope_of(point, x + 0.5 * h, *energy + 0.5 * h * a);
        const double c = slope_of(point, x + 0.5 * h, *energy + 0.5 * h * b);
        const double d = slope_of(point, x + h, *energy + h * c);
        *energy += h / 6.0 * (a + 2.0 * b + 2.0 * c + d);
    }
    return mpm_gruneisen_pressure(&point->material, j, *energy, &unused);
}

static double path_error(int law, double end, int steps)
{
    struct point point;
    double energy;
    begin(&point, law);
    for (int k = 1; k <= steps; k++)
        ck_assert(move(&point, 1.0 + (end - 1.0) * k / steps, 0.0));
    const double pressure = isentropic(&point, law, end, &energy);
    return fabs(point.pressure - pressure) / point.wave;
}

START_TEST(slow_steps_follow_the_isentrope_with_second_order)
{
    static const double ENDS[] = {0.7, 0.9, 1.1, 1.3};
    static const double LOW = 3.8, HIGH = 4.2, FLOOR = 1e-10;
    for (int law = 0; law < LAWS; law++)
        for (size_t k = 0; k < sizeof ENDS / sizeof ENDS[0]; k++) {
            const double coarse = path_error(law, ENDS[k], 50),
                         fine = path_error(law, ENDS[k], 100);
            ck_assert_double_le(fine, 1e-4);
            if (fine > FLOOR) { /* gamma of 0: p is a function of J alone */
                ck_assert_double_ge(coarse, LOW * fine);
                ck_assert_double_le(coarse, HIGH * fine);
            }
        }
}
END_TEST

/* c^2 = dp/drho along a step so small that it is isentropic; rho = rho_0/J. */
START_TEST(sound_has_the_speed_of_the_isentropes_slope)
{
    static const double STEP = 1e-5, TOLERANCE = 1e-8; /* STEP^2, and round-off over STEP */
    static const double STATES[] = {0.75, 0.95, 1.02};
    for (int law = 0; law < LAWS; law++)
        for (size_t k = 0; k < sizeof STATES / sizeof STATES[0]; k++) {
            struct point point, up, down;
            begin(&point, law);
            ck_assert(move(&point, STATES[k], 0.01 * point.wave));
            up = down = point;
            up.material.parameter = down.material.parameter = point.parameter;
            ck_assert(move(&up, point.j * (1.0 - STEP), 0.0));
            ck_assert(move(&down, point.j * (1.0 + STEP), 0.0));
            const double slope = (up.pressure - down.pressure) / (1.0 / up.j - 1.0 / down.j);
            ck_assert_near(slope, point.wave, TOLERANCE * point.wave + 1e-3 * STEP * point.wave);
        }
}
END_TEST

/* --------------------------------------------------------------------- temperature */

/* dT/T = -gamma_0 dJ on the isentrope, and c_v dT = dq at constant J. */
START_TEST(temperature_follows_the_isentrope_and_heat_raises_it)
{
    static const double TOLERANCE = 1e-9;
    static const double ENDS[] = {0.5, 0.75, 0.8, 0.9, 0.97, 1.2};
    for (int law = 0; law < LAWS; law++)
        for (size_t k = 0; k < sizeof ENDS / sizeof ENDS[0]; k++) {
            struct point point;
            begin(&point, law);
            if (law < METALS && ENDS[k] <= mpm_gruneisen_least_volume(&point.material))
                continue;
            const double start = temperature(&point);
            const double ratio = law < METALS ? exp(metals[law].gamma * (1.0 - ENDS[k]))
                                              : pow(ENDS[k], 1.0 - gases[law - METALS].index);
            (void)isentropic(&point, law, ENDS[k], &point.energy);
            point.j = ENDS[k];
            const double scale = point.wave / HEAT_CAPACITY + start;
            ck_assert_near(temperature(&point), start * ratio, TOLERANCE * scale);
            const double heat = 0.01 * point.wave, before = temperature(&point);
            ck_assert(move(&point, point.j, heat));
            ck_assert_near(temperature(&point) - before, heat / HEAT_CAPACITY, TOLERANCE * scale);
        }
}
END_TEST

/* The energy of the isentrope is a series below s eta = 0.3 and a quadrature above: the same where
 * they meet, as differences there are of the second order of the distance. */
START_TEST(the_temperature_has_no_jump_where_its_series_ends)
{
    static const double END = 0.3, STEP = 1e-7, ROUND_OFF = 1e-11;
    for (int law = 0; law < METALS; law++) {
        struct point point;
        double t[5];
        begin(&point, law);
        point.energy = 0.0;
        for (int k = 0; k < 5; k++) {
            const double eta = (END + (k - 2.5) * STEP) / metals[law].slope;
            point.j = 1.0 - eta;
            t[k] = temperature(&point);
        }
        const double change = t[4] - t[0];
        for (int k = 1; k < 4; k++)
            ck_assert_near(t[k] - t[0], 0.25 * k * change, ROUND_OFF * fabs(t[0]));
    }
}
END_TEST

/* ------------------------------------------------------------------ cut-off, pole */

START_TEST(tension_ends_at_the_cut_off_and_its_energy_is_its_work)
{
    static const double CUT = 1e9, ROUND_OFF = 1e-12;
    struct point point;
    begin(&point, 0);
    point.parameter[MPM_PARAMETER_PRESSURE_CUTOFF] = CUT;
    const double most = -CUT / metals[0].density;
    /* the step that passes the cut-off has the trapezoidal rule up to there */
    const double square = metals[0].speed * metals[0].speed;
    double work = 0.0, last = 0.0;
    for (double j = 1.0005; j < 1.1; j += 0.0005) {
        const double old = point.j;
        ck_assert(move(&point, j, 0.0));
        ck_assert_double_ge(point.pressure, most * (1.0 + ROUND_OFF));
        double at = j;
        if (last > most * (1.0 - ROUND_OFF) && point.pressure < most * (1.0 - ROUND_OFF)) {
            const double mean = 0.5 * (last + most); /* -c_0^2 (x - 1) + gamma_0 e(x) = most */
            at = (square - most + metals[0].gamma * (work + mean * old)) /
                 (square + metals[0].gamma * mean);
        }
        work -= 0.5 * (last + point.pressure) * (at - old) + point.pressure * (j - at);
        last = point.pressure;
        ck_assert_near(point.energy, work, ROUND_OFF * fabs(most));
        ck_assert_double_gt(point.wave, 0.0);
    }
    ck_assert_near(point.pressure, most, ROUND_OFF * fabs(most));
}
END_TEST

/* Cut-offs as parts of the largest tension of the isentrope, rho_0 c_0^2/gamma_0, or of rho_0
 * c_0^2. */
static const double CUTS[] = {0.0, 0.05, 0.5};
enum { CUT_COUNT = sizeof CUTS / sizeof CUTS[0] };

/* On the isentrope p = rho_0 c_0^2 (exp(gamma_0 eta) - 1)/gamma_0 in tension. */
struct spall {
    double tension;                        /* p_c/rho_0 */
    double volume, temperature, stiffness; /* where the isentrope reaches it: J, T, -dp/dJ/rho_0 */
};

static struct spall begin_cut(struct point *point, int law, double part)
{
    begin(point, law);
    const double square = metals[law].speed * metals[law].speed, gamma = metals[law].gamma;
    const double tension = part * square / fmax(gamma, 1.0);
    point->parameter[MPM_PARAMETER_PRESSURE_CUTOFF] = tension * metals[law].density;
    const double left = 1.0 - gamma * tension / square;
    return (struct spall){tension, gamma > 0.0 ? 1.0 - log(left) / gamma : 1.0 + tension / square,
                          START * left, square * left};
}

/* In steps of at most 1e-3. */
static void go_to(struct point *point, double j)
{
    const double from = point->j;
    const int steps = 1 + (int)(fabs(j - from) / 1e-3);
    for (int k = 1; k <= steps; k++)
        ck_assert(move(point, from + (j - from) * k / steps, 0.0));
}

/* The error of the trapezoidal rule in 1000 steps or more, and of the step in which the cut-off
 * begins. */
static const double PATH = 1e-6;

/* Far beyond 1 + 1/gamma_0, where the pressure without a cut-off has no sound. */
START_TEST(a_spalled_body_keeps_its_temperature_and_its_sound)
{
    const int law = _i / CUT_COUNT;
    struct point point;
    const struct spall spall = begin_cut(&point, law, CUTS[_i % CUT_COUNT]);
    const double square = metals[law].speed * metals[law].speed;
    const double sound = spall.volume * spall.volume * spall.stiffness;
    for (double j = spall.volume + 0.1; j < 5.0; j *= 1.2) {
        go_to(&point, j);
        ck_assert_near(point.pressure, -spall.tension, 1e-15 * square);
        ck_assert_near(point.wave, sound, PATH * square);
        ck_assert_near(temperature(&point), spall.temperature, PATH * square / HEAT_CAPACITY);
        ck_assert_double_gt(temperature(&point), 0.0);
    }
}
END_TEST

START_TEST(a_spalled_body_has_its_pressure_again_where_it_lost_it)
{
    static const double NEAR = 1e-4;
    const int law = _i / CUT_COUNT;
    struct point point;
    const struct spall spall = begin_cut(&point, law, CUTS[_i % CUT_COUNT]);
    const double square = metals[law].speed * metals[law].speed;
    go_to(&point, 3.0);
    go_to(&point, spall.volume + NEAR);
    ck_assert_near(point.pressure, -spall.tension, 1e-15 * square);
    go_to(&point, spall.volume - NEAR);
    ck_assert_near(point.pressure + spall.tension, NEAR * spall.stiffness, 0.02 * NEAR * square);
    go_to(&point, 1.0);
    ck_assert_near(point.pressure, 0.0, PATH * square);
    ck_assert_near(point.energy, 0.0, PATH * square);
    ck_assert_near(temperature(&point), START, PATH * square / HEAT_CAPACITY);
    go_to(&point, 3.0); /* and closed in one step */
    ck_assert(move(&point, spall.volume - NEAR, 0.0));
    ck_assert_near(point.pressure + spall.tension, NEAR * spall.stiffness, 0.02 * NEAR * square);
}
END_TEST

/* At constant pressure, with c_p = c_v c^2/c_T^2: the slope of p in J at constant T is
 * c_0^2 - gamma_0 p_c/rho_0 - gamma_0^2 c_v T. */
START_TEST(heat_warms_a_spalled_body_at_constant_pressure_and_lets_its_material_expand)
{
    static const double HEAT = 1e-3, NEAR = 1e-5; /* K; part, from HEAT and round-off over it */
    const int law = _i / CUT_COUNT;
    struct point point;
    const struct spall spall = begin_cut(&point, law, CUTS[_i % CUT_COUNT]);
    const double gamma = metals[law].gamma;
    go_to(&point, 2.0);
    const double before = temperature(&point), wave = point.wave;
    ck_assert(move(&point, 2.0, HEAT * HEAT_CAPACITY));
    const double softer = spall.stiffness - gamma * gamma * HEAT_CAPACITY * before;
    ck_assert_near(temperature(&point) - before, HEAT * softer / spall.stiffness, NEAR * HEAT);
    const double grown = sqrt(point.wave / spall.stiffness) - sqrt(wave / spall.stiffness);
    ck_assert_near(grown, gamma * HEAT * HEAT_CAPACITY / spall.stiffness, 1e-12);
}
END_TEST

/* Where the isentrope has no such tension. */
START_TEST(a_cut_off_beyond_the_largest_tension_gives_no_state)
{
    struct point point;
    begin(&point, 0);
    const double most = metals[0].speed * metals[0].speed / metals[0].gamma;
    point.parameter[MPM_PARAMETER_PRESSURE_CUTOFF] = 1.01 * most * metals[0].density;
    ck_assert(move(&point, 1.1, 0.0));
    ck_assert(!move(&point, 3.0, 0.0)); /* in one step beyond it */
}
END_TEST

START_TEST(beyond_the_pole_there_is_no_state)
{
    for (int law = 0; law < METALS; law++) {
        struct point point;
        begin(&point, law);
        const double least = mpm_gruneisen_least_volume(&point.material);
        ck_assert_near(least, fmax(0.0, 1.0 - 1.0 / metals[law].slope), 0.0);
        if (least == 0.0)
            continue;
        ck_assert(!move(&point, least, 0.0));
        begin(&point, law);
        ck_assert(!move(&point, 0.999 * least, 0.0));
        begin(&point, law); /* heat alone would give sound a speed there */
        ck_assert(!move(&point, 0.9 * least, 1e6 * point.wave));
        begin(&point, law);
        ck_assert(move(&point, least + 1e-6, 0.0));
    }
}
END_TEST

/* ------------------------------------------------------------------------------ suite */

Suite *suite_equation_of_state(void)
{
    Suite *suite = suite_create("equation_of_state");
    TCase *tests = tcase_create("laws");
    tcase_add_test(tests, one_step_from_rest_is_the_jump_of_a_shock);
    tcase_add_test(tests, one_step_of_a_gas_obeys_hugoniot);
    tcase_add_test(tests, slow_steps_follow_the_isentrope_with_second_order);
    tcase_add_test(tests, sound_has_the_speed_of_the_isentropes_slope);
    tcase_add_test(tests, temperature_follows_the_isentrope_and_heat_raises_it);
    tcase_add_test(tests, the_temperature_has_no_jump_where_its_series_ends);
    tcase_add_test(tests, tension_ends_at_the_cut_off_and_its_energy_is_its_work);
    tcase_add_loop_test(tests, a_spalled_body_keeps_its_temperature_and_its_sound, 0,
                        METALS * CUT_COUNT);
    tcase_add_loop_test(tests, a_spalled_body_has_its_pressure_again_where_it_lost_it, 0,
                        METALS * CUT_COUNT);
    tcase_add_loop_test(tests,
                        heat_warms_a_spalled_body_at_constant_pressure_and_lets_its_material_expand,
                        0, METALS * CUT_COUNT);
    tcase_add_test(tests, a_cut_off_beyond_the_largest_tension_gives_no_state);
    tcase_add_test(tests, beyond_the_pole_there_is_no_state);
    suite_add_tcase(suite, tests);
    return suite;
}
