/* Solids with Mie and Grueneisen's pressure, driven along given paths of F: pressure against the
 * fluid's, deviator against that of the solids without equation of state, energy against the work
 * of the stress, temperature against an integration of its own, sound against the slope of the
 * stress.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "model/laws/mie_gruneisen.h"
#include "model/particles.h"
#include "suites.h"
#include "support/near.h"

/* kg, mm, ms, K, GPa: tungsten alloy, references.md P. */
static const double DENSITY = 17.6e-6, SHEAR = 124.0, YIELD = 1.5, SPEED = 3980, START = 300.0;
static const double CAPACITY = 134.0, GAMMA = 1.54, REFERENCE = 300.0, MELTING = 1723.0;
enum { PLASTIC = 4, ENERGY = 5, WORK = 6 };
static const double ROUND_OFF = 1e-12;

static const struct solid {
    const char *name;
    const struct mpm_material_law *law, *without; /* with and without the equation of state */
    double kinematic, modulus, coefficient, rate, softening, quinney;
} solids[] = {
    {"perfect", &mpm_von_mises_gruneisen, &mpm_von_mises, 0, 0, 0, 0, 0, 1},
    {"linear", &mpm_von_mises_gruneisen, &mpm_von_mises, 0, 2, 0, 0, 0, 1},
    {"kinematic", &mpm_von_mises_gruneisen, &mpm_von_mises, 3, 0, 0, 0, 0, 1},
    {"power", &mpm_johnson_cook_gruneisen, &mpm_johnson_cook, 0, 0, 0.5, 0, 0, 1},
    {"rate", &mpm_johnson_cook_gruneisen, &mpm_johnson_cook, 0, 0, 0.5, 0.05, 0, 1},
    {"softening", &mpm_johnson_cook_gruneisen, &mpm_johnson_cook, 0, 0, 0.5, 0.05, 1, 0.9},
    {"half of it heat", &mpm_johnson_cook_gruneisen, &mpm_johnson_cook, 0, 0, 0.5, 0, 0.7, 0.5},
};
enum { SOLIDS = sizeof solids / sizeof solids[0], RIGID_OF_HEAT = 5 };

struct point {
    double parameter[MPM_PARAMETER_COUNT];
    struct mpm_material material;
    double f[MPM_GRADIENT_SIZE], state[MPM_LAW_STATES], tau[MPM_SYMMETRIC_SIZE], wave;
};

static void set_strength(const struct solid *solid, double *p)
{
    const bool thermal = solid->softening > 0.0;
    p[MPM_PARAMETER_SHEAR] = SHEAR;
    p[MPM_PARAMETER_YIELD_STRESS] = YIELD;
    p[MPM_PARAMETER_HARDENING_MODULUS] = solid->modulus;
    p[MPM_PARAMETER_HARDENING_STRAIN] = 0.0;
    p[MPM_PARAMETER_KINEMATIC_MODULUS] = solid->kinematic;
    p[MPM_PARAMETER_HARDENING_COEFFICIENT] = solid->coefficient;
    p[MPM_PARAMETER_HARDENING_EXPONENT] = solid->coefficient > 0.0 ? 0.3 : 0.0;
    p[MPM_PARAMETER_RATE_COEFFICIENT] = solid->rate;
    p[MPM_PARAMETER_REFERENCE_RATE] = solid->rate > 0.0 ? 1e-3 : 0.0;
    p[MPM_PARAMETER_SOFTENING_EXPONENT] = solid->softening;
    p[MPM_PARAMETER_REFERENCE_TEMPERATURE] = thermal ? REFERENCE : 0.0;
    p[MPM_PARAMETER_MELTING_TEMPERATURE] = thermal ? MELTING : 0.0;
    p[MPM_PARAMETER_TAYLOR_QUINNEY] = thermal ? solid->quinney : 0.0;
}

