/* Exact fields and handbook values of cracks.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/near.h"
#include "verification/exact/clamped_strip.h"
#include "verification/exact/cracks/cantilever_crack.h"
#include "verification/exact/cracks/centre_crack.h"
#include "verification/exact/cracks/penny_crack.h"
#include "verification/exact/cracks/slanted_crack.h"
#include "verification/exact/cracks/struck_crack.h"
#include "verification/exact/cracks/williams_field.h"
#include "verification/measures/interaction_integral.h"

#include <math.h>

enum { AXES = 2 };

static const double PI = 3.14159265358979323846;

static struct williams_field field_of(int kind)
{
    static const double loads[][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.8, -0.6, 0.5}};
    return (struct williams_field){
        .mode_1 = loads[kind][0],
        .mode_2 = loads[kind][1],
        .parallel = loads[kind][2],
        .shear = 3.0,
        .kappa = 1.8,
        .tip = {0.3, -0.2},
        .direction = {0.6, 0.8},
    };
}

/* Central differences of a field that changes over 1: (1e-5)^2 and round-off 1e-16/1e-5. */
static const double DIFFERENCES = 2e-10;

START_TEST(the_gradient_of_a_tip_is_that_of_its_displacement)
{
    const struct williams_field field = field_of(_i);
    const double step = 1e-5, place[AXES] = {1.4, 0.9};
    double gradient[4];
    williams_field_gradient(&field, place, gradient);
    for (int k = 0; k < AXES; k++) {
        double u[2][AXES];
        for (int side = 0; side < 2; side++) {
            double beside[AXES] = {place[0], place[1]};
            beside[k] += side == 0 ? -step : step;
            williams_field_displacement(&field, beside, u[side]);
        }
        for (int i = 0; i < AXES; i++)
            ck_assert_near(gradient[2 * i + k], (u[1][i] - u[0][i]) / (2.0 * step), DIFFERENCES);
    }
}
END_TEST

/* Stress in local axes from the gradient, by Hooke's law of a plane. */
static void local_stress(const struct williams_field *field, double r, double theta,
                         double stress[3])
{
    const double place[AXES] = {r * cos(theta), r * sin(theta)};
    double g[4];
    williams_field_gradient(field, place, g);
    const double lame = field->shear * (3.0 - field->kappa) / (field->kappa - 1.0);
    stress[0] = 2.0 * field->shear * g[0] + lame * (g[0] + g[3]);
    stress[1] = 2.0 * field->shear * g[3] + lame * (g[0] + g[3]);
    stress[2] = field->shear * (g[1] + g[2]);
}

START_TEST(a_tip_has_free_faces_and_its_stress_ahead)
{
    struct williams_field field = field_of(_i);
    double stress[3];
    field.tip[0] = field.tip[1] = 0.0;
    field.direction[0] = 1.0;
    field.direction[1] = 0.0;
    for (int side = -1; side <= 1; side += 2) {
        local_stress(&field, 0.7, side * PI, stress);
        ck_assert_near(stress[1], 0.0, 1e-14);
        ck_assert_near(stress[2], 0.0, 1e-14);
    }
    local_stress(&field, 0.7, 0.0, stress);
    const double root = sqrt(2.0 * PI * 0.7);
    ck_assert_near(stress[1], field.mode_1 / root, 1e-14);
    ck_assert_near(stress[2], field.mode_2 / root, 1e-14);
    ck_assert_near(stress[0], field.mode_1 / root + field.parallel, 1e-14);
}
END_TEST

/* M. Isida, Eng. Fract. Mech. 5 (1973) 647-665, by series, as the handbook tabulates it. */
START_TEST(tadas_formula_has_the_numbers_of_isidas_series)
{
    static const double series[] = {1.0060, 1.0246, 1.0577, 1.1094, 1.1867, 1.3033, 1.4882, 1.8160};
    for (int k = 0; k < 8; k++) {
        const struct centre_crack crack = {0.1 * (k + 1), 1.0, 2.0};
        const double scale = 2.0 * sqrt(PI * crack.half_length);
        ck_assert_near(centre_crack_tada(&crack) / scale, series[k], 1e-3 * series[k]);
        if (k < 7) /* up to a/W = 0.7 */
            ck_assert_near(centre_crack_feddersen(&crack) / scale, series[k], 3.5e-3 * series[k]);
    }
}
END_TEST

START_TEST(beam_theory_with_rotation_agrees_with_plane_elasticity)
{
    for (double slender = 5.0; slender < 30.0; slender += 1.0) {
        const struct cantilever_crack crack = {slender * 2.0, 2.0, 0.3, 70.0, 0.3};
        const double beam = sqrt(crack.modulus * cantilever_crack_release(&crack));
        const double plane = cantilever_crack_intensity(&crack);
        ck_assert_near(beam, plane, 0.01 * plane);
    }
    ck_assert_near(cantilever_crack_rotation(0.3), 0.6635, 5e-5);
}
END_TEST

