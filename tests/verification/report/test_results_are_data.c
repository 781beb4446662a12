/* A folder of results from elsewhere is data: nothing in it is run, and no name or text of it leads
 * out of its place.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/catalogue.h"
#include "support/folder.h"
#include "support/verify.h"

#include "verification/common/record.h"

#include <glib.h>
#include <glib/gstdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* The run of a small catalogue, and a folder beside both that nothing may be written to. */
struct place {
    char *catalogue, *output, *elsewhere;
};

static struct place place_open(void)
{
    const struct place place = {test_folder_create(), test_folder_create(), test_folder_create()};
    test_case_write_quadrature(place.catalogue);
    struct test_said said =
        test_verify_with("mpm-verify run --catalogue @ --output @", place.catalogue, place.output);
    ck_assert_msg(said.exit_status == 0, "%s", said.err);
    test_said_free(&said);
    return place;
}

static void place_close(struct place *place)
{
    GDir *directory = g_dir_open(place->elsewhere, 0, NULL);
    ck_assert_msg(g_dir_read_name(directory) == NULL, "something was written elsewhere");
    g_dir_close(directory);
    test_folder_remove(place->elsewhere);
    test_folder_remove(place->output);
    test_folder_remove(place->catalogue);
}

static struct test_said report_of(const struct place *place)
{
    return test_verify_with("mpm-verify report @ --catalogue @", place->output, place->catalogue);
}

static void write_at(const char *folder, const char *name, const char *text)
{
    char *path = g_build_filename(folder, name, NULL), *home = g_path_get_dirname(path);
    ck_assert_int_eq(g_mkdir_with_parents(home, 0777), 0);
    ck_assert(g_file_set_contents(path, text, -1, NULL));
    g_free(home);
    g_free(path);
}

/* The first `from` of a file becomes `to`. */
static void replace_in(const char *folder, const char *name, const char *from, const char *to)
{
    char *text = test_folder_read(folder, name), *found = strstr(text, from);
    ck_assert_msg(found != NULL, "%s", from);
    *found = '\0';
    char *changed = g_strconcat(text, to, found + strlen(from), NULL);
    write_at(folder, name, changed);
    g_free(changed);
    g_free(text);
}

static void assert_refused(const struct place *place, const char *message, const char *what)
{
    struct test_said said = report_of(place);
    ck_assert_msg(said.exit_status == 2, "%s: %d %s", what, said.exit_status, said.err);
    ck_assert_msg(strstr(said.err, message) != NULL, "%s: %s", what, said.err);
    test_said_free(&said);
}

/* ------------------------------------------------------------------- scripts */

START_TEST(scripts_pages_and_styles_in_a_folder_are_not_used)
{
    struct place place = place_open();
    char *evil =
        g_strdup_printf("system \"echo x > %s/mark\"\nset title 'evil'\nplot 1\n", place.elsewhere);
    static const char *const scripts[] = {
        "cases/Q/source/curve.gp", "cases/Q/curve.gp", "style/style.gp",  "style/comparison.gp",
        "cases/Q/.gnuplot",        ".gnuplot",         "style/page.html", "style/table.js",
        "style/report.css",        "style/glossary.md"};
    char *before = test_folder_read(place.output, "cases/Q/figure-curve.svg");
    for (size_t i = 0; i < G_N_ELEMENTS(scripts); i++)
        write_at(place.output, scripts[i], evil);
    struct test_said said = report_of(&place);
    ck_assert_msg(said.exit_status == 0, "%s", said.err);
    char *page = test_folder_read(place.output, "cases/Q/index.html");
    char *after = test_folder_read(place.output, "cases/Q/figure-curve.svg");
    ck_assert_ptr_null(strstr(page, "evil"));
    ck_assert_str_eq(before, after);
    g_free(before);
    g_free(after);
    g_free(page);
    g_free(evil);
    test_said_free(&said);
    place_close(&place);
}
END_TEST

START_TEST(a_run_leaves_no_scripts_behind)
{
    struct place place = place_open();
    static const char *const gone[] = {"style", "cases/Q/source"};
    for (size_t i = 0; i < G_N_ELEMENTS(gone); i++) {
        char *path = test_folder_path(place.output, gone[i]);
        ck_assert_msg(!test_file_exists(path), "%s", path);
        g_free(path);
    }
    place_close(&place);
}
END_TEST