static void set_parameters(const struct solid *solid, double *p)
{
    for (int k = 0; k < MPM_PARAMETER_COUNT; k++)
        p[k] = (double)NAN;
    set_strength(solid, p);
    p[MPM_PARAMETER_BULK] = DENSITY * SPEED * SPEED;
    p[MPM_PARAMETER_SOUND_SPEED] = SPEED;
    p[MPM_PARAMETER_HUGONIOT_SLOPE] = 1.24;
    p[MPM_PARAMETER_GRUNEISEN] = GAMMA;
    p[MPM_PARAMETER_PRESSURE_CUTOFF] = HUGE_VAL;
    p[MPM_PARAMETER_SPECIFIC_HEAT] = CAPACITY;
    p[MPM_PARAMETER_START_TEMPERATURE] = START;
}

static void begin(struct point *point, const struct solid *solid,
                  const struct mpm_material_law *law)
{
    const double unit[MPM_GRADIENT_SIZE] = {1, 0, 0, 1, 1};
    set_parameters(solid, point->parameter);
    point->material = mpm_material_make(law, DENSITY, point->parameter, NULL);
    mpm_material_start(&point->material, point->state);
    point->wave = mpm_material_start_wave(&point->material);
    memcpy(point->f, unit, sizeof unit);
}

static bool move(struct point *point, const double f[MPM_GRADIENT_SIZE], double duration)
{
    double old[MPM_GRADIENT_SIZE];
    memcpy(old, point->f, sizeof old);
    memcpy(point->f, f, sizeof old);
    const struct mpm_law_step step = {old,         point->f, duration,   (double)NAN,
                                      (double)NAN, 0.0,      (double)NAN};
    return point->material.law->update(&point->material, &step, point->state, point->tau,
                                       &point->wave);
}

static double energy_of(const struct point *point)
{
    return point->material.law->energy(&point->material, point->f, point->state);
}

static double mean_of(const struct point *point)
{
    return (point->tau[MPM_SYM_XX] + point->tau[MPM_SYM_YY] + point->tau[MPM_SYM_ZZ]) / 3.0;
}

/* F at s in [0, 1]: there and back along a path without an axis that stays. */
enum path { UNIAXIAL, SHEARED, CLOSED, PATHS };

static void place(enum path path, double s, double f[MPM_GRADIENT_SIZE])
{
    const double turn = path == CLOSED ? sin(6.283185307179586 * s) : s;
    const double back = path == CLOSED ? 1.0 - cos(6.283185307179586 * s) : s;
    f[MPM_XX] = 1.0 - 0.1 * turn;
    f[MPM_XY] = path == UNIAXIAL ? 0.0 : 0.15 * back;
    f[MPM_YX] = path == UNIAXIAL ? 0.0 : -0.05 * turn;
    f[MPM_YY] = path == UNIAXIAL ? 1.0 : 1.0 + 0.04 * back;
    f[MPM_ZZ] = path == UNIAXIAL ? 1.0 : 1.0 - 0.05 * back;
}

/* ------------------------------------------------------------------------- stress */

START_TEST(without_shear_it_is_the_fluid)
{
    struct point solid, fluid;
    begin(&solid, &solids[_i], solids[_i].law);
    begin(&fluid, &solids[_i], &mpm_mie_gruneisen);
    for (int k = 1; k <= 60; k++) {
        const double side = 1.0 - 0.1 * sin(0.1 * k);
        const double f[MPM_GRADIENT_SIZE] = {side, 0, 0, side, side};
        ck_assert(move(&solid, f, 1e-3) && move(&fluid, f, 1e-3));
        for (int c = 0; c < MPM_SYMMETRIC_SIZE; c++)
            ck_assert_near(solid.tau[c], fluid.tau[c], ROUND_OFF * SPEED * SPEED);
        ck_assert_near(energy_of(&solid), energy_of(&fluid), ROUND_OFF * SPEED * SPEED);
    }
    ck_assert_double_eq(solid.state[PLASTIC], 0.0);
}
END_TEST

