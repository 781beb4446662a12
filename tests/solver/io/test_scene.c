/* Reading scenes: good ones, malformed ones, defaults.
 *
 * Malformed scenes are files: their first line is `# expect: <part of the message>`,
 * the second `# line: N` if the message names a line.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/scene/schema.h"
#include "model/scene.h"
#include "suites.h"
#include "support/folder.h"
#include "support/near.h"
#include "support/scene_files.h"
#include "support/skip.h"

#include <glib.h>
#include <jansson.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* --------------------------------------------------------- folders of scenes */

static gint by_name(gconstpointer a, gconstpointer b)
{
    return strcmp(*(const char *const *)a, *(const char *const *)b);
}

/* Paths of the scenes in a folder, sorted. */
static GPtrArray *scenes_in(const char *folder)
{
    GPtrArray *paths = g_ptr_array_new_with_free_func(g_free);
    GDir *dir = g_dir_open(folder, 0, NULL);
    ck_assert_msg(dir != NULL, "no folder %s: tests run at the top of the source", folder);
    for (const char *name = g_dir_read_name(dir); name != NULL; name = g_dir_read_name(dir))
        if (g_str_has_suffix(name, ".yaml"))
            g_ptr_array_add(paths, g_build_filename(folder, name, NULL));
    g_dir_close(dir);
    g_ptr_array_sort(paths, by_name);
    return paths;
}

/* What the head of a malformed scene promises: the part of the message, and
 * "path:line: " or "path: " before it. */
static void read_promise(const char *path, char **expected, char **place)
{
    char *text = test_file_read(path);
    char **lines = g_strsplit(text, "\n", 3);
    ck_assert_msg(g_str_has_prefix(lines[0], "# expect: "), "%s: no `# expect:`", path);
    *expected = g_strdup(lines[0] + strlen("# expect: "));
    *place = g_str_has_prefix(lines[1], "# line: ")
                 ? g_strdup_printf("%s:%s: ", path, lines[1] + strlen("# line: "))
                 : g_strdup(path);
    g_strfreev(lines);
    g_free(text);
}

START_TEST(every_malformed_scene_is_refused_with_its_message_and_line)
{
    enum { LEAST_COUNT = 45 };
    GPtrArray *paths = scenes_in("tests/scenes/bad");
    ck_assert_uint_ge(paths->len, LEAST_COUNT);
    for (guint i = 0; i < paths->len; i++) {
        const char *path = g_ptr_array_index(paths, i);
        char *expected = NULL, *place = NULL;
        read_promise(path, &expected, &place);
        char *message = test_scene_refusal(path);
        test_contains(message, expected);
        ck_assert_msg(g_str_has_prefix(message, place), "got: %s\nnot at: %s", message, place);
        ck_assert_msg(strchr(message, '\n') == NULL, "%s", message);
        g_free(message);
        g_free(expected);
        g_free(place);
    }
    g_ptr_array_free(paths, TRUE);
}
END_TEST

START_TEST(every_good_scene_is_read)
{
    GPtrArray *paths = scenes_in("tests/scenes/good");
    ck_assert_uint_ge(paths->len, 5);
    for (guint i = 0; i < paths->len; i++)
        mpm_scene_free(test_scene_read(g_ptr_array_index(paths, i), NULL));
    g_ptr_array_free(paths, TRUE);
}
END_TEST

/* Wrong only in what they fill or select: found when the simulation is made. */
static void check_spoiled(const char *path, enum mpm_status expected_status)
{
    char *expected = NULL, *place = NULL;
    read_promise(path, &expected, &place);
    struct mpm_scene *scene = test_scene_read(path, NULL);
    struct mpm_simulation *simulation = NULL;
    struct mpm_error error = {.message = ""};
    const enum mpm_status status = mpm_simulation_create(
        scene, &(struct mpm_simulation_options){.threads = 1}, &simulation, &error);
    ck_assert_msg(status == expected_status, "%s gave status %d: %s", path, (int)status,
                  error.message);
    ck_assert_ptr_null(simulation);
    test_contains(error.message, expected);
    if (status == MPM_BAD_INPUT)
        ck_assert_msg(g_str_has_prefix(error.message, place), "got: %s\nnot at: %s", error.message,
                      place);
    mpm_scene_free(scene);
    g_free(expected);
    g_free(place);
}

