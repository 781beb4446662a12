/* Pictures of scenes: what a run leaves for them, whatever its program is, and the case that has to
 * state why it has none. The catalogue itself is among the cases.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/catalogue.h"
#include "support/folder.h"
#include "support/marks.h"

#include "verification/cases/case_picture.h"
#include "verification/suite/measurement.h"
#include "verification/suite/picture_field.h"
#include "verification/suite/picture_take.h"

#include <fcntl.h>
#include <glib.h>
#include <jansson.h>
#include <math.h>
#include <string.h>
#include <unistd.h>

/* Two bodies of 64 particles each, 8 by 8, beside each other; the right one flies. */
static const char scene_text[] =
    "format: 1\n"
    "geometry: plane_strain\n"
    "units: {length: mm, mass: g, time: ms}\n"
    "grid: {origin: [0, 0], cell: [1, 1], cells: [20, 8]}\n"
    "time: {end: 1, step: 0.125}\n"
    "materials: [{name: soft, law: neo_hookean, density: 1, bulk: 1.25, shear: 0.75}]\n"
    "bodies:\n"
    "  - {name: one, material: soft, region: {rectangle: {from: [2, 2], to: [6, 6]}}}\n"
    "  - {name: other, material: soft, region: {rectangle: {from: [10, 2], to: [14, 6]}},\n"
    "     velocity: [0.5, 0]}\n";

/* Makes two simulations, the second with the setting that its parameter states. */
static enum mpm_status run_twice(struct measurement *m, struct mpm_error *error)
{
    const char *setting;
    TRY(measurement_text(m, "second", &setting, error));
    for (size_t k = 0; k < 2; k++) {
        struct mpm_scene *scene;
        struct mpm_simulation *simulation = NULL;
        TRY(measurement_scene(m, &setting, k, &scene, error));
        enum mpm_status status =
            mpm_simulation_create(scene, measurement_options(m), &simulation, error);
        while (status == MPM_OK && mpm_simulation_time(simulation) < mpm_scene_end_time(scene))
            status = mpm_simulation_advance(simulation, mpm_scene_end_time(scene), error);
        mpm_simulation_free(simulation);
        mpm_scene_free(scene);
        TRY(status);
    }
    measurement_report(m, "value", 1);
    return MPM_OK;
}

static enum mpm_status run_nothing(struct measurement *m, struct mpm_error *error)
{
    (void)error;
    measurement_report(m, "value", 1);
    return MPM_OK;
}

static enum mpm_status run_skipped(struct measurement *m, struct mpm_error *error)
{
    (void)error;
    measurement_skip(m, "not here");
    return MPM_OK;
}

static struct program_table programs(void)
{
    static const struct measure_program twice = {"twice", "", run_twice},
                                        nothing = {"nothing", "", run_nothing},
                                        skipped = {"skipped", "", run_skipped};
    static const struct measure_program *const table[] = {&twice, &nothing, &skipped};
    return (struct program_table){table, G_N_ELEMENTS(table)};
}

/* Case A on a program, with more lines of case.yaml, read. */
struct place {
    char *folder;
    struct catalogue *catalogue;
};

static struct place open_case(const char *program, const char *more)
{
    struct place place = {.folder = test_folder_create()};
    struct mpm_error error = {.message = ""};
    char *text = test_case_text("A", program);
    char *with_second = g_strdup_printf("%sscene: scene.yaml\n%s", text, more);
    char **parts = g_strsplit(with_second, "  - {name: speed, value: 1}\n", 2);
    char *whole = g_strconcat(
        parts[0], "  - {name: second, value: \"bodies.1.velocity.0=-0.25\"}\n", parts[1], NULL);
    test_case_write(place.folder, "A", whole);
    g_free(test_folder_write(place.folder, "T/A/scene.yaml", scene_text));
    ck_assert_msg(catalogue_read(place.folder, programs(), &place.catalogue, &error) == MPM_OK,
                  "%s", error.message);
    g_free(whole);
    g_strfreev(parts);
    g_free(with_second);
    g_free(text);
    return place;
}

