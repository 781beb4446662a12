/* Pages of the library's headers in a report: copied whole, linked, and without any script.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/catalogue.h"
#include "support/folder.h"
#include "support/verify.h"

#include <glib.h>
#include <glib/gstdio.h>
#include <string.h>
#include <unistd.h>

#define DOXYGEN "<html><head><meta name=\"generator\" content=\"Doxygen 1.9.4\"></head>"
#define POLICY                                                                                     \
    "<!DOCTYPE html><meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none';"

static struct {
    char *catalogue, *output, *pages;
} place;

static const char picture[] = {'\x89', 'P', 'N', 'G', '\0', '\n', '\xff'};

static void write_page(const char *name, const char *text)
{
    g_free(test_folder_write(place.pages, name, text));
}

static void set_up(void)
{
    place.catalogue = test_folder_create();
    place.output = test_folder_create();
    place.pages = test_folder_create();
    test_case_write_quadrature(place.catalogue);
    write_page("index.html", DOXYGEN "<body>pages<script>alert(1)</script></body></html>\n");
    write_page("mpm_8h.html", DOXYGEN "<body>mpm.h</body></html>\n");
    write_page("doxygen.css", "body { color: black }\n");
    write_page("menu.js", "alert(1)\n");
    write_page("logo.svg", "<svg><script>alert(1)</script></svg>\n");
    write_page("a b.html", DOXYGEN);
    char *path = test_folder_path(place.pages, "tab.png");
    ck_assert(g_file_set_contents(path, picture, sizeof picture, NULL));
    g_free(path);
    path = test_folder_path(place.pages, "search");
    ck_assert_int_eq(g_mkdir(path, 0777), 0);
    g_free(path);
    ck_assert_int_eq(test_run_all(place.catalogue, place.output), 0);
}

static void tear_down(void)
{
    test_folder_remove(place.pages);
    test_folder_remove(place.output);
    test_folder_remove(place.catalogue);
}

static void expect_status(const char *line, int exit_status, const char *message)
{
    struct test_said said = test_verify(line);
    ck_assert_msg(said.exit_status == exit_status, "%s: %d: %s", line, said.exit_status, said.err);
    ck_assert_msg(strstr(said.err, message) != NULL, "%s: no %s in %s", line, message, said.err);
    test_said_free(&said);
}

/* mpm-verify report of the folder with `options`. */
static void expect_report(const char *options, int exit_status, const char *message)
{
    char *line = g_strdup_printf("mpm-verify report %s --catalogue %s%s", place.output,
                                 place.catalogue, options);
    expect_status(line, exit_status, message);
    g_free(line);
}

static void expect_report_with_pages(const char *pages, int exit_status, const char *message)
{
    char *options = g_strdup_printf(" --api %s", pages);
    expect_report(options, exit_status, message);
    g_free(options);
}

static bool has(const char *name)
{
    char *path = test_folder_path(place.output, name);
    const bool there = test_file_exists(path);
    g_free(path);
    return there;
}

static bool links_to_pages(const char *page, const char *link)
{
    char *text = test_folder_read(place.output, page);
    const bool links = strstr(text, link) != NULL;
    g_free(text);
    return links;
}

static void expect_links(bool linked)
{
    ck_assert_int_eq(links_to_pages("index.html", "<a href=\"api/index.html\">API</a>"), linked);
    ck_assert_int_eq(
        links_to_pages("cases/Q/index.html", "<a href=\"../../api/index.html\">API</a>"), linked);
}

static void expect_copy(void)
{
    char *page = test_folder_read(place.output, "api/index.html");
    ck_assert_msg(g_str_has_prefix(page, POLICY), "%s", page);
    ck_assert_ptr_eq(strstr(strstr(page, POLICY) + 1, POLICY), NULL);
    ck_assert_ptr_nonnull(strstr(page, "\n" DOXYGEN "<body>pages"));
    g_free(page);
    char *path = test_folder_path(place.output, "api/tab.png"), *bytes = NULL;
    gsize length = 0;
    ck_assert(g_file_get_contents(path, &bytes, &length, NULL));
    ck_assert(length == sizeof picture && memcmp(bytes, picture, length) == 0);
    g_free(bytes);
    g_free(path);
    ck_assert(has("api/mpm_8h.html") && has("api/doxygen.css"));
    ck_assert(!has("api/menu.js") && !has("api/logo.svg") && !has("api/search"));
    ck_assert(!has("api/a b.html"));
}

