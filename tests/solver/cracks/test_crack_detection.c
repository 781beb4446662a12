/* Contact of cracks beside each other, at the axis and at edges: surfaces that are pressed stay as
 * far apart as the same particles are without cracks.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "model/crack.h"
#include "suites.h"
#include "support/combinations.h"
#include "support/crack_block.h"
#include "support/near.h"

#include <glib.h>
#include <math.h>
#include <stdlib.h>

enum { AXES = 2, MOST = 3, STEPS = 90 };

/* A block that two rigid bodies press by up to 4 %; two by two particles a cell. */
static const char PRESSED[] =
    "format: 1\n"
    "geometry: plane_strain\n"
    "grid: {origin: [0, 0], cell: [1, 1], cells: [8, 14]}\n"
    "time: {end: 60, courant: 0.4}\n"
    "materials: [{name: m, law: neo_hookean, density: 1, young: 1, poisson: 0.3}]\n"
    "bodies:\n"
    "  - {name: block, material: m, region: {rectangle: {from: [1, 1], to: [7, 13]}}}\n"
    "  - {name: low, rigid: {velocity: [free, '0.001*t']}, region: {rectangle: {from: [0, 0],"
    " to: [8, 1]}}}\n"
    "  - {name: high, rigid: {velocity: [free, '-0.001*t']}, region: {rectangle: {from: [0, 13],"
    " to: [8, 14]}}}\n"
    "damping: {grid: 0.2}\n";

/* Cracks by their heights at the first and the last point, from `from` to `to`. */
struct cracks {
    double from, to;
    size_t count;
    double height[MOST][2];
    bool reversed; /* does the second one run the other way? */
};

static void add_cracks(struct settings *settings, const struct cracks *cracks, const char *more)
{
    GString *const text = g_string_new("cracks=[");
    for (size_t k = 0; k < cracks->count; k++) {
        const bool back = cracks->reversed && k == 1;
        const double *const height = cracks->height[k];
        g_string_append_printf(text, "%s{points: [[%g, %g], [%g, %g]], %s}", k == 0 ? "" : ", ",
                               back ? cracks->to : cracks->from, height[back ? 1 : 0],
                               back ? cracks->from : cracks->to, height[back ? 0 : 1], more);
    }
    settings_add_formatted(settings, "%s]", text->str);
    g_string_free(text, TRUE);
}

static double height_at(const struct cracks *cracks, size_t k, double x)
{
    const double part = (x - cracks->from) / (cracks->to - cracks->from);
    return cracks->height[k][0] + part * (cracks->height[k][1] - cracks->height[k][0]);
}

/* The least distance, now, of pairs of particles that began one above the other with the crack
 * between them, a cell or more from its ends; over that of the same pairs without cracks. */
static double least_ratio(const double *start, const double *now, const double *intact,
                          size_t count, const struct cracks *cracks, size_t k, double margin)
{
    double least = HUGE_VAL;
    for (size_t p = 0; p < count; p++)
        for (size_t q = 0; q < count; q++) {
            const double x = start[AXES * p], height = height_at(cracks, k, x);
            const double low = start[AXES * p + 1], high = start[AXES * q + 1];
            if (x != start[AXES * q] || x < cracks->from + margin || x > cracks->to - 1.0 ||
                !(low < height && high > height && high - low < 0.6))
                continue;
            least = fmin(least, (now[AXES * q + 1] - now[AXES * p + 1]) /
                                    (intact[AXES * q + 1] - intact[AXES * p + 1]));
        }
    return least;
}

/* Surfaces that slide a little, and contact that begins a little late, change distances by up to
 * this part. */
static const double PRESSED_CLOSE = 0.06;

/* The scene with cracks and without, and what is between; `margin`: of pairs from the first point.
 */