/* Softening excepted: the solid without an equation of state is not heated by compression. */
START_TEST(its_deviator_is_that_without_an_equation_of_state)
{
    for (int path = 0; path < PATHS; path++) {
        struct point one, other;
        double f[MPM_GRADIENT_SIZE];
        begin(&one, &solids[_i], solids[_i].law);
        begin(&other, &solids[_i], solids[_i].without);
        for (int k = 1; k <= 40; k++) {
            place((enum path)path, k / 40.0, f);
            ck_assert(move(&one, f, 1e-3) && move(&other, f, 1e-3));
            for (int c = 0; c < MPM_SYMMETRIC_SIZE; c++) {
                const bool diagonal = c != MPM_SYM_XY;
                ck_assert_near(one.tau[c] - (diagonal ? mean_of(&one) : 0.0),
                               other.tau[c] - (diagonal ? mean_of(&other) : 0.0),
                               ROUND_OFF * SPEED * SPEED);
            }
        }
        ck_assert_double_eq(one.state[PLASTIC], other.state[PLASTIC]);
        ck_assert_double_gt(one.state[PLASTIC], 0.02);
    }
}
END_TEST

/* The fastest wave along x of an elastic step: (d tau_xx/d ln F_xx - tau_xx)/rho_0. */
START_TEST(sound_is_the_slope_of_the_stress)
{
    static const double SMALL = 1e-5;
    for (double x = -0.15; x < 0.1; x += 0.03) {
        struct point at, on;
        begin(&at, &solids[0], &mpm_von_mises_gruneisen);
        at.parameter[MPM_PARAMETER_YIELD_STRESS] = 1e6;
        const double side = exp(x);
        const double f[MPM_GRADIENT_SIZE] = {side * exp(SMALL), 0, 0, side, side};
        const double unit[MPM_GRADIENT_SIZE] = {side, 0, 0, side, side};
        for (int k = 1; k <= 200; k++) { /* slowly, so that no step has the entropy of a jump */
            const double now = exp(x * k / 200);
            const double part[MPM_GRADIENT_SIZE] = {now, 0, 0, now, now};
            ck_assert(move(&at, part, 1e-3));
        }
        ck_assert(move(&at, unit, 1e-3));
        on = at;
        on.material.parameter = on.parameter;
        ck_assert(move(&on, f, 1e-3));
        const double slope = (on.tau[MPM_SYM_XX] - at.tau[MPM_SYM_XX]) / SMALL;
        const double wave = slope - 0.5 * (on.tau[MPM_SYM_XX] + at.tau[MPM_SYM_XX]);
        /* second differences: SMALL times the curvature, about 10 of the slope */
        ck_assert_near(wave / (0.5 * (at.wave + on.wave)), 1.0, 10.0 * SMALL);
    }
}
END_TEST

/* ------------------------------------------------------------------------- energy */

/* tau : d(ln F) of a step, with F in its middle */
static double work_of(const double old[MPM_SYMMETRIC_SIZE], const double now[MPM_SYMMETRIC_SIZE],
                      const double from[MPM_GRADIENT_SIZE], const double to[MPM_GRADIENT_SIZE])
{
    double f[MPM_GRADIENT_SIZE], df[MPM_GRADIENT_SIZE], tau[MPM_SYMMETRIC_SIZE];
    for (int k = 0; k < MPM_GRADIENT_SIZE; k++) {
        f[k] = 0.5 * (from[k] + to[k]);
        df[k] = to[k] - from[k];
    }
    for (int k = 0; k < MPM_SYMMETRIC_SIZE; k++)
        tau[k] = 0.5 * (old[k] + now[k]);
    const double area = f[MPM_XX] * f[MPM_YY] - f[MPM_XY] * f[MPM_YX];
    const double xx = (df[MPM_XX] * f[MPM_YY] - df[MPM_XY] * f[MPM_YX]) / area;
    const double xy = (df[MPM_XY] * f[MPM_XX] - df[MPM_XX] * f[MPM_XY]) / area;
    const double yx = (df[MPM_YX] * f[MPM_YY] - df[MPM_YY] * f[MPM_YX]) / area;
    const double yy = (df[MPM_YY] * f[MPM_XX] - df[MPM_YX] * f[MPM_XY]) / area;
    return tau[MPM_SYM_XX] * xx + tau[MPM_SYM_YY] * yy + tau[MPM_SYM_XY] * (xy + yx) +
           tau[MPM_SYM_ZZ] * df[MPM_ZZ] / f[MPM_ZZ];
}

