/* Reports: rendered from the result lines alone, well-formed, the same every time; a
 * figure that cannot be drawn is reported.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/catalogue.h"
#include "support/folder.h"
#include "support/verify.h"

#include "verification/pages/figure.h"
#include "verification/pages/figure_shorten.h"
#include "verification/pages/markdown.h"

#include <glib.h>
#include <string.h>

static const char *const rendered[] = {"index.html",         "summary.md",
                                       "junit.xml",          "results.tap",
                                       "cases/Q/index.html", "cases/Q/figure-curve.svg"};

START_TEST(reports_are_well_formed_and_rendered_again_to_the_same_bytes)
{
    char *catalogue = test_misbehaving_catalogue(), *output = test_folder_create();
    char *before[G_N_ELEMENTS(rendered)];
    test_case_write_quadrature(catalogue);
    struct test_said said =
        test_verify_with("mpm-verify run --catalogue @ --output @", catalogue, output);
    ck_assert_int_eq(said.exit_status, 1);
    test_said_free(&said);
    for (size_t i = 0; i < G_N_ELEMENTS(rendered); i++) {
        before[i] = test_folder_read(output, rendered[i]);
        ck_assert_uint_gt(strlen(before[i]), 100);
        if (!g_str_has_suffix(rendered[i], ".md") && !g_str_has_suffix(rendered[i], ".tap"))
            test_assert_well_formed(before[i], rendered[i]);
        /* one script, that of the tables; none of a text */
        ck_assert_ptr_null(strstr(before[i], "<script>alert"));
        if (i != 3)
            continue;
        /* as many results as in the plan */
        char *count = g_strdup_printf("\n1..%zu\n", (size_t)TEST_BEHAVIOURS + 2);
        ck_assert_ptr_nonnull(strstr(before[i], count));
        ck_assert_ptr_nonnull(strstr(before[i], "# SKIP no reference | data \\# here\n"));
        g_free(count);
    }
    said = test_verify_with("mpm-verify report @ --catalogue @", output, catalogue);
    ck_assert_msg(said.exit_status == 0, "%s", said.err);
    for (size_t i = 0; i < G_N_ELEMENTS(rendered); i++) {
        char *after = test_folder_read(output, rendered[i]);
        ck_assert_msg(strcmp(before[i], after) == 0, "%s", rendered[i]);
        g_free(after);
        g_free(before[i]);
    }
    test_said_free(&said);
    test_folder_remove(output);
    test_folder_remove(catalogue);
}
END_TEST

START_TEST(result_lines_alone_are_enough_for_a_report)
{
    char *catalogue = test_folder_create(), *output = test_folder_create();
    char *alone = test_folder_create();
    test_case_write_quadrature(catalogue);
    struct test_said said =
        test_verify_with("mpm-verify run --catalogue @ --output @", catalogue, output);
    test_said_free(&said);
    char *lines = test_folder_read(output, "checks.jsonl");
    g_free(test_folder_write(alone, "checks.jsonl", lines));
    said = test_verify_with("mpm-verify report @", alone, NULL);
    ck_assert_msg(said.exit_status == 0, "%s", said.err);
    char *page = test_folder_read(alone, "cases/Q/index.html"),
         *junit = test_folder_read(alone, "junit.xml");
    ck_assert_ptr_nonnull(strstr(page, "result lines alone"));
    test_assert_well_formed(page, "page");
    test_assert_well_formed(junit, "junit.xml");
    test_said_free(&said);
    g_free(page);
    g_free(junit);
    g_free(lines);
    test_folder_remove(alone);
    test_folder_remove(output);
    test_folder_remove(catalogue);
}
END_TEST