static void assert_separate(const struct settings *settings, const struct cracks *cracks,
                            const char *more, double margin)
{
    struct settings cracked = {.count = 0}, plain = {.count = 0};
    for (guint k = 0; k < settings->count; k++) {
        settings_add(&cracked, settings->texts[k]);
        settings_add(&plain, settings->texts[k]);
    }
    add_cracks(&cracked, cracks, more);
    struct test_run runs[2] = {test_run_open(PRESSED, cracked.texts, 1),
                               test_run_open(PRESSED, plain.texts, 1)};
    size_t count;
    double *const start = test_run_field(&runs[0], MPM_FIELD_POSITION, &count);
    for (int k = 0; k < 2; k++)
        test_run_steps(&runs[k], STEPS);
    double *const now = test_run_field(&runs[0], MPM_FIELD_POSITION, NULL);
    double *const intact = test_run_field(&runs[1], MPM_FIELD_POSITION, NULL);
    for (size_t k = 0; k < cracks->count; k++)
        ck_assert_near(least_ratio(start, now, intact, count, cracks, k, margin), 1.0,
                       PRESSED_CLOSE);
    for (size_t k = 0; k < mpm_scene_crack_quantity_count(runs[0].scene); k++)
        ck_assert_double_eq(mpm_simulation_crack_quantity(runs[0].simulation, k), 0.0);
    free(start);
    free(now);
    free(intact);
    for (int k = 0; k < 2; k++)
        test_run_close(&runs[k]);
    settings_clear(&cracked);
    settings_clear(&plain);
}

/* ------------------------------------------------------- cracks beside each other */

static const struct cracks beside[] = {
    {2.3, 5.7, 1, {{6.5, 6.5}}, false},
    {2.3, 5.7, 2, {{4.5, 4.5}, {8.5, 8.5}}, false},
    {2.3, 5.7, 2, {{5.5, 5.5}, {8.5, 8.5}}, false},
    {2.3, 5.7, 2, {{6.5, 6.5}, {8.5, 8.5}}, false},
    {2.3, 5.7, 2, {{6.5, 6.5}, {8.0, 8.0}}, false},
    {2.3, 5.7, 2, {{5.5, 5.5}, {8.5, 8.5}}, true},
    {2.3, 5.7, 3, {{4.5, 4.5}, {6.5, 6.5}, {8.5, 8.5}}, false},
    {2.3, 5.7, 3, {{5.1, 5.1}, {6.6, 6.6}, {8.1, 8.1}}, false},
    {2.3, 5.7, 2, {{5.6, 6.1}, {8.4, 7.7}}, false}, /* oblique to each other: 2.8 to 1.6 */
    {2.3, 5.7, 3, {{4.4, 4.9}, {6.6, 6.6}, {8.9, 8.2}}, false},
};

/* Oblique surfaces slide unless they stick. */
static bool is_straight(const struct cracks *cracks)
{
    for (size_t k = 0; k < cracks->count; k++)
        if (cracks->height[k][0] != cracks->height[k][1])
            return false;
    return true;
}

START_TEST(pressed_cracks_beside_each_other_stay_closed)
{
    static const char *const detections[] = {"volume", "displacement"};
    static const char *const shapes[] = {"ugimp", "cpdi", "bspline2"};
    const struct cracks *const cracks = &beside[(size_t)_i % G_N_ELEMENTS(beside)];
    const char *const detection = detections[(size_t)_i / G_N_ELEMENTS(beside)];
    char *const more = g_strdup_printf("contact: %s, detection: %s",
                                       is_straight(cracks) ? "frictionless" : "stick", detection);
    for (size_t k = 0; k < G_N_ELEMENTS(shapes); k++) {
        struct settings settings = {.count = 0};
        settings_add_formatted(&settings, "method={shape: %s, stress_update: usavg}", shapes[k]);
        assert_separate(&settings, cracks, more, 1.0);
        settings_clear(&settings);
    }
    g_free(more);
}
END_TEST

/* Particles above one crack and below the other see the nodes between both from above, and share a
 * field there: it has no contact, and the history counts such nodes. */
START_TEST(nodes_between_near_cracks_that_run_opposite_ways_are_counted)
{
    static const struct cracks opposite = {2.3, 5.7, 2, {{6.5, 6.5}, {8.0, 8.0}}, true};
    struct settings settings = {.count = 0};
    settings_add(&settings, "method={shape: bspline2, stress_update: usavg}");
    add_cracks(&settings, &opposite, "contact: frictionless");
    struct test_run run = test_run_open(PRESSED, settings.texts, 1);
    test_run_steps(&run, 1);
    for (size_t k = 0; k < 2; k++)
        ck_assert_double_gt(mpm_simulation_crack_quantity(run.simulation, k), 0.0);
    test_run_close(&run);
    settings_clear(&settings);
}
END_TEST

/* ------------------------------------------------------------- edges and the axis */

