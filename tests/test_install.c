/* An installed copy, as programs of others see it: compiled, linked and run with what pkg-config
 * says. `make test` installs the copy, and names it in MPM_INSTALLED.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "mpm.h"
#include "suites.h"
#include "support/command.h"
#include "support/folder.h"
#include "support/skip.h"

#include <glib.h>
#include <string.h>

static const char *installed(void)
{
    return g_getenv("MPM_INSTALLED");
}

/* Programs without a sanitizer cannot load a library with one, and those with one are no example.
 */
static const char *reason_to_skip(void)
{
    const char *const variant = g_getenv("MPM_VARIANT");
    if (installed() == NULL)
        return "MPM_INSTALLED is not set: `make test` sets it";
    if (variant != NULL && strcmp(variant, "release") != 0 && strcmp(variant, "debug") != 0)
        return "the library of this variant needs runtimes that other programs do not have";
    return NULL;
}

#define SKIP_WITHOUT_COPY()                                                                        \
    do {                                                                                           \
        const char *const reason = reason_to_skip();                                               \
        if (reason != NULL)                                                                        \
            TEST_SKIP(reason);                                                                     \
    } while (0)

/* Runs a line of the shell that sees the copy; the test fails unless its exit status is
 * `expected`. Returns the output (g_free), errors after it. */
static char *shell(int expected, const char *format, ...) __attribute__((format(printf, 2, 3)));
static char *shell(int expected, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    char *const line = g_strdup_vprintf(format, arguments);
    va_end(arguments);
    char *const whole = g_strdup_printf("I='%s'; export PKG_CONFIG_PATH=$I/lib/pkgconfig "
                                        "LD_LIBRARY_PATH=$I/lib CC='%s'; : ${CC:=cc}; "
                                        "exec 2>&1; set -e; %s",
                                        installed(), g_getenv("MPM_CC"), line);
    struct test_command command = test_command_run("/bin/sh", "-c", whole, NULL);
    ck_assert_msg(command.exit_status == expected, "exit status %d of: %s\n%s", command.exit_status,
                  line, command.output);
    char *const output = g_strdup(command.output);
    test_command_free(&command);
    g_free(whole);
    g_free(line);
    return output;
}

static bool has_program(const char *name)
{
    char *const path = g_find_program_in_path(name);
    g_free(path);
    return path != NULL;
}

/* ------------------------------------------------------------------- names */

START_TEST(versions_agree)
{
    SKIP_WITHOUT_COPY();
    char *const expected =
        g_strdup_printf("%d.%d.%d", MPM_VERSION_MAJOR, MPM_VERSION_MINOR, MPM_VERSION_PATCH);
    ck_assert_str_eq(mpm_build_info()->version, expected);
    char *const citation = test_file_read("CITATION.cff");
    char *const line = g_strdup_printf("\nversion: %s\n", expected);
    ck_assert_ptr_nonnull(strstr(citation, line));
    char *const package = shell(0, "pkg-config --modversion touchstone");
    ck_assert_str_eq(g_strstrip(package), expected);
    char *const program = shell(0, "$I/bin/mpm --version");
    ck_assert_ptr_nonnull(strstr(program, expected));
    g_free(package);
    g_free(program);
    g_free(line);
    g_free(citation);
    g_free(expected);
}
END_TEST

START_TEST(one_library_is_to_be_named)
{
    SKIP_WITHOUT_COPY();
    char *const flags = shell(0, "pkg-config --libs-only-l touchstone");
    ck_assert_str_eq(g_strstrip(flags), "-lmpm");
    char *const all = shell(0, "pkg-config --static --libs-only-l touchstone");
    ck_assert(g_str_has_prefix(all, "-lmpm "));
    ck_assert_ptr_null(strstr(all + 1, "-lmpm"));
    ck_assert_ptr_nonnull(strstr(all, "-lmuparser"));
    g_free(flags);
    g_free(all);
}
END_TEST

/* What the headers declare, with their comments left out, one name a line. */
static char *declared_names(void)
{
    return shell(
        0, "for h in $I/include/mpm*.h; do $CC -E -P -I$I/include -include $h -x c /dev/null; "
           "done | grep -o 'mpm_[a-z0-9_]*(\\|mpm_kind_[a-z]*' | tr -d ' (' | sort -u");
}

START_TEST(the_shared_library_shows_what_headers_declare_and_nothing_else)
{
    SKIP_WITHOUT_COPY();
    if (!has_program("nm"))
        TEST_SKIP("nm is not installed");
    char *const declared = declared_names();
    char *const shown =
        shell(0, "nm -D --defined-only $I/lib/libmpm.so | awk '{print $3}' | sort -u");
    char **const names = g_strsplit(g_strstrip(shown), "\n", -1);
    char **const functions = g_strsplit(g_strstrip(declared), "\n", -1);
    ck_assert_uint_gt(g_strv_length(names), 80);
    for (size_t k = 0; names[k] != NULL; k++)
        ck_assert_msg(g_strv_contains((const char *const *)functions, names[k]),
                      "%s is in no header", names[k]);
    for (size_t k = 0; functions[k] != NULL; k++)
        ck_assert_msg(g_strv_contains((const char *const *)names, functions[k]),
                      "%s is not in the library", functions[k]);
    g_strfreev(names);
    g_strfreev(functions);
    g_free(declared);
    g_free(shown);
}
END_TEST