static void close_case(struct place *place)
{
    catalogue_free(place->catalogue);
    test_folder_remove(place->folder);
}

static enum mpm_status run_case(const struct place *place, struct mpm_error *error)
{
    const struct catalogue_case *const entry = &place->catalogue->cases[0];
    char *path = test_folder_path(place->folder, "rows");
    const int rows = open(path, O_CREAT | O_TRUNC | O_WRONLY | O_CLOEXEC, 0600);
    const struct measurement_setup setup = {.entry = entry,
                                            .variant = &entry->file->variants[0],
                                            .data_folder = place->folder,
                                            .simulation = {.threads = 1},
                                            .rows = rows};
    const enum mpm_status status = measurement_run(&setup, error);
    close(rows);
    g_free(path);
    return status;
}

/* What it has left; json_decref. */
static json_t *picture_of(const struct place *place)
{
    struct mpm_error error = {.message = ""};
    ck_assert_msg(run_case(place, &error) == MPM_OK, "%s", error.message);
    char *path = test_folder_path(place->folder, "picture-only.json");
    json_t *object = json_load_file(path, 0, NULL);
    ck_assert_ptr_nonnull(object);
    g_free(path);
    return object;
}

static double at(const json_t *list, size_t i)
{
    return json_number_value(json_array_get(list, i));
}

static const json_t *frame_of(const json_t *object, const char *shot, size_t frame)
{
    return json_array_get(json_object_get(json_object_get(object, shot), "frames"), frame);
}

START_TEST(the_last_state_of_the_first_simulation_is_taken)
{
    struct place place = open_case("twice", "");
    json_t *object = picture_of(&place);
    const json_t *const still = json_object_get(object, "still"), *const frame =
                                                                      frame_of(object, "still", 0);
    ck_assert_uint_eq(json_array_size(json_object_get(still, "body")), 128);
    ck_assert_double_eq(json_number_value(json_object_get(frame, "time")), 1);
    ck_assert_double_eq_tol(at(json_object_get(frame, "u"), 0), 0, 1e-12);
    ck_assert_double_eq_tol(at(json_object_get(frame, "u"), 2 * 127), 0.5, 1e-9);
    ck_assert_double_eq(at(json_object_get(still, "half"), 0), 0.25);
    ck_assert_double_eq(at(json_object_get(still, "start"), 0), 2.25);
    ck_assert(json_is_null(json_object_get(object, "motion")));
    const json_t *const field = json_object_get(object, "field");
    ck_assert_str_eq(json_string_value(json_object_get(field, "name")), "von_mises");
    ck_assert_str_eq(json_string_value(json_object_get(field, "unit")), "MPa");
    /* defaults are in the scene, which thus needs no schema to be drawn */
    ck_assert_int_eq(json_integer_value(json_object_get(
                         json_object_get(json_object_get(object, "scene"), "grid"), "refine")),
                     1);
    json_decref(object);
    close_case(&place);
}
END_TEST

START_TEST(another_simulation_field_and_time_are_taken_where_the_case_states_them)
{
    struct place place = open_case(
        "twice", "picture: {simulation: 2, field: displacement_x, time: 0.5, magnify: 3}\n");
    json_t *object = picture_of(&place);
    const json_t *const frame = frame_of(object, "still", 0);
    ck_assert_double_eq(json_number_value(json_object_get(frame, "time")), 0.5);
    ck_assert_double_eq_tol(at(json_object_get(frame, "value"), 127), -0.125, 1e-9);
    ck_assert_double_eq(json_number_value(json_object_get(object, "magnify")), 3);
    /* the settings of that simulation */
    const json_t *const other =
        json_array_get(json_object_get(json_object_get(object, "scene"), "bodies"), 1);
    ck_assert_double_eq(at(json_object_get(other, "velocity"), 0), -0.25);
    json_decref(object);
    close_case(&place);
}
END_TEST