/* A crack that begins where nodes see half a cell. */
static const struct {
    const char *name, *settings[4];
    double from;
} edges[] = {
    {"r = 0", {"geometry=axisymmetric", "bodies.block.region.rectangle.from=[0, 1]"}, 0.0},
    {"r = 0 with mirrored nodes beyond",
     {"geometry=axisymmetric", "bodies.block.region.rectangle.from=[0, 1]",
      "grid={origin: [-2, 0], cell: [1, 1], cells: [10, 14]}"},
     0.0},
    {"a wall at the grid's edge",
     {"bodies.block.region.rectangle.from=[0, 1]",
      "boundary=[{region: {line: {from: [0, 0], to: [0, 14]}}, velocity: [0, free]}]"},
     0.0},
    {"a plane of symmetry inside the grid",
     {"boundary=[{region: {line: {from: [1, 0], to: [1, 14]}}, symmetry: true}]",
      "bodies.low.region.rectangle.from=[1, 0]", "bodies.high.region.rectangle.from=[1, 13]"},
     1.00001},
};

START_TEST(the_area_of_a_cell_is_halved_where_a_node_sees_half_of_it)
{
    const struct cracks cracks = {edges[_i].from, 5.7, 1, {{6.5, 6.5}}, false};
    const bool mirrored = edges[_i].settings[2] != NULL && cracks.from == 0.0;
    for (size_t k = 0; k < TEST_SHAPES; k++) {
        struct settings settings = {.count = 0};
        if (mirrored && k != MPM_UGIMP && k != MPM_CPDI)
            continue; /* points have no domains that reach beyond */
        settings_add_formatted(&settings, "method={shape: %s, stress_update: usavg%s}",
                               test_shapes[k],
                               mirrored ? ", axis: planar, axis_nodes: mirrored" : "");
        for (int i = 0; i < 4 && edges[_i].settings[i] != NULL; i++)
            settings_add(&settings, edges[_i].settings[i]);
        assert_separate(&settings, &cracks, "contact: frictionless, detection: cell", 0.0);
        settings_clear(&settings);
    }
}
END_TEST

/* ------------------------------------------------------------------- normals */

/* The normal at a node is that of the segment that the line from the particle crosses: of three and
 * of five the middle one, whichever end the chain begins at, by segments and by the part's line. */
enum { ZIGZAG = 6 };

START_TEST(a_line_that_crosses_several_segments_has_the_middle_one_from_both_ends)
{
    static const struct {
        double particle[2], node[2];
        size_t segment;
    } lines[] = {{{0, 1}, {3.25, 1.25}, 1}, {{0, 1}, {5, 1}, 2}, {{5, 1.25}, {1.75, 1.25}, 3}};
    double x[2][ZIGZAG] = {{0, 1, 2, 3, 4, 5}, {5, 4, 3, 2, 1, 0}};
    double y[2][ZIGZAG] = {{0, 2, 0, 2, 0, 2}, {2, 0, 2, 0, 2, 0}};
    const double slacks[] = {HUGE_VAL, 1e-12};
    for (int k = 0; k < 2; k++)
        for (int s = 0; s < 2; s++) {
            const struct mpm_crack_chain chain = {.x = x[k], .y = y[k], .count = ZIGZAG};
            const struct mpm_crack_part part = mpm_crack_part_of(&chain, 0, ZIGZAG - 1, slacks[s]);
            size_t segment = SIZE_MAX;
            ck_assert(mpm_crack_part_side(&chain, &part, lines[_i].particle, lines[_i].node,
                                          &segment) != MPM_CRACK_SAME_SIDE);
            ck_assert_uint_eq(k == 0 ? segment : ZIGZAG - 2 - segment, lines[_i].segment);
        }
}
END_TEST

Suite *suite_crack_detection(void)
{
    Suite *suite = suite_create("crack_detection");
    TCase *near = tcase_create("beside each other");
    tcase_add_loop_test(near, pressed_cracks_beside_each_other_stay_closed, 0,
                        2 * (int)G_N_ELEMENTS(beside));
    tcase_add_test(near, nodes_between_near_cracks_that_run_opposite_ways_are_counted);
    suite_add_tcase(suite, near);
    TCase *at_edges = tcase_create("edges");
    tcase_add_loop_test(at_edges, the_area_of_a_cell_is_halved_where_a_node_sees_half_of_it, 0,
                        G_N_ELEMENTS(edges));
    suite_add_tcase(suite, at_edges);
    TCase *normals = tcase_create("normals");
    tcase_add_loop_test(
        normals, a_line_that_crosses_several_segments_has_the_middle_one_from_both_ends, 0, 3);
    suite_add_tcase(suite, normals);
    return suite;
}