START_TEST(a_small_disk_shaped_crack_is_one_in_an_infinite_body)
{
    const struct penny_crack small = {1.0, 1e6, 0.5}, large = {0.99, 1.0, 1.0};
    ck_assert_near(penny_crack_infinite(&small), 2.0 * 0.5 / sqrt(PI), 1e-15);
    ck_assert_near(penny_crack_cylinder(&small), penny_crack_infinite(&small), 1e-6);
    /* at a/b = 1 the polynomial is 1 + 1/2 - 5/8 + 0.421 */
    ck_assert_near(penny_crack_cylinder(&large) / penny_crack_infinite(&large) *
                       (1.0 - 0.99 * 0.99) / sqrt(0.01),
                   1.296, 0.01);
}
END_TEST

/* For nu = 0 and a step: 2 sigma sqrt(c t/pi), c = sqrt(E/rho). */
START_TEST(a_wave_that_rises_within_no_time_is_a_step_and_others_are_sums_of_steps)
{
    const struct struck_crack step = {4.0, 0.0, 1.0, 0.5, 1e-6}, slow = {4.0, 0.3, 1.0, 0.5, 1.5};
    ck_assert_near(struck_crack_celerity(&step), 2.0, 1e-15);
    ck_assert_near(struck_crack_intensity(&step, 3.0), sqrt(6.0 / PI), 1e-6);
    ck_assert_near(struck_crack_intensity(&slow, -0.1), 0.0, 0.0);
    for (double time = 0.5; time < 4.0; time += 0.5) {
        enum { STEPS = 4000 };
        double sum = 0.0;
        for (int k = 0; k < STEPS; k++) {
            struct struck_crack part = slow;
            part.stress /= STEPS;
            part.rise = 1e-9;
            sum += struck_crack_intensity(&part, time - slow.rise * (k + 0.5) / STEPS);
        }
        ck_assert_near(struck_crack_intensity(&slow, time), sum, 1e-4 * sum);
    }
}
END_TEST

/* a/W, height over width, angle in degrees */
static struct slanted_crack_intensity slanted(double part, double height, double degrees)
{
    const struct slanted_crack crack = {part, 1.0, height, degrees * PI / 180.0, 2.0};
    struct slanted_crack_intensity found;
    struct mpm_error error;
    ck_assert_int_eq(slanted_crack_solve(&crack, &found, &error), MPM_OK);
    found.mode_1 /= 2.0 * sqrt(PI * part);
    found.mode_2 /= 2.0 * sqrt(PI * part);
    return found;
}

/* Polynomials up to the order 47 over a plate 2.5 times as high as wide: 1e-16 times the condition
 * of their coefficients, which is 1e9 or so. */
static const double MIRRORED = 1e-6;

/* Isida's numbers are those of a long plate; 0.1 % is the handbook's. */
START_TEST(a_crack_across_the_tension_has_the_numbers_of_isidas_series)
{
    static const double series[] = {1.0060, 1.0246, 1.0577, 1.1094, 1.1867, 1.3033};
    for (int k = 0; k < 6; k++) {
        const struct slanted_crack_intensity found = slanted(0.1 * (k + 1), 2.5, 0.0);
        ck_assert_near(found.mode_1, series[k], 1e-3 * series[k]);
        ck_assert_near(found.mode_2, 0.0, MIRRORED);
    }
}
END_TEST

/* The finite plate adds some (a/W)^2 of them: 1e-3 for a/W = 0.02. */
START_TEST(a_small_slanted_crack_is_one_in_an_infinite_plate)
{
    for (double degrees = -75.0; degrees <= 75.0; degrees += 15.0) {
        const struct slanted_crack_intensity found = slanted(0.02, 1.0, degrees);
        const double c = cos(degrees * PI / 180.0), s = sin(degrees * PI / 180.0);
        ck_assert_near(found.mode_1, c * c, 1e-3);
        ck_assert_near(found.mode_2, s * c, 1e-3);
    }
}
END_TEST

/* Equilibrium and free faces hold by construction, so the edges decide. */
START_TEST(the_edges_of_a_plate_with_a_slanted_crack_have_their_tractions)
{
    for (double degrees = -60.0; degrees <= 60.0; degrees += 15.0) {
        const struct slanted_crack_intensity found = slanted(0.5, 1.0, degrees);
        const struct slanted_crack_intensity mirrored = slanted(0.5, 1.0, -degrees);
        ck_assert(found.residual < 1e-3);
        ck_assert_near(found.mode_1, mirrored.mode_1, MIRRORED);
        ck_assert_near(found.mode_2, -mirrored.mode_2, MIRRORED);
    }
}
END_TEST

START_TEST(a_slanted_crack_that_leaves_its_plate_is_refused)
{
    const struct slanted_crack crack = {1.2, 1.0, 1.0, 0.25 * PI, 1.0},
                               steep = {1.2, 2.0, 1.0, 1.5, 1.0};
    struct slanted_crack_intensity found;
    struct mpm_error error;
    ck_assert_int_eq(slanted_crack_solve(&crack, &found, &error), MPM_OK);
    ck_assert_int_eq(slanted_crack_solve(&steep, &found, &error), MPM_BAD_INPUT);
}
END_TEST

