/* Contact between bodies: how scenes state it, and what is refused.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "model/scene.h"
#include "suites.h"
#include "support/near.h"
#include "support/scene_files.h"
#include "support/scenes.h"

#include <glib.h>
#include <string.h>

static const char TOUCHING[] = "tests/scenes/good/touching.yaml";

START_TEST(contact_says_what_its_file_says)
{
    struct mpm_scene *scene = test_scene_read(TOUCHING, NULL);
    const struct mpm_contact_spec *const contact = &scene->contact;
    ck_assert(!contact->by_body);
    ck_assert_uint_eq(contact->field_count, 3);
    ck_assert_uint_eq(contact->deformable_fields, 2);
    ck_assert_uint_eq(contact->pair_count, 2);
    const struct mpm_pair_spec *const first = &contact->pairs[0], *const second =
                                                                      &contact->pairs[1];
    ck_assert(first->of[0] == 0 && first->of[1] == 1 && first->law == MPM_PAIR_FRICTION);
    ck_assert_double_eq(first->friction, 0.3);
    ck_assert_double_eq(first->static_friction, 0.3);
    ck_assert(first->normal == MPM_NORMAL_LARGER && first->detection == MPM_TOUCH_EXTENT);
    ck_assert(second->of[0] == 1 && second->of[1] == 2 && second->law == MPM_PAIR_STICK);
    ck_assert_double_eq(second->adhesion, 0.1);
    ck_assert_double_eq(second->touching, 0.8);
    ck_assert(second->detection == MPM_TOUCH_VOLUME && second->normal == MPM_NORMAL_GIVEN);
    ck_assert_double_eq(second->direction[1], 1.0); /* from the tool to the block, turned round */
    static const char *const names[] = {"soft", "hard", "tool"};
    for (size_t k = 0; k < 3; k++)
        ck_assert_str_eq(mpm_scene_contact_field_name(scene, k), names[k]);
    ck_assert_ptr_null(mpm_scene_contact_field_name(scene, 3));
    mpm_scene_free(scene);
}
END_TEST

START_TEST(stiffnesses_may_differ_as_far_as_the_normal_bears_it)
{
    static const char *const allowed[] = {
        "contact={law: interface, tension: 1, shear: 10}",
        "contact={law: interface, tension: 1, compression: 10, shear: 1}",
        "contact={law: interface, tension: 1, shear: 200, ratio_limit: 200}",
        "contact={law: interface, tension: 1, shear: 200, normal: logistic}",
        ("contact={pairs: [{of: [soft, hard], law: interface, tension: 200, shear: 1, "
         "normal: given, direction: [0, 1]}]}"),
        "contact={law: interface, tension: 1, shear: 0}",
        "contact={law: interface, tension: 0, shear: 1}",
    };
    for (size_t k = 0; k < sizeof allowed / sizeof *allowed; k++)
        mpm_scene_free(test_scene_read(TOUCHING, allowed[k]));
}
END_TEST

START_TEST(bodies_between_which_there_is_no_law_share_a_field)
{
    struct mpm_scene *scene =
        test_scene_read(TOUCHING, "contact={fields: bodies, pairs: [{of: [low, tool], law: "
                                  "frictionless}, {of: [tool, high], law: frictionless}]}");
    ck_assert_uint_eq(scene->contact.field_count, 2);
    ck_assert_uint_eq(scene->contact.deformable_fields, 1);
    ck_assert_uint_eq(scene->contact.pair_count, 1);
    mpm_scene_free(scene);
}
END_TEST