/* Energy of the law less the work of its stress, over the path in so many steps. */
static double residue(const struct solid *solid, enum path path, int steps, double *work)
{
    struct point point;
    double f[MPM_GRADIENT_SIZE], old[MPM_SYMMETRIC_SIZE] = {0.0}, from[MPM_GRADIENT_SIZE];
    begin(&point, solid, solid->law);
    *work = 0.0;
    for (int k = 1; k <= steps; k++) {
        memcpy(from, point.f, sizeof from);
        place(path, (double)k / steps, f);
        ck_assert(move(&point, f, 1e-2 / steps));
        *work += work_of(old, point.tau, from, f);
        memcpy(old, point.tau, sizeof old);
    }
    ck_assert_double_gt(point.state[WORK], 0.1 * DENSITY);
    return energy_of(&point) - *work;
}

/* Of first order where N turns in the step or the yield stress has the start's temperature, else
 * of second. */
START_TEST(energy_is_the_work_of_the_stress)
{
    for (int path = 0; path < PATHS; path++) {
        double work;
        const double coarse = residue(&solids[_i], (enum path)path, 500, &work);
        const double fine = residue(&solids[_i], (enum path)path, 4000, &work);
        ck_assert_double_le(fabs(fine), 0.2 * fabs(coarse));
        ck_assert_near(fine / fabs(work), 0.0, 1e-4);
    }
}
END_TEST

/* dT = gamma_0 T d(eta) + chi dw/c */
START_TEST(temperature_is_that_of_compression_and_plastic_work)
{
    enum { STEPS = 20000 };
    for (int path = 0; path < PATHS; path++) {
        struct point point;
        double f[MPM_GRADIENT_SIZE], temperature = START;
        begin(&point, &solids[_i], solids[_i].law);
        for (int k = 1; k <= STEPS; k++) {
            const double volume = mpm_determinant(point.f), work = point.state[WORK];
            place((enum path)path, (double)k / STEPS, f);
            ck_assert(move(&point, f, 1e-2 / STEPS));
            temperature = temperature * exp(GAMMA * (volume - mpm_determinant(f))) +
                          solids[_i].quinney * (point.state[WORK] - work) / CAPACITY;
        }
        ck_assert_near(point.material.law->temperature(&point.material, point.f, point.state) /
                           temperature,
                       1.0, 1e-6);
        ck_assert_double_gt(temperature, START + 1.0);
    }
}
END_TEST

START_TEST(heat_of_viscosity_enters_energy_and_pressure)
{
    static const double HEAT = 2e4;
    struct point point;
    begin(&point, &solids[_i], solids[_i].law);
    const struct mpm_law_step step = {point.f,     point.f, 1e-3,       (double)NAN,
                                      (double)NAN, HEAT,    (double)NAN};
    ck_assert(
        point.material.law->update(&point.material, &step, point.state, point.tau, &point.wave));
    ck_assert_near(energy_of(&point), HEAT, ROUND_OFF * HEAT);
    ck_assert_near(mean_of(&point), -GAMMA * HEAT, ROUND_OFF * SPEED * SPEED);
}
END_TEST