START_TEST(pages_are_copied_without_scripts_and_every_page_leads_to_them)
{
    expect_links(false);
    for (int round = 0; round < 3; round++) { /* the second time they are there, the third kept */
        if (round < 2)
            expect_report_with_pages(place.pages, 0, "");
        else
            expect_report("", 0, "");
        expect_copy();
        expect_links(true);
    }
    char *copy = test_folder_path(place.output, "api");
    expect_report_with_pages(copy, 0, ""); /* of a copy: the same once more */
    expect_copy();
    g_free(copy);
}
END_TEST

START_TEST(a_page_that_is_gone_is_removed_and_a_run_without_pages_removes_all)
{
    expect_report_with_pages(place.pages, 0, "");
    char *gone = test_folder_path(place.pages, "mpm_8h.html");
    ck_assert_int_eq(g_unlink(gone), 0);
    g_free(test_folder_write(place.output, "api/old.html.partial", "half"));
    expect_report_with_pages(place.pages, 0, "");
    ck_assert(!has("api/mpm_8h.html") && !has("api/old.html.partial") && has("api/index.html"));
    ck_assert_int_eq(test_run_all(place.catalogue, place.output), 0);
    ck_assert(!has("api"));
    expect_links(false);
    g_free(gone);
}
END_TEST

START_TEST(a_run_takes_pages_and_one_that_goes_on_has_them_too)
{
    char *line = g_strdup_printf("mpm-verify run --catalogue %s --output %s --api %s",
                                 place.catalogue, place.output, place.pages);
    expect_status(line, 0, "");
    expect_copy();
    expect_links(true);
    char *on = g_strdup_printf("mpm-verify run --resume --output %s", place.output);
    expect_status(on, 0, "");
    expect_copy();
    expect_links(true);
    char *none = g_strdup_printf("mpm-verify run --catalogue %s --output %s --api %s",
                                 place.catalogue, place.output, place.catalogue);
    expect_status(none, 2, "index.html: cannot be read");
    expect_copy(); /* nothing has changed */
    g_free(none);
    g_free(on);
    g_free(line);
}
END_TEST

START_TEST(a_folder_that_is_not_doxygens_is_refused_and_nothing_is_written)
{
    char *own = test_folder_read(place.output, "index.html");
    char *link = test_folder_path(place.pages, "link.html");
    char *options = g_strdup_printf(" --api /dev/null --baseline %s", place.output);
    expect_report_with_pages("/dev/null", 2, "/dev/null/index.html: cannot be read");
    expect_report_with_pages(place.catalogue, 2, "allowed is the html folder of Doxygen");
    expect_report_with_pages(place.output, 2, "index.html: was not written by Doxygen");
    expect_report(options, 2, "cannot be read");
    ck_assert_int_eq(symlink("/etc/passwd", link), 0);
    expect_report_with_pages(place.pages, 2, "link.html: is a link");
    ck_assert(!has("api") && !has("changes.json"));
    char *after = test_folder_read(place.output, "index.html");
    ck_assert_str_eq(own, after);
    g_free(after);
    g_free(options);
    g_free(link);
    g_free(own);
}
END_TEST

/* ---------------------------------------------------------- a folder from elsewhere */

