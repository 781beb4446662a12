/* Scenes from texts and calls, and observers of runs.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "model/scene.h"
#include "suites.h"

#include <math.h>
#include <string.h>

static const char block[] = "format: 1\n"
                            "geometry: plane_strain\n"
                            "grid: {cell: [1, 1], cells: [4, 4]}\n"
                            "time: {end: 1, step: 0.3}\n"
                            "bodies:\n"
                            "  - {name: block, material: rubber,\n"
                            "     region: {rectangle: {from: [1, 1], to: [3, 3]}}}\n"
                            "materials: [{name: rubber, law: neo_hookean, density: 1, bulk: 0.1,\n"
                            "             shear: 0.1}]\n";

static struct mpm_draft *draft_of(const char *text)
{
    struct mpm_draft *draft = NULL;
    struct mpm_error error = {.message = ""};
    const size_t length = text != NULL ? strlen(text) : 0;
    ck_assert_msg(mpm_draft_create("block", text, length, &draft, &error) == MPM_OK, "%s",
                  error.message);
    return draft;
}

static struct mpm_scene *build_and_free(struct mpm_draft *draft)
{
    struct mpm_scene *scene = NULL;
    struct mpm_error error = {.message = ""};
    const enum mpm_status status = mpm_draft_build(draft, &scene, &error);
    ck_assert_msg(status == MPM_OK, "%s", error.message);
    mpm_draft_free(draft);
    return scene;
}

/* ------------------------------------------------------------------ drafts */

START_TEST(a_draft_becomes_the_scene_of_its_text_and_settings)
{
    struct mpm_draft *const draft = draft_of(block);
    const double corners[] = {1, 1, 3, 1, 2, 2.5};
    mpm_draft_set(draft, "bodies.block.velocity", "[x, 0]", NULL);
    mpm_draft_set_number(draft, "materials.rubber.bulk", 0.1 + 0.2, NULL);
    mpm_draft_set_integer(draft, "grid.refine", 2, NULL);
    mpm_draft_set_boolean(draft, "time.allow_unstable", true, NULL);
    mpm_draft_set_text(draft, "title", "a \"b\" \\ c: [", NULL);
    mpm_draft_set_pair(draft, "grid.cell", 0.7, 1.0 / 3.0, NULL);
    mpm_draft_set(draft, "bodies.block.region", "{}", NULL);
    mpm_draft_set_points(draft, "bodies.block.region.polygon.points", corners, 3, NULL);
    mpm_draft_set(draft, "grid.cells", "[8, 12]", NULL);
    struct mpm_scene *const scene = build_and_free(draft);
    ck_assert_str_eq(scene->bodies[0].velocity.text[0], "x");
    ck_assert(scene->materials[0].parameter[MPM_PARAMETER_BULK] == 0.1 + 0.2);
    ck_assert_str_eq(scene->title, "a \"b\" \\ c: [");
    ck_assert(scene->cell[0] == 0.35);
    ck_assert(scene->cell[1] == 1.0 / 3.0 / 2.0);
    ck_assert_uint_eq(scene->bodies[0].region.point_count, 3);
    ck_assert(scene->bodies[0].region.points[2][1] == 2.5);
    ck_assert_uint_eq(scene->setting_count, 9);
    mpm_scene_free(scene);
}
END_TEST

START_TEST(a_draft_can_start_from_nothing)
{
    struct mpm_draft *const draft = draft_of(NULL);
    mpm_draft_set_integer(draft, "format", 1, NULL);
    mpm_draft_set_text(draft, "geometry", "plane_strain", NULL);
    mpm_draft_set(draft, "grid", "{cell: [1, 1], cells: [4, 4]}", NULL);
    mpm_draft_set_number(draft, "time.end", 1.0, NULL);
    mpm_draft_set(draft, "materials.+",
                  "{name: rubber, law: neo_hookean, density: 1, bulk: 1, shear: 1}", NULL);
    for (int k = 0; k < 2; k++) {
        mpm_draft_set_text(draft, "bodies.+.name", k == 0 ? "low" : "high", NULL);
        mpm_draft_set_text(draft, k == 0 ? "bodies.low.material" : "bodies.high.material", "rubber",
                           NULL);
    }
    mpm_draft_set(draft, "bodies.low.region", "{rectangle: {from: [1, 1], to: [3, 2]}}", NULL);
    mpm_draft_set(draft, "bodies.high.region", "{rectangle: {from: [1, 2], to: [3, 3]}}", NULL);
    struct mpm_scene *const scene = build_and_free(draft);
    ck_assert_uint_eq(mpm_scene_body_count(scene), 2);
    ck_assert_str_eq(mpm_scene_body_name(scene, 1), "high");
    mpm_scene_free(scene);
}
END_TEST

