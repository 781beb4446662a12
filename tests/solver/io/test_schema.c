/* The schema as JSON, for programs.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/scene/schema.h"
#include "io/units.h"
#include "model/material.h"
#include "suites.h"

#include <glib.h>
#include <jansson.h>
#include <stdlib.h>
#include <string.h>

/* The objects of the JSON, by their `key`. */
static json_t *schema_objects(void)
{
    char *text = mpm_schema_list();
    json_t *schema = json_loads(text, 0, NULL);
    ck_assert_ptr_nonnull(schema);
    free(text);
    const json_t *keys = json_object_get(schema, "keys");
    json_t *objects = json_object();
    for (size_t i = 0; i < json_array_size(keys); i++) {
        json_t *key = json_array_get(keys, i);
        const char *path = json_string_value(json_object_get(key, "key"));
        ck_assert_int_eq(json_object_set(objects, path, key), 0);
    }
    ck_assert_uint_eq(json_object_size(objects), json_array_size(keys));
    json_decref(schema);
    return objects;
}

START_TEST(the_schema_as_json_has_every_key_of_the_table)
{
    json_t *objects = schema_objects();
    size_t count = 0, found = 0;
    char *text = mpm_schema_text(NULL, &count);
    char **rows = g_strsplit(g_strchomp(text), "\n", -1);
    ck_assert_uint_eq(json_object_size(objects), count);
    for (size_t i = 1; rows[i] != NULL; i++) {
        ck_assert_msg(g_utf8_strlen(rows[i], -1) <= 80, "%s", rows[i]);
        if (rows[i][0] == ' ')
            continue;
        char *key = g_strndup(rows[i], strcspn(rows[i], " "));
        ck_assert_msg(json_object_get(objects, key) != NULL, "%s", key);
        g_free(key);
        found++;
    }
    ck_assert_uint_eq(found, count);
    g_strfreev(rows);
    free(text);
    json_decref(objects);
}
END_TEST

START_TEST(a_filter_leaves_the_keys_that_have_its_word)
{
    static const struct {
        const char *filter, *first;
        size_t least, most;
    } rows[] = {
        {"REFINE", "\ngrid.refine ", 1, 3},       {"bspline2", "\nmethod.shape ", 1, 2},
        {"damping.pic", "\ndamping.pic ", 1, 1},  {"conductance", "\ncracks[].heat ", 3, 30},
        {"planar scenes", "\nthickness ", 2, 10}, {"no such word", "", 0, 0},
    };
    for (size_t i = 0; i < G_N_ELEMENTS(rows); i++) {
        size_t count = 0;
        char *text = mpm_schema_text(rows[i].filter, &count);
        ck_assert_msg(count >= rows[i].least && count <= rows[i].most, "%s: %zu", rows[i].filter,
                      count);
        ck_assert_msg(strstr(text, rows[i].first) != NULL, "%s: %s", rows[i].filter, text);
        free(text);
    }
}
END_TEST

/* What an editor is told of some keys. */
START_TEST(the_schema_for_editors_has_types_ranges_choices_and_defaults)
{
    static const char *const expected[][2] = {
        {"geometry", "{'enum': ['plane_strain', 'plane_stress', 'axisymmetric']}"},
        {"thickness", "{'type': 'number', 'exclusiveMinimum': 0, 'default': 1}"},
        {"title", "{'maxLength': 4096, 'minLength': 0, 'default': ''}"},
        {"grid",
         "{'type': 'object', 'additionalProperties': false, 'required': ['cell', 'cells']}"},
        {"bodies", "{'type': 'array', 'minItems': 1}"},
        {"boundary", "{'type': 'array', 'default': []}"},
        {"output", "{'default': {}}"},
    };
    char *text = mpm_schema_document();
    json_t *schema = json_loads(text, 0, NULL);
    const json_t *properties = json_object_get(schema, "properties");
    for (size_t i = 0; i < G_N_ELEMENTS(expected); i++) {
        char *wanted = g_strdelimit(g_strdup(expected[i][1]), "'", '"');
        json_t *members = json_loads(wanted, 0, NULL);
        const json_t *key = json_object_get(properties, expected[i][0]);
        ck_assert_ptr_nonnull(members);
        for (void *at = json_object_iter(members); at != NULL;
             at = json_object_iter_next(members, at)) {
            const char *name = json_object_iter_key(at);
            ck_assert_msg(json_equal(json_object_get(key, name), json_object_iter_value(at)),
                          "%s: %s", expected[i][0], name);
        }
        ck_assert_ptr_nonnull(json_object_get(key, "description"));
        json_decref(members);
        g_free(wanted);
    }
    json_decref(schema);
    free(text);
}
END_TEST