START_TEST(every_scene_that_only_its_geometry_spoils_is_refused_at_creation)
{
    GPtrArray *paths = scenes_in("tests/scenes/bad_model");
    ck_assert_uint_ge(paths->len, 8);
    for (guint i = 0; i < paths->len; i++)
        check_spoiled(g_ptr_array_index(paths, i), MPM_BAD_INPUT);
    g_ptr_array_free(paths, TRUE);
}
END_TEST

START_TEST(a_scene_that_no_memory_holds_is_a_failure_of_the_environment)
{
    static const struct {
        const char *path;
        double needed; /* bytes: 100 a node, 200 a particle */
    } scenes[] = {{"tests/scenes/too_big/huge_grid.yaml", 1e11},
                  {"tests/scenes/too_big/huge_bodies.yaml", 8e11}};
    if ((double)sysconf(_SC_PHYS_PAGES) * (double)sysconf(_SC_PAGESIZE) > scenes[_i].needed)
        TEST_SKIP("this machine might hold it");
    check_spoiled(scenes[_i].path, MPM_ENVIRONMENT_FAILED);
}
END_TEST

/* ------------------------------------------------------------------ content */

START_TEST(a_scene_says_what_its_file_says)
{
    struct mpm_scene *scene = test_scene_read("tests/scenes/good/compressed_disk.yaml", NULL);
    ck_assert_str_eq(scene->title, "Radial compression of a disk");
    ck_assert_int_eq(scene->geometry, MPM_AXISYMMETRIC);
    ck_assert_str_eq(scene->units_length, "mm");
    ck_assert_str_eq(scene->units_mass, "g");
    ck_assert_str_eq(scene->units_time, "ms");
    ck_assert_str_eq(scene->units_temperature, "K");
    ck_assert_double_eq(scene->cell[0], 2.5);
    ck_assert_int_eq(scene->cells[0], 24);
    ck_assert_int_eq(scene->cells[1], 4);
    ck_assert_double_eq(mpm_scene_end_time(scene), 3.6);
    ck_assert_int_eq(scene->stress_update, MPM_USAVG);
    ck_assert_str_eq(scene->materials[0].name, "polymer");
    ck_assert_str_eq(scene->materials[0].law->name, "neo_hookean");
    ck_assert_double_eq(scene->materials[0].density, 1.2e-3);
    ck_assert_double_eq(scene->materials[0].parameter[MPM_PARAMETER_BULK], 2254.9);
    ck_assert_double_eq(scene->materials[0].parameter[MPM_PARAMETER_SHEAR], 864.662);
    ck_assert_double_eq(scene->history_interval, 0.01);
    ck_assert_double_eq(scene->snapshot_interval, 0.1);
    ck_assert_ptr_null(scene->body_force.text[0]); /* [0, 0] costs nothing */
    ck_assert_ptr_null(scene->body_force.text[1]);
    mpm_scene_free(scene);
}
END_TEST

START_TEST(bodies_and_boundaries_say_what_their_file_says)
{
    struct mpm_scene *scene = test_scene_read("tests/scenes/good/compressed_disk.yaml", NULL);
    ck_assert_uint_eq(mpm_scene_body_count(scene), 2);
    ck_assert_str_eq(mpm_scene_body_name(scene, 0), "disk");
    ck_assert(!scene->bodies[0].rigid);
    ck_assert_str_eq(scene->bodies[0].velocity.text[0], "-8.31*r/50");
    ck_assert_str_eq(scene->bodies[0].velocity.text[1], "0");
    ck_assert_int_eq(scene->bodies[0].line, 18);
    ck_assert_str_eq(mpm_scene_body_name(scene, 1), "ring");
    ck_assert(scene->bodies[1].rigid);
    ck_assert_str_eq(scene->bodies[1].velocity.text[0], "-8.31");
    ck_assert_ptr_null(scene->bodies[1].velocity.text[1]);
    ck_assert_int_eq(scene->bodies[1].region.kind, MPM_REGION_RECTANGLE);
    ck_assert_double_eq(scene->bodies[1].region.b[0], 55.0);
    ck_assert_uint_eq(scene->boundary_count, 2);
    ck_assert_int_eq(scene->boundaries[1].line, 26);
    ck_assert_int_eq(scene->boundaries[1].region.kind, MPM_REGION_LINE);
    ck_assert_double_eq(scene->boundaries[1].region.a[1], 10.0);
    ck_assert_ptr_null(scene->boundaries[1].velocity.text[0]);
    ck_assert_str_eq(scene->boundaries[1].velocity.text[1], "0");
    mpm_scene_free(scene);
}
END_TEST

