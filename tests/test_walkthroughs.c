/* The walk-throughs of docs/walkthroughs: their commands run, what they show of the output is
 * there, their pictures come out again, what they quote of a scene is in its file, the values of
 * theory are computed here, and numbers of their prose come from these.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/document.h"
#include "support/folder.h"
#include "support/prose.h"
#include "support/skip.h"

#include "verification/exact/heat/heat.h"

#include <glib.h>
#include <math.h>
#include <string.h>

static const double PI = 3.14159265358979323846;

/* What builds may differ by: compilers and SIMD change round-off alone, which a collision
 * magnifies; the texts have six digits. */
static const double TOLERANCE = 2e-3;
static const double PIXELS = 3.0; /* and steps of a colour's 255 */

/* ------------------------------------------------------------------------- theory */

static double two_disks(size_t row)
{
    const double mass = 1.1e-3 * PI * 25.0, run_mass = 0.1738 / 2.0, speed = 4.0;
    const double values[] = {2.0 * mass, mass * speed, 0.5 * run_mass * speed * speed,
                             -run_mass * speed};
    return values[row];
}

static double bar_on_wall(size_t row)
{
    const double density = 1e-3, speed = 0.5, mass = density * 40.0 * 2.0;
    const double wave = sqrt((1.5 + 4.0 / 3.0 * 0.75) / density);
    const double values[] = {-density * wave * speed, 2.0 * 40.0 / wave, 2.0 * mass * speed,
                             mass * speed, 0.5 * mass * speed * speed};
    return values[row];
}

/* Tada, Paris and Irwin, The Stress Analysis of Cracks Handbook, sec. 2.11 */
static double edge_crack(size_t row)
{
    const double length = 5.5, part = length / 10.0, q = 0.5 * PI * part;
    const double bend = 1.0 - sin(q);
    const double k = 0.1 * sqrt(PI * length) * sqrt(tan(q) / q) *
                     (0.752 + 2.02 * part + 0.37 * bend * bend * bend) / cos(q);
    return row % 2 == 0 ? k : k * k / 1000.0;
}

static double heated_cylinder(size_t row)
{
    static const double rows[][2] = {{0.5, 3e3}, {0.5, 6e3}, {10.0, 6e3}, {10.0, 12e3}};
    const double diffusivity = 0.05 / (7.8e-3 * 460.0), radius = 20.0;
    return 100.0 * heat_surface_held(HEAT_CYLINDER, rows[row][0] / radius,
                                     diffusivity * rows[row][1] / (radius * radius));
}

static double rod_on_plate(size_t row)
{
    const double momentum = 0.5 * 7.8e-3 * 9.0 * 30.0 * 1500.0;
    const double values[] = {1455.63 / (1.0 + sqrt(2.7 / 7.8)), momentum, 0.5 * momentum * 1500.0};
    return values[row];
}

static const struct page {
    const char *name;
    double (*theory)(size_t row);
    size_t commands, shown, rows, pictures;
} pages[] = {
    {"basics", NULL, 7, 9, 0, 1},
    {"two-disks", two_disks, 9, 19, 4, 1},
    {"bar-on-wall", bar_on_wall, 10, 17, 5, 1},
    {"edge-crack", edge_crack, 8, 8, 4, 1},
    {"heated-cylinder", heated_cylinder, 9, 15, 4, 1},
    {"rod-on-plate", rod_on_plate, 7, 15, 3, 1},
};

