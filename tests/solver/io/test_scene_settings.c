/* `--set PATH=VALUE` in all its forms.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "model/scene.h"
#include "suites.h"

#include <string.h>

static const char *const MINIMAL = "tests/scenes/good/minimal.yaml";
static const char *const DISK = "tests/scenes/good/compressed_disk.yaml";

static struct mpm_scene *read_with(const char *path, const char *const *settings, size_t count)
{
    struct mpm_scene *scene = NULL;
    struct mpm_error error = {.message = ""};
    const enum mpm_status status = mpm_scene_read(path, settings, count, &scene, &error);
    ck_assert_msg(status == MPM_OK, "%s", error.message);
    return scene;
}

#define READ(path, ...)                                                                            \
    read_with(path, (const char *const[]){__VA_ARGS__},                                            \
              sizeof((const char *const[]){__VA_ARGS__}) / sizeof(const char *))

START_TEST(a_setting_replaces_a_value)
{
    struct mpm_scene *scene = READ(DISK, "method.shape=cpdi", "grid.cell.1=1.25", "grid.cells.1=8",
                                   "time.end= 0.5 ", "title='a = b'");
    ck_assert_int_eq(scene->shape, MPM_CPDI);
    ck_assert_double_eq(scene->cell[0], 2.5);
    ck_assert_double_eq(scene->cell[1], 1.25);
    ck_assert_str_eq(scene->title, "a = b");
    mpm_scene_free(scene);
}
END_TEST

START_TEST(entries_are_named_by_position_or_name)
{
    struct mpm_scene *scene =
        READ(DISK, "materials.polymer.bulk=100", "materials.0.shear=7", "bodies.disk.velocity.1=z",
             "bodies.1.rigid.velocity.0=\"-2*t\"", "boundary.1.velocity=[1, free]",
             "boundary.0.region.line.to.0=30");
    ck_assert_double_eq(scene->materials[0].parameter[MPM_PARAMETER_BULK], 100.0);
    ck_assert_double_eq(scene->materials[0].parameter[MPM_PARAMETER_SHEAR], 7.0);
    ck_assert_str_eq(scene->bodies[0].velocity.text[0], "-8.31*r/50");
    ck_assert_str_eq(scene->bodies[0].velocity.text[1], "z");
    ck_assert_str_eq(scene->bodies[1].velocity.text[0], "-2*t");
    ck_assert_str_eq(scene->boundaries[1].velocity.text[0], "1");
    ck_assert_ptr_null(scene->boundaries[1].velocity.text[1]);
    ck_assert_double_eq(scene->boundaries[0].region.b[0], 30.0);
    mpm_scene_free(scene);
}
END_TEST

START_TEST(a_valid_key_that_is_missing_is_added)
{
    struct mpm_scene *scene =
        READ(MINIMAL, "grid.refine=2", "method.stress_update=usf", "method.transfer.fraction=0.9",
             "output.history=0.1", "bodies.block.velocity.1=3", "loads.body_force.1=-9.81",
             "units.length=mm", "boundary=[{region: all, velocity: [0, free]}]");
    ck_assert_double_eq(scene->cell[0], 0.5);
    ck_assert_int_eq(scene->cells[0], 8);
    ck_assert_int_eq(scene->stress_update, MPM_USF);
    ck_assert_double_eq(scene->flip_fraction, 0.9);
    ck_assert_double_eq(scene->history_interval, 0.1);
    ck_assert_str_eq(scene->bodies[0].velocity.text[0], "0");
    ck_assert_str_eq(scene->bodies[0].velocity.text[1], "3");
    ck_assert_ptr_null(scene->body_force.text[0]);
    ck_assert_str_eq(scene->body_force.text[1], "-9.81");
    ck_assert_str_eq(scene->units_length, "mm");
    ck_assert_uint_eq(scene->boundary_count, 1);
    mpm_scene_free(scene);
}
END_TEST

START_TEST(a_setting_can_replace_whole_sections)
{
    struct mpm_scene *scene =
        READ(MINIMAL, "grid={cell: [0.5, 0.5], cells: [8, 8]}",
             "bodies.block.region={disk: {center: [2, 2], radius: 1}}",
             "materials.rubber={name: steel, law: linear_elastic, density: 7, young: 210, "
             "poisson: 0.3}",
             "bodies.block.material=steel");
    ck_assert_double_eq(scene->cell[0], 0.5);
    ck_assert_int_eq(scene->bodies[0].region.kind, MPM_REGION_DISK);
    ck_assert_str_eq(scene->materials[0].law->name, "linear_elastic");
    ck_assert_int_eq(scene->materials[0].line, 0); /* it is in no line of the file */
    mpm_scene_free(scene);
}
END_TEST