START_TEST(every_shape_of_region_is_read)
{
    struct mpm_scene *scene = test_scene_read("tests/scenes/good/shapes.yaml", NULL);
    static const enum mpm_region_kind kinds[] = {MPM_REGION_RECTANGLE, MPM_REGION_DISK,
                                                 MPM_REGION_ANNULUS, MPM_REGION_POLYGON};
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++)
        ck_assert_int_eq(scene->bodies[i].region.kind, kinds[i]);
    ck_assert_double_eq(scene->bodies[1].region.outer, 1.0);
    ck_assert_double_eq(scene->bodies[2].region.inner, 0.5);
    ck_assert_double_eq(scene->bodies[2].region.outer, 1.5);
    ck_assert_uint_eq(scene->bodies[3].region.point_count, 6);
    ck_assert_double_eq(scene->bodies[3].region.points[5][1], 6.0);
    ck_assert_uint_eq(scene->bodies[2].material, 0);
    ck_assert_uint_eq(scene->bodies[3].material, 1);
    ck_assert_double_eq(scene->boundaries[0].region.a[0], 0.0); /* ends in ascending order */
    ck_assert_double_eq(scene->boundaries[0].region.b[0], 10.0);
    ck_assert_double_eq(scene->step, 1e-3);
    mpm_scene_free(scene);
    scene = test_scene_read("tests/scenes/good/behind_the_axis.yaml", NULL);
    ck_assert_int_eq(scene->boundaries[0].region.kind, MPM_REGION_ALL);
    mpm_scene_free(scene);
}
END_TEST

START_TEST(numbers_have_one_value_in_every_spelling)
{
    struct mpm_scene *scene = test_scene_read("tests/scenes/good/numbers.yaml", NULL);
    ck_assert_str_eq(scene->title, "2024");
    ck_assert_double_eq(scene->thickness, 10.0);
    ck_assert_double_eq(scene->origin[0], -0.5);
    ck_assert_double_eq(scene->origin[1], 0.25);
    ck_assert_double_eq(scene->cell[0], 0.5); /* refine: 2 */
    ck_assert_double_eq(scene->cell[1], 0.25);
    ck_assert_int_eq(scene->cells[0], 8); /* 04 is no octal number, nor is 010 */
    ck_assert_int_eq(scene->cells[1], 20);
    ck_assert_double_eq(scene->end, 1e6);
    ck_assert_int_eq(scene->steps, 1000);
    ck_assert_int_eq(scene->bodies[0].particles_per_cell[1], 16);
    ck_assert_str_eq(scene->body_force.text[1], "-9.81");
    ck_assert_ptr_null(scene->body_force.text[0]);
    mpm_scene_free(scene);
}
END_TEST

/* K = E / (3 (1 - 2 nu)), G = E / (2 (1 + nu)): two roundings each, 1e-15 relative. */
START_TEST(young_and_poisson_give_bulk_and_shear)
{
    const double round_off = 1e-15;
    struct mpm_scene *scene = test_scene_read("tests/scenes/good/shapes.yaml", NULL);
    const double bulk = 210.0 / (3.0 * (1.0 - 0.6)), shear = 210.0 / 2.6;
    ck_assert_near(scene->materials[0].parameter[MPM_PARAMETER_BULK], bulk, round_off * bulk);
    ck_assert_near(scene->materials[0].parameter[MPM_PARAMETER_SHEAR], shear, round_off * shear);
    mpm_scene_free(scene);
}
END_TEST

START_TEST(the_hash_is_that_of_the_bytes)
{
    char *text = test_file_read(TEST_MINIMAL_SCENE);
    char *expected = g_compute_checksum_for_string(G_CHECKSUM_SHA256, text, -1);
    struct mpm_scene *scene =
        test_scene_read(TEST_MINIMAL_SCENE, "grid.refine=2"); /* of the file, not the edit */
    for (size_t i = 0; i < sizeof scene->sha256; i++) {
        char digits[3];
        (void)snprintf(digits, sizeof digits, "%02x", scene->sha256[i]);
        ck_assert_int_eq(strncmp(digits, expected + 2 * i, 2), 0);
    }
    ck_assert_uint_eq(scene->setting_count, 1);
    ck_assert_str_eq(scene->settings[0], "grid.refine=2");
    mpm_scene_free(scene);
    g_free(expected);
    g_free(text);
}
END_TEST