/* Numbers of the prose that no output has. */
static const struct test_prose_claim claims[] = {
    {"basics", "19 %", "100*(1.65298/1.39193 - 1)", "edge-crack"},
    {"basics", "3.6 %", "100*(1.44202/1.39193 - 1)", "edge-crack"},
    {"basics", "7.8e-3", "7800*1e3/1e9", NULL},
    {"basics", "7.8e-9", "7800/1e3/1e9", NULL},
    {"basics", "5190", "sqrt(210e9/7800)", NULL},
    {"two-disks", "0.7 %", "100*(1 - (0.666841 + 0.0246131)/0.696222)", NULL},
    {"two-disks", "0.92", "2*0.333277/0.3476 - 1", NULL},
    {"two-disks", "5.5 %", "100*(0.742901/(0.176/4*4^2) - 1)", NULL},
    {"two-disks", "0.704", "0.176/4*4^2", NULL},
    {"bar-on-wall", "1.2", "(40 + 20)/50", NULL},
    {"edge-crack", "0.5 %", NULL, "Tada, Paris and Irwin, sec. 2.11"},
    {"edge-crack", "0.752", NULL, "Tada, Paris and Irwin, sec. 2.11"},
    {"edge-crack", "2.02", NULL, "Tada, Paris and Irwin, sec. 2.11"},
    {"edge-crack", "0.37", NULL, "Tada, Paris and Irwin, sec. 2.11"},
    {"edge-crack", "19 %", "100*(1.65298/1.39193 - 1)", NULL},
    {"heated-cylinder", "0.01394", "0.05/(7.8e-3*460)", NULL},
    {"heated-cylinder", "0.5 %", "100*(68.2466/67.9299 - 1)", NULL},
};

/* --------------------------------------------------------------------- one page */

struct reading {
    const struct page *page;
    char *folder, *said; /* by the last command */
    GString *shown;      /* lines of output in the page, so far */
    size_t commands, shown_lines, rows, pictures;
};

static void run(struct reading *reading, const char *line)
{
    struct test_command command = test_document_run(line, reading->folder, "");
    ck_assert_msg(command.exit_status == 0, "%s: %s%s", line, command.output, command.errors);
    g_free(reading->said);
    reading->said = g_strconcat(command.output, command.errors, NULL);
    test_command_free(&command);
    reading->commands++;
}

static void assert_said(struct reading *reading, const char *line)
{
    char **lines = g_strsplit(reading->said, "\n", -1);
    bool found = false;
    for (char **said = lines; *said != NULL && !found; said++)
        found = test_words_agree(line, *said, TOLERANCE);
    ck_assert_msg(found, "%s: \"%s\" is not in: %s", reading->page->name, line, reading->said);
    g_strfreev(lines);
    g_string_append_printf(reading->shown, " %s \n", line);
    reading->shown_lines++;
}

/* "| quantity | run | theory | difference |" */
static void assert_compared(struct reading *reading, const char *line)
{
    char **cells = g_strsplit(line, " | ", -1), *word = g_strdup_printf(" %s ", cells[1]);
    ck_assert_uint_eq(g_strv_length(cells), 4);
    char *shown = test_text_replaced(g_strdup(reading->shown->str), "\n", " ");
    ck_assert_msg(strstr(shown, word) != NULL, "%s: %s was shown by no command",
                  reading->page->name, cells[1]);
    const double ran = g_ascii_strtod(cells[1], NULL), stated = g_ascii_strtod(cells[2], NULL),
                 difference = g_ascii_strtod(cells[3], NULL);
    const double theory = reading->page->theory(reading->rows);
    ck_assert_msg(fabs(stated - theory) <= 6e-6 * fabs(theory), "%s: theory is %.9g", line, theory);
    ck_assert_msg(fabs(100.0 * (ran / theory - 1.0) - difference) <= 0.0501, "%s: it is %+.2f %%",
                  line, 100.0 * (ran / theory - 1.0));
    g_free(shown);
    g_free(word);
    g_strfreev(cells);
    reading->rows++;
}

/* "](two-disks-von_mises-000001.svg)" is plot-von_mises-000001.svg of the results. */
static void assert_drawn(struct reading *reading, const char *target)
{
    const size_t length = strlen(reading->page->name);
    char *name = g_strndup(target, strcspn(target, ")"));
    char *drawn =
        g_strdup_printf("%s/%s/plot-%s", reading->folder, reading->page->name, name + length + 1);
    char *kept = g_build_filename("docs/walkthroughs", name, NULL), *text = test_file_read(drawn);
    if (g_strcmp0(g_getenv("WALKTHROUGH_PICTURES"), "write") == 0)
        ck_assert(g_file_set_contents(kept, text, -1, NULL));
    char *picture = test_file_read(kept);
    ck_assert_msg(test_pictures_agree(picture, text, PIXELS), "%s is another picture than %s", kept,
                  drawn);
    g_free(picture);
    g_free(text);
    g_free(kept);
    g_free(drawn);
    g_free(name);
    reading->pictures++;
}

