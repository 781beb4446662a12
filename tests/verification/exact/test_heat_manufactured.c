/* The scenes of case H5: their starts and held values are the fields they are compared with, and
 * their sources make these fields solutions, by differences; the vortices keep volumes and sides.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "model/scene.h"
#include "mpm_expression.h"
#include "suites.h"
#include "support/near.h"
#include "support/scene_files.h"
#include "verification/exact/heat/heat.h"

#include <math.h>

/* Second differences of waves with derivatives of order (2 pi)^4: truncation 2e-6, rounding 4e-8.
 */
static const double STEP = 1e-4, SLOPE = 1e-5, ROUND_OFF = 1e-13;

enum { AXES = 2 };

static double planar_product(const double place[AXES], double time)
{
    return heat_product(place, 1.0, 2.0, time);
}

static double planar_ramp(const double place[AXES], double time)
{
    return (1.0 + 0.5 * place[0] - 0.25 * place[1]) * exp(-2.0 * time);
}

static double axial_ramp(const double place[AXES], double time)
{
    return (1.0 + 0.5 * place[1]) * exp(-2.0 * time);
}

static const struct {
    const char *path;
    double (*field)(const double place[AXES], double time);
    bool moves, insulated;
} scenes[] = {
    {"verification/catalogue/H/H5/square.yaml", planar_product, false, true},
    {"verification/catalogue/H/H5/cylinder.yaml", planar_product, false, true},
    {"verification/catalogue/H/H5/vortex.yaml", planar_product, true, true},
    {"verification/catalogue/H/H5/ring.yaml", planar_product, true, true},
    {"verification/catalogue/H/H5/ramp.yaml", planar_ramp, false, false},
    {"verification/catalogue/H/H5/ramp_cylinder.yaml", axial_ramp, false, false},
    {"verification/catalogue/H/H5/ramp_vortex.yaml", planar_ramp, true, false},
    {"verification/catalogue/H/H5/ramp_ring.yaml", axial_ramp, true, false},
};
enum { SCENES = sizeof scenes / sizeof scenes[0] };

static const double places[][AXES] = {{0.13, 0.71}, {0.42, 0.18}, {0.66, 0.57}, {0.91, 0.34}};
enum { PLACES = sizeof places / sizeof places[0] };

static double value_of(const struct mpm_scene *scene, const char *text, const double place[AXES],
                       double time)
{
    struct mpm_expression *expression = NULL;
    struct mpm_error error = {.message = ""};
    const enum mpm_status status =
        mpm_expression_create(text, mpm_scene_coordinates(scene), true, 1, &expression, &error);
    ck_assert_msg(status == MPM_OK, "%s: %s", text, error.message);
    const double value = mpm_expression_value(expression, 0, place, time);
    mpm_expression_free(expression);
    return value;
}

/* 0 where nothing moves */
static double velocity(const struct mpm_scene *scene, int component, const double place[AXES])
{
    return scene->boundary_count == 0
               ? 0.0
               : value_of(scene, scene->boundaries[0].velocity.text[component], place, 0.0);
}

static void place_beside(const double place[AXES], int axis, double by, double there[AXES])
{
    there[0] = place[0];
    there[1] = place[1];
    there[axis] += by;
}

/* rho c (T_t + v . grad T) - k div grad T */
static double source_needed(const struct mpm_scene *scene, int k, const double place[AXES],
                            double time)
{
    const struct mpm_conduction *const conduction =
        &scene->materials[0].conduction[MPM_TEMPERATURE];
    const double capacity = scene->materials[0].density * conduction->capacity;
    const double here = scenes[k].field(place, time);
    double rate =
        (scenes[k].field(place, time + STEP) - scenes[k].field(place, time - STEP)) / (2.0 * STEP);
    double spread = 0.0;
    for (int axis = 0; axis < AXES; axis++) {
        double low[AXES], high[AXES];
        place_beside(place, axis, -STEP, low);
        place_beside(place, axis, STEP, high);
        const double below = scenes[k].field(low, time), above = scenes[k].field(high, time);
        const double slope = (above - below) / (2.0 * STEP);
        rate += velocity(scene, axis, place) * slope;
        spread += (above - 2.0 * here + below) / (STEP * STEP);
        if (axis == 0 && scene->geometry == MPM_AXISYMMETRIC)
            spread += slope / place[0];
    }
    return capacity * rate - conduction->k[0] * spread;
}