/* Particles on a lattice of 0.05 with the field of a tip. Sums over cells of a smooth function that
 * ends smoothly have an error by the jump across the crack alone, h/r of it. */
START_TEST(the_interaction_integral_finds_the_modes_of_a_tip)
{
    enum { SIDE = 80, COUNT = SIDE * SIDE };
    static double place[2 * COUNT], gradient[5 * COUNT], stress[4 * COUNT], volume[COUNT];
    const struct williams_field field = field_of(_i);
    for (int p = 0; p < COUNT; p++) {
        const int row = p / SIDE, column = p % SIDE;
        double u[4];
        place[2 * p] = field.tip[0] - 2.0 + 0.05 * (column + 0.5);
        place[2 * p + 1] = field.tip[1] - 2.0 + 0.05 * (row + 0.5);
        williams_field_gradient(&field, place + 2 * p, u);
        const double lame = field.shear * (3.0 - field.kappa) / (field.kappa - 1.0);
        gradient[5 * p] = 1.0 + u[0];
        gradient[5 * p + 1] = u[1];
        gradient[5 * p + 2] = u[2];
        gradient[5 * p + 3] = 1.0 + u[3];
        stress[4 * p] = 2.0 * field.shear * u[0] + lame * (u[0] + u[3]);
        stress[4 * p + 1] = 2.0 * field.shear * u[3] + lame * (u[0] + u[3]);
        stress[4 * p + 3] = field.shear * (u[1] + u[2]);
        volume[p] = 0.05 * 0.05;
    }
    double found[2];
    interaction_integral(&(struct interaction_particles){COUNT, place, gradient, stress, volume},
                         &field, 0.5, 1.8, found);
    ck_assert_near(found[0], field.mode_1, 0.02);
    ck_assert_near(found[1], field.mode_2, 0.02);
    interaction_integral(&(struct interaction_particles){COUNT, place, gradient, stress, volume},
                         &field, 5.0, 6.0, found);
    ck_assert(isnan(found[0]) && isnan(found[1]));
}
END_TEST

/* Energy of the strip ahead, M (delta/h)^2/2 over the height 2 h, is what growth sets free; and a
 * crack that has grown as far as expected is where that is the toughness. */
START_TEST(a_crack_in_a_strip_grows_to_where_the_energy_ahead_is_the_toughness)
{
    const struct clamped_strip strip = {.modulus = 2.0,
                                        .height = 4.5,
                                        .toughness = 8e-6,
                                        .rate = 7.5e-6,
                                        .gradient = 0.03,
                                        .tip = 12.5};
    const double delta = strip.rate * 700.0 * (1.0 - 0.03 * 5.0);
    ck_assert_near(clamped_strip_release(&strip, 17.5, 700.0),
                   0.5 * strip.modulus * delta * delta / (4.5 * 4.5) * 9.0, 1e-18);
    ck_assert_double_eq(clamped_strip_growth(&strip, 100.0), 0.0);
    for (double time = 800.0; time < 1600.0; time += 100.0)
        ck_assert_near(
            clamped_strip_release(&strip, 12.5 + clamped_strip_growth(&strip, time), time), 8e-6,
            1e-18);
}
END_TEST

Suite *suite_fracture(void)
{
    Suite *suite = suite_create("fracture");
    TCase *fields = tcase_create("fields");
    tcase_add_loop_test(fields, the_gradient_of_a_tip_is_that_of_its_displacement, 0, 4);
    tcase_add_loop_test(fields, a_tip_has_free_faces_and_its_stress_ahead, 0, 4);
    suite_add_tcase(suite, fields);
    TCase *handbook = tcase_create("handbook");
    tcase_add_test(handbook, tadas_formula_has_the_numbers_of_isidas_series);
    tcase_add_test(handbook, beam_theory_with_rotation_agrees_with_plane_elasticity);
    tcase_add_test(handbook, a_crack_in_a_strip_grows_to_where_the_energy_ahead_is_the_toughness);
    tcase_add_test(handbook, a_small_disk_shaped_crack_is_one_in_an_infinite_body);
    tcase_add_test(handbook,
                   a_wave_that_rises_within_no_time_is_a_step_and_others_are_sums_of_steps);
    suite_add_tcase(suite, handbook);
    TCase *slanted_cracks = tcase_create("slanted cracks");
    tcase_add_test(slanted_cracks, a_crack_across_the_tension_has_the_numbers_of_isidas_series);
    tcase_add_test(slanted_cracks, a_small_slanted_crack_is_one_in_an_infinite_plate);
    tcase_add_test(slanted_cracks, the_edges_of_a_plate_with_a_slanted_crack_have_their_tractions);
    tcase_add_test(slanted_cracks, a_slanted_crack_that_leaves_its_plate_is_refused);
    tcase_add_loop_test(slanted_cracks, the_interaction_integral_finds_the_modes_of_a_tip, 0, 4);
    suite_add_tcase(suite, slanted_cracks);
    return suite;
}