START_TEST(a_page_states_what_the_catalogue_no_longer_has)
{
    static const struct {
        const char *file, *text; /* of the catalogue; NULL: removed */
        const char *page;
        bool drawn;
    } table[] = {
        {"T/Q/curve.gp", "load style\nplot x\n", "another one than the run had", true},
        {"T/Q/curve.gp", NULL, "its script curve.gp is not in the catalogue", false},
        {"T/Q", NULL, "case Q is not in the catalogue", false},
    };
    struct place place = place_open();
    char *page = test_folder_read(place.output, "cases/Q/index.html");
    ck_assert_ptr_null(strstr(page, "than the run had"));
    g_free(page);
    for (size_t i = 0; i < G_N_ELEMENTS(table); i++) {
        if (table[i].text != NULL) {
            write_at(place.catalogue, table[i].file, table[i].text);
        } else {
            char *old = test_folder_path(place.catalogue, table[i].file);
            char *new = g_strconcat(old, ".old", NULL);
            ck_assert_int_eq(g_rename(old, new), 0);
            g_free(old);
            g_free(new);
        }
        struct test_said said = report_of(&place);
        page = test_folder_read(place.output, "cases/Q/index.html");
        ck_assert_msg(said.exit_status == 0, "%s", said.err);
        ck_assert_msg(strstr(page, table[i].page) != NULL, "%s", table[i].page);
        ck_assert_int_eq(strstr(page, "<img") != NULL, table[i].drawn);
        test_said_free(&said);
        g_free(page);
    }
    place_close(&place);
}
END_TEST

START_TEST(a_run_that_recorded_no_script_has_that_stated)
{
    struct place place = place_open();
    replace_in(place.output, "checks.jsonl", "script_sha256", "script_md5");
    struct test_said said = report_of(&place);
    char *page = test_folder_read(place.output, "cases/Q/index.html");
    ck_assert_int_eq(said.exit_status, 0);
    ck_assert_ptr_nonnull(strstr(page, "did not record which script"));
    g_free(page);
    test_said_free(&said);
    place_close(&place);
}
END_TEST

/* --------------------------------------------------------------------- paths */

START_TEST(a_name_that_leads_out_of_the_folder_is_refused)
{
    static const struct {
        const char *from, *to;
    } table[] = {
        {"\"case\":\"Q\"", "\"case\":\"../../x\""},
        {"\"case\":\"Q\"", "\"case\":\"/tmp/x\""},
        {"\"case\":\"Q\"", "\"case\":\"..\""},
        {"\"case\":\"Q\"", "\"case\":\"\""},
        {"\"case\":\"Q\"", "\"case\":\"<x>\""},
        {"\"family\":\"T\"", "\"family\":\"../..\""},
        {"\"figure\":\"curve\"", "\"figure\":\"../x\""},
        {"\"script\":\"curve.gp\"", "\"script\":\"../../x.gp\""},
        {"\"script\":\"curve.gp\"", "\"script\":\"/tmp/x.gp\""},
        {"\"script\":\"curve.gp\"", "\"script\":\"< date .gp\""},
        {"\"script\":\"curve.gp\"", "\"script\":\"-e.gp\""},
        {"\"script\":\"curve.gp\"", "\"script\":\".gp\""},
        {"\"variant\":\"cubic\"", "\"variant\":\"a'; system('date'); b='\""},
        {"\"variant\":\"cubic\"", "\"variant\":\"../x\""},
        {"\"cases\":[", "\"cases\":[{\"family\":\"T\",\"case\":\"Q\"},"},
    };
    for (size_t i = 0; i < G_N_ELEMENTS(table); i++) {
        struct place place = place_open();
        replace_in(place.output, "checks.jsonl", table[i].from, table[i].to);
        assert_refused(&place, "checks.jsonl:1: is no record of a run: cases.", table[i].to);
        place_close(&place);
    }
}
END_TEST

START_TEST(a_link_in_a_folder_of_results_is_refused)
{
    static const char *const names[] = {"checks.jsonl",
                                        "measurements.jsonl",
                                        "cases",
                                        "cases/Q",
                                        "cases/Q/data-cubic-curve.dat",
                                        "cases/Q/rows-cubic.jsonl",
                                        "changes.json",
                                        "headroom.json",
                                        "mutants.json"};
    for (size_t i = 0; i < G_N_ELEMENTS(names); i++) {
        struct place place = place_open();
        char *path = test_folder_path(place.output, names[i]);
        char *moved = g_strconcat(place.output, ".moved", NULL);
        (void)g_rename(path, moved); /* some are not there */
        const bool folder = i == 2 || i == 3;
        ck_assert_int_eq(symlink(folder ? place.elsewhere : moved, path), 0);
        assert_refused(&place, "is a link", names[i]);
        ck_assert_int_eq(g_unlink(path), 0);
        if (!folder && g_file_test(moved, G_FILE_TEST_EXISTS))
            ck_assert_int_eq(g_unlink(moved), 0);
        else
            ck_assert(!folder || g_rename(moved, path) == 0);
        g_free(moved);
        g_free(path);
        place_close(&place);
    }
}
END_TEST

