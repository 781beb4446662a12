/* The exact states of rest of family T against what they must satisfy: balance, faces, law.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/near.h"
#include "verification/exact/heat/thermal_disk.h"
#include "verification/exact/homogeneous_load.h"
#include "verification/exact/lame_cylinder.h"
#include "verification/exact/self_weight.h"

#include <glib.h>
#include <math.h>

static const struct compression_material polymer = {2254.9, 864.662};
static const double tractions[] = {-300.0, 1.0, 200.0, 1000.0};
enum { TRACTIONS = G_N_ELEMENTS(tractions) };

/* Stretches to 1e-13, times moduli of order 1e4. */
static const double ROOT = 1e-8;
/* Central differences with a step of 1e-5: 1e-10 of curvatures of order 1e4, and rounding. */
static const double DIFFERENCE = 1e-5, SLOPE = 1e-4;

static double energy_slope(const struct homogeneous_state *state, int along)
{
    double up[3] = {state->radial, state->axial, state->radial};
    double down[3] = {state->radial, state->axial, state->radial};
    up[along] += DIFFERENCE;
    down[along] -= DIFFERENCE;
    return (compression_energy(&polymer, up) - compression_energy(&polymer, down)) /
           (2.0 * DIFFERENCE);
}

static void assert_stress_is_the_slope_of_the_energy(const struct homogeneous_state *state)
{
    const double volume = state->radial * state->radial * state->axial;
    ck_assert_near(state->stress.rr, state->radial / volume * energy_slope(state, 0), SLOPE);
    ck_assert_near(state->stress.zz, state->axial / volume * energy_slope(state, 1), SLOPE);
    ck_assert_near(state->stress.tt, state->stress.rr, 0.0);
}

START_TEST(an_end_load_leaves_the_sides_free_and_is_borne_by_the_end)
{
    for (int power = 0; power <= 2; power++) {
        struct homogeneous_state state;
        ck_assert(homogeneous_end_load(&polymer, tractions[_i], power, &state));
        ck_assert_near(state.stress.rr, 0.0, ROOT);
        ck_assert_near(state.stress.zz * pow(state.radial, power), tractions[_i], ROOT);
        ck_assert((state.axial > 1.0) == (tractions[_i] > 0.0));
        assert_stress_is_the_slope_of_the_energy(&state);
    }
}
END_TEST

START_TEST(a_rim_load_gives_the_state_of_radial_compression)
{
    struct homogeneous_state state;
    ck_assert(homogeneous_rim_load(&polymer, tractions[_i], &state));
    ck_assert_near(state.stress.rr, tractions[_i], ROOT);
    ck_assert_double_eq(state.axial, 1.0);
    const struct compression_stress same =
        compression_stress(&polymer, state.radial * state.radial);
    ck_assert_near(same.rr, state.stress.rr, ROOT);
    ck_assert_near(same.zz, state.stress.zz, ROOT);
    assert_stress_is_the_slope_of_the_energy(&state);
}
END_TEST

START_TEST(a_load_that_no_stretch_bears_has_no_state)
{
    struct homogeneous_state state;
    ck_assert(!homogeneous_end_load(&polymer, 1e7, 0.0, &state));
    ck_assert(!homogeneous_rim_load(&polymer, -1e9, &state));
}
END_TEST

START_TEST(the_cylinder_is_in_balance_and_follows_hooke)
{
    const struct lame_cylinder c = {10.0, 20.0, 3.0, 1.0, 1000.0, 0.3};
    ck_assert_near(lame_cylinder_state(&c, c.inner).rr, -c.inner_pressure, 1e-14);
    ck_assert_near(lame_cylinder_state(&c, c.outer).rr, -c.outer_pressure, 1e-14);
    for (double r = 10.5; r < 20.0; r += 1.0) {
        const struct lame_state at = lame_cylinder_state(&c, r);
        const struct lame_state up = lame_cylinder_state(&c, r + DIFFERENCE);
        const struct lame_state down = lame_cylinder_state(&c, r - DIFFERENCE);
        const double slope = (up.rr - down.rr) / (2.0 * DIFFERENCE);
        const double stretch = (up.u - down.u) / (2.0 * DIFFERENCE);
        ck_assert_near(slope + (at.rr - at.tt) / r, 0.0, 1e-9);
        ck_assert_near(c.young * stretch, at.rr - c.poisson * (at.tt + at.zz), 1e-6);
        ck_assert_near(c.young * at.u / r, at.tt - c.poisson * (at.rr + at.zz), 1e-12);
        ck_assert_near(at.zz, c.poisson * (at.rr + at.tt), 1e-14);
    }
}
END_TEST

