/* Pictures of scenes on pages: drawn from what a run left, which may come from anywhere.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/folder.h"
#include "support/verify.h"

#include "verification/pages/colours.h"
#include "verification/pages/svg.h"
#include "verification/report/case_pictures.h"
#include "verification/report/picture_file.h"
#include "verification/report/picture_svg.h"
#include "verification/report/sketch_svg.h"

#include <glib.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Two particles of one body, the second stretched twice along x, sheared, and moved by 1. */
#define SCENE                                                                                      \
    "{\"geometry\":\"plane_strain\",\"units\":{\"length\":\"mm\",\"mass\":\"g\",\"time\":\"ms\"}," \
    "\"grid\":{\"origin\":[0,0],\"cell\":[1,1],\"cells\":[9,4],\"refine\":1},"                     \
    "\"materials\":[{\"name\":\"soft<er>\",\"law\":\"neo_hookean\"}],"                             \
    "\"bodies\":[{\"name\":\"bar & co\",\"material\":\"soft<er>\","                                \
    "\"region\":{\"rectangle\":{\"from\":[0,0],\"to\":[2,1]}},\"velocity\":[1,0]}],"               \
    "\"boundary\":[{\"region\":{\"line\":{\"from\":[0,0],\"to\":[0,1]}},\"velocity\":[0,0]},"      \
    "{\"region\":{\"line\":{\"from\":[0,0],\"to\":[2,0]}},\"symmetry\":true},"                     \
    "{\"region\":{\"rectangle\":{\"from\":[1,0],\"to\":[2,1]}},\"velocity\":[\"free\",\"2*t\"]}]," \
    "\"loads\":{\"tractions\":[{\"body\":\"bar & co\",\"edge\":\"right\",\"value\":[0,\"-9*t\"]}]" \
    ",\"body_force\":[0,-9.81]},"                                                                  \
    "\"cracks\":[{\"points\":[[0.5,0.5],[1.5,0.5]],\"contact\":\"frictionless\"}]}"
#define STATES(u, frames)                                                                          \
    "{\"stride\":1,\"body\":[0,0],\"half\":[0.5,0.5],\"start\":[0.5,0.5,1.5,0.5],\"frames\":["     \
    "{\"time\":0.5,\"step\":4,\"u\":[0,0," u "],\"g\":[0,0,0,0,1,0.5,0,0],\"value\":[1,3],"        \
    "\"cracks\":[[0.5,0.5,1.5,0.5]]}" frames "]}"
#define FILE_TEXT(scene, still, motion)                                                            \
    "{\"format\":1,\"case\":\"A\",\"variant\":\"only\",\"count\":2,\"magnify\":1,"                 \
    "\"field\":{\"name\":\"von_mises\",\"title\":\"von Mises stress\",\"unit\":\"MPa\","           \
    "\"signed\":false},\"scene\":" scene ",\"still\":" still ",\"motion\":" motion "}"
static const char good[] = FILE_TEXT(SCENE, STATES("1,0", ""), "null");
static const char moving[] =
    FILE_TEXT(SCENE, STATES("1,0", ""),
              STATES("0,0", ",{\"time\":1,\"step\":8,\"u\":[0,0,1,0],\"g\":[0,0,0,0,1,0.5,0,0],"
                            "\"value\":[1,3],\"cracks\":[]}"));

struct place {
    char *home;
    json_t *entry;
};

static struct place open_place(const char *text)
{
    struct place place = {test_folder_create(), NULL};
    if (text != NULL)
        g_free(test_folder_write(place.home, "picture-only.json", text));
    place.entry = json_loads("{\"case\":\"A\",\"title\":\"T\",\"picture\":{\"variant\":\"only\","
                             "\"caption\":\"See <this>.\",\"strip\":true}}",
                             0, NULL);
    ck_assert_ptr_nonnull(place.entry);
    return place;
}

static void close_place(struct place *place)
{
    json_decref(place->entry);
    test_folder_remove(place->home);
}

/* The part of the page; g_free. */
static char *page_of(const struct place *place)
{
    struct mpm_error error = {.message = ""};
    GString *html = g_string_new("<div>");
    ck_assert_msg(case_pictures(place->home, place->entry, html, &error) == MPM_OK, "%s",
                  error.message);
    g_string_append(html, "</div>");
    test_assert_well_formed(html->str, "pictures");
    return g_string_free(html, FALSE);
}

static bool has_file(const struct place *place, const char *name)
{
    char *path = test_folder_path(place->home, name);
    const bool there = test_file_exists(path);
    g_free(path);
    return there;
}