START_TEST(a_file_under_a_name_that_no_run_gives_is_refused)
{
    static const char *const names[] = {"data-a b.dat",
                                        "data-'; system('x'); '.dat",
                                        "data-\"><script>alert(1)<.dat",
                                        "data-|date.dat",
                                        "rows-\xff.jsonl",
                                        "data-\x1b[2J.dat"};
    struct place place = place_open();
    for (size_t i = 0; i < G_N_ELEMENTS(names); i++) {
        char *path = g_build_filename(place.output, "cases", "Q", names[i], NULL);
        ck_assert(g_file_set_contents(path, "1 2\n", -1, NULL));
        assert_refused(&place, "is no name of a run's file", names[i]);
        ck_assert_int_eq(g_unlink(path), 0);
        g_free(path);
    }
    char *pipe = g_build_filename(place.output, "cases", "Q", "data-pipe.dat", NULL);
    ck_assert_int_eq(mkfifo(pipe, 0600), 0);
    assert_refused(&place, "is no ordinary file", "a pipe");
    g_free(pipe);
    place_close(&place);
}
END_TEST

/* -------------------------------------------------------------------- records */

START_TEST(a_record_of_the_wrong_kind_is_refused_with_its_line)
{
    static const struct {
        const char *from, *to, *fault;
    } table[] = {
        {"\"title\":\"Gauss quadrature\"", "\"title\":[]",
         ":1: is no record of a run: cases.0.title"},
        {"\"needs\":[", "\"needs\":[1,", ":1: is no record of a run: cases.0.figures.0.needs"},
        {"\"figures\":[", "\"figures\":[7,", ":1: is no record of a run: cases.0.figures.0"},
        {"\"variants\":[", "\"variants\":{},\"x\":[",
         ":1: is no record of a run: cases.0.variants"},
        {"\"jobs\":", "\"jobs\":-", ":1: is no record of a run: jobs"},
        {"\"seconds\":", "\"seconds\":1e999,\"x\":", ":1: is no record of a run: "},
        {"\"seconds\":", "\"seconds\":99999999999999999999,\"x\":", ":1: is no record of a run: "},
        {"\"particle_steps\":", "\"particle_steps\":1e5,\"x\":",
         ":1: is no record of a run: cases.0.variants.0.particle_steps"},
        {"{\"kind\":\"check\"", "{\"kind\":\"check\",\"value\":NaN", ":2: is no record of a check"},
        {"{\"kind\":\"check\"", "{\"kind\":\"check\",\"low\":\"1\",\"x\":{\"low\":1}",
         ":2: is no record"},
        {"\"mutations\":", "\"mutations\":-1,\"x\":", ":2: is no record of a check: mutations"},
        {"\"quantity\":\"integral\"", "\"quantity\":null", ":2: is no record of a check: quantity"},
        {"\"basis\":\"theory\"", "\"basis\":{}", ":2: is no record of a check: basis"},
        {"\"status\":\"pass\"", "\"status\":\"well\"", ":2: is no record of a check: status"},
        {"\"reason\":\"\"", "\"reason\":\"\\u001b[2J\"", ":2: is no record of a check: a text has"},
        {"\"reason\":\"\"", "\"reason\":\"\\u009b2J\"", ":2: is no record of a check: a text has"},
        {"\"reason\":\"\"", "\"reason\":\"\\uffff\"", ":2: is no record of a check: a text has"},
        {"\"kind\":\"check\"", "\"a\\u0007\":1", ":2: is no record of a check: a text has"},
    };
    struct place place = place_open();
    char *whole = test_folder_read(place.output, "checks.jsonl");
    for (size_t i = 0; i < G_N_ELEMENTS(table); i++) {
        replace_in(place.output, "checks.jsonl", table[i].from, table[i].to);
        assert_refused(&place, table[i].fault, table[i].to);
        write_at(place.output, "checks.jsonl", whole);
    }
    GString *deep = g_string_new(whole);
    for (int i = 0; i < 100000; i++)
        g_string_append_c(deep, '[');
    write_at(place.output, "checks.jsonl", deep->str);
    assert_refused(&place, "checks.jsonl:4: is no record of a check", "nested");
    g_string_free(deep, TRUE);
    g_free(whole);
    place_close(&place);
}
END_TEST