/* ----------------------------------------------------------------- defaults */

START_TEST(a_minimal_scene_has_the_documented_defaults)
{
    struct mpm_scene *scene = test_scene_read(TEST_MINIMAL_SCENE, NULL);
    ck_assert_str_eq(scene->title, "");
    ck_assert_double_eq(scene->thickness, 1.0);
    ck_assert_double_eq(scene->origin[0], 0.0);
    ck_assert_double_eq(scene->courant, 0.4);
    ck_assert_double_eq(scene->step, 0.0);
    ck_assert_int_eq(scene->steps, 0);
    ck_assert(!scene->allow_unstable);
    ck_assert_int_eq(scene->shape, MPM_UGIMP);
    ck_assert_int_eq(scene->axis, MPM_TRUNCATED);
    ck_assert_int_eq(scene->stress_update, MPM_MUSL);
    ck_assert_int_eq(scene->position_update, MPM_GRID_VELOCITY);
    ck_assert_int_eq(scene->radius_update, MPM_RADIUS_SHAPE);
    ck_assert_double_eq(scene->flip_fraction, 1.0);
    ck_assert_int_eq(scene->deformation_terms, 2);
    ck_assert_int_eq(scene->bodies[0].particles_per_cell[0], 2);
    ck_assert_str_eq(scene->bodies[0].velocity.text[1], "0");
    ck_assert_uint_eq(scene->boundary_count, 0);
    ck_assert_double_eq(scene->history_interval, 0.0);
    ck_assert_double_eq(scene->snapshot_interval, 0.0);
    mpm_scene_free(scene);
}
END_TEST

/* All that a default can reach, as one text. */
static char *describe(const struct mpm_scene *scene)
{
    static const struct mpm_crack_spec no_crack;
    const struct mpm_body_spec *body = &scene->bodies[0];
    const struct mpm_crack_spec *crack = scene->crack_count > 0 ? &scene->cracks[0] : &no_crack;
    static const struct mpm_pair_spec no_pair;
    const struct mpm_pair_spec *pair =
        scene->contact.pair_count > 0 ? scene->contact.pairs : &no_pair;
    return g_strdup_printf(
        "%s|%s|%s|%s|%s|%.17g|%.17g %.17g|%.17g|%" G_GINT64_FORMAT "|%.17g %.17g %d|%d %d %d %d %d "
        "%.17g %d|%d %d %s %s|%zu|%s %s|%" G_GINT64_FORMAT " %.17g %.17g|%zu %d|%d %zu %d %g %g "
        "%g|%d %zu %d %d|%d %s",
        scene->title, scene->units_length, scene->units_mass, scene->units_time,
        scene->units_temperature, scene->thickness, scene->origin[0], scene->origin[1],
        scene->cell[0], (gint64)scene->cells[0], scene->courant, scene->step, scene->allow_unstable,
        (int)scene->shape, (int)scene->axis, (int)scene->stress_update, (int)scene->position_update,
        (int)scene->radius_update, scene->flip_fraction, scene->deformation_terms,
        body->particles_per_cell[0], body->particles_per_cell[1], body->velocity.text[0],
        body->velocity.text[1], scene->boundary_count,
        scene->body_force.text[0] != NULL ? scene->body_force.text[0] : "none",
        scene->body_force.text[1] != NULL ? scene->body_force.text[1] : "none",
        (gint64)scene->rest.steps, scene->rest.after, scene->damping.target, scene->edge_load_count,
        scene->edge_load_count > 0 ? (int)scene->edge_loads[0].frame : 0, (int)scene->crack_method,
        scene->crack_count, (int)crack->contact, crack->separated, crack->touching, crack->spacing,
        scene->contact.by_body, scene->contact.pair_count, pair->normal, pair->detection,
        (int)scene->scalars[MPM_TEMPERATURE].transfer,
        scene->scalars[MPM_TEMPERATURE].asked ? scene->scalars[MPM_TEMPERATURE].start : "none");
}