START_TEST(a_figure_that_cannot_be_drawn_is_an_error_of_the_report)
{
    const struct {
        const char *script;
        const char *message;
    } table[] = {
        {"load style\nplot sin(\n", "gnuplot: "},
        {"load style\nplot 'missing.dat', x\n", "missing.dat"},
        {"load style\nx = system('date')\nplot x\n", "curve.gp:2: system: a figure's script"},
        {"x = 1\n", "no SVG file"},
    };
    char *path = g_strdup(g_getenv("PATH"));
    for (size_t i = 0; i <= G_N_ELEMENTS(table); i++) {
        char *catalogue = test_folder_create(), *output = test_folder_create();
        test_case_write_quadrature(catalogue);
        if (i < G_N_ELEMENTS(table))
            g_free(test_folder_write(catalogue, "T/Q/curve.gp", table[i].script));
        else
            g_setenv("PATH", catalogue, TRUE); /* the last: no gnuplot at all */
        struct test_said said =
            test_verify_with("mpm-verify run --catalogue @ --output @", catalogue, output);
        g_setenv("PATH", path, TRUE);
        ck_assert_int_eq(said.exit_status, 4);
        ck_assert_ptr_nonnull(strstr(said.err, "figure curve of case Q"));
        ck_assert_msg(
            strstr(said.err, i < G_N_ELEMENTS(table) ? table[i].message : "cannot be run") != NULL,
            "%s", said.err);
        /* the results are there all the same, and the page states what is missing */
        ck_assert_str_eq(test_last_line(said.out), "2 passed, 0 failed, 0 skipped");
        char *page = test_folder_read(output, "cases/Q/index.html");
        ck_assert_ptr_nonnull(strstr(page, "could not be drawn"));
        test_assert_well_formed(page, "page");
        g_free(page);
        test_said_free(&said);
        test_folder_remove(output);
        test_folder_remove(catalogue);
    }
    g_free(path);
}
END_TEST

START_TEST(a_figure_without_its_variants_is_left_out_with_the_reason)
{
    char *catalogue = test_folder_create(), *output = test_folder_create();
    test_case_write_quadrature(catalogue);
    struct test_said said = test_verify_with(
        "mpm-verify run --variant cubic --catalogue @ --output @", catalogue, output);
    ck_assert_int_eq(said.exit_status, 0);
    char *page = test_folder_read(output, "cases/Q/index.html");
    ck_assert_ptr_nonnull(strstr(page, "needs variant ninth"));
    g_free(page);
    test_said_free(&said);
    test_folder_remove(output);
    test_folder_remove(catalogue);
}
END_TEST

START_TEST(a_figure_takes_its_text_colour_from_the_reader)
{
    char *dressed = figure_dress(
        "<?xml version=\"1.0\"?>\n<svg \n viewBox=\"0 0 1 1\" "
        "xmlns=\"http://www.w3.org/2000/svg\">\n"
        "<title>x</title>\n<desc>Produced by GNUPLOT 5.4 </desc>\n"
        "<path stroke='black' fill=\"rgb(  0,   0,   0)\" d='M0,0'/><path stroke='rgb(10, 0, 0)'/>"
        "</svg>",
        "a < b", "c & d");
    ck_assert_ptr_nonnull(strstr(dressed, "stroke='currentColor' fill=\"currentColor\""));
    ck_assert_ptr_nonnull(strstr(dressed, "stroke='rgb(10, 0, 0)'"));
    ck_assert_ptr_nonnull(strstr(dressed, "role=\"img\""));
    ck_assert_ptr_nonnull(strstr(dressed, "a &lt; b</title>"));
    ck_assert_ptr_null(strstr(dressed, "GNUPLOT"));
    test_assert_well_formed(dressed, "figure");
    g_free(dressed);
}
END_TEST

