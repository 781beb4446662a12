/* A small catalogue and its programs.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "support/catalogue.h"

#include "support/folder.h"

#include <glib.h>
#include <gsl/gsl_integration.h>
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <unistd.h>

/* ------------------------------------------------------------------ programs */

static double power(double x, void *exponent)
{
    return pow(x, *(double *)exponent);
}

/* The integral of x^n over [0, 1] by Gauss quadrature, times n + 1: exactly 1. */
static enum mpm_status run_quadrature(struct measurement *measurement, struct mpm_error *error)
{
    double points, exponent;
    TRY(measurement_number(measurement, "points", &points, error));
    TRY(measurement_number(measurement, "exponent", &exponent, error));
    gsl_integration_glfixed_table *table = gsl_integration_glfixed_table_alloc((size_t)points);
    const gsl_function function = {power, &exponent};
    const double integral = gsl_integration_glfixed(&function, 0, 1, table);
    double curve[2 * 11];
    for (int i = 0; i <= 10; i++) {
        curve[2 * i] = 0.1 * i;
        curve[2 * i + 1] = power(0.1 * i, &exponent);
    }
    gsl_integration_glfixed_table_free(table);
    measurement_report(measurement, "integral", integral * (exponent + 1));
    measurement_note(measurement, "%g points <of> \"Gauss\" & exponent %g", points, exponent);
    measurement_note(measurement, "%s kernels",
                     mpm_kernels_name(measurement_options(measurement)->kernels));
    measurement_work(measurement, 1000);
    return measurement_series(measurement, "curve", "x x^n", 2, 11, curve, error);
}

static enum mpm_status run_pass(struct measurement *measurement, struct mpm_error *error)
{
    (void)error;
    measurement_report(measurement, "value", 1);
    return MPM_OK;
}

static enum mpm_status run_fail(struct measurement *measurement, struct mpm_error *error)
{
    (void)error;
    measurement_report(measurement, "value", 3);
    return MPM_OK;
}

static enum mpm_status run_weak(struct measurement *measurement, struct mpm_error *error)
{
    (void)error;
    measurement_report(measurement, "value", 10);
    return MPM_OK;
}

/* The cases below report a good value first: it must not count. */
static enum mpm_status run_crash(struct measurement *measurement, struct mpm_error *error)
{
    run_pass(measurement, error);
    fprintf(stderr, "about to <crash> & burn\n");
    raise(SIGKILL);
    return MPM_OK;
}

/* The grandchild shows whether the whole group is ended. */
static enum mpm_status run_hang(struct measurement *measurement, struct mpm_error *error)
{
    run_pass(measurement, error);
    if (fork() == 0)
        (void)alarm(60); /* where the run itself is killed, nobody ends it */
    while (measurement_has(measurement, "speed"))
        pause();
    return MPM_OK;
}

static enum mpm_status run_omit(struct measurement *measurement, struct mpm_error *error)
{
    (void)error;
    measurement_report(measurement, "another", 1);
    return MPM_OK;
}

static enum mpm_status run_leave(struct measurement *measurement, struct mpm_error *error)
{
    run_pass(measurement, error);
    _exit(7);
}

static enum mpm_status run_refuse(struct measurement *measurement, struct mpm_error *error)
{
    run_pass(measurement, error);
    return failure_set(error, MPM_RUN_FAILED, "step 12, particle 3: J = -0.1");
}

static enum mpm_status run_spoil(struct measurement *measurement, struct mpm_error *error)
{
    (void)error;
    measurement_report(measurement, "value", (double)NAN);
    return MPM_OK;
}

static enum mpm_status run_skip(struct measurement *measurement, struct mpm_error *error)
{
    (void)error;
    measurement_skip(measurement, "no reference | data # here");
    return MPM_OK;
}

static enum mpm_status run_undecided(struct measurement *measurement, struct mpm_error *error)
{
    (void)error;
    measurement_inconclusive(measurement, "value", "ended before %s", "breakdown");
    return MPM_OK;
}

/* Each of its files is smaller than all that it has said. */
static enum mpm_status run_talk(struct measurement *measurement, struct mpm_error *error)
{
    char *words = g_strnfill(70000, 'x');
    fprintf(stderr, "%s\n", words);
    measurement_note(measurement, "%s", words);
    g_free(words);
    return run_pass(measurement, error);
}

/* The case's scene to its end; waits halfway for ever where `speed` is above 1. */
static enum mpm_status run_scene(struct measurement *measurement, struct mpm_error *error)
{
    double speed;
    struct mpm_scene *scene;
    struct mpm_simulation *simulation = NULL;
    TRY(measurement_number(measurement, "speed", &speed, error));
    TRY(measurement_scene(measurement, NULL, 0, &scene, error));
    const double end = mpm_scene_end_time(scene);
    enum mpm_status status =
        mpm_simulation_create(scene, measurement_options(measurement), &simulation, error);
    for (bool halfway = false; status == MPM_OK && mpm_simulation_time(simulation) < end;) {
        status = mpm_simulation_advance(simulation, end, error);
        const double time = mpm_simulation_time(simulation);
        if (status != MPM_OK || halfway || time < end / 2)
            continue;
        halfway = true;
        status = measurement_series(measurement, "halfway", "time", 1, 1, &time, error);
        while (speed > 1)
            pause();
    }
    mpm_simulation_free(simulation);
    mpm_scene_free(scene);
    measurement_report(measurement, "value", 1);
    return status;
}

