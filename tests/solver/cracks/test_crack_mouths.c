/* Cracks that begin outside of their body: where they enter it, and how far they have opened there.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/crack_block.h"
#include "support/near.h"

#include <glib.h>
#include <math.h>
#include <stdint.h>

enum { AXES = 2 };

/* Halves that part at a speed, beyond a line from one side of the block to the other, which the
 * crack follows from outside of it to outside. */
static const struct {
    const char *points, *velocity;
    double mouth[2][AXES]; /* the edges are x = 3 and x = 9 */
    double speed;
} mouths[] = {
    {"[[0, 5.6], [12, 5.6]]", "[0, 'y > 5.6 ? 0.3 : 0']", {{3.0, 5.6}, {9.0, 5.6}}, 0.3},
    {"[[12, 5.6], [0, 5.6]]", "[0, 'y < 5.6 ? -0.3 : 0']", {{9.0, 5.6}, {3.0, 5.6}}, 0.3},
    {"[[1.37, 5.6], [10.77, 5.6]]", "[0, 'y > 5.6 ? 0.3 : 0']", {{3.0, 5.6}, {9.0, 5.6}}, 0.3},
    /* the normal is (-0.28, 0.96) */
    {"[[1.2, 4.2], [10.8, 7]]",
     "['0.96*(y-5.6) > 0.28*(x-6) ? -0.084 : 0', '0.96*(y-5.6) > 0.28*(x-6) ? 0.288 : 0']",
     {{3.0, 4.725}, {9.0, 6.475}},
     0.3},
    /* with a stretch along the crack, which moves the mouths apart */
    {"[[1.37, 5.6], [10.77, 5.6]]",
     "['0.2*(x-6)', 'y > 5.6 ? 0.3 : 0']",
     {{3.0, 5.6}, {9.0, 5.6}},
     0.3},
};

/* Edges are found to 1e-6 of a cell. A point of an oblique crack moves at a mean of both sides'
 * velocities that is another one at each point, so that its normal turns by up to 1e-3, and the
 * opening along it is less by half of the square. */
static const double MOUTH_EDGE = 2e-6, MOUTH_OPENING = 1e-6;

static struct test_run open_mouths(int index, const char *law)
{
    struct settings settings = {.count = 0};
    settings_add(&settings, "method.shape=ugimp");
    settings_add(&settings, "time={end: 1000, step: 0.01}");
    settings_add(&settings, "materials.rubber.bulk=1e-9");
    settings_add(&settings, "materials.rubber.shear=1e-9");
    settings_add_formatted(&settings, "bodies.block.velocity=%s", mouths[index].velocity);
    settings_add_formatted(&settings, "cracks=[{points: %s, contact: none, %s}]",
                           mouths[index].points, law);
    return crack_block_open(&settings);
}

START_TEST(the_opening_at_an_end_outside_of_the_body_is_that_of_its_mouth)
{
    struct test_run run = open_mouths(_i, "opening: true");
    const struct mpm_cracks *const cracks = &crack_block_state(&run)->cracks;
    for (int end = 0; end < 2; end++) {
        const size_t mouth = cracks->openings.mouths[0][end];
        ck_assert_uint_lt(mouth, cracks->point_count);
        for (int axis = 0; axis < AXES; axis++)
            ck_assert_near(cracks->position[axis][mouth], mouths[_i].mouth[end][axis], MOUTH_EDGE);
    }
    test_run_steps(&run, 100);
    const double opened = mouths[_i].speed * mpm_simulation_time(run.simulation);
    ck_assert_near(mpm_simulation_crack_quantity(run.simulation, 0), opened, MOUTH_OPENING);
    ck_assert_near(mpm_simulation_crack_quantity(run.simulation, 2), opened, MOUTH_OPENING);
    test_run_close(&run);
}
END_TEST

/* An end in the body has no mouth, and a chain that has a point on each edge gets no other. */
START_TEST(a_chain_gets_a_point_where_it_enters_a_body_and_none_elsewhere)
{
    static const struct {
        const char *points, *more;
        size_t count;
        bool mouth[2];
    } chains[] = {
        {"[[4, 5.6], [8, 5.6]]", "opening: true", 11, {false, false}},
        {"[[3, 5.6], [9, 5.6]]", "opening: true", 16, {false, false}},
        {"[[1, 5.6], [3, 5.6], [8, 5.6]]", "opening: true", 19, {true, false}},
        {"[[1, 5.6], [8, 5.6]]", "opening: true", 19, {true, false}},
        {"[[4, 5.6], [9.3, 5.6]]", "opening: true", 15, {false, true}},
        {"[[1, 5.6], [8, 5.6]]", "opening: false", 19, {false, false}},
    };
    for (size_t k = 0; k < G_N_ELEMENTS(chains); k++) {
        struct settings settings = {.count = 0};
        settings_add_formatted(&settings, "cracks=[{points: %s, contact: none, %s}]",
                               chains[k].points, chains[k].more);
        struct test_run run = crack_block_open(&settings);
        const struct mpm_cracks *const cracks = &crack_block_state(&run)->cracks;
        ck_assert_uint_eq(cracks->point_count, chains[k].count);
        for (int end = 0; end < 2 && cracks->openings.mouths != NULL; end++)
            ck_assert(chains[k].mouth[end] == (cracks->openings.mouths[0][end] != SIZE_MAX));
        test_run_close(&run);
    }
}
END_TEST

Suite *suite_crack_mouths(void)
{
    Suite *suite = suite_create("crack_mouths");
    TCase *mouths_case = tcase_create("mouths");
    tcase_add_loop_test(mouths_case, the_opening_at_an_end_outside_of_the_body_is_that_of_its_mouth,
                        0, G_N_ELEMENTS(mouths));
    tcase_add_test(mouths_case, a_chain_gets_a_point_where_it_enters_a_body_and_none_elsewhere);
    suite_add_tcase(suite, mouths_case);
    return suite;
}