/* ---------------------------------------------------------------------- texts */

/* Ends a text of gnuplot, of HTML, of an attribute, of a comment and of CDATA, and then acts. */
static char *evil_text(const struct place *place)
{
    return g_strdup_printf("'; system('echo x > %s/mark'); x='`echo x > %s/mark` --> ]]> "
                           "\"><script>alert(1)</script><img src=x onerror=alert(1)>",
                           place->elsewhere, place->elsewhere);
}

/* Every text becomes `evil` but names, kinds and what decides which page is made. */
static void spoil(json_t *value, const char *evil)
{
    static const char *const kept[] = {
        "kind",    "family",   "case",   "check",    "variant", "figure", "script",  "status",
        "outcome", "pareto_x", "better", "pareto_y", "main",    "needs",  "section", "change"};
    const char *key;
    json_t *member;
    void *next;
    json_object_foreach_safe(value, next, key, member)
    {
        bool keep = strcmp(key, "quantity") == 0;
        for (size_t i = 0; i < G_N_ELEMENTS(kept); i++)
            keep = keep || strcmp(key, kept[i]) == 0;
        if (json_is_string(member) && !keep)
            json_object_set_new(value, key, json_string(evil));
        else if (!keep)
            spoil(member, evil);
    }
    for (size_t i = 0; i < json_array_size(value); i++)
        if (json_is_string(json_array_get(value, i)))
            json_array_set_new(value, i, json_string(evil));
        else
            spoil(json_array_get(value, i), evil);
}

/* A comparison with a picture of both variants, and two parts of their names. */
static const char comparison[] =
    "\"figures\":[],\"comparison\":{\"title\":\"t\",\"columns\":["
    "{\"quantity\":\"integral\",\"title\":\"t\",\"unit\":\"u\",\"better\":\"zero\",\"about\":\"\"},"
    "{\"quantity\":\"cpu_seconds\",\"title\":\"t\",\"unit\":\"u\",\"better\":\"low\"}],"
    "\"pareto_x\":\"cpu_seconds\",\"pareto_y\":\"integral\",\"main\":\"integral\",\"notes\":[\"n\"]"
    ","
    "\"parts\":[{\"part\":\"c*\",\"kind\":\"order\",\"title\":\"t\"},"
    "{\"part\":\"n*';x='`date`\",\"kind\":\"shape\",\"title\":\"t\"}]},\"old_figures\":[";

static void spoil_file(const struct place *place, const char *name)
{
    char *text = test_folder_read(place->output, name), *evil = evil_text(place);
    char **lines = g_strsplit(text, "\n", -1);
    GString *spoiled = g_string_new(NULL);
    for (char **line = lines; *line != NULL && **line != '\0'; line++) {
        json_t *object = json_loads(*line, 0, NULL);
        spoil(object, evil);
        char *written = json_dumps(object, JSON_COMPACT | JSON_PRESERVE_ORDER);
        g_string_append_printf(spoiled, "%s\n", written);
        free(written);
        json_decref(object);
    }
    write_at(place->output, name, spoiled->str);
    g_string_free(spoiled, TRUE);
    g_strfreev(lines);
    g_free(evil);
    g_free(text);
}

static unsigned assert_pages_sound(const char *folder)
{
    unsigned count = 0;
    GDir *directory = g_dir_open(folder, 0, NULL);
    for (const char *name; (name = g_dir_read_name(directory)) != NULL;) {
        char *path = g_build_filename(folder, name, NULL);
        if (g_file_test(path, G_FILE_TEST_IS_DIR)) {
            count += assert_pages_sound(path);
        } else if (g_str_has_suffix(name, ".html") || g_str_has_suffix(name, ".svg") ||
                   g_str_has_suffix(name, ".xml")) {
            char *text = test_file_read(path);
            ck_assert_msg(strstr(text, "<script>alert") == NULL, "%s", path);
            ck_assert_msg(strstr(text, "<img src=x") == NULL, "%s", path);
            test_assert_well_formed(text, path);
            g_free(text);
            count++;
        }
        g_free(path);
    }
    g_dir_close(directory);
    return count;
}