START_TEST(the_schema_as_json_says_kind_range_choices_and_default)
{
    static const char *const expected[][2] = {
        {"geometry", "{'shape': 'choice', 'value': null, 'required': true, 'default': null, "
                     "'choices': ['plane_strain', 'plane_stress', 'axisymmetric']}"},
        {"thickness", "{'shape': 'one', 'value': 'number', 'geometry': 'planar', 'unit': 'length', "
                      "'default': '1', 'low': 0.0, 'low_open': true, 'high': null}"},
        {"grid.cells", "{'shape': 'pair', 'value': 'integer', 'low': 1.0, 'high': 2147483648.0, "
                       "'low_open': false, 'high_open': false, 'choices': null}"},
        {"method.axis", "{'geometry': 'axisymmetric', 'default': 'truncated'}"},
        {"materials[].law", "{'shape': 'one', 'value': 'law'}"},
        {"materials[].poisson", "{'low': -1.0, 'high': 0.5, 'low_open': true, 'high_open': true}"},
        {"bodies[].rigid", "{'shape': 'group', 'value': null, 'geometry': null}"},
        {"boundary[].velocity", "{'shape': 'pair', 'value': 'drive', 'unit': 'length/time'}"},
        {"boundary", "{'shape': 'list', 'default': '[]', 'required': false}"},
        {"cracks[].points", "{'shape': 'points', 'value': 'number', 'low': 2.0, 'high': 10000.0}"},
        {"damping.pic", "{'value': 'expression'}"},
        {"time.allow_unstable", "{'value': 'boolean'}"},
        {"title", "{'value': 'text'}"},
        {"units.length", "{'value': 'name', 'help': 'name of the unit of length'}"},
    };
    json_t *objects = schema_objects();
    for (size_t i = 0; i < sizeof expected / sizeof *expected; i++) {
        char *text = g_strdelimit(g_strdup(expected[i][1]), "'", '"');
        json_t *members = json_loads(text, 0, NULL);
        const json_t *key = json_object_get(objects, expected[i][0]);
        ck_assert_ptr_nonnull(members);
        for (void *at = json_object_iter(members); at != NULL;
             at = json_object_iter_next(members, at)) {
            const char *name = json_object_iter_key(at);
            ck_assert_msg(json_equal(json_object_get(key, name), json_object_iter_value(at)),
                          "%s: %s", expected[i][0], name);
        }
        json_decref(members);
        g_free(text);
    }
    json_decref(objects);
}
END_TEST

START_TEST(the_schema_as_json_lists_the_laws_with_their_parameters)
{
    char *text = mpm_schema_list();
    json_t *schema = json_loads(text, 0, NULL);
    const json_t *const laws = json_object_get(schema, "laws");
    const struct mpm_material_law *law;
    for (size_t k = 0; (law = mpm_material_law_at(k)) != NULL; k++) {
        const json_t *const entry = json_array_get(laws, k);
        const json_t *const parameters = json_object_get(entry, "parameters");
        ck_assert_str_eq(json_string_value(json_object_get(entry, "law")), law->name);
        ck_assert_str_eq(json_string_value(json_object_get(entry, "help")), law->description);
        ck_assert_uint_eq(json_array_size(parameters), law->parameter_count);
        for (size_t i = 0; i < law->parameter_count; i++)
            ck_assert_str_eq(
                json_string_value(json_object_get(json_array_get(parameters, i), "key")),
                mpm_parameter_key(law->parameters[i].which));
        for (size_t i = 0; i < law->parameter_count; i++)
            ck_assert_int_eq(
                json_is_true(json_object_get(json_array_get(parameters, i), "required")),
                !law->parameters[i].optional);
        ck_assert_uint_eq(json_array_size(json_object_get(entry, "variables")),
                          law->variable_count);
        ck_assert_int_eq(json_is_true(json_object_get(entry, "energy")), law->energy != NULL);
        ck_assert_int_eq(json_is_true(json_object_get(entry, "plane_stress")),
                         mpm_material_law_has_plane_stress(law));
    }
    ck_assert_uint_ge(json_array_size(laws), 2);
    json_decref(schema);
    free(text);
}
END_TEST

START_TEST(dimensions_are_written_as_quotients)
{
    const struct {
        struct mpm_dimension dimension;
        const char *text;
    } table[] = {
        {MPM_DIMENSION_NONE, ""},
        {MPM_DIMENSION_LENGTH, "length"},
        {MPM_DIMENSION_RATE, "1/time"},
        {MPM_DIMENSION_VELOCITY, "length/time"},
        {MPM_DIMENSION_STRESS, "mass/(length time^2)"},
        {MPM_DIMENSION_ENERGY, "mass length^2/time^2"},
        {{.length = 2, .time = -2, .temperature = -1}, "length^2/(time^2 temperature)"},
    };
    for (size_t i = 0; i < G_N_ELEMENTS(table); i++) {
        char text[MPM_UNIT_SIZE];
        mpm_dimension_text(table[i].dimension, text);
        ck_assert_str_eq(text, table[i].text);
    }
}
END_TEST

Suite *suite_schema(void)
{
    Suite *suite = suite_create("schema");
    TCase *json = tcase_create("JSON");
    tcase_add_test(json, the_schema_as_json_has_every_key_of_the_table);
    tcase_add_test(json, a_filter_leaves_the_keys_that_have_its_word);
    tcase_add_test(json, the_schema_for_editors_has_types_ranges_choices_and_defaults);
    tcase_add_test(json, the_schema_as_json_says_kind_range_choices_and_default);
    tcase_add_test(json, the_schema_as_json_lists_the_laws_with_their_parameters);
    tcase_add_test(json, dimensions_are_written_as_quotients);
    suite_add_tcase(suite, json);
    return suite;
}