/* Solid and hollow, in plane stress and plane strain: balance, Hooke's law with alpha theta, free
 * surfaces. */
START_TEST(the_disk_is_in_balance_and_follows_hooke_with_expansion)
{
    const bool hollow = _i / 2 == 1, plane_stress = _i % 2 == 1;
    const struct thermal_disk d = {hollow ? 10.0 : 0.0, 20.0, 1000.0, 0.3, 1e-3, 2.0, plane_stress};
    ck_assert_near(thermal_disk_state(&d, d.outer).rr, 0.0, 1e-14);
    ck_assert_near(thermal_disk_state(&d, d.outer).rise, 0.0, 1e-14);
    if (hollow) {
        ck_assert_near(thermal_disk_state(&d, d.inner).rr, 0.0, 1e-14);
        ck_assert_near(thermal_disk_state(&d, d.inner).rise, 2.0, 1e-14);
        ck_assert_near(thermal_disk_state(&d, sqrt(200.0)).rise, 1.0, 1e-14);
    }
    for (double r = hollow ? 10.5 : 0.5; r < 20.0; r += 1.0) {
        const struct thermal_disk_state at = thermal_disk_state(&d, r);
        const struct thermal_disk_state up = thermal_disk_state(&d, r + DIFFERENCE);
        const struct thermal_disk_state down = thermal_disk_state(&d, r - DIFFERENCE);
        const double slope = (up.rr - down.rr) / (2.0 * DIFFERENCE);
        const double stretch = (up.u - down.u) / (2.0 * DIFFERENCE), free = 1e-3 * at.rise;
        ck_assert_near(slope + (at.rr - at.tt) / r, 0.0, 1e-9);
        ck_assert_near(stretch, at.strain, 1e-9);
        ck_assert_near(1000.0 * (stretch - free), at.rr - 0.3 * (at.tt + at.zz), 1e-6);
        ck_assert_near(1000.0 * (at.u / r - free), at.tt - 0.3 * (at.rr + at.zz), 1e-12);
        ck_assert_near(plane_stress ? at.zz : at.zz - 0.3 * (at.rr + at.tt) + 1000.0 * free, 0.0,
                       1e-14);
    }
}
END_TEST

/* Also with a weight that grows with the height. */
START_TEST(the_column_bears_what_is_above)
{
    const double slope = _i == 0 ? 0.0 : -12.0;
    const struct self_weight column = {50.0, -800.0, slope, 1e6};
    ck_assert_double_eq(self_weight_stress(&column, 50.0), 0.0);
    ck_assert_double_eq(self_weight_stress(&column, 0.0), -40000.0 + 1250.0 * slope);
    ck_assert_near(self_weight_displacement(&column, 50.0), -1.0 + 125e3 / 3e6 * slope, 1e-15);
    for (double y = 1.0; y < 50.0; y += 7.0) {
        const double strain = (self_weight_displacement(&column, y + DIFFERENCE) -
                               self_weight_displacement(&column, y - DIFFERENCE)) /
                              (2.0 * DIFFERENCE);
        const double change = (self_weight_stress(&column, y + DIFFERENCE) -
                               self_weight_stress(&column, y - DIFFERENCE)) /
                              (2.0 * DIFFERENCE);
        ck_assert_near(column.modulus * strain, self_weight_stress(&column, y), 1e-4);
        ck_assert_near(change, -column.weight - slope * y, 1e-4);
    }
}
END_TEST

Suite *suite_static_states(void)
{
    Suite *suite = suite_create("static_states");
    TCase *states = tcase_create("states of rest");
    tcase_add_loop_test(states, an_end_load_leaves_the_sides_free_and_is_borne_by_the_end, 0,
                        TRACTIONS);
    tcase_add_loop_test(states, a_rim_load_gives_the_state_of_radial_compression, 0, TRACTIONS);
    tcase_add_test(states, a_load_that_no_stretch_bears_has_no_state);
    tcase_add_test(states, the_cylinder_is_in_balance_and_follows_hooke);
    tcase_add_loop_test(states, the_disk_is_in_balance_and_follows_hooke_with_expansion, 0, 4);
    tcase_add_loop_test(states, the_column_bears_what_is_above, 0, 2);
    suite_add_tcase(suite, states);
    return suite;
}
