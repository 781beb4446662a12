/* All mistakes of a scene at once, scenes from standard input, keys that are taken out.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "model/scene.h"
#include "mpm_yaml.h"
#include "suites.h"
#include "support/command.h"
#include "support/folder.h"
#include "support/scene_files.h"

#include <glib.h>
#include <string.h>

#define SCENE "tests/scenes/good/compressed_disk.yaml"

/* ------------------------------------------------------------ many mistakes */

static char *folder;

static void set_up(void)
{
    folder = test_folder_create();
}

static void tear_down(void)
{
    test_folder_remove(folder);
}

/* A scene of `head`, with keys of the rest as they should be. */
static char *scene_with(const char *head)
{
    char *text = g_strconcat(head,
                             "format: 1\n"
                             "time: {end: 1}\n"
                             "grid: {cell: [1, 1], cells: [10, 10]}\n",
                             NULL);
    char *path = test_folder_write(folder, "scene.yaml", text);
    g_free(text);
    return path;
}

/* What each list of faults has, in order: line and part of the message; `count` of all. */
static const struct {
    const char *head;
    size_t count;
    struct {
        int line;
        const char *said;
    } faults[4];
} lists[] = {
    /* keys and values by themselves: in the order of the lines, whatever that of the table */
    {"output: {histroy: 1}\nbodies: []\nmaterials: [{name: a, law: steel, density: -1}]\n"
     "geometry: plane_strain\n",
     4,
     {{1, "output: unknown key \"histroy\"; allowed: history, "},
      {2, "bodies: empty"},
      {3, "materials.0.law: unknown law, got \"steel\""},
      {3, "materials.0.density: out of range, got \"-1\"; allowed: number above 0"}}},
    /* in a list, each entry */
    {"geometry: plane_strain\nmaterials:\n- {name: a, law: none, density: x}\n"
     "- {name: b, law: none, density: y}\n"
     "bodies: [{name: b, material: a, region: {disk: {center: [5, z], radius: 1}}, "
     "particles_per_cell: [2, 2]}]\n",
     3,
     {{3, "materials.0.density: not a number, got \"x\""},
      {4, "materials.1.density: not a number, got \"y\""},
      {5, "bodies.0.region.disk.center.1: not a number, got \"z\""}}},
    /* what needs several keys: bodies and boundaries together */
    {"geometry: plane_strain\nmaterials: [{name: steel, law: linear_elastic, density: 1, bulk: 1, "
     "shear: 1}]\n"
     "bodies:\n"
     "- {name: a, material: stel, region: {disk: {center: [5, 5], radius: 1}}, "
     "particles_per_cell: [2, 2]}\n"
     "- {name: b, region: {disk: {center: [8, 5], radius: 1}}, particles_per_cell: [2, 2]}\n"
     "boundary:\n- {region: {line: {from: [0, 0], to: [10, 0]}}, velocity: [free, free]}\n",
     3,
     {{4, "no such material, got \"stel\"; allowed: a name in materials; did you mean steel?"},
      {5, "bodies.1: none of material and rigid given"},
      {7, "boundary.0.velocity: both components are free"}}},
    /* a misspelt key is not missing too */
    {"goemetry: plane_strain\nmaterials: [{name: a, law: none, density: 1, nmae: b}]\n"
     "bodies: [{name: b, materail: a, region: {disk: {center: [5, 5], radus: 1}}, "
     "particles_per_cell: [2, 2]}]\n",
     4,
     {{1, "unknown key \"goemetry\""},
      {2, "materials.0: unknown key \"nmae\""},
      {3, "bodies.0: unknown key \"materail\""},
      {3, "bodies.0.region.disk: unknown key \"radus\""}}},
    /* one alone */
    {"geometry: plane_strain\nmaterials: [{name: a, law: none, density: 1}]\n",
     1,
     {{1, "bodies: missing, the key is required"}}},
};

START_TEST(all_mistakes_of_a_kind_are_listed_by_line)
{
    char *path = scene_with(lists[_i].head);
    struct mpm_scene *scene = NULL;
    struct mpm_faults faults;
    struct mpm_error first = {.status = MPM_OK};
    ck_assert_int_eq(mpm_scene_read_all(path, NULL, 0, &scene, &faults), MPM_BAD_INPUT);
    ck_assert_ptr_null(scene);
    ck_assert_msg(faults.count == lists[_i].count, "%zu: %s", faults.count,
                  faults.list[faults.count - 1].message);
    for (size_t k = 0; k < faults.count; k++) {
        const struct mpm_error *fault = &faults.list[k];
        ck_assert_int_eq(fault->status, MPM_BAD_INPUT);
        ck_assert_msg(fault->line == lists[_i].faults[k].line, "%d: %s", fault->line,
                      fault->message);
        ck_assert_msg(strstr(fault->message, lists[_i].faults[k].said) != NULL, "%s",
                      fault->message);
    }
    ck_assert_int_eq(mpm_scene_read(path, NULL, 0, &scene, &first), MPM_BAD_INPUT);
    ck_assert_str_eq(first.message, faults.list[0].message);
    g_free(path);
}
END_TEST