START_TEST(sources_make_the_fields_solutions)
{
    struct mpm_scene *const scene = test_scene_read(scenes[_i].path, NULL);
    const char *const source = scene->scalars[MPM_TEMPERATURE].source;
    static const double times[] = {0.1, 0.7};
    for (int p = 0; p < PLACES; p++)
        for (int t = 0; t < 2; t++)
            ck_assert_near(value_of(scene, source, places[p], times[t]),
                           source_needed(scene, _i, places[p], times[t]), SLOPE);
    mpm_scene_free(scene);
}
END_TEST

START_TEST(starts_and_held_values_are_those_of_the_fields)
{
    struct mpm_scene *const scene = test_scene_read(scenes[_i].path, NULL);
    const struct mpm_scalar_spec *const heat = &scene->scalars[MPM_TEMPERATURE];
    ck_assert_int_eq(heat->condition_count == 0, scenes[_i].insulated);
    for (int p = 0; p < PLACES; p++) {
        ck_assert_near(value_of(scene, heat->start, places[p], 0.0),
                       scenes[_i].field(places[p], 0.0), ROUND_OFF);
        for (size_t c = 0; c < heat->condition_count; c++)
            ck_assert_near(value_of(scene, heat->conditions[c].value, places[p], 0.3),
                           scenes[_i].field(places[p], 0.3), ROUND_OFF);
    }
    mpm_scene_free(scene);
}
END_TEST

START_TEST(no_heat_passes_sides_that_are_insulated)
{
    for (int axis = 0; axis < AXES && scenes[_i].insulated; axis++)
        for (int side = 0; side < 2; side++) {
            double place[AXES] = {0.37, 0.37}, low[AXES], high[AXES];
            place[axis] = side;
            place_beside(place, axis, -STEP, low);
            place_beside(place, axis, STEP, high);
            ck_assert_near(scenes[_i].field(low, 0.2), scenes[_i].field(high, 0.2), ROUND_OFF);
        }
}
END_TEST

/* div v = 0 inside, also by hoops; nothing passes a side; bodies start with the nodes' velocity. */
START_TEST(vortices_keep_volumes_and_sides)
{
    struct mpm_scene *const scene = test_scene_read(scenes[_i].path, NULL);
    ck_assert_int_eq(scene->boundary_count == 1, scenes[_i].moves);
    for (int p = 0; p < PLACES && scenes[_i].moves; p++) {
        double divergence = scene->geometry == MPM_AXISYMMETRIC
                                ? velocity(scene, 0, places[p]) / places[p][0]
                                : 0.0;
        for (int axis = 0; axis < AXES; axis++) {
            double low[AXES], high[AXES], side[AXES] = {places[p][0], places[p][1]};
            place_beside(places[p], axis, -STEP, low);
            place_beside(places[p], axis, STEP, high);
            divergence += (velocity(scene, axis, high) - velocity(scene, axis, low)) / (2.0 * STEP);
            ck_assert_near(value_of(scene, scene->bodies[0].velocity.text[axis], places[p], 0.0),
                           velocity(scene, axis, places[p]), ROUND_OFF);
            for (int end = 0; end < 2; end++) {
                side[axis] = end;
                ck_assert_near(velocity(scene, axis, side), 0.0, ROUND_OFF);
            }
        }
        ck_assert_near(divergence, 0.0, 1e-7);
    }
    mpm_scene_free(scene);
}
END_TEST

Suite *suite_heat_manufactured(void)
{
    Suite *suite = suite_create("heat_manufactured");
    TCase *fields = tcase_create("fields");
    tcase_add_loop_test(fields, sources_make_the_fields_solutions, 0, SCENES);
    tcase_add_loop_test(fields, starts_and_held_values_are_those_of_the_fields, 0, SCENES);
    tcase_add_loop_test(fields, no_heat_passes_sides_that_are_insulated, 0, SCENES);
    tcase_add_loop_test(fields, vortices_keep_volumes_and_sides, 0, SCENES);
    suite_add_tcase(suite, fields);
    return suite;
}