static const struct {
    const char *path, *value, *message;
} mistakes[] = {
    {"method.shap", "ugimp", "block: --set \"method.shap=ugimp\": unknown key \"shap\""},
    {"method.shape", "ugimpp", "unknown choice, got \"ugimpp\"; allowed: classic | ugimp"},
    {"time.courant", "-7", "out of range, got \"-7\"; allowed: "},
    {"grid.cell", "[1, 0]", "out of range, got \"0\"; allowed: "},
    {"grid.cell", "[1", "did not find expected"},
    {"bodies.disk.velocity", "[0, 0]", "no entry \"disk\" in the list of 1; allowed: a position"},
    {"bodies.block.name.x", "1", "is one value and has no part"},
    {"a=b", "1", "block: not a path, got \"a=b\"; allowed: keys joined by points"},
    {"time", "{end: 1}=", "did not find"},
};

START_TEST(a_wrong_value_is_refused_at_once_and_left_out)
{
    struct mpm_draft *const draft = draft_of(block);
    struct mpm_error error = {.message = ""};
    ck_assert_int_eq(mpm_draft_set(draft, mistakes[_i].path, mistakes[_i].value, &error),
                     MPM_BAD_INPUT);
    ck_assert_msg(strstr(error.message, mistakes[_i].message) != NULL, "%s", error.message);
    struct mpm_scene *const scene = build_and_free(draft);
    ck_assert_uint_eq(scene->setting_count, 0);
    mpm_scene_free(scene);
}
END_TEST

/* An entry whose key is refused is none: neither a position nor a name reaches it. */
START_TEST(a_refused_setting_leaves_no_entry)
{
    struct mpm_draft *const draft = draft_of(block);
    struct mpm_error error = {.message = ""};
    ck_assert_int_eq(mpm_draft_set(draft, "bodies.+.nosuch", "1", &error), MPM_BAD_INPUT);
    ck_assert_int_eq(mpm_draft_set(draft, "bodies.1.velocity", "[0, 0]", &error), MPM_BAD_INPUT);
    ck_assert_msg(strstr(error.message, "no entry \"1\" in the list of 1") != NULL, "%s",
                  error.message);
    mpm_scene_free(build_and_free(draft));
}
END_TEST

START_TEST(a_failure_that_nobody_saw_fails_the_build)
{
    struct mpm_draft *const draft = draft_of(block);
    struct mpm_scene *scene = NULL;
    struct mpm_error error = {.message = ""};
    mpm_draft_set_number(draft, "grid.cell.0", (double)NAN, NULL);
    mpm_draft_set_number(draft, "time.end", -1.0, NULL);
    ck_assert_int_eq(mpm_draft_build(draft, &scene, &error), MPM_BAD_INPUT);
    ck_assert_ptr_null(scene);
    ck_assert_msg(strstr(error.message, "grid.cell.0") != NULL, "%s", error.message);
    mpm_draft_free(draft);
}
END_TEST

START_TEST(a_text_is_read_as_a_file_is)
{
    struct mpm_scene *scene = NULL;
    struct mpm_error error = {.message = ""};
    const char *const settings[] = {"grid.cells=[8, 8]"};
    ck_assert_int_eq(mpm_scene_parse("a text", block, strlen(block), settings, 1, &scene, &error),
                     MPM_OK);
    ck_assert_int_eq(scene->cells[0], 8);
    mpm_scene_free(scene);
    ck_assert_int_eq(mpm_scene_parse("a text", block, 30, NULL, 0, &scene, &error), MPM_BAD_INPUT);
    ck_assert_ptr_null(scene);
    ck_assert_msg(strncmp(error.message, "a text", 6) == 0, "%s", error.message);
}
END_TEST

/* --------------------------------------------------------------- observers */

enum { SEEN_MAX = 64 };
struct seen {
    double time[SEEN_MAX];
    size_t count;
    enum mpm_status status; /* to return */
};

static enum mpm_status look(void *context, struct mpm_observation *observation,
                            struct mpm_error *error)
{
    struct seen *const seen = context;
    const struct mpm_simulation *const simulation = mpm_observation_simulation(observation);
    struct mpm_field_view position, again;
    ck_assert_int_eq(mpm_observation_field(observation, MPM_FIELD_POSITION, &position, error),
                     MPM_OK);
    ck_assert_int_eq(mpm_observation_field(observation, MPM_FIELD_POSITION, &again, error), MPM_OK);
    ck_assert_ptr_eq(position.values, again.values);
    ck_assert_uint_eq(position.count, mpm_simulation_particle_count(simulation));
    ck_assert_uint_eq(position.components, 2);
    double own[2];
    mpm_simulation_field_range(simulation, MPM_FIELD_POSITION, position.count - 1, 1, own);
    ck_assert(position.values[(position.count - 1) * position.stride + 1] == own[1]);
    ck_assert_int_eq(mpm_observation_field(observation, MPM_FIELD_TEMPERATURE, &again, error),
                     MPM_BAD_INPUT);
    ck_assert_uint_lt(seen->count, SEEN_MAX);
    seen->time[seen->count++] = mpm_simulation_time(simulation);
    return seen->count > 2 ? seen->status : MPM_OK;
}