/* Thirteen unknown keys, the last ones first. */
START_TEST(ten_mistakes_are_shown_and_all_are_counted)
{
    GString *head = g_string_new(NULL);
    for (int i = 0; i < 13; i++)
        g_string_append_printf(head, "wrong_%02d: 1\n", i);
    g_string_append(head, "geometry: plane_strain\n"
                          "materials: [{name: a, law: none, density: 1}]\n"
                          "bodies: [{name: b, material: a, region: {disk: {center: [5, 5], radius: "
                          "1}}, particles_per_cell: [2, 2]}]\n");
    char *path = scene_with(head->str);
    struct test_command command = test_command_run("mpm", "check", path, NULL);
    ck_assert_int_eq(command.exit_status, MPM_BAD_INPUT);
    ck_assert_str_eq(command.output, "");
    char **lines = g_strsplit(g_strchomp(command.errors), "\n", -1);
    ck_assert_uint_eq(g_strv_length(lines), MPM_FAULTS_MAX + 1);
    for (int i = 0; i < MPM_FAULTS_MAX; i++) {
        char *start = g_strdup_printf("mpm: %s:%d: unknown key \"wrong_%02d\"", path, i + 1, i);
        ck_assert_msg(g_str_has_prefix(lines[i], start), "%s", lines[i]);
        g_free(start);
    }
    char *last = g_strdup_printf("mpm: %s: 13 mistakes, the first 10 shown", path);
    ck_assert_str_eq(lines[MPM_FAULTS_MAX], last);
    g_free(last);
    g_strfreev(lines);
    test_command_free(&command);
    g_free(path);
    g_string_free(head, TRUE);
}
END_TEST

START_TEST(all_mistakes_of_settings_are_listed)
{
    const char *const settings[] = {"time.stp=1", "grid.refine=2", "bodies.dsik.material=a", "x"};
    struct mpm_scene *scene = NULL;
    struct mpm_faults faults;
    ck_assert_int_eq(mpm_scene_read_all(SCENE, settings, 4, &scene, &faults), MPM_BAD_INPUT);
    ck_assert_uint_eq(faults.count, 3);
    test_contains(faults.list[0].message, "--set \"time.stp=1\": unknown key \"stp\"");
    test_contains(faults.list[0].message, "; did you mean step?");
    test_contains(faults.list[1].message, "no entry \"dsik\" in the list of 2");
    test_contains(faults.list[1].message, "; did you mean disk?");
    test_contains(faults.list[2].message, "not a setting; allowed: PATH=VALUE, or PATH= to unset");
}
END_TEST

START_TEST(one_mistake_of_a_program_is_one_line)
{
    struct test_command command =
        test_command_run("mpm", "check", SCENE, "--set", "method.shape=cdpi", NULL);
    ck_assert_int_eq(command.exit_status, MPM_BAD_INPUT);
    ck_assert_str_eq(
        command.errors,
        "mpm: " SCENE ": --set \"method.shape=cdpi\": method.shape: unknown choice, got "
        "\"cdpi\"; allowed: classic | ugimp | cpdi | bspline2 | bspline3; did you mean "
        "cpdi?\n");
    test_command_free(&command);
}
END_TEST

/* ----------------------------------------------------------- standard input */

static struct test_command in_shell(const char *script)
{
    char *mpm = g_build_filename(g_getenv("MPM_BIN"), "mpm", NULL);
    char *output = test_folder_path(folder, "results");
    struct test_command command =
        test_command_run("/bin/sh", "-c", script, "sh", mpm, SCENE, output, NULL);
    g_free(output);
    g_free(mpm);
    return command;
}

START_TEST(a_scene_from_a_pipe_is_that_of_the_file)
{
    struct test_command command = in_shell(
        "cat \"$2\" | \"$1\" check - > \"$3.pipe\" && \"$1\" check \"$2\" > \"$3.file\" && "
        "cmp \"$3.pipe\" \"$3.file\" && "
        "cat \"$2\" | \"$1\" run - -q --set time.steps=3 --output \"$3.a\" && "
        "\"$1\" run \"$2\" -q --set time.steps=3 --output \"$3.b\" && "
        "cmp \"$3.a/history.csv\" \"$3.b/history.csv\" && "
        "grep -h sha256 \"$3.a/run.json\" \"$3.b/run.json\" | uniq | wc -l");
    ck_assert_msg(command.exit_status == 0, "%s%s", command.output, command.errors);
    ck_assert_int_eq(g_ascii_strtoll(command.output, NULL, 10), 1);
    test_command_free(&command);
}
END_TEST