START_TEST(the_last_setting_wins)
{
    struct mpm_scene *scene = READ(MINIMAL, "time.end=2", "grid.refine=8", "time.end=3",
                                   "grid={cell: [2, 2], cells: [2, 2]}");
    ck_assert_double_eq(scene->end, 3.0);
    ck_assert_double_eq(scene->cell[0], 2.0); /* the whole grid came after its refine */
    ck_assert_uint_eq(scene->setting_count, 4);
    mpm_scene_free(scene);
}
END_TEST

START_TEST(a_setting_mends_a_scene_that_would_be_refused)
{
    struct mpm_scene *scene = READ("tests/scenes/bad/courant_zero.yaml", "time.courant=0.5");
    ck_assert_double_eq(scene->courant, 0.5);
    mpm_scene_free(scene);
}
END_TEST

START_TEST(points_of_polygons_can_be_set)
{
    struct mpm_scene *scene =
        READ("tests/scenes/good/shapes.yaml", "bodies.angle.region.polygon.points.0.1=5.5",
             "bodies.angle.region.polygon.points.1=[9, 5.5]");
    ck_assert_double_eq(scene->bodies[3].region.points[0][1], 5.5);
    ck_assert_double_eq(scene->bodies[3].region.points[1][1], 5.5);
    mpm_scene_free(scene);
}
END_TEST

/* Messages name the setting, not a line. */
static const struct {
    const char *setting, *message;
} mistakes[] = {
    {"grid.cell.0=0", "--set \"grid.cell.0=0\": grid.cell.0: out of range, got \"0\"; allowed: "},
    {"time.courant=5", "--set \"time.courant=5\": time.courant: out of range, got 5; allowed: "},
    {"method.shape=bspline4", "method.shape: unknown choice, got \"bspline4\"; allowed: classic"},
    {"method.axis=truncated", "method.axis: not for this geometry"},
    {"bodies.0.velocity.0=q", "bodies.0.velocity.0: \"q\": column 1: Unexpected token \"q\""},
    {"bodies.0.material=steel", "bodies.0.material: no such material, got \"steel\""},
    {"bodies.block.region.rectangle.to=[9, 3]", "bodies.0.region: outside the grid"},
    {"grid={cell: [1, 1]}", "--set \"grid={cell: [1, 1]}\": grid.cells: missing"},
    {"grid={cell: [1, 1], cell: [2, 2]}", "key \"cell\" repeated; allowed: once"},
    {"grid.size=1", "unknown key \"size\"; allowed: origin, cell, cells, refine"},
    {"velocity=1", "unknown key \"velocity\"; allowed: format, title"},
    {"grid..cell=1", "unknown key \"\""},
    {".grid=1", "unknown key \"\""},
    {"grid.=1", "unknown key \"\""},
    {"time.end.0=1", "end is one value and has no part \"0\""},
    {"method.shape.x=1", "shape is one value and has no part \"x\""},
    {"grid.cell.2=1", "no entry \"2\" in the list of 2"},
    {"grid.cell.-1=1", "no entry \"-1\" in the list of 2"},
    {"grid.cell.x=1", "no entry \"x\" in the list of 2"},
    {"materials.1.bulk=1", "no entry \"1\" in the list of 1"},
    {"materials.steel.bulk=1", "no entry \"steel\" in the list of 1"},
    {"bodies.99999999999999999999.name=a", "no entry \"99999999999999999999\""},
    {"bodies.0.rigid.velocity.0=1", "the scene has no velocity whose part could be set"},
    {"boundary.0.velocity=[0, 0]", "no entry \"0\" in the list of 0"},
    {"time.end.0=", "end is one value and has no part \"0\""},
    {"tme.end=", "unknown key \"tme\"; allowed: format, title"},
    {"bodies.1=", "no entry \"1\" in the list of 1; allowed: a position from 0, or the `name` of "
                  "an entry"},
    {"bodies.+=", "no entry \"+\" in the list of 1"},
    {"bodies.blok=", "`name` of an entry; did you mean block?"},
    {"time.end=~", "time.end: not a number"},
    {"time.end=[1", "not YAML: "},
    {"time.end=1\n---\n2", "a second YAML document"},
    {"time.end=&a 1", "an anchor (&name)"},
    {"time.end=*a", "an alias (*name)"},
    {"time.end=!!int 1", "a tag (!name)"},
    {"title=\xff", "not a text: byte 1 is 0xff"},
    {"time.end", "not a setting; allowed: PATH=VALUE"},
    {"=1", "not a setting; allowed: PATH=VALUE"},
    {"", "not a setting; allowed: PATH=VALUE"},
    {"bodies.0=1", "bodies.0: not a mapping, got \"1\""},
    {"materials=[]", "materials: empty, one entry is needed at least"},
    {"format=2", "format: out of range, got \"2\"; allowed: integer 1"},
};