START_TEST(a_page_has_the_sketch_and_the_state)
{
    struct place place = open_place(good);
    char *page = page_of(&place), *still = test_folder_read(place.home, "picture-state.svg"),
         *sketch = test_folder_read(place.home, "picture-sketch.svg");
    test_assert_well_formed(still, "state");
    test_assert_well_formed(sketch, "sketch");
    ck_assert_ptr_nonnull(strstr(page, "<img src=\"picture-sketch.svg\" width=\"560\""));
    ck_assert_ptr_nonnull(strstr(page, "<img src=\"picture-state.svg\" width=\"560\""));
    ck_assert_ptr_nonnull(strstr(page, "See &lt;this&gt;."));
    ck_assert_ptr_nonnull(strstr(page, "bar &amp; co: soft&lt;er&gt;, law neo_hookean; rectangle, "
                                       "2 by 1 mm; velocity at the start (1, 0) mm/ms"));
    ck_assert_ptr_nonnull(strstr(still, "von Mises stress / MPa"));
    ck_assert_ptr_nonnull(strstr(still, "t = 0.5 ms"));
    ck_assert_ptr_nonnull(strstr(still, "x / mm"));
    ck_assert(has_file(&place, "picture-small.svg"));
    ck_assert(!has_file(&place, "picture-motion.svg"));
    ck_assert_ptr_null(strstr(page, "<details"));
    g_free(sketch);
    g_free(still);
    g_free(page);
    close_place(&place);
}
END_TEST

START_TEST(the_legend_states_what_holds_and_loads_the_bodies)
{
    static const char *const parts[] = {
        "fixed<",
        "plane of symmetry",
        "moves with velocity (free, 2*t) mm/ms",
        "traction (0, -9*t)",
        "body force per mass (0, −9.81) mm/ms²",
        "crack, contact frictionless",
    };
    json_t *scene = json_loads(SCENE, 0, NULL);
    GString *legend = g_string_new(NULL);
    char *svg = sketch_svg(scene, "title", legend);
    for (size_t i = 0; i < G_N_ELEMENTS(parts); i++)
        ck_assert_msg(strstr(legend->str, parts[i]) != NULL, "%s in %s", parts[i], legend->str);
    ck_assert_ptr_nonnull(strstr(svg, "class=\"fissure\""));
    ck_assert_ptr_nonnull(strstr(svg, "class=\"load head\""));
    ck_assert_ptr_nonnull(strstr(svg, ">2 mm<"));
    g_free(svg);
    g_string_free(legend, TRUE);
    json_decref(scene);
}
END_TEST

/* Corners of the domains, in tenths of a pixel: one is twice as long as the other, and sheared. */
START_TEST(domains_are_what_the_deformation_gradient_makes_of_rectangles)
{
    struct place place = open_place(good);
    struct picture_file file;
    struct mpm_error error;
    char *path = test_folder_path(place.home, "picture-only.json");
    ck_assert_int_eq(picture_file_read(path, &file, &error), MPM_OK);
    char *svg = picture_still_svg(&file, "t", "d");
    GRegex *regex = g_regex_new("M(-?\\d+) (-?\\d+)l(\\d+) 0 (\\d+) -(\\d+) -\\d+ 0z",
                                G_REGEX_DEFAULT, G_REGEX_MATCH_DEFAULT, NULL);
    GMatchInfo *match;
    double width[2] = {0, 0}, left[2] = {0, 0}, sheared[2] = {0, 0}, tall = 0;
    g_regex_match(regex, svg, G_REGEX_MATCH_DEFAULT, &match);
    for (size_t i = 0; i < 2; i++) {
        ck_assert(g_match_info_matches(match));
        double number[4];
        for (int k = 0; k < 4; k++) {
            char *text = g_match_info_fetch(match, k == 0 ? 1 : k + 2);
            number[k] = g_ascii_strtod(text, NULL);
            g_free(text);
        }
        left[i] = number[0];
        width[i] = number[1];
        sheared[i] = number[2];
        tall = number[3];
        g_match_info_next(match, NULL);
    }
    ck_assert_double_eq_tol(width[0], tall, 2);
    ck_assert_double_eq_tol(width[1], 2 * tall, 2);
    ck_assert_double_eq_tol(sheared[0], 0, 0.5);
    ck_assert_double_eq_tol(sheared[1], 0.5 * tall, 2);
    ck_assert_double_eq_tol(left[1] - left[0], 1.25 * tall, 2); /* 2.5 - 1 - 0.25 to 0.5 - 0.5 */
    g_match_info_free(match);
    g_regex_unref(regex);
    g_free(svg);
    picture_file_clear(&file);
    g_free(path);
    close_place(&place);
}
END_TEST