static enum mpm_status run_with(const struct mpm_observer *observers, size_t count,
                                struct mpm_error *error)
{
    struct mpm_draft *const draft = draft_of(block);
    mpm_draft_set(draft, "bodies.block.velocity", "[0.1, 0.2]", NULL);
    struct mpm_scene *const scene = build_and_free(draft);
    const struct mpm_run_options options = {
        .simulation = {.threads = 1}, .observers = observers, .observer_count = count};
    const enum mpm_status status = mpm_scene_run(scene, &options, error);
    mpm_scene_free(scene);
    return status;
}

static void assert_times(const struct seen *seen, const double *times, size_t count)
{
    ck_assert_uint_eq(seen->count, count);
    for (size_t k = 0; k < count; k++)
        ck_assert_double_eq_tol(seen->time[k], times[k], 1e-12);
}

/* Steps of 0.3 land on 0.25, 0.5, 0.75 of the one and on 0.4 of the other, and go on from there. */
START_TEST(observers_are_called_at_their_steps_and_times)
{
    struct seen by_interval = {.count = 0}, by_times = {.count = 0}, by_steps = {.count = 0};
    static const double times[] = {0.4, 0.5 + 2e-16, 7.0}; /* 0.5 and a rounding */
    const struct mpm_observer observers[] = {
        {.interval = 0.25, .observe = look, .context = &by_interval},
        {.times = times, .time_count = 3, .observe = look, .context = &by_times},
        {.steps = 2, .observe = look, .context = &by_steps},
    };
    struct mpm_error error = {.message = ""};
    ck_assert_msg(run_with(observers, 3, &error) == MPM_OK, "%s", error.message);
    assert_times(&by_interval, (const double[]){0, 0.25, 0.5, 0.75, 1}, 5);
    assert_times(&by_times, (const double[]){0, 0.4, 0.5, 1}, 4);
    assert_times(&by_steps, (const double[]){0, 0.4, 0.75, 1},
                 4); /* steps end at 0.25 0.4 0.5 0.75 1 */
}
END_TEST

START_TEST(an_observer_can_end_the_run)
{
    struct seen seen = {.status = MPM_RUN_FAILED};
    const struct mpm_observer observer = {.steps = 1, .observe = look, .context = &seen};
    struct mpm_error error = {.message = ""};
    ck_assert_int_eq(run_with(&observer, 1, &error), MPM_RUN_FAILED);
    ck_assert_uint_eq(seen.count, 3);
    ck_assert_msg(strstr(error.message, "observer 0: the scene has no field temperature") != NULL,
                  "%s", error.message);
}
END_TEST

START_TEST(wrong_observers_are_refused)
{
    static const double twice[] = {0.4, 0.4};
    const struct {
        struct mpm_observer observer;
        const char *message;
    } wrong[] = {
        {{.steps = 1}, "observer 0: it has no function"},
        {{.interval = -1.0, .observe = look}, "interval -1; allowed: 0 or above"},
        {{.interval = (double)NAN, .observe = look}, "allowed: 0 or above, finite"},
        {{.times = twice, .time_count = 2, .observe = look}, "time 1 is 0.4; allowed: finite"},
    };
    for (size_t k = 0; k < sizeof wrong / sizeof *wrong; k++) {
        struct mpm_error error = {.message = ""};
        ck_assert_int_eq(run_with(&wrong[k].observer, 1, &error), MPM_BAD_INPUT);
        ck_assert_msg(strstr(error.message, wrong[k].message) != NULL, "%s", error.message);
    }
}
END_TEST

START_TEST(fields_are_found_by_name)
{
    enum mpm_field field = MPM_FIELD_ID;
    struct mpm_error error = {.message = ""};
    ck_assert_int_eq(mpm_field_find("stress", &field, &error), MPM_OK);
    ck_assert_int_eq(field, MPM_FIELD_STRESS);
    ck_assert_int_eq(mpm_field_find("strain", &field, &error), MPM_BAD_INPUT);
    ck_assert_msg(strstr(error.message, "'strain' is no field; allowed: id, body, pos") != NULL,
                  "%s", error.message);
}
END_TEST

Suite *suite_draft(void)
{
    Suite *suite = suite_create("draft");
    TCase *drafts = tcase_create("drafts");
    tcase_add_test(drafts, a_draft_becomes_the_scene_of_its_text_and_settings);
    tcase_add_test(drafts, a_draft_can_start_from_nothing);
    tcase_add_loop_test(drafts, a_wrong_value_is_refused_at_once_and_left_out, 0,
                        (int)(sizeof mistakes / sizeof *mistakes));
    tcase_add_test(drafts, a_refused_setting_leaves_no_entry);
    tcase_add_test(drafts, a_failure_that_nobody_saw_fails_the_build);
    tcase_add_test(drafts, a_text_is_read_as_a_file_is);
    tcase_add_test(drafts, fields_are_found_by_name);
    suite_add_tcase(suite, drafts);
    TCase *observers = tcase_create("observers");
    tcase_add_test(observers, observers_are_called_at_their_steps_and_times);
    tcase_add_test(observers, an_observer_can_end_the_run);
    tcase_add_test(observers, wrong_observers_are_refused);
    suite_add_tcase(suite, observers);
    return suite;
}