START_TEST(a_motion_has_its_frames_from_start_to_end)
{
    struct place place = open_case("twice", "picture: {frames: 5}\n");
    json_t *object = picture_of(&place);
    for (size_t i = 0; i < 5; i++)
        ck_assert_double_eq(
            json_number_value(json_object_get(frame_of(object, "motion", i), "time")),
            0.25 * (double)i);
    ck_assert_ptr_null(frame_of(object, "motion", 5));
    json_decref(object);
    close_case(&place);
}
END_TEST

START_TEST(more_particles_than_a_file_may_hold_are_thinned_out_evenly)
{
    struct place place = open_case("twice", "picture: {frames: 40}\n");
    g_free(test_folder_write(place.folder, "T/A/scene.yaml", scene_text));
    struct case_variant *const variant = &place.catalogue->cases[0].file->variants[0];
    char *settings[] = {(char[]){"grid.refine=4"}}; /* 2048 particles; 200 for each state */
    variant->settings = settings;
    variant->settings_count = 1;
    json_t *object = picture_of(&place);
    const json_t *const motion = json_object_get(object, "motion");
    const size_t drawn = json_array_size(json_object_get(motion, "body"));
    ck_assert_int_eq(json_integer_value(json_object_get(object, "count")), 2048);
    ck_assert_int_eq(json_integer_value(json_object_get(motion, "stride")), 4);
    ck_assert_uint_eq(drawn, 128);
    /* as large as all those that it stands for: together they cover both bodies */
    const json_t *const half = json_object_get(motion, "half");
    ck_assert_double_eq_tol(4 * at(half, 0) * at(half, 1) * (double)drawn, 32, 1e-9);
    ck_assert_uint_eq(json_array_size(json_object_get(json_object_get(object, "still"), "body")),
                      2048);
    json_decref(object);
    variant->settings = NULL;
    variant->settings_count = 0;
    close_case(&place);
}
END_TEST

START_TEST(a_program_without_the_simulation_fails_unless_the_case_states_why)
{
    static const struct {
        const char *program, *more, *message; /* NULL: it is well */
    } table[] = {
        {"nothing", "", "no picture: the program made 0 simulations, and that of number 1"},
        {"twice", "picture: {simulation: 3}\n", "the program made 2 simulations"},
        {"nothing", "no_picture: it evaluates functions\n", NULL},
        {"skipped", "", NULL},
    };
    for (size_t i = 0; i < G_N_ELEMENTS(table); i++) {
        struct place place = open_case(table[i].program, table[i].more);
        struct mpm_error error = {.message = ""};
        const enum mpm_status status = run_case(&place, &error);
        ck_assert_int_eq(status, table[i].message == NULL ? MPM_OK : MPM_RUN_FAILED);
        if (table[i].message != NULL)
            ck_assert_msg(strstr(error.message, table[i].message) != NULL, "%s", error.message);
        char *path = test_folder_path(place.folder, "picture-only.json");
        ck_assert(!test_file_exists(path));
        g_free(path);
        close_case(&place);
    }
}
END_TEST

/* Particles of the two bodies lie one cell and more apart, so that none is strained. */
START_TEST(values_are_what_their_names_say)
{
    static const struct {
        const char *field;
        double value; /* of the last particle at the end */
    } table[] = {
        {"speed", 0.5},        {"velocity_x", 0.5},     {"velocity_y", 0},  {"displacement", 0.5},
        {"volume_ratio", 1},   {"displacement_y", 0},   {"pressure", 0},    {"stress_xx", 0},
        {"plastic_strain", 0}, {"displacement_x", 0.5}, {"temperature", 0}, {"internal_energy", 0},
    };
    for (size_t i = 0; i < G_N_ELEMENTS(table); i++) {
        char *more = g_strdup_printf("picture: {field: %s}\n", table[i].field);
        struct place place = open_case("twice", more);
        json_t *object = picture_of(&place);
        const json_t *const values = json_object_get(frame_of(object, "still", 0), "value");
        ck_assert_msg(fabs(at(values, 127) - table[i].value) < 1e-9, "%s: %g", table[i].field,
                      at(values, 127));
        json_decref(object);
        close_case(&place);
        g_free(more);
    }
}
END_TEST