START_TEST(a_motion_can_be_stopped_and_rests_for_those_who_want_it)
{
    struct place place = open_place(moving);
    char *page = page_of(&place), *svg = test_folder_read(place.home, "picture-motion.svg");
    test_assert_well_formed(svg, "motion");
    ck_assert_ptr_nonnull(strstr(page, "<details class=\"motion\" open=\"open\"><summary>"));
    ck_assert_ptr_nonnull(strstr(svg, "@media(prefers-reduced-motion:reduce){.f{animation:none}"
                                      ".f.last{visibility:visible}}"));
    ck_assert_ptr_nonnull(strstr(svg, "class=\"f\" style=\"animation-delay:0.00s\""));
    ck_assert_ptr_nonnull(strstr(svg, "class=\"f last\" style=\"animation-delay:0.25s\""));
    g_free(svg);
    g_free(page);
    close_place(&place);
}
END_TEST

/* Each is a change to the good file. */
START_TEST(a_file_that_no_run_writes_is_refused_with_the_reason_on_the_page)
{
    static const struct {
        const char *from, *to;
    } table[] = {
        {"\"format\":1", "\"format\":2"},
        {"\"magnify\":1", "\"magnify\":0"},
        {"\"magnify\":1", "\"magnify\":\"1\""},
        {"\"body\":[0,0]", "\"body\":[0,1]"},
        {"\"body\":[0,0]", "\"body\":[0,-1]"},
        {"\"body\":[0,0]", "\"body\":[0,0.5]"},
        {"\"body\":[0,0]", "\"body\":[]"},
        {"\"half\":[0.5,0.5]", "\"half\":[0.5]"},
        {"\"start\":[0.5,0.5,1.5,0.5]", "\"start\":[0.5,0.5,1.5,null]"},
        {"\"u\":[0,0,1,0]", "\"u\":[0,0,1,1e300]"},
        {"\"u\":[0,0,1,0]", "\"u\":[0,0,1]"},
        {"\"g\":[0,0,0,0,1,0.5,0,0]", "\"g\":{}"},
        {"\"value\":[1,3]", "\"value\":[1,\"3\"]"},
        {"\"time\":0.5", "\"time\":\"now\""},
        {"\"frames\":[", "\"fr\":["},
        {"{\"format\"", "[{\"format\""},
    };
    for (size_t i = 0; i < G_N_ELEMENTS(table); i++) {
        char **parts = g_strsplit(good, table[i].from, 2);
        ck_assert_ptr_nonnull(parts[1]);
        char *text = g_strconcat(parts[0], table[i].to, parts[1], NULL);
        struct place place = open_place(text);
        char *page = page_of(&place);
        ck_assert_msg(strstr(page, "No picture of the scene:") != NULL, "%s", table[i].to);
        ck_assert(!has_file(&place, "picture-state.svg"));
        g_free(page);
        close_place(&place);
        g_free(text);
        g_strfreev(parts);
    }
}
END_TEST

START_TEST(values_that_are_no_numbers_and_odd_scenes_are_drawn_without_them)
{
    static const struct {
        const char *from, *to;
    } table[] = {
        {"\"value\":[1,3]", "\"value\":[1,null]"},
        {"\"value\":[1,3]", "\"value\":[null,null]"},
        {"\"value\":[1,3]", "\"value\":[2,2]"},
        {"\"rectangle\":{\"from\":[0,0],\"to\":[2,1]}", "\"rectangle\":{\"from\":7}"},
        {"\"boundary\":[", "\"boundary\":[7,{\"region\":\"all\",\"velocity\":[]},"},
        {"\"cracks\":[{", "\"cracks\":[{\"points\":[[]]},{\"points\":7},{"},
        {"\"cracks\":[[0.5,0.5,1.5,0.5]]", "\"cracks\":[[0.5],7,[]]"},
        {"\"grid\":{", "\"grid\":{\"refine\":1e-9,"},
        {"\"velocity\":[1,0]", "\"velocity\":[1e-300,\"<script>\"]"},
        {"\"origin\":[0,0]", "\"origin\":[1e50,0]"},
        {"\"rectangle\":{\"from\":[0,0],\"to\":[2,1]}",
         "\"disk\":{\"center\":[0,0],\"radius\":1e308}"},
    };
    for (size_t i = 0; i < G_N_ELEMENTS(table); i++) {
        char **parts = g_strsplit(good, table[i].from, 2);
        ck_assert_ptr_nonnull(parts[1]);
        char *text = g_strconcat(parts[0], table[i].to, parts[1], NULL);
        struct place place = open_place(text);
        char *page = page_of(&place);
        const char *const names[] = {"picture-state.svg", "picture-sketch.svg"};
        for (size_t k = 0; k < G_N_ELEMENTS(names) && has_file(&place, names[k]); k++) {
            char *svg = test_folder_read(place.home, names[k]);
            test_assert_well_formed(svg, table[i].to);
            ck_assert_ptr_null(strstr(svg, "nan"));
            ck_assert_ptr_null(strstr(svg, "inf"));
            g_free(svg);
        }
        ck_assert_ptr_null(strstr(page, "<script>"));
        g_free(page);
        close_place(&place);
        g_free(text);
        g_strfreev(parts);
    }
}
END_TEST