/* A scene in which one more key can be set: some need their group, with what that requires. */
static const char *scene_around(const char *key, bool axisymmetric)
{
    if (g_str_has_prefix(key, "loads.tractions[].") ||
        g_str_has_prefix(key, "loads.particle_forces[]."))
        return "tests/scenes/good/loaded_block.yaml";
    if (g_str_has_prefix(key, "time.rest.") || g_str_has_prefix(key, "damping.thermostat."))
        return "tests/scenes/good/damped_to_rest.yaml";
    if (g_str_has_prefix(key, "cracks[].j_integral[]."))
        return "tests/scenes/good/growing_crack.yaml";
    if (g_str_has_prefix(key, "cracks[].") || strcmp(key, "method.cracks") == 0)
        return "tests/scenes/good/cracked_block.yaml";
    if (g_str_has_prefix(key, "contact."))
        return "tests/scenes/good/touching.yaml";
    if (g_str_has_prefix(key, "transport.concentration."))
        return "tests/scenes/good/diffusing.yaml";
    if (g_str_has_prefix(key, "transport."))
        return "tests/scenes/good/conducting.yaml";
    return axisymmetric ? "tests/scenes/good/compressed_disk.yaml" : TEST_MINIMAL_SCENE;
}

/* Setting a key to the default that the schema prints must change nothing. */
static void check_default(const char *key, const char *value, bool axisymmetric)
{
    const char *base = scene_around(key, axisymmetric);
    char **parts = g_strsplit(key, "[]", -1);
    char *path = g_strjoinv(".0", parts);
    char *setting = g_strdup_printf("%s=%s", path, value);
    struct mpm_scene *with = test_scene_read(base, setting);
    struct mpm_scene *without = test_scene_read(base, NULL);
    char *left = describe(with), *right = describe(without);
    ck_assert_msg(strcmp(left, right) == 0, "%s: %s, without: %s", setting, left, right);
    mpm_scene_free(with);
    mpm_scene_free(without);
    g_free(left);
    g_free(right);
    g_free(setting);
    g_free(path);
    g_strfreev(parts);
}

START_TEST(damping_and_rest_say_what_their_file_says)
{
    struct mpm_scene *scene =
        test_scene_read("tests/scenes/good/damped_to_rest.yaml", "damping.thermostat.scale=3");
    const struct mpm_damping_spec *const damping = &scene->damping;
    ck_assert_str_eq(damping->grid, "0.1*x");
    ck_assert_str_eq(damping->particle, "0.2");
    ck_assert_str_eq(damping->pic, "1-0.1*t");
    ck_assert(damping->thermostat && damping->gain == 2.0 && damping->scale == 3.0);
    ck_assert(scene->rest.asked && scene->rest.residual == 1e-3);
    ck_assert(scene->rest.kinetic_energy == 1e-6 && scene->rest.steps == 10);
    ck_assert(mpm_scene_is_damped(scene));
    mpm_scene_free(scene);
    scene = test_scene_read(TEST_MINIMAL_SCENE, "damping={grid: 0, particle: 0.0, pic: 1}");
    ck_assert(!mpm_scene_is_damped(scene) && !scene->rest.asked);
    mpm_scene_free(scene);
}
END_TEST

START_TEST(loads_on_edges_say_what_their_file_says)
{
    struct mpm_scene *scene = test_scene_read("tests/scenes/good/loaded_block.yaml", NULL);
    ck_assert_uint_eq(scene->edge_load_count, 2);
    const struct mpm_edge_load_spec *const first = &scene->edge_loads[0], *const second =
                                                                              &scene->edge_loads[1];
    ck_assert_str_eq(first->key, "loads.tractions.0");
    ck_assert(!first->on_particles && first->body == 1);
    ck_assert(first->edge == MPM_EDGE_ALL && first->frame == MPM_FRAME_GLOBAL);
    ck_assert_ptr_null(first->value.text[0]);
    ck_assert_str_eq(first->value.text[1], "1000*t");
    ck_assert_str_eq(second->key, "loads.particle_forces.0");
    ck_assert(second->on_particles && second->body == 0);
    ck_assert(second->edge == MPM_EDGE_LEFT && second->frame == MPM_FRAME_EDGE);
    ck_assert_str_eq(second->value.text[0], "x");
    mpm_scene_free(scene);
}
END_TEST