START_TEST(a_text_of_any_kind_stays_a_text_on_every_page)
{
    for (unsigned pictured = 0; pictured < 2; pictured++) {
        struct place place = place_open();
        if (pictured == 1)
            replace_in(place.output, "checks.jsonl", "\"figures\":[", comparison);
        spoil_file(&place, "checks.jsonl");
        spoil_file(&place, "measurements.jsonl");
        struct test_said said = report_of(&place);
        ck_assert_msg(said.exit_status == 0, "%s", said.err);
        ck_assert_uint_ge(assert_pages_sound(place.output), 8);
        char *picture =
            test_folder_read(place.output, pictured == 1 ? "cases/Q/figure-comparison.svg"
                                                         : "cases/Q/figure-curve.svg");
        ck_assert_ptr_nonnull(strstr(picture, "system"));
        g_free(picture);
        test_said_free(&said);
        place_close(&place);
    }
}
END_TEST

START_TEST(a_stored_file_of_the_wrong_kind_is_refused)
{
    static const char *const table[][3] = {
        {"changes.json", "{\"format\":1}", "changes.json: before"},
        {"changes.json", "{\"format\":1,\n\"before\"}", "changes.json:2: "},
        {"headroom.json", "{\"format\":1,\"builds\":[{\"name\":[]}]}",
         "headroom.json: builds.0.name"},
        {"headroom.json", "{\"format\":1,\"builds\":[{\"name\":\"\",\"values\":{\"a\":\"b\"}}]}",
         "headroom.json: builds.0.values"},
        {"mutants.json", "{\"format\":1,\"mutants\":[{\"name\":\"\\u001b\"}]}",
         "mutants.json: a text has"},
        {"mutants.json", "[]", "mutants.json: allowed is an object"},
    };
    struct place place = place_open();
    for (size_t i = 0; i < G_N_ELEMENTS(table); i++) {
        write_at(place.output, table[i][0], table[i][1]);
        assert_refused(&place, table[i][2], table[i][1]);
        char *path = test_folder_path(place.output, table[i][0]);
        ck_assert_int_eq(g_unlink(path), 0);
        g_free(path);
    }
    place_close(&place);
}
END_TEST

START_TEST(compare_and_headroom_refuse_the_same)
{
    static const char *const commands[] = {"mpm-verify compare @ @", "mpm-verify headroom @",
                                           "mpm-verify report @ --baseline @",
                                           "mpm-verify report @ --headroom b=@"};
    struct place place = place_open(), bad = place_open();
    replace_in(bad.output, "checks.jsonl", "\"reason\":\"\"", "\"reason\":\"\\u001b[2J\"");
    for (size_t i = 0; i < G_N_ELEMENTS(commands); i++) {
        const bool first = i == 1;
        struct test_said said = test_verify_with(commands[i], first ? bad.output : place.output,
                                                 first ? NULL : bad.output);
        ck_assert_msg(said.exit_status == 2, "%s: %s", commands[i], said.err);
        ck_assert_msg(strstr(said.err, "checks.jsonl:2: ") != NULL, "%s", said.err);
        test_said_free(&said);
    }
    place_close(&bad);
    place_close(&place);
}
END_TEST

START_TEST(a_record_of_any_bytes_can_be_read_back)
{
    json_t *text = record_text_of("a\x1b[2J \xc2\x9b \xef\xbf\xbf \xff\tb\n");
    ck_assert_str_eq(json_string_value(text), "a?[2J ? ? \xef\xbf\xbd\tb\n");
    json_decref(text);
}
END_TEST

Suite *suite_results_are_data(void)
{
    Suite *suite = suite_create("results_are_data");
    TCase *scripts = tcase_create("scripts");
    tcase_add_test(scripts, scripts_pages_and_styles_in_a_folder_are_not_used);
    tcase_add_test(scripts, a_run_leaves_no_scripts_behind);
    tcase_add_test(scripts, a_page_states_what_the_catalogue_no_longer_has);
    tcase_add_test(scripts, a_run_that_recorded_no_script_has_that_stated);
    suite_add_tcase(suite, scripts);
    TCase *paths = tcase_create("paths");
    tcase_add_test(paths, a_name_that_leads_out_of_the_folder_is_refused);
    tcase_add_test(paths, a_link_in_a_folder_of_results_is_refused);
    tcase_add_test(paths, a_file_under_a_name_that_no_run_gives_is_refused);
    suite_add_tcase(suite, paths);
    TCase *records = tcase_create("records");
    tcase_add_test(records, a_record_of_the_wrong_kind_is_refused_with_its_line);
    tcase_add_test(records, a_text_of_any_kind_stays_a_text_on_every_page);
    tcase_add_test(records, a_stored_file_of_the_wrong_kind_is_refused);
    tcase_add_test(records, compare_and_headroom_refuse_the_same);
    tcase_add_test(records, a_record_of_any_bytes_can_be_read_back);
    suite_add_tcase(suite, records);
    return suite;
}