/* update with the heat = update without it, then reheat */
START_TEST(heat_after_a_step_is_heat_in_it)
{
    static const double HEAT = 3e4;
    const struct mpm_material_law *const law = solids[_i].law;
    for (int path = 0; path < PATHS; path++) {
        struct point one, other;
        double f[MPM_GRADIENT_SIZE], old_f[MPM_GRADIENT_SIZE], old_state[MPM_LAW_STATES];
        begin(&one, &solids[_i], law);
        place((enum path)path, 0.1, f);
        ck_assert(move(&one, f, 1e-3));
        other = one;
        other.material.parameter = other.parameter;
        memcpy(old_f, one.f, sizeof old_f);
        memcpy(old_state, one.state, sizeof old_state);
        place((enum path)path, 0.2, f);
        struct mpm_law_step step = {old_f, f, 1e-3, (double)NAN, (double)NAN, 0.0, (double)NAN};
        ck_assert(law->update(&one.material, &step, one.state, one.tau, &one.wave));
        step.heat = HEAT;
        ck_assert(law->reheat(&one.material, &step, old_state, one.state, one.tau, &one.wave));
        ck_assert(law->update(&other.material, &step, other.state, other.tau, &other.wave));
        for (int c = 0; c < MPM_SYMMETRIC_SIZE; c++)
            ck_assert_near(one.tau[c], other.tau[c], ROUND_OFF * SPEED * SPEED);
        for (size_t k = 0; k < law->variable_count; k++)
            ck_assert_near(one.state[k], other.state[k], ROUND_OFF * fmax(1.0, other.state[k]));
        ck_assert_near(one.wave / other.wave, 1.0, ROUND_OFF);
    }
}
END_TEST

/* ----------------------------------------------------------------------- softening */

/* To a side by an isentrope, then sheared: the yield stress is that of the heat of compression. */
START_TEST(heat_of_compression_softens)
{
    const struct solid *const solid = &solids[6];
    struct point point;
    begin(&point, solid, solid->law);
    for (int k = 1; k <= 10000; k++) {
        const double side = 1.0 - 0.08 * k / 10000;
        const double f[MPM_GRADIENT_SIZE] = {side, 0, 0, side, side};
        ck_assert(move(&point, f, 1e-3));
    }
    const double side = 0.92, warm = START * exp(GAMMA * (1.0 - side * side * side));
    const double f[MPM_GRADIENT_SIZE] = {side * exp(0.05), 0, 0, side * exp(-0.05), side};
    ck_assert(move(&point, f, 1e-3));
    const double half = 0.5 * DENSITY * (point.tau[MPM_SYM_XX] - point.tau[MPM_SYM_YY]);
    const double hot = pow((warm - REFERENCE) / (MELTING - REFERENCE), solid->softening);
    const double strength = (YIELD + 0.5 * pow(point.state[PLASTIC], 0.3)) * (1.0 - hot);
    ck_assert_near(half * sqrt(3.0) / strength, 1.0, 1e-6);
    ck_assert_double_gt(hot, 0.1);
}
END_TEST

START_TEST(metal_molten_by_a_shock_is_a_fluid)
{
    struct point solid, fluid;
    const double hit[MPM_GRADIENT_SIZE] = {0.55, 0, 0, 1, 1};
    const double sheared[MPM_GRADIENT_SIZE] = {0.55, 0.2, 0, 1, 1};
    begin(&solid, &solids[5], solids[5].law);
    begin(&fluid, &solids[5], &mpm_mie_gruneisen);
    ck_assert(move(&solid, hit, 1e-3) && move(&fluid, hit, 1e-3));
    ck_assert_double_gt(solid.material.law->temperature(&solid.material, solid.f, solid.state),
                        MELTING);
    ck_assert(move(&solid, sheared, 1e-3) && move(&fluid, sheared, 1e-3));
    ck_assert_near(solid.tau[MPM_SYM_XX], solid.tau[MPM_SYM_YY], ROUND_OFF * SPEED * SPEED);
    ck_assert_near(solid.tau[MPM_SYM_XY], 0.0, ROUND_OFF * SPEED * SPEED);
}
END_TEST

/* ----------------------------------------------------------------------- bad input */

START_TEST(beyond_the_pole_there_is_no_end)
{
    const double f[MPM_GRADIENT_SIZE] = {0.19, 0, 0, 1, 1}; /* 1 - 1/1.24 is 0.194 */
    struct point point;
    const double one[MPM_GRADIENT_SIZE] = {1, 0, 0, 1, 1};
    begin(&point, &solids[_i], solids[_i].law);
    double start[MPM_LAW_STATES];
    memcpy(start, point.state, sizeof start);
    const struct mpm_law_step step = {one, f, 1e-3, (double)NAN, (double)NAN, 0.0, (double)NAN};
    ck_assert(!move(&point, f, 1e-3));
    ck_assert_int_eq(point.material.law->fault_of(&point.material, &step, start), MPM_LAW_NO_STATE);
}
END_TEST

