/* A run of the suite that was killed goes on to the same pictures of scenes: those of programs that
 * had ended are kept, and a program that had not takes them anew.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/catalogue.h"
#include "support/folder.h"
#include "support/scene_files.h"
#include "support/verify.h"

#include <glib.h>
#include <jansson.h>
#include <signal.h>
#include <string.h>

enum { FRAMES = 5 };

struct folders {
    char *catalogue, *output;
};

static char *replaced(const char *text, const char *old, const char *new)
{
    char **parts = g_strsplit(text, old, 2);
    ck_assert_msg(g_strv_length(parts) == 2, "no %s", old);
    char *whole = g_strjoinv(new, parts);
    g_strfreev(parts);
    return whole;
}

/* Case B runs a scene with pictures of a motion, and waits halfway if `waits`. */
static void write_scene(const char *catalogue, bool waits)
{
    char *text = test_case_text("B", "scene");
    char *slow = replaced(text, "timeout: 0.5", "timeout: 500");
    char *fast = replaced(slow, "{name: speed, value: 1}",
                          waits ? "{name: speed, value: 2}" : "{name: speed, value: 1}");
    char *whole = g_strdup_printf("%sscene: scene.yaml\npicture: {frames: %d}\n", fast, FRAMES);
    test_case_write(catalogue, "B", whole);
    char *scene = replaced(TEST_LEAST_SCENE, "{name: block,", "{name: block, velocity: [0.5, 0],");
    g_free(test_folder_write(catalogue, "T/B/scene.yaml", scene));
    g_free(scene);
    g_free(whole);
    g_free(fast);
    g_free(slow);
    g_free(text);
}

/* Case Z, which comes after B. */
static void write_last(const char *catalogue, bool hangs)
{
    char *text = test_case_text("Z", hangs ? "hang" : "pass");
    char *patient = replaced(text, "timeout: 0.5", "timeout: 500");
    test_case_write(catalogue, "Z", patient);
    g_free(patient);
    g_free(text);
}

/* One program at a time, so that B has ended when Z begins. */
static int run_one_by_one(const char *catalogue, const char *output)
{
    struct test_said said =
        test_verify_with("mpm-verify run --jobs 1 --catalogue @ --output @", catalogue, output);
    const int status = said.exit_status;
    test_said_free(&said);
    return status;
}

/* Killed while B, or after it Z, was running; neither waits any more. */
static struct folders killed_run(bool in_scene)
{
    const struct folders folders = {test_folder_create(), test_folder_create()};
    write_scene(folders.catalogue, in_scene);
    write_last(folders.catalogue, !in_scene);
    const pid_t process = test_in_process(run_one_by_one, folders.catalogue, folders.output);
    test_wait_for(folders.output, in_scene ? ".run/report/cases/B/data-only-halfway.dat"
                                           : ".run/report/cases/Z/rows-only.jsonl");
    ck_assert_int_eq(kill(process, SIGKILL), 0);
    ck_assert_int_eq(test_exit_status(process), 128 + SIGKILL);
    write_scene(folders.catalogue, false);
    write_last(folders.catalogue, false);
    return folders;
}

static unsigned frames_of(const char *picture, const char *shot)
{
    json_t *object = json_loads(picture, 0, NULL);
    ck_assert_ptr_nonnull(object);
    const json_t *const frames = json_object_get(json_object_get(object, shot), "frames");
    const unsigned count = (unsigned)json_array_size(frames);
    const double last =
        json_number_value(json_object_get(json_array_get(frames, count - 1), "time"));
    ck_assert_double_eq_tol(last, 1, 1e-9);
    json_decref(object);
    return count;
}

START_TEST(a_killed_run_goes_on_to_the_same_pictures)
{
    static const char *const names[] = {"picture-only.json", "picture-state.svg",
                                        "picture-sketch.svg", "picture-small.svg",
                                        "picture-motion.svg"};
    const struct folders folders = killed_run(_i == 1);
    const struct folders whole = {folders.catalogue, test_folder_create()};
    struct test_said said = test_verify_with("mpm-verify run --resume --catalogue @ --output @",
                                             folders.catalogue, folders.output);
    ck_assert_msg(said.exit_status == 0, "%s%s", said.out, said.err);
    ck_assert_int_eq(run_one_by_one(whole.catalogue, whole.output), 0);
    for (size_t i = 0; i < G_N_ELEMENTS(names); i++) {
        char *path = g_strdup_printf("cases/B/%s", names[i]);
        char *found = test_folder_read(folders.output, path);
        char *expected = test_folder_read(whole.output, path);
        ck_assert_msg(strcmp(found, expected) == 0, "%s is another one", names[i]);
        if (i == 0) {
            ck_assert_uint_eq(frames_of(found, "still"), 1);
            ck_assert_uint_eq(frames_of(found, "motion"), FRAMES);
        }
        g_free(expected);
        g_free(found);
        g_free(path);
    }
    test_said_free(&said);
    test_folder_remove(whole.output);
    test_folder_remove(folders.output);
    test_folder_remove(folders.catalogue);
}
END_TEST

Suite *suite_resume_pictures(void)
{
    Suite *suite = suite_create("resume_pictures");
    TCase *runs = tcase_create("runs");
    tcase_add_loop_test(runs, a_killed_run_goes_on_to_the_same_pictures, 0, 2);
    suite_add_tcase(suite, runs);
    return suite;
}