#define TEST_PROGRAMS(PROGRAM)                                                                     \
    PROGRAM(quadrature)                                                                            \
    PROGRAM(pass)                                                                                  \
    PROGRAM(fail)                                                                                  \
    PROGRAM(weak)                                                                                  \
    PROGRAM(crash)                                                                                 \
    PROGRAM(hang)                                                                                  \
    PROGRAM(omit)                                                                                  \
    PROGRAM(leave)                                                                                 \
    PROGRAM(refuse)                                                                                \
    PROGRAM(spoil)                                                                                 \
    PROGRAM(skip)                                                                                  \
    PROGRAM(talk)                                                                                  \
    PROGRAM(scene)                                                                                 \
    PROGRAM(undecided)

#define PROGRAM_DEFINE(name)                                                                       \
    static const struct measure_program program_##name = {#name, "for tests", run_##name};
TEST_PROGRAMS(PROGRAM_DEFINE)
#undef PROGRAM_DEFINE

struct program_table test_programs(void)
{
#define PROGRAM_ROW(name) &program_##name,
    static const struct measure_program *const programs[] = {TEST_PROGRAMS(PROGRAM_ROW)};
#undef PROGRAM_ROW
    return (struct program_table){programs, G_N_ELEMENTS(programs)};
}

/* --------------------------------------------------------------------- cases */

char *test_case_text(const char *name, const char *program)
{
    return g_strdup_printf("format: 1\n"
                           "family: T\n"
                           "case: %s\n"
                           "title: A case <for> tests & \"no\" more\n"
                           "summary: It holds one check.\n"
                           "tags: [small]\n"
                           "program: %s\n"
                           "parameters:\n"
                           "  - {name: speed, value: 1}\n"
                           "variants:\n"
                           "  - {name: only, tier: ci, timeout: 0.5}\n"
                           "checks:\n"
                           "  - check: value\n"
                           "    title: the value\n"
                           "    variants: [only]\n"
                           "    quantity: value\n"
                           "    unit: \"%%\"\n"
                           "    norm: none | nothing\n"
                           "    expected: 1\n"
                           "    low: 0.5\n"
                           "    high: 2\n"
                           "    basis: theory\n"
                           "    why: it is <one> & only\n",
                           name, program);
}

void test_case_write(const char *folder, const char *name, const char *text)
{
    char *home = g_build_filename(folder, "T", name, NULL);
    g_mkdir_with_parents(home, 0777);
    g_free(test_folder_write(home, "case.yaml", text));
    g_free(test_folder_write(home, "README.md",
                             "# A heading that the page has itself\n\n## Problem\n\nLet x < y & "
                             "<script>alert(1)</script>.\n\n| a | b |\n|---|--:|\n| 1 | 2 |\n"));
    g_free(home);
}

void test_case_write_quadrature(const char *folder)
{
    test_case_write(
        folder, "Q",
        "format: 1\nfamily: T\ncase: Q\ntitle: Gauss quadrature\n"
        "summary: Integrals of powers.\nprogram: quadrature\n"
        "parameters:\n  - {name: points, value: 4}\n"
        "variants:\n"
        "  - {name: cubic, tier: ci, timeout: 20, parameters: [{name: exponent, value: "
        "3}]}\n"
        "  - {name: ninth, tier: ci, timeout: 20, parameters: [{name: exponent, value: "
        "9}]}\n"
        "  - {name: fine, tier: full, timeout: 20, parameters: [{name: exponent, "
        "value: 9}, {name: points, value: 5}]}\n"
        "checks:\n"
        "  - {check: exact, title: exact to degree 2n - 1, variants: [cubic, fine], "
        "quantity: integral, unit: \"1\", norm: value, expected: 1, low: 0.99999999999, "
        "high: 1.00000000001, basis: theory, why: Gauss}\n"
        "  - {check: short, title: too few points, variants: [\"n*\"], quantity: "
        "integral, unit: \"1\", norm: value, expected: 1, low: 0.99999999999, high: "
        "1.00000000001, basis: theory, why: degree 9 needs 5 points, outcome: fail, "
        "fails_low: 0.99, fails_high: 0.9999999}\n"
        "figures:\n"
        "  - {name: curve, script: curve.gp, title: Powers, caption: x^n <over> x., "
        "reference: exact, needs: [cubic, ninth]}\n");
    char *home = g_build_filename(folder, "T", "Q", NULL);
    g_free(test_folder_write(home, "curve.gp",
                             "load style\nset xlabel 'x'\n"
                             "plot for [v in variants] data.'/data-'.v.'-curve.dat' using 1:2 with "
                             "linespoints ls variant_style(v) title v\n"));
    g_free(home);
}