/* Shear without end, by a part of itself in each step, until F and C_p^-1 hold no elastic strain
 * any more. With and without an equation of state; on the way strength melts away. */
START_TEST(sheared_without_end_it_has_a_state_or_fails)
{
    static const double LARGE = 1e4, PART = 0.02;
    enum { STEPS = 2000 };
    const struct solid *const solid = &solids[_i / 2];
    struct point point;
    bool sound = true;
    double shear = 0.0;
    begin(&point, solid, _i % 2 == 0 ? solid->law : solid->without);
    for (int k = 0; k < STEPS && sound; k++) {
        shear += PART * (1.0 + shear);
        const double f[MPM_GRADIENT_SIZE] = {1, shear, 0, 1, 1};
        sound = move(&point, f, 1e-3);
        for (int c = 0; c < MPM_SYMMETRIC_SIZE && sound; c++)
            ck_assert(isfinite(point.tau[c]));
        ck_assert(!sound || (isfinite(point.wave) && point.wave > 0.0));
    }
    ck_assert(!sound);
    if (solid->kinematic > 0.0) /* no plastic strain leads back from a shear of 11 */
        return;
    ck_assert_msg(shear > LARGE, "%s ends at a shear of %g", solid->name, shear);
    ck_assert(isnan(point.tau[MPM_SYM_XY])); /* F is what is too large: law_state.c */
}
END_TEST

START_TEST(parameters_come_in_groups)
{
    struct point point;
    begin(&point, &solids[_i], solids[_i].law);
    if (solids[_i].softening == 0.0)
        point.parameter[MPM_PARAMETER_SPECIFIC_HEAT] =
            point.parameter[MPM_PARAMETER_START_TEMPERATURE] = 0.0;
    ck_assert_ptr_null(solids[_i].law->fault(point.parameter));
    point.parameter[MPM_PARAMETER_START_TEMPERATURE] =
        point.parameter[MPM_PARAMETER_START_TEMPERATURE] > 0.0 ? 0.0 : START;
    ck_assert_ptr_nonnull(solids[_i].law->fault(point.parameter));
}
END_TEST

Suite *suite_gruneisen_solid(void)
{
    Suite *suite = suite_create("gruneisen_solid");
    TCase *stress = tcase_create("stress");
    tcase_add_loop_test(stress, without_shear_it_is_the_fluid, 0, SOLIDS);
    tcase_add_loop_test(stress, its_deviator_is_that_without_an_equation_of_state, 0,
                        RIGID_OF_HEAT);
    tcase_add_test(stress, sound_is_the_slope_of_the_stress);
    suite_add_tcase(suite, stress);
    TCase *energy = tcase_create("energy");
    tcase_add_loop_test(energy, energy_is_the_work_of_the_stress, 0, SOLIDS);
    tcase_add_loop_test(energy, temperature_is_that_of_compression_and_plastic_work, 0, SOLIDS);
    tcase_add_loop_test(energy, heat_of_viscosity_enters_energy_and_pressure, 0, SOLIDS);
    tcase_add_loop_test(energy, heat_after_a_step_is_heat_in_it, 0, SOLIDS);
    suite_add_tcase(suite, energy);
    TCase *softening = tcase_create("softening");
    tcase_add_test(softening, heat_of_compression_softens);
    tcase_add_test(softening, metal_molten_by_a_shock_is_a_fluid);
    suite_add_tcase(suite, softening);
    TCase *input = tcase_create("input");
    tcase_add_loop_test(input, beyond_the_pole_there_is_no_end, 0, SOLIDS);
    tcase_add_loop_test(input, sheared_without_end_it_has_a_state_or_fails, 0, 2 * SOLIDS);
    tcase_add_loop_test(input, parameters_come_in_groups, 0, SOLIDS);
    suite_add_tcase(suite, input);
    return suite;
}
