/* Parameters of laws that no scene has yet: without moduli, with some of its own.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/scene/scene_build.h"
#include "suites.h"

#include <math.h>
#include <string.h>

static const struct mpm_law_parameter shear_alone[] = {{.which = MPM_PARAMETER_SHEAR}};
static const struct mpm_law_parameter shear_of_7[] = {
    {.which = MPM_PARAMETER_SHEAR, .optional = true, .fallback = 7.0}};
static const struct mpm_material_law dust = {.name = "dust"};
static const struct mpm_material_law oil = {
    .name = "oil", .parameters = shear_alone, .parameter_count = 1};
static const struct mpm_material_law wax = {
    .name = "wax", .parameters = shear_of_7, .parameter_count = 1};

static enum mpm_status build(const struct mpm_material_law *law, const struct mpm_raw_material *raw,
                             double *parameter, struct mpm_error *error)
{
    static char path[] = "scene.yaml";
    struct mpm_scene scene = {.path = path};
    const struct mpm_tree_node root = {.kind = MPM_TREE_MAPPING};
    const struct mpm_reading reading = {.scene = &scene, .root = &root, .error = error};
    return mpm_build_parameters(&reading, "materials.0", law, raw, parameter);
}

static char number[] = "2";
static const struct {
    const struct mpm_material_law *law;
    struct mpm_raw_material raw;
    const char *message; /* NULL: nothing is wrong */
    double shear;
} cases[] = {
    {&dust, {.name = NULL}, NULL, (double)NAN},
    {&dust, {.bulk = number}, "the law dust has no parameter bulk; allowed: none", 0.0},
    {&dust, {.young = number}, "the law dust has no parameter young; allowed: none", 0.0},
    {&dust, {.poisson = number}, "the law dust has no parameter poisson; allowed: none", 0.0},
    {&oil, {.shear = number}, NULL, 2.0},
    {&oil, {.name = NULL}, "the law oil requires shear, which is missing", 0.0},
    {&oil, {.bulk = number}, "the law oil has no parameter bulk; allowed: shear", 0.0},
    {&wax, {.name = NULL}, NULL, 7.0},
    {&wax, {.shear = number}, NULL, 2.0},
};
enum { CASES = sizeof cases / sizeof cases[0] };

START_TEST(a_law_has_the_parameters_that_it_states)
{
    double parameter[MPM_PARAMETER_COUNT];
    struct mpm_error error = {.message = ""};
    const enum mpm_status status = build(cases[_i].law, &cases[_i].raw, parameter, &error);
    if (cases[_i].message != NULL) {
        ck_assert_int_eq(status, MPM_BAD_INPUT);
        ck_assert_msg(strstr(error.message, cases[_i].message) != NULL, "%s", error.message);
        return;
    }
    ck_assert_msg(status == MPM_OK, "%s", error.message);
    ck_assert(isnan(parameter[MPM_PARAMETER_BULK]));
    ck_assert(isnan(cases[_i].shear) ? isnan(parameter[MPM_PARAMETER_SHEAR])
                                     : parameter[MPM_PARAMETER_SHEAR] == cases[_i].shear);
}
END_TEST

Suite *suite_scene_materials(void)
{
    Suite *const suite = suite_create("scene materials");
    TCase *const tests = tcase_create("laws");
    tcase_add_loop_test(tests, a_law_has_the_parameters_that_it_states, 0, CASES);
    suite_add_tcase(suite, tests);
    return suite;
}