START_TEST(a_bad_scene_from_a_pipe_is_refused_with_its_line)
{
    static const struct {
        const char *script, *said;
    } rows[] = {
        {"echo 'format: 2' | \"$1\" check -", "mpm: standard input:1: format: out of range"},
        {"\"$1\" check - < /dev/null", "mpm: standard input:1: empty; allowed: a YAML document"},
        {"\"$1\" run - < \"$2\"", "mpm: run: --output DIR is missing: standard input has no name"},
        {"head -c 17000000 /dev/zero | \"$1\" check -", "standard input: the file is too big"},
        {"\"$1\" check - <&-", "standard input"},
        {"\"$1\" check - < /",
         "mpm: standard input: Is a directory; allowed: a readable scene file"},
        {"printf 'a: 1\\nb: 2\\n' | \"$1\" check -", "mpm: standard input: 8 mistakes\n"},
    };
    for (size_t i = 0; i < G_N_ELEMENTS(rows); i++) {
        struct test_command command = in_shell(rows[i].script);
        ck_assert_msg(command.exit_status == MPM_BAD_INPUT, "%s: %d", rows[i].script,
                      command.exit_status);
        ck_assert_msg(strstr(command.errors, rows[i].said) != NULL, "%s: %s", rows[i].script,
                      command.errors);
        test_command_free(&command);
    }
}
END_TEST

/* ----------------------------------------------------------- keys taken out */

START_TEST(a_setting_without_a_value_takes_a_key_out)
{
    struct mpm_scene *scene = test_scene_read(SCENE, "output=");
    ck_assert(scene->history_interval == 0.0 && scene->snapshot_interval == 0.0);
    mpm_scene_free(scene);
    scene = test_scene_read(SCENE, "title=");
    ck_assert_str_eq(scene->title, "");
    mpm_scene_free(scene);
    scene = test_scene_read(SCENE, "boundary.0=");
    struct mpm_scene *whole = test_scene_read(SCENE, NULL);
    ck_assert_uint_eq(scene->boundary_count + 1, whole->boundary_count);
    mpm_scene_free(whole);
    mpm_scene_free(scene);
    scene = test_scene_read(SCENE, "bodies.ring="); /* by its name */
    ck_assert_uint_eq(scene->body_count, 1);
    mpm_scene_free(scene);
    scene = test_scene_read(SCENE, "time.rest.patience="); /* which is not there */
    ck_assert(!scene->rest.asked);
    mpm_scene_free(scene);
}
END_TEST

START_TEST(what_is_no_key_cannot_be_taken_out)
{
    static const struct {
        const char *setting, *said;
    } rows[] = {
        {"output.histroy=", "unknown key \"histroy\"; allowed: history, "},
        {"time.rest.pateince=", "unknown key \"pateince\""},
        {"bodies.7=", "no entry \"7\" in the list of 2"},
        {"time.end.x=", "end is one value and has no part \"x\""},
        {"time.end=", "time.end: missing, the key is required"},
        {"=", "not a setting"},
    };
    for (size_t i = 0; i < G_N_ELEMENTS(rows); i++) {
        struct mpm_scene *scene = NULL;
        struct mpm_error error = {.message = ""};
        const enum mpm_status status = mpm_scene_read(SCENE, &rows[i].setting, 1, &scene, &error);
        ck_assert_int_eq(status, MPM_BAD_INPUT);
        test_contains(error.message, rows[i].said);
    }
}
END_TEST

START_TEST(all_in_quotes_is_the_same_word)
{
    static const char *const texts[] = {"all", "\"all\"", "'all'", "{all: true}"};
    for (size_t i = 0; i < G_N_ELEMENTS(texts); i++) {
        char *setting = g_strdup_printf("boundary=[{region: %s, velocity: [0, free]}]", texts[i]);
        struct mpm_scene *scene = test_scene_read(SCENE, setting);
        ck_assert_int_eq(scene->boundaries[0].region.kind, MPM_REGION_ALL);
        mpm_scene_free(scene);
        g_free(setting);
    }
}
END_TEST

Suite *suite_scene_faults(void)
{
    Suite *suite = suite_create("scene_faults");
    TCase *faults = tcase_create("mistakes");
    tcase_add_checked_fixture(faults, set_up, tear_down);
    tcase_add_loop_test(faults, all_mistakes_of_a_kind_are_listed_by_line, 0,
                        (int)G_N_ELEMENTS(lists));
    tcase_add_test(faults, ten_mistakes_are_shown_and_all_are_counted);
    tcase_add_test(faults, all_mistakes_of_settings_are_listed);
    tcase_add_test(faults, one_mistake_of_a_program_is_one_line);
    suite_add_tcase(suite, faults);
    TCase *input = tcase_create("standard input");
    tcase_add_checked_fixture(input, set_up, tear_down);
    tcase_add_test(input, a_scene_from_a_pipe_is_that_of_the_file);
    tcase_add_test(input, a_bad_scene_from_a_pipe_is_refused_with_its_line);
    suite_add_tcase(suite, input);
    TCase *settings = tcase_create("settings");
    tcase_add_test(settings, a_setting_without_a_value_takes_a_key_out);
    tcase_add_test(settings, what_is_no_key_cannot_be_taken_out);
    tcase_add_test(settings, all_in_quotes_is_the_same_word);
    suite_add_tcase(suite, settings);
    return suite;
}