START_TEST(a_page_without_pictures_states_why)
{
    struct place place = open_place(NULL);
    char *page = page_of(&place);
    ck_assert_ptr_nonnull(strstr(page, "variant only, whose run it shows, has left none here"));
    g_free(page);
    json_object_set_new(place.entry, "picture", json_null());
    json_object_set_new(place.entry, "no_picture", json_string("It <has> no scene."));
    page = page_of(&place);
    ck_assert_ptr_nonnull(strstr(page, "It &lt;has&gt; no scene."));
    g_free(page);
    close_place(&place);
}
END_TEST

/* Equal steps of a value are equal steps of lightness, as sRGB has it. */
START_TEST(colours_are_ordered_by_lightness)
{
    double last = 0;
    for (int i = 0; i <= 20; i++) {
        char text[COLOUR_SIZE];
        unsigned rgb;
        colour_at(i / 20.0, false, text);
        rgb = (unsigned)strtoul(text + 1, NULL, 16);
        const double luminance = 0.2126 * pow((rgb >> 16 & 255) / 255.0, 2.2) +
                                 0.7152 * pow((rgb >> 8 & 255) / 255.0, 2.2) +
                                 0.0722 * pow((rgb & 255) / 255.0, 2.2);
        const double lightness = cbrt(luminance);
        ck_assert_msg(i == 0 || (lightness - last > 0.015 && lightness - last < 0.06), "%d: %g", i,
                      lightness - last);
        last = lightness;
    }
}
END_TEST

/* A step that is less than the last digit of its numbers would never reach the end. */
START_TEST(axes_far_from_zero_have_an_end)
{
    static const double low[2] = {1e17, -1e17}, high[2] = {1e17 + 32, -1e17 + 32};
    char *const names[2] = {"x", "y"};
    const struct svg_view view = svg_view_of(low, high, 0, 0, 400, 400);
    GString *svg = g_string_new(NULL);
    svg_axes(svg, &view, names);
    ck_assert(strstr(svg->str, "<text") != NULL && svg->len < 10000);
    ck_assert(svg_width(&view) <= 400.1 && svg_height(&view) <= 400.1);
    g_string_free(svg, TRUE);
}
END_TEST

START_TEST(numbers_of_tics_are_short_and_told_apart)
{
    static const struct {
        double value, step, largest;
        const char *text;
    } table[] = {
        {20, 10, 30, "20"},           {-0.4, 0.2, 1, "−0.4"},       {0, 0.1, 1, "0.0"},
        {2e-7, 1e-7, 5e-7, "2·10⁻⁷"}, {1e-6, 1e-6, 1e-6, "10⁻⁶"},   {1.5e6, 5e5, 2e6, "1.5·10⁶"},
        {2500, 500, 3000, "2500"},    {5e-5, 5e-5, 3e-4, "5·10⁻⁵"}, {1e-4, 5e-5, 3e-4, "1.0·10⁻⁴"},
        {0, 5e-5, 3e-4, "0"},
    };
    for (size_t i = 0; i < G_N_ELEMENTS(table); i++) {
        char *text = svg_tic_text(table[i].value, table[i].step, table[i].largest);
        ck_assert_str_eq(text, table[i].text);
        g_free(text);
    }
    ck_assert_double_eq_tol(svg_step(10, 6), 2, 1e-12);
    ck_assert_double_eq_tol(svg_step(0.9, 3), 0.5, 1e-12);
}
END_TEST

Suite *suite_case_pictures(void)
{
    Suite *suite = suite_create("case_pictures");
    TCase *page = tcase_create("page");
    tcase_add_test(page, a_page_has_the_sketch_and_the_state);
    tcase_add_test(page, the_legend_states_what_holds_and_loads_the_bodies);
    tcase_add_test(page, domains_are_what_the_deformation_gradient_makes_of_rectangles);
    tcase_add_test(page, a_motion_can_be_stopped_and_rests_for_those_who_want_it);
    tcase_add_test(page, a_file_that_no_run_writes_is_refused_with_the_reason_on_the_page);
    tcase_add_test(page, values_that_are_no_numbers_and_odd_scenes_are_drawn_without_them);
    tcase_add_test(page, a_page_without_pictures_states_why);
    suite_add_tcase(suite, page);
    TCase *parts = tcase_create("parts");
    tcase_add_test(parts, colours_are_ordered_by_lightness);
    tcase_add_test(parts, axes_far_from_zero_have_an_end);
    tcase_add_test(parts, numbers_of_tics_are_short_and_told_apart);
    suite_add_tcase(suite, parts);
    return suite;
}