START_TEST(a_mistake_in_a_setting_names_the_setting)
{
    struct mpm_scene *scene = NULL;
    struct mpm_error error = {.message = ""};
    const char *const settings[] = {"time.allow_unstable=false", mistakes[_i].setting};
    const enum mpm_status status = mpm_scene_read(MINIMAL, settings, 2, &scene, &error);
    ck_assert_int_eq(status, MPM_BAD_INPUT);
    ck_assert_ptr_null(scene);
    ck_assert_msg(strstr(error.message, mistakes[_i].message) != NULL, "%s: got %s",
                  mistakes[_i].setting, error.message);
    ck_assert_msg(strncmp(error.message, "tests/scenes/good/minimal.yaml: --set \"", 39) == 0,
                  "got %s", error.message);
}
END_TEST

START_TEST(a_mistake_in_the_file_names_its_line_whatever_is_set)
{
    struct mpm_scene *scene = NULL;
    struct mpm_error error = {.message = ""};
    const char *const settings[] = {"grid.refine=2"};
    ck_assert_int_eq(
        mpm_scene_read("tests/scenes/bad/courant_zero.yaml", settings, 1, &scene, &error),
        MPM_BAD_INPUT);
    ck_assert_msg(strstr(error.message, "courant_zero.yaml:6: time.courant") != NULL, "%s",
                  error.message);
}
END_TEST

START_TEST(a_long_setting_is_cut_in_the_message)
{
    char setting[4000] = "time.end=";
    memset(setting + strlen(setting), 'x', sizeof setting - strlen(setting) - 1);
    setting[sizeof setting - 1] = '\0';
    struct mpm_scene *scene = NULL;
    struct mpm_error error = {.message = ""};
    const char *const settings[] = {setting};
    ck_assert_int_eq(mpm_scene_read(MINIMAL, settings, 1, &scene, &error), MPM_BAD_INPUT);
    ck_assert_msg(strstr(error.message, "xxx...\": time.end: not a number, got \"xxx") != NULL,
                  "%s", error.message);
    ck_assert_msg(strstr(error.message, "allowed: number above 0") != NULL, "%s", error.message);
}
END_TEST

Suite *suite_scene_settings(void)
{
    Suite *suite = suite_create("scene settings");
    TCase *edits = tcase_create("edits");
    tcase_add_test(edits, a_setting_replaces_a_value);
    tcase_add_test(edits, entries_are_named_by_position_or_name);
    tcase_add_test(edits, a_valid_key_that_is_missing_is_added);
    tcase_add_test(edits, a_setting_can_replace_whole_sections);
    tcase_add_test(edits, the_last_setting_wins);
    tcase_add_test(edits, a_setting_mends_a_scene_that_would_be_refused);
    tcase_add_test(edits, points_of_polygons_can_be_set);
    suite_add_tcase(suite, edits);
    TCase *errors = tcase_create("mistakes");
    tcase_add_loop_test(errors, a_mistake_in_a_setting_names_the_setting, 0,
                        (int)(sizeof mistakes / sizeof *mistakes));
    tcase_add_test(errors, a_mistake_in_the_file_names_its_line_whatever_is_set);
    tcase_add_test(errors, a_long_setting_is_cut_in_the_message);
    suite_add_tcase(suite, errors);
    return suite;
}