START_TEST(marks_of_a_figure_that_follow_each_other_are_one_group)
{
    char *shorter = figure_shorten("<path stroke='rgb( 10, 0, 255)'/>\n"
                                   "\t<use xlink:href='#gpPt4' transform='translate(10.00,-4.00) "
                                   "scale(2.00)' color='rgb(1,2,3)'/>\n"
                                   "\t<use xlink:href='#gpPt4' transform='translate(30.00,5.00) "
                                   "scale(2.00)' color='rgb(1,2,3)'/>\n"
                                   "\t<use xlink:href='#gpPt4' transform='translate(1.00,1.00) "
                                   "scale(2.00)' color='rgb(9,9,9)'/>\n"
                                   "\t<use xlink:href='#gpPt4' transform='translate(1.00,1.00) "
                                   "scale(4.00)' color='rgb(9,9,9)'/>\n"
                                   "\t<use xlink:href='#gpPt4' transform='translate(1.00,1.00) "
                                   "scale(4.00)' color='currentColor'/>\n"
                                   "<text>rgb(1,2,3)</text></g>");
    ck_assert_str_eq(shorter,
                     "<path stroke='#0a00ff'/>\n<g color='#010203' transform='scale(2.00)'>\n"
                     "<use xlink:href='#gpPt4' x='5.000' y='-2.000'/>\n"
                     "<use xlink:href='#gpPt4' x='15.000' y='2.500'/>\n"
                     "<use xlink:href='#gpPt4' x='0.500' y='0.500' color='#090909'/>\n</g>\n"
                     "\t<use xlink:href='#gpPt4' transform='translate(1.00,1.00) scale(4.00)' "
                     "color='#090909'/>\n"
                     "\t<use xlink:href='#gpPt4' transform='translate(1.00,1.00) scale(4.00)' "
                     "color='currentColor'/>\n"
                     "<text>rgb(1,2,3)</text></g>");
    g_free(shorter);
}
END_TEST

START_TEST(markdown_loses_raw_html_and_its_first_heading)
{
    char *html = markdown_html("# Title\n\n## Problem\n\n<b>raw</b> [x](javascript:alert(1))\n\n"
                               "| a |\n|---|\n| 1 |\n",
                               NULL);
    ck_assert_ptr_null(strstr(html, "Title"));
    ck_assert_ptr_nonnull(strstr(html, "<h2>Problem</h2>"));
    ck_assert_ptr_null(strstr(html, "<b>"));
    ck_assert_ptr_null(strstr(html, "javascript"));
    ck_assert_ptr_nonnull(strstr(html, "<table>"));
    g_free(html);
}
END_TEST

START_TEST(markdown_without_a_text_below_its_title_is_an_empty_page)
{
    static const char *const texts[] = {"", "\n", "# Title", "# Title\n", "<b></b>"};
    for (size_t i = 0; i < G_N_ELEMENTS(texts); i++) {
        char *html = markdown_html(texts[i], NULL);
        ck_assert_msg(strstr(html, "Title") == NULL && strstr(html, "table") == NULL, "'%s': '%s'",
                      texts[i], html);
        g_free(html);
    }
}
END_TEST

START_TEST(equations_are_those_of_the_table_and_else_stay_tex)
{
    json_t *table = json_pack("{s:{s:s},s:{s:s}}", "display", "a < b", "<math>display</math>",
                              "inline", "x", "<math>inline</math>");
    char *html = markdown_html("Of $`x`$ and $`y`$, of `x` and $5.\n\n```math\na < b\n```\n\n"
                               "```math\n<math>not ours</math>\n```\n",
                               table);
    ck_assert_ptr_nonnull(strstr(html, "Of <math>inline</math> and <code>y</code>, of "
                                       "<code>x</code> and $5."));
    ck_assert_ptr_nonnull(strstr(html, "<math>display</math></div>"));
    ck_assert_ptr_nonnull(strstr(html, "&lt;math&gt;not ours"));
    g_free(html);
    json_decref(table);
}
END_TEST

Suite *suite_report(void)
{
    Suite *suite = suite_create("report");
    TCase *reports = tcase_create("reports");
    tcase_add_test(reports, reports_are_well_formed_and_rendered_again_to_the_same_bytes);
    tcase_add_test(reports, result_lines_alone_are_enough_for_a_report);
    tcase_add_test(reports, equations_are_those_of_the_table_and_else_stay_tex);
    tcase_add_test(reports, marks_of_a_figure_that_follow_each_other_are_one_group);
    tcase_add_test(reports, markdown_loses_raw_html_and_its_first_heading);
    tcase_add_test(reports, markdown_without_a_text_below_its_title_is_an_empty_page);
    suite_add_tcase(suite, reports);
    TCase *figures = tcase_create("figures");
    tcase_add_test(figures, a_figure_that_cannot_be_drawn_is_an_error_of_the_report);
    tcase_add_test(figures, a_figure_without_its_variants_is_left_out_with_the_reason);
    tcase_add_test(figures, a_figure_takes_its_text_colour_from_the_reader);
    suite_add_tcase(suite, figures);
    return suite;
}