START_TEST(pages_that_could_run_a_script_are_refused)
{
    static const struct {
        const char *name, *text, *message;
        bool replaceable;
    } table[] = {
        {"api/index.html", DOXYGEN "<script>alert(1)</script>", "does not forbid scripts", true},
        {"api/other.html", "", "does not forbid scripts", true},
        {"api/evil.js", "alert(1)", "evil.js: allowed are pages", false},
        {"api/evil.svg", "<svg/>", "evil.svg: allowed are pages", false},
        {"api/evil.xhtml", "", "evil.xhtml: allowed are pages", false},
        {"api/evil.HTML", "", "evil.HTML: allowed are pages", false},
        {"api/.html", "", ".html: allowed are pages", false},
        {"api/a b.html", "", "a b.html: allowed are pages", false},
        {"api/evil.js.partial", "", "evil.js.partial: allowed are pages", false},
    };
    expect_report_with_pages(place.pages, 0, "");
    for (size_t i = 0; i < G_N_ELEMENTS(table); i++) {
        char *path = test_folder_write(place.output, table[i].name, table[i].text);
        g_free(test_folder_write(place.output, "index.html", "as it was"));
        expect_report("", 2, table[i].message);
        char *front = test_folder_read(place.output, "index.html");
        ck_assert_str_eq(front, "as it was");
        g_free(front);
        expect_report_with_pages(place.pages, table[i].replaceable ? 0 : 2, "");
        if (!table[i].replaceable)
            ck_assert_int_eq(g_unlink(path), 0);
        g_free(path);
    }
    expect_report_with_pages(place.pages, 0, "");
    expect_copy();
}
END_TEST

START_TEST(a_script_before_the_line_that_forbids_it_is_refused)
{
    expect_report_with_pages(place.pages, 0, "");
    char *copy = test_folder_read(place.output, "api/index.html");
    char *late = g_strconcat("<script>alert(1)</script>", copy, NULL);
    g_free(test_folder_write(place.output, "api/index.html", late));
    expect_report("", 2, "does not forbid scripts");
    g_free(late);
    g_free(copy);
}
END_TEST

START_TEST(a_link_or_a_folder_among_pages_is_refused)
{
    static const char *const names[] = {"api", "api/index.html", "api/x.png", "api/x.html"};
    expect_report_with_pages(place.pages, 0, "");
    for (size_t i = 0; i < G_N_ELEMENTS(names); i++) {
        char *path = test_folder_path(place.output, names[i]),
             *moved = g_strconcat(path, "-", NULL);
        const bool there = test_file_exists(path);
        ck_assert_int_eq(there ? g_rename(path, moved) : 0, 0);
        ck_assert_int_eq(symlink(i == 0 ? place.pages : "/etc/passwd", path), 0);
        char *away = g_strconcat(place.output, ".moved", NULL); /* out of the folder's way */
        ck_assert_int_eq(there ? g_rename(moved, away) : 0, 0);
        expect_report("", 2, "is a link");
        expect_report_with_pages(place.pages, 2, "is a link");
        ck_assert_int_eq(g_unlink(path), 0);
        ck_assert_int_eq(there ? g_rename(away, path) : 0, 0);
        g_free(away);
        g_free(moved);
        g_free(path);
    }
    char *folder = test_folder_path(place.output, "api/x.html");
    ck_assert_int_eq(g_mkdir(folder, 0777), 0);
    expect_report("", 2, "is a folder");
    g_free(folder);
}
END_TEST

Suite *suite_report_api(void)
{
    Suite *suite = suite_create("report_api");
    TCase *pages = tcase_create("pages");
    tcase_add_checked_fixture(pages, set_up, tear_down);
    tcase_add_test(pages, pages_are_copied_without_scripts_and_every_page_leads_to_them);
    tcase_add_test(pages, a_page_that_is_gone_is_removed_and_a_run_without_pages_removes_all);
    tcase_add_test(pages, a_run_takes_pages_and_one_that_goes_on_has_them_too);
    tcase_add_test(pages, a_folder_that_is_not_doxygens_is_refused_and_nothing_is_written);
    tcase_add_test(pages, pages_that_could_run_a_script_are_refused);
    tcase_add_test(pages, a_script_before_the_line_that_forbids_it_is_refused);
    tcase_add_test(pages, a_link_or_a_folder_among_pages_is_refused);
    suite_add_tcase(suite, pages);
    return suite;
}