static void read_line(struct reading *reading, const char *line, const char *section)
{
    char *picture = g_strconcat("](", reading->page->name, "-", NULL);
    const char *target = strstr(line, picture);
    if (test_document_command(line))
        run(reading, line);
    else if (g_str_has_prefix(line, "    "))
        assert_said(reading, line + 4);
    else if (strcmp(section, "## Compared with theory") == 0 && g_str_has_prefix(line, "| ") &&
             strstr(line, "| theory |") == NULL)
        assert_compared(reading, line);
    else if (target != NULL)
        assert_drawn(reading, target + 2);
    g_free(picture);
}

/* What stands between ```yaml and ``` is in the scene, line by line. */
static void assert_quoted(const struct page *page, const char *text)
{
    char *path = g_strdup_printf("docs/walkthroughs/%s.yaml", page->name);
    char *scene = test_file_read(path), **parts = g_strsplit(text, "```", -1);
    size_t quotes = 0;
    ck_assert_uint_eq(g_strv_length(parts) % 2, 1);
    for (guint k = 1; k < g_strv_length(parts); k += 2, quotes++) {
        ck_assert_msg(g_str_has_prefix(parts[k], "yaml\n"), "%s", parts[k]);
        ck_assert_msg(strstr(scene, parts[k] + strlen("yaml\n")) != NULL, "not in %s: %s", path,
                      parts[k]);
    }
    ck_assert_uint_ge(quotes, 1);
    g_strfreev(parts);
    g_free(scene);
    g_free(path);
}

static bool has_program(const char *name)
{
    char *path = g_find_program_in_path(name);
    const bool found = path != NULL;
    g_free(path);
    return found;
}

/* Sanitizers make the longest run, of seconds, one of minutes, and find no more in it than in the
 * tests of what it calls. */
static const char *reason_to_skip(void)
{
    const char *const variant = g_getenv("MPM_VARIANT");
    if (variant != NULL && strcmp(variant, "release") != 0)
        return "the documents are run by the release build";
    return has_program("python3") && has_program("gnuplot") && g_getenv("MPM_BIN") != NULL
               ? NULL
               : "needs MPM_BIN, python3 and gnuplot";
}

START_TEST(the_walkthrough_does_what_it_says)
{
    const char *const reason = reason_to_skip();
    if (reason != NULL)
        TEST_SKIP(reason);
    const struct page *page = &pages[_i];
    struct reading reading = {page, test_folder_create(), g_strdup(""), g_string_new(NULL), 0, 0, 0,
                              0};
    char *path = g_strdup_printf("docs/walkthroughs/%s.md", page->name);
    char *text = test_file_read(path), **parts = g_strsplit(text, "```", -1);
    char *section = g_strdup("");
    assert_quoted(page, text);
    for (guint k = 0; k < g_strv_length(parts); k += 2) {
        char **lines = g_strsplit(parts[k], "\n", -1);
        for (char **line = lines; *line != NULL; line++) {
            if (g_str_has_prefix(*line, "## ")) {
                g_free(section);
                section = g_strdup(*line);
            }
            read_line(&reading, *line, section);
        }
        g_strfreev(lines);
    }
    ck_assert_msg(reading.commands == page->commands && reading.shown_lines == page->shown &&
                      reading.rows == page->rows && reading.pictures == page->pictures,
                  "%s: %zu commands, %zu lines of output, %zu rows, %zu pictures", page->name,
                  reading.commands, reading.shown_lines, reading.rows, reading.pictures);
    g_free(section);
    g_strfreev(parts);
    g_free(text);
    g_free(path);
    g_string_free(reading.shown, TRUE);
    g_free(reading.said);
    test_folder_remove(reading.folder);
}
END_TEST

START_TEST(numbers_of_the_prose_come_from_what_is_shown)
{
    char *fault =
        test_prose_judge("docs/walkthroughs", pages[_i].name, claims, G_N_ELEMENTS(claims));
    ck_assert_msg(fault == NULL, "%s", fault);
}
END_TEST