START_TEST(every_default_is_what_the_schema_prints)
{
    enum { DEFAULTS_LEAST = 20 };
    char *text = mpm_schema_list();
    json_t *schema = json_loads(text, 0, NULL);
    const json_t *keys = json_object_get(schema, "keys");
    int checked = 0;
    for (size_t i = 0; i < json_array_size(keys); i++) {
        const json_t *key = json_array_get(keys, i);
        const char *value = json_string_value(json_object_get(key, "default"));
        const char *geometry = json_string_value(json_object_get(key, "geometry"));
        if (value == NULL)
            continue;
        check_default(json_string_value(json_object_get(key, "key")), value,
                      g_strcmp0(geometry, "axisymmetric") == 0);
        checked++;
    }
    ck_assert_int_ge(checked, DEFAULTS_LEAST);
    json_decref(schema);
    free(text);
}
END_TEST

/* The entry of a key: its lines as one. */
static char *schema_entry(const char *text, const char *key)
{
    char *start = g_strdup_printf("\n%s", key);
    const char *at = strstr(text, start);
    while (at != NULL && strchr(" \n", at[strlen(start)]) == NULL)
        at = strstr(at + 1, start);
    ck_assert_msg(at != NULL, "no row %s", key);
    GString *entry = g_string_new(NULL);
    char **words = g_strsplit_set(at != NULL ? at + 1 : "", " \n", -1);
    for (char **word = words; *word != NULL && entry->len < 200; word++)
        if (**word != '\0')
            g_string_append_printf(entry, "%s%s", entry->len > 0 ? " " : "", *word);
    g_strfreev(words);
    g_free(start);
    return g_string_free(entry, FALSE);
}

START_TEST(the_schema_lists_keys_with_type_unit_default_and_range)
{
    static const char *const rows[][2] = {
        {"format", "integer; required; 1"},
        {"grid.cells", "2 integers; required; from 1 to 2147483648"},
        {"time.courant", "number; default 0.4; above 0"},
        {"method.stress_update", "choice; default musl; usl | musl | usf | usavg"},
        {"method.extrapolate", "boolean; true | false"},
        {"method.transfer.order", "integer; from 1 to 100"},
        {"materials[].density", "number, mass/length^3; required; above 0"},
        {"bodies[].region.polygon.points",
         "list of 2 numbers, length; required; 3 to 10000 points"},
        {"cracks[].separated", "number; default 0.9; between 0 and 1, both excluded"},
        {"boundary[].symmetry", "boolean; true | false"},
        {"loads.tractions[].edge", "choice; required; top | bottom | left | right | all"},
        {"boundary[].velocity", "2 expressions or free, length/time "},
        {"output.snapshots", "number, time; above 0"},
    };
    size_t count = 0;
    char *text = mpm_schema_text(NULL, &count);
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        char *expected = g_strdup_printf("%s %s", rows[i][0], rows[i][1]);
        char *entry = schema_entry(text, rows[i][0]);
        ck_assert_msg(g_str_has_prefix(entry, expected), "%s: %s", expected, entry);
        g_free(entry);
        g_free(expected);
    }
    free(text);
}
END_TEST

Suite *suite_scene(void)
{
    Suite *suite = suite_create("scene");
    TCase *folders = tcase_create("folders of scenes");
    tcase_add_test(folders, every_malformed_scene_is_refused_with_its_message_and_line);
    tcase_add_test(folders, every_good_scene_is_read);
    tcase_add_test(folders, every_scene_that_only_its_geometry_spoils_is_refused_at_creation);
    tcase_add_loop_test(folders, a_scene_that_no_memory_holds_is_a_failure_of_the_environment, 0,
                        2);
    suite_add_tcase(suite, folders);
    TCase *content = tcase_create("content");
    tcase_add_test(content, a_scene_says_what_its_file_says);
    tcase_add_test(content, bodies_and_boundaries_say_what_their_file_says);
    tcase_add_test(content, every_shape_of_region_is_read);
    tcase_add_test(content, numbers_have_one_value_in_every_spelling);
    tcase_add_test(content, young_and_poisson_give_bulk_and_shear);
    tcase_add_test(content, the_hash_is_that_of_the_bytes);
    tcase_add_test(content, a_minimal_scene_has_the_documented_defaults);
    tcase_add_test(content, damping_and_rest_say_what_their_file_says);
    tcase_add_test(content, loads_on_edges_say_what_their_file_says);
    tcase_add_test(content, every_default_is_what_the_schema_prints);
    tcase_add_test(content, the_schema_lists_keys_with_type_unit_default_and_range);
    suite_add_tcase(suite, content);
    return suite;
}