START_TEST(pressure_is_positive_where_a_body_is_compressed)
{
    struct place place = open_case("twice", "picture: {field: pressure}\n");
    struct case_variant *const variant = &place.catalogue->cases[0].file->variants[0];
    char *settings[] = {(char[]){"bodies.0.velocity=['-0.1*(x-4)', 0]"}};
    variant->settings = settings;
    variant->settings_count = 1;
    json_t *object = picture_of(&place);
    const json_t *const values = json_object_get(frame_of(object, "still", 0), "value");
    ck_assert_double_gt(at(values, 8 * 4 + 4), 0.05);
    json_decref(object);
    variant->settings = NULL;
    variant->settings_count = 0;
    close_case(&place);
}
END_TEST

START_TEST(units_of_stress_have_their_names)
{
    static const struct {
        const char *units, *stress, *speed;
    } table[] = {
        {"{\"length\": \"mm\", \"mass\": \"g\", \"time\": \"ms\"}", "MPa", "mm ms⁻¹"},
        {"{\"length\": \"m\", \"mass\": \"kg\", \"time\": \"s\"}", "Pa", "m s⁻¹"},
        {"{\"length\": \"mm\", \"mass\": \"kg\", \"time\": \"ms\"}", "GPa", "mm ms⁻¹"},
        {"{\"length\": \"ft\", \"mass\": \"lb\", \"time\": \"s\"}", "lb ft⁻¹ s⁻²", "ft s⁻¹"},
        {"{}", "1", "1"},
    };
    for (size_t i = 0; i < G_N_ELEMENTS(table); i++) {
        json_t *units = json_loads(table[i].units, 0, NULL);
        char *stress =
            picture_field_unit(units, picture_field_describe(PICTURE_VON_MISES)->dimension);
        char *speed = picture_field_unit(units, picture_field_describe(PICTURE_SPEED)->dimension);
        ck_assert_str_eq(stress, table[i].stress);
        ck_assert_str_eq(speed, table[i].speed);
        g_free(speed);
        g_free(stress);
        json_decref(units);
    }
}
END_TEST

/* A run fails if a scene's picture is not taken, so that this, and the run, leave no case out. */
START_TEST(every_case_of_the_catalogue_has_pictures_or_states_why_not)
{
    struct catalogue *catalogue;
    struct mpm_error error = {.message = ""};
    size_t in_strip = 0;
    ck_assert_msg(catalogue_read("verification/catalogue", programs_all(), &catalogue, &error) ==
                      MPM_OK,
                  "%s", error.message);
    for (size_t i = 0; i < catalogue->count; i++) {
        const struct case_file *const file = catalogue->cases[i].file;
        const bool scene = file->scene != NULL;
        ck_assert_msg(scene == (case_picture_variant(file) != NULL),
                      "case %s: a scene without pictures, or pictures without one", file->name);
        ck_assert_msg(scene == (file->no_picture == NULL),
                      "case %s: no_picture belongs to cases without a scene", file->name);
        in_strip += scene && case_picture_of(file).strip;
    }
    ck_assert_uint_ge(in_strip, 6);
    catalogue_free(catalogue);
}
END_TEST

Suite *suite_picture_take(void)
{
    Suite *suite = suite_create("picture_take");
    TCase *taking = tcase_create("taking");
    tcase_add_test(taking, the_last_state_of_the_first_simulation_is_taken);
    tcase_add_test(taking, another_simulation_field_and_time_are_taken_where_the_case_states_them);
    tcase_add_test(taking, a_motion_has_its_frames_from_start_to_end);
    tcase_add_test(taking, more_particles_than_a_file_may_hold_are_thinned_out_evenly);
    tcase_add_test(taking, a_program_without_the_simulation_fails_unless_the_case_states_why);
    tcase_add_test(taking, values_are_what_their_names_say);
    tcase_add_test(taking, pressure_is_positive_where_a_body_is_compressed);
    tcase_add_test(taking, units_of_stress_have_their_names);
    tcase_add_test(taking, every_case_of_the_catalogue_has_pictures_or_states_why_not);
    suite_add_tcase(suite, taking);
    return suite;
}