START_TEST(a_number_of_the_prose_that_comes_from_nowhere_is_found)
{
    static const struct {
        const char *prose;
        struct test_prose_claim claim;
        const char *fault; /* NULL: none */
    } pages_of_test[] = {
        {"It is 1.23 mm, not `9.9`, [here](a-7.7.md).", {"p", "", NULL, NULL}, NULL},
        {"It is 1.24 mm.", {"p", "", NULL, NULL}, "p: 1.24 comes from no output, scene or claim"},
        {"It has 0.5 and 4 parts.", {"p", "", NULL, NULL}, NULL},
        {"It is 4 % more.", {"p", "", NULL, NULL}, "p: 4 % comes from no output, scene or claim"},
        {"It is 3 % more.", {"p", "", NULL, NULL}, NULL},
        {"It is 23 % more.", {"p", "23 %", "100*(1.2345 - 1)", NULL}, NULL},
        {"It is 24 % more.",
         {"p", "24 %", "100*(1.2345 - 1)", NULL},
         "p: 24 %: 100*(1.2345 - 1) is 23.45"},
        {"It is 23 % more.",
         {"p", "23 %", "100*(1.234 - 1)", NULL},
         "p: 23 %: 1.234 of 100*(1.234 - 1) is shown nowhere"},
        {"It is 8.31.", {"p", "8.31", NULL, "a handbook"}, NULL},
        {"It is 8.31.", {"p", "8.31", NULL, NULL}, "p: 8.31: literature has no name"},
        {"It is gone.", {"p", "23 %", "23", NULL}, "p: the claim 23 % is not in the prose"},
    };
    char *folder = test_folder_create();
    g_free(test_folder_write(folder, "p.yaml", "length: 0.5\n"));
    for (size_t k = 0; k < G_N_ELEMENTS(pages_of_test); k++) {
        char *text = g_strdup_printf("%s\n\n    width 1.2345\n\n## Compared with theory\n\n"
                                     "| a | 1 | 2 | +3.1 %% |\n",
                                     pages_of_test[k].prose);
        g_free(test_folder_write(folder, "p.md", text));
        const unsigned count = pages_of_test[k].claim.number[0] == '\0' ? 0 : 1;
        char *fault = test_prose_judge(folder, "p", &pages_of_test[k].claim, count);
        ck_assert_msg(g_strcmp0(fault, pages_of_test[k].fault) == 0, "%s: %s",
                      pages_of_test[k].prose, fault);
        g_free(fault);
        g_free(text);
    }
    test_folder_remove(folder);
}
END_TEST

START_TEST(pictures_are_compared)
{
    static const char one[] = "<desc>5</desc><text x=\"10\">0.5</text><path d='M1,2 L30,4'/>";
    static const struct {
        const char *other;
        bool agree;
    } pictures[] = {
        {one, true},
        {"<desc>5</desc><text x=\"11\">0.5</text><path d='M1,2\n L29.5,4'/>", true},
        {"<desc>5</desc><text x=\"10\">0.6</text><path d='M1,2 L30,4'/>", false},
        {"<desc>5</desc><text x=\"10\">0.5</text><path d='M1,2 L40,4'/>", false},
        {"<desc>5</desc><text x=\"10\">0.5</text><path d='M1,2 L30,4 L3,4'/>", false},
        {"<desc>6</desc>", true},
    };
    for (size_t k = 0; k < G_N_ELEMENTS(pictures); k++)
        ck_assert_msg(test_pictures_agree(one, pictures[k].other, 3.0) == pictures[k].agree, "%s",
                      pictures[k].other);
}
END_TEST

Suite *suite_walkthroughs(void)
{
    Suite *suite = suite_create("walkthroughs");
    TCase *tcase = tcase_create("walkthroughs");
    tcase_add_test(tcase, pictures_are_compared);
    tcase_add_test(tcase, a_number_of_the_prose_that_comes_from_nowhere_is_found);
    tcase_add_loop_test(tcase, numbers_of_the_prose_come_from_what_is_shown, 0,
                        (int)G_N_ELEMENTS(pages));
    tcase_add_loop_test(tcase, the_walkthrough_does_what_it_says, 0, (int)G_N_ELEMENTS(pages));
    tcase_set_timeout(tcase, 120);
    suite_add_tcase(suite, tcase);
    return suite;
}