START_TEST(the_shared_library_is_named_by_its_interface)
{
    SKIP_WITHOUT_COPY();
    if (!has_program("readelf"))
        TEST_SKIP("readelf is not installed");
    char *const text = shell(0, "readelf -d $I/lib/libmpm.so | grep SONAME; ls $I/lib");
    char *const name = g_strdup_printf("[libmpm.so.%d.%d]", MPM_VERSION_MAJOR, MPM_VERSION_MINOR);
    ck_assert_msg(strstr(text, name) != NULL, "no %s in: %s", name, text);
    g_free(name);
    g_free(text);
}
END_TEST

/* ---------------------------------------------------------------- programs */

/* Compiles an example of the copy in a new folder, and returns what it prints. */
static char *build_and_run(const char *compiler, const char *source, const char *libraries)
{
    char *const folder = test_folder_create();
    char *const output =
        shell(0,
              "cd %s; %s -Wall -Wextra -Wpedantic -Werror $I/share/touchstone/examples/%s "
              "-o example $(pkg-config --cflags touchstone) %s; ./example",
              folder, compiler, source, libraries);
    test_folder_remove(folder);
    return output;
}

static const char shared_library[] = "$(pkg-config --libs touchstone) -lm",
                  static_library[] = "-Wl,-Bstatic -lmpm -Wl,-Bdynamic "
                                     "$(pkg-config --static --libs touchstone | sed s/-lmpm//) "
                                     "-L$I/lib";

static double number_after(const char *text, const char *words)
{
    const char *const found = strstr(text, words);
    ck_assert_msg(found != NULL, "no '%s' in: %s", words, text);
    return g_ascii_strtod(found + strlen(words), NULL);
}

/* The bar's frequency has an error of second order in cells of 1/32 wavelength. */
START_TEST(c_program_makes_a_scene_by_calls)
{
    SKIP_WITHOUT_COPY();
    char *const output = build_and_run("$CC -std=c11", "c/bar.c", shared_library);
    ck_assert_double_eq_tol(number_after(output, "period "), 32.0, 0.32);
    char *const same = build_and_run("$CC -std=c11", "c/bar.c", static_library);
    ck_assert_str_eq(output, same);
    g_free(output);
    g_free(same);
}
END_TEST

/* 0, 0.4, ... 3.6 are ten, and two of the list are not among them. */
START_TEST(c_program_observes_a_run)
{
    SKIP_WITHOUT_COPY();
    char *const output = build_and_run("$CC -std=c11", "c/disks.c", shared_library);
    ck_assert_ptr_nonnull(strstr(output, "time 1.500 "));
    ck_assert_ptr_nonnull(strstr(output, "in 12 calls"));
    ck_assert_double_lt(number_after(output, "nearest "), 0.5);
    g_free(output);
}
END_TEST

START_TEST(cpp_program_runs)
{
    SKIP_WITHOUT_COPY();
    if (!has_program("g++"))
        TEST_SKIP("g++ is not installed");
    char *const output = build_and_run("g++ -std=c++11", "cpp/disk.cpp", shared_library);
    const double volume = number_after(output, "relative volume ");
    ck_assert_double_gt(volume, 0.7);
    ck_assert_double_lt(volume, 1.0);
    ck_assert_double_gt(number_after(output, "mean pressure "), 100.0);
    g_free(output);
}
END_TEST

START_TEST(python_program_runs_and_reads_results)
{
    SKIP_WITHOUT_COPY();
    char *const modules = shell(0, "/usr/bin/python3 -c 'import numpy, h5py' || true");
    const bool missing = modules[0] != '\0';
    g_free(modules);
    if (missing)
        TEST_SKIP("python3-numpy or python3-h5py is not installed");
    char *const folder = test_folder_create();
    char *const output = shell(0,
                               "cd %s; /usr/bin/python3 -B "
                               "$I/share/touchstone/examples/python/bar.py results",
                               folder);
    ck_assert_ptr_nonnull(strstr(output, "time 16.00"));
    ck_assert_ptr_nonnull(strstr(output, "unknown choice, got \"ugimpp\"; allowed: classic"));
    test_folder_remove(folder);
    g_free(output);
}
END_TEST

START_TEST(python_errors_pass_through_the_library)
{
    SKIP_WITHOUT_COPY();
    char *const output =
        shell(0, "cd $I/share/touchstone/examples/python; /usr/bin/python3 -B -c '\n"
                 "import sys\n"
                 "try: import bar, touchstone\n"
                 "except ModuleNotFoundError as missing: print(missing); sys.exit()\n"
                 "def fail(now): raise ValueError(now.field(\"velocity\").shape)\n"
                 "try: bar.build().run(observers=[touchstone.Observer(fail)])\n"
                 "except ValueError as error: print(\"raised\", error)\n"
                 "'");
    if (strstr(output, "No module named") == NULL)
        ck_assert_str_eq(output, "raised (64, 2)\n");
    g_free(output);
}
END_TEST

Suite *suite_install(void)
{
    Suite *suite = suite_create("install");
    TCase *tcase = tcase_create("copy");
    tcase_set_timeout(tcase, 60.0);
    tcase_add_test(tcase, versions_agree);
    tcase_add_test(tcase, one_library_is_to_be_named);
    tcase_add_test(tcase, the_shared_library_shows_what_headers_declare_and_nothing_else);
    tcase_add_test(tcase, the_shared_library_is_named_by_its_interface);
    tcase_add_test(tcase, c_program_makes_a_scene_by_calls);
    tcase_add_test(tcase, c_program_observes_a_run);
    tcase_add_test(tcase, cpp_program_runs);
    tcase_add_test(tcase, python_program_runs_and_reads_results);
    tcase_add_test(tcase, python_errors_pass_through_the_library);
    suite_add_tcase(suite, tcase);
    return suite;
}
