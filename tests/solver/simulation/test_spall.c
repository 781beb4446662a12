/* Clouds of particles whose tension has reached the cut-off of their equation of state: they expand
 * far beyond where the pressure without a cut-off has no sound.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/tensor.h"
#include "suites.h"
#include "support/near.h"
#include "support/scenes.h"

#include <glib.h>
#include <math.h>

/* c_0^2 = 100, p_c/rho_0 = 1, gamma_0 = 2: sound would end at J = 1.5. */
#define PRESSURE                                                                                   \
    ", density: 2, sound_speed: 10, hugoniot_slope: 1.5, gruneisen: 2, pressure_cutoff: 2"
#define HEAT     ", specific_heat: 0.01, start_temperature: 300"
#define STRENGTH ", shear: 50, yield_stress: 0.5"
#define SOFTENING                                                                                  \
    ", hardening_coefficient: 1, hardening_exponent: 0.5, softening_exponent: 1, "                 \
    "reference_temperature: 290, melting_temperature: 2000, taylor_quinney: 0.9"

static const struct cloud {
    const char *material;
    double hottest;
} clouds[] = {
    {"materials=[{name: m, law: mie_gruneisen" PRESSURE HEAT "}]", 300.0},
    {"materials=[{name: m, law: mie_gruneisen" PRESSURE HEAT
     ", viscosity: {linear: 0.5, quadratic: 1.5}}]",
     301.0},
    {"materials=[{name: m, law: von_mises_gruneisen" PRESSURE HEAT STRENGTH "}]", 400.0},
    {"materials=[{name: m, law: johnson_cook_gruneisen" PRESSURE HEAT STRENGTH SOFTENING "}]",
     500.0},
};
enum { CLOUDS = sizeof clouds / sizeof clouds[0] };
/* Of the start, less gamma_0 p_c/(rho_0 c_0^2) of it. */
static const double COLDEST = 0.98 * 300.0;

#define SCENE                                                                                      \
    "format: 1\ngeometry: plane_strain\n"                                                          \
    "grid: {cell: [1, 1], cells: [20, 20]}\n"                                                      \
    "time: {end: 4, courant: 0.3}\n"                                                               \
    "materials: [{name: m, law: none, density: 1}]\n"                                              \
    "bodies:\n"                                                                                    \
    "  - {name: b, material: m, region: {rectangle: {from: [8, 8], to: [12, 12]}},\n"              \
    "     velocity: [\"3*(x - 10)\", \"3*(y - 10)\"]}\n"                                           \
    "output: {energy_balance: true}\n"

static struct test_run open_with(const char *material, const char *more)
{
    const char *const settings[] = {material, more, NULL};
    return test_run_open(SCENE, settings, 1);
}

/* The mean det F. */
static double mean_volume(const struct test_run *run)
{
    size_t count;
    double *const f = test_run_field(run, MPM_FIELD_DEFORMATION_GRADIENT, &count);
    double sum = 0.0;
    for (size_t p = 0; p < count; p++)
        sum += mpm_determinant(&f[MPM_GRADIENT_SIZE * p]);
    g_free(f);
    return sum / (double)count;
}

static void judge_temperatures(const struct test_run *run, double hottest)
{
    static const double NEAR = 0.5; /* K, of the way to the cut-off in one or two steps */
    size_t count;
    double *const now = test_run_field(run, MPM_FIELD_STATE_TEMPERATURE, &count);
    for (size_t p = 0; p < count; p++) {
        ck_assert_double_ge(now[p], COLDEST - NEAR);
        ck_assert_double_le(now[p], hottest + NEAR);
    }
    g_free(now);
}

/* The wave speed at most; the time step follows from it. */
static const double FASTEST = 10.0 * 1.1;

START_TEST(a_free_cloud_expands_to_three_times_its_volume_and_keeps_its_energy)
{
    static const double ROUND_OFF = 1e-11, VOLUME = 3.0;
    static const double LOSS = 0.03; /* of MUSL, 2.0 % at most */
    struct test_run run = open_with(clouds[_i].material, NULL);
    const struct mpm_ledger begin = test_run_ledger(&run);
    struct mpm_ledger now = begin;
    while (mean_volume(&run) < VOLUME) {
        test_run_steps(&run, 1);
        now = test_run_ledger(&run);
        ck_assert_near(now.total_energy + now.transfer_loss, begin.total_energy,
                       ROUND_OFF * begin.total_energy);
    }
    ck_assert_double_gt(mpm_simulation_time_step(run.simulation), 0.3 / (2.0 * FASTEST));
    ck_assert_double_le(fabs(now.transfer_loss), LOSS * begin.kinetic_energy);
    judge_temperatures(&run, clouds[_i].hottest);
    test_run_close(&run);
}
END_TEST

/* Two clouds of the same body fly apart, meet walls and come together again. */
START_TEST(a_cloud_that_walls_throw_back_bears_pressure_again)
{
    static const double ROUND_OFF = 1e-11;
    struct test_run run =
        open_with(clouds[_i].material,
                  "boundary=[{region: {line: {from: [6, 0], to: [6, 20]}}, symmetry: true},"
                  " {region: {line: {from: [14, 0], to: [14, 20]}}, symmetry: true},"
                  " {region: {line: {from: [0, 6], to: [20, 6]}}, symmetry: true},"
                  " {region: {line: {from: [0, 14], to: [20, 14]}}, symmetry: true}]");
    const struct mpm_ledger begin = test_run_ledger(&run);
    struct mpm_ledger now = begin;
    double largest = 1.0, least = 1.0;
    while (now.time < 2.0) {
        test_run_steps(&run, 1);
        now = test_run_ledger(&run);
        largest = fmax(largest, now.j_max);
        least = fmin(least, now.j_min);
        ck_assert_near(now.total_energy + now.transfer_loss, begin.total_energy,
                       ROUND_OFF * begin.total_energy);
    }
    ck_assert_double_gt(largest, 3.0);
    ck_assert_double_lt(least, 0.98);
    test_run_close(&run);
}
END_TEST

Suite *suite_spall(void)
{
    Suite *const suite = suite_create("spall");
    TCase *const tests = tcase_create("clouds");
    tcase_add_loop_test(tests, a_free_cloud_expands_to_three_times_its_volume_and_keeps_its_energy,
                        0, CLOUDS);
    tcase_add_loop_test(tests, a_cloud_that_walls_throw_back_bears_pressure_again, 0, CLOUDS);
    suite_add_tcase(suite, tests);
    return suite;
}
