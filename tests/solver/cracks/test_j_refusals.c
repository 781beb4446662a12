/* Contours that have no J integral: each is refused with its reason.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/crack_blocks.h"
#include "support/folder.h"
#include "support/scene_files.h"
#include "support/scenes.h"

#include <glib.h>

static const char BLOCK[] = BLOCK_OF_J;

static const struct refusal {
    const char *settings[4]; /* ends with NULL */
    const char *message;
} REFUSALS[] = {
    {{"cracks=[{points: [[0.2, 18.1], [18.3, 18.1]], j_integral: [{contour: 17}]}]"}, "edge"},
    {{"cracks=[{points: [[0.2, 18.1], [33, 18.1]], j_integral: [{contour: 4}]}]"}, "grid"},
    {{"cracks=[{points: [[16.2, 18.1], [18.3, 18.1]], j_integral: [{contour: 4}]}]"},
     "meets its crack 0 times"},
    {{"cracks=[{points: [[0.2, 18.1], [18.3, 18.1]], j_integral: [{contour: 6}]},"
      " {points: [[15.2, 15.1], [28.3, 15.1]]}]"},
     "meets cracks.1"},
    /* all of another crack inside: J would be that of both */
    {{"cracks=[{points: [[0.2, 18.1], [18.3, 18.1]], j_integral: [{contour: 6}]},"
      " {points: [[19.6, 18.1], [20.4, 18.9]]}]"},
     "cracks.1 lies inside the contour, near (19.6, 18.1)"},
    {{"geometry=axisymmetric",
      "cracks=[{points: [[0, 18.1], [8.3, 18.1]], j_integral: [{contour: 8}]}]",
      "bodies.block.region={rectangle: {from: [0, 1.6], to: [34, 34.4]}}"},
     "reaches the axis r = 0"},
    {{"cracks=[{points: [[0.2, 18.1], [18.3, 18.1]], j_integral: [{contour: 4}]}]",
      "materials=[{name: stiff, law: linear_elastic, density: 2, bulk: 80, shear: 48},"
      " {name: soft, law: linear_elastic, density: 2, bulk: 8, shear: 4.8}]",
      "bodies=[{name: block, material: stiff, region: {rectangle: {from: [2, 1.6], to: [18, 34.4]}}"
      "}, {name: other, material: soft, region: {rectangle: {from: [18, 1.6], to: [34, 34.4]}}}]"},
     "two materials, stiff and soft"},
    {{"cracks=[{points: [[0.2, 18.1], [18.3, 18.1]], j_integral: [{contour: 4}, {contour: 5},"
      " {contour: 4}]}]"},
     "the same integral as cracks.0.j_integral.0"},
};

START_TEST(a_contour_that_is_none_is_refused_with_the_reason)
{
    const struct refusal *const refusal = &REFUSALS[_i];
    struct test_run run = {NULL, NULL};
    struct mpm_error error = {.message = ""};
    const struct mpm_simulation_options options = {.threads = 1};
    size_t count = 0;
    while (refusal->settings[count] != NULL)
        count++;
    char *const folder = test_folder_create();
    char *const path = test_folder_write(folder, "scene.yaml", BLOCK);
    enum mpm_status status = mpm_scene_read(path, refusal->settings, count, &run.scene, &error);
    if (status == MPM_OK)
        status = mpm_simulation_create(run.scene, &options, &run.simulation, &error);
    g_free(path);
    test_folder_remove(folder);
    ck_assert_int_eq(status, MPM_BAD_INPUT);
    test_contains(error.message, refusal->message);
    mpm_simulation_free(run.simulation);
    mpm_scene_free(run.scene);
}
END_TEST

Suite *suite_j_refusals(void)
{
    Suite *suite = suite_create("j_refusals");
    TCase *scenes = tcase_create("scenes");
    tcase_add_loop_test(scenes, a_contour_that_is_none_is_refused_with_the_reason, 0,
                        G_N_ELEMENTS(REFUSALS));
    suite_add_tcase(suite, scenes);
    return suite;
}