/* Settings of the good scene, and part of the message. */
static const char *const refused[][2] = {
    {"contact.heat=perfect", "contact.heat: given in a scene without transport.temperature"},
    {"contact.conductance=1",
     "contact.conductance: given in a scene without transport.temperature"},
    {"contact={law: none}", "contact: no pair with a law: all bodies share one velocity field"},
    {"contact={law: glue}", "allowed: none | bonded | stick"},
    {"contact={law: friction}", "contact.law: friction without its coefficient"},
    {"contact={law: friction, friction: -0.1}", "contact.friction: out of range"},
    {"contact={law: stick, friction: 0.1}",
     "contact.friction: got 0.1, which this pair does not use; allowed: with law: friction only"},
    {"contact={law: friction, friction: 0.4, static_friction: 0.3}",
     "contact.static_friction: got 0.3; allowed: at least friction, 0.4"},
    {"contact={law: bonded, adhesion: 1}", "contact.adhesion: got 1, which this pair does not use"},
    {"contact={law: stick, touching: 0.5}", "contact.touching: got 0.5, which this pair does not"},
    {"contact={law: interface, tension: 1}", "contact.law: an interface without stiffness"},
    {"contact={law: interface, tension: -1, shear: 1}", "contact.tension: out of range"},
    {"contact={law: interface, tension: 1, shear: 10.1}",
     "contact.shear: stiffnesses along and across the surface differ by a factor of 10.1"},
    {"contact={law: interface, tension: 2, compression: 11, shear: 1}",
     "allowed: up to 10 (ratio_limit), or normal: logistic or given"},
    {"contact={law: interface, tension: 1, shear: 200, ratio_limit: 199}",
     "allowed: up to 199 (ratio_limit)"},
    {"contact={law: stick, ratio_limit: 20}",
     "contact.ratio_limit: got 20, which this pair does not use"},
    {"contact={law: interface, tension: 1, shear: 1, ratio_limit: 0.5}",
     "contact.ratio_limit: out of range"},
    {"contact={law: stick, tension: 1}", "contact.tension: got 1, which this pair does not use"},
    {"contact={law: stick, normal: given}", "contact.normal: given for all pairs"},
    {"contact={pairs: [{of: [soft, glass], law: stick}]}",
     "contact.pairs.0.of: unknown material or rigid body 'glass'"},
    {"contact={fields: bodies, pairs: [{of: [soft, high], law: stick}]}",
     "contact.pairs.0.of: unknown body 'soft'"},
    {"contact={pairs: [{of: [soft, soft], law: stick}]}", "contact.pairs.0.of: 'soft' with itself"},
    {"contact={pairs: [{of: [soft, hard], law: stick}, {of: [hard, soft], law: bonded}]}",
     "contact.pairs.1.of: 'hard' and 'soft' again, which contact.pairs.0 has already"},
    {"contact={pairs: [{of: [soft, hard], law: stick, normal: given}]}",
     "contact.pairs.0.normal: given without direction"},
    {"contact={pairs: [{of: [soft, hard], law: stick, direction: [1, 0]}]}",
     "contact.pairs.0.direction: got 1, which this pair does not use"},
    {"contact={pairs: [{of: [soft, hard], law: stick, normal: given, direction: [0, 0]}]}",
     "contact.pairs.0.direction: got a vector of length 0"},
    {"contact={pairs: [{of: [soft, tool], law: interface, tension: 1, shear: 1}]}",
     "contact.pairs.0.of: an interface with rigid body 'tool'"},
    {"contact={pairs: [{of: [soft], law: stick}]}", "contact.pairs.0.of:"},
    {"contact={pairs: [{law: stick}]}", "contact.pairs.0.of: missing"},
    {"contact={pairs: [{of: [soft, hard]}]}", "contact.pairs.0.law: missing"},
    {"contact={fields: bodies, pairs: [{of: [low, tool], law: stick}]}",
     "'high' and 'tool' have another law than a pair of the same two velocity fields"},
    {"contact={fields: bodies, pairs: [{of: [tool, tool], law: stick}]}", "'tool' with itself"},
};

static void assert_refused(const char *setting, const char *part)
{
    const char *const settings[] = {setting, NULL};
    struct mpm_scene *scene = NULL;
    struct mpm_error error = {.message = ""};
    ck_assert_int_eq(mpm_scene_read(TOUCHING, settings, 1, &scene, &error), MPM_BAD_INPUT);
    ck_assert_ptr_null(scene);
    test_contains(error.message, part);
}

START_TEST(contact_that_cannot_be_is_refused_with_its_place)
{
    assert_refused(refused[_i][0], refused[_i][1]);
}
END_TEST

/* A rigid body with a free component, and two names that are one. */
START_TEST(rigid_bodies_in_contact_are_driven_along_both_axes)
{
    assert_refused("bodies.tool.rigid.velocity=[free, -1]",
                   "rigid body 'tool' has a free component of velocity");
}
END_TEST

static char *many_bodies(int count)
{
    GString *const text = g_string_new("bodies=[");
    for (int k = 0; k < count; k++)
        g_string_append_printf(text,
                               "%s{name: b%d, material: soft, region: {rectangle: {from: [%d, 2], "
                               "to: [%d, 4]}}}",
                               k > 0 ? ", " : "", k, 1 + k, 2 + k);
    g_string_append(text, "]");
    return g_string_free(text, FALSE);
}

START_TEST(there_are_up_to_eight_fields)
{
    for (int count = 8; count <= 9; count++) {
        char *const bodies = many_bodies(count);
        const char *const settings[] = {bodies, "contact={fields: bodies, law: frictionless}",
                                        NULL};
        struct mpm_scene *scene = NULL;
        struct mpm_error error = {.message = ""};
        const enum mpm_status status = mpm_scene_read(TOUCHING, settings, 2, &scene, &error);
        ck_assert_int_eq(status, count == 8 ? MPM_OK : MPM_BAD_INPUT);
        if (count == 9)
            test_contains(error.message, "too many velocity fields, got 9");
        mpm_scene_free(scene);
        g_free(bodies);
    }
}
END_TEST

Suite *suite_scene_contact(void)
{
    Suite *suite = suite_create("scene_contact");
    TCase *content = tcase_create("content");
    tcase_add_test(content, contact_says_what_its_file_says);
    tcase_add_test(content, bodies_between_which_there_is_no_law_share_a_field);
    tcase_add_test(content, stiffnesses_may_differ_as_far_as_the_normal_bears_it);
    tcase_add_loop_test(content, contact_that_cannot_be_is_refused_with_its_place, 0,
                        G_N_ELEMENTS(refused));
    tcase_add_test(content, rigid_bodies_in_contact_are_driven_along_both_axes);
    tcase_add_test(content, there_are_up_to_eight_fields);
    suite_add_tcase(suite, content);
    return suite;
}
