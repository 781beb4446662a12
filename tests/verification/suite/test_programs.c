/* What measuring programs refuse and what they make of runs that break.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/folder.h"

#include "verification/common/rows.h"
#include "verification/suite/measurement.h"

#include <fcntl.h>
#include <glib.h>
#include <string.h>
#include <unistd.h>

enum { PARAMETERS_MAX = 24 };

/* Parts NAME=VALUE that blanks part; a blank of a value is written +. */
static unsigned read_parameters(char **words, struct case_parameter parameters[PARAMETERS_MAX])
{
    unsigned count = 0;
    for (; words[count] != NULL; count++) {
        ck_assert_uint_lt(count, PARAMETERS_MAX);
        char *const sign = strchr(words[count], '=');
        *sign = '\0';
        parameters[count] = (struct case_parameter){words[count], g_strdelimit(sign + 1, "+", ' ')};
    }
    return count;
}

/* Runs a program on a case of the tree's catalogue with just these parameters and settings;
 * returns its rows as text (g_free). */
static char *run(const char *program, const char *folder, const char *parameters,
                 const char *settings, enum mpm_status *status, struct mpm_error *error)
{
    struct case_parameter table[PARAMETERS_MAX];
    char **words = g_strsplit(parameters, " ", -1), **set = g_strsplit(settings, " ", -1);
    char *place = g_build_filename("verification/catalogue", folder, NULL);
    char *scene = g_build_filename(place, "scene.yaml", NULL);
    char *output = test_folder_create(), *rows = test_folder_write(output, "rows", "");
    char name[] = "X1";
    struct case_file file = {.name = name};
    struct case_variant variant = {.name = name, .settings = set, .parameters = table};
    variant.parameters_count = read_parameters(words, table);
    variant.settings_count = g_strv_length(set);
    const struct catalogue_case entry = {.file = &file,
                                         .folder = place,
                                         .scene_path = scene,
                                         .program = programs_find(programs_all(), program)};
    const struct measurement_setup setup = {.entry = &entry,
                                            .variant = &variant,
                                            .data_folder = output,
                                            .simulation = {.threads = 1},
                                            .rows = open(rows, O_WRONLY)};
    *status = measurement_run(&setup, error);
    close(setup.rows);
    char *text = test_file_read(rows);
    g_free(rows);
    test_folder_remove(output);
    g_free(scene);
    g_free(place);
    g_strfreev(set);
    g_strfreev(words);
    return text;
}

#define TRACTION                                                                                   \
    "time=0.5 half_x=0.25 half_y=0.2 value_x=0.3 value_y=-0.2 axisymmetric=0 rows=6 columns="
#define MANUFACTURED                                                                               \
    "field=axis_aligned law=neo_hookean geometry=plane_strain density=1 bulk=1 shear=1 cell_x=1 "  \
    "cell_y=1 "                                                                                    \
    "length=1 refine=1 particles=2 steps=8 looks=1 refine_time=1 refine_particles=1 "
#define WAVE                                                                                       \
    "modulus=1 poisson=0 density=1 stress=1 rise=1 distance=1 from=1 interval=1 early=1 contours="
#define STRETCH "hold=1 interval=1 from=1 to=1 modulus=1 density=1 fraction=1 position=midpoint "
#define BAR     "family=bar length=1 modulus=1 density=1 modes="

static const struct {
    const char *program, *folder, *parameters, *message;
} REFUSED[] = {
    {"traction_sum", "T/T2", TRACTION "0", "\"columns\" is 0; allowed: whole numbers from 1 to"},
    {"traction_sum", "T/T2", TRACTION "7.5", "\"columns\" is 7.5; allowed: whole numbers"},
    {"traction_sum", "T/T2", TRACTION "-8", "\"columns\" is -8; allowed: whole numbers"},
    {"traction_sum", "T/T2", TRACTION "7", "are 7 and 6; allowed: those of the scene's 48"},
    {"vibration", "W/W2", BAR "0", "\"modes\" is 0; allowed: whole numbers from 1"},
    {"vibration", "W/W2", "family=Bar modes=1", "is \"Bar\"; allowed: bar, cylinder, disk"},
    {"statics", "T/T1", "solution=none", "is \"none\"; allowed: end_load, rim_load, plane"},
    {"manufactured", "M/M0", MANUFACTURED "levels=2 refine_space=1",
     "\"levels\" is 2 and nothing is refined; allowed: 1, or 2 for one of refine_space"},
    {"manufactured", "M/M0", MANUFACTURED "levels=2 refine_space=3",
     "\"refine_space\" is 3; allowed: whole numbers from 1 to 2"},
    {"manufactured", "M/M0", "geometry=round", "\"field\" is missing"},
    {"energy", "E/E1", "interval=0 from=4 to=6 limit=5", "samples every 0; allowed: above 0"},
    {"stretch", "G/G4", STRETCH "careful=1 order=first",
     "is \"first\"; allowed: usl, musl, usf, usavg"},
    {"stretch", "G/G4", STRETCH "order=usl careful=0",
     "steps of 0, samples every 1; allowed: above"},
    {"crack_wave", "D/D6b", WAVE "4+6x", "\"contours\": \"4 6x\"; allowed: 1 to 4 numbers"},
    {"crack_wave", "D/D6b", WAVE "4+5+6+7+8", "allowed: 1 to 4 numbers"},
    {"crack_wave", "D/D6b", WAVE "+", "allowed: 1 to 4 numbers"},
};

START_TEST(a_parameter_that_means_nothing_is_refused_with_what_is_allowed)
{
    enum mpm_status status;
    struct mpm_error error = {.message = ""};
    g_free(run(REFUSED[_i].program, REFUSED[_i].folder, REFUSED[_i].parameters, "time.end=0.01",
               &status, &error));
    ck_assert_int_eq(status, MPM_BAD_INPUT);
    ck_assert_msg(strstr(error.message, REFUSED[_i].message) != NULL, "%s", error.message);
    ck_assert_msg(strstr(error.message, "case X1") != NULL || _i == 3, "%s", error.message);
}
END_TEST

/* Loads that throw the body out of the grid: in the step that determines their force, or before. */
static const struct {
    const char *program, *folder, *parameters, *settings, *quantity;
} BREAKING[] = {
    {"traction_sum", "T/T2",
     "time=0.5 half_x=0.25 half_y=0.2 value_x=1e9 value_y=0 axisymmetric=0 rows=6 columns=8",
     "time.end=1", "force_error"},
    {"traction_sum", "T/T2", TRACTION "8", "loads.body_force=[1e9,0] time.end=1", "force_error"},
    {"turning_load", "T/T2c", "traction=10 after=0", "loads.body_force=[1e9,0]", "axial_error"},
    {"statics", "T/T1", "solution=end_load bulk=1 shear=1 traction=0.1 power=0 length=1",
     "loads.body_force=[0,1e20]", "stress_worst"},
};

START_TEST(what_a_run_that_breaks_should_have_measured_is_inconclusive)
{
    enum mpm_status status;
    struct mpm_error error = {.message = ""};
    char *rows = run(BREAKING[_i].program, BREAKING[_i].folder, BREAKING[_i].parameters,
                     BREAKING[_i].settings, &status, &error);
    ck_assert_msg(status == MPM_OK, "%s", error.message);
    ck_assert_msg(strstr(rows, "the run ended: ") != NULL, "%s", rows);
    unsigned line, found = 0;
    GArray *parsed = rows_parse(rows, &line);
    ck_assert_ptr_nonnull(parsed);
    for (guint k = 0; k < parsed->len; k++) {
        const struct row *const row = &g_array_index(parsed, struct row, k);
        if (strcmp(row->name, BREAKING[_i].quantity) != 0)
            continue;
        ck_assert_msg(row->kind == ROW_INCONCLUSIVE, "%s: %s", row->name, row->text);
        found++;
    }
    ck_assert_uint_eq(found, 1);
    g_array_unref(parsed);
    g_free(rows);
}
END_TEST

Suite *suite_programs(void)
{
    Suite *suite = suite_create("programs");
    TCase *refusals = tcase_create("refusals");
    tcase_add_loop_test(refusals, a_parameter_that_means_nothing_is_refused_with_what_is_allowed, 0,
                        G_N_ELEMENTS(REFUSED));
    suite_add_tcase(suite, refusals);
    TCase *breaks = tcase_create("breaks");
    tcase_add_loop_test(breaks, what_a_run_that_breaks_should_have_measured_is_inconclusive, 0,
                        G_N_ELEMENTS(BREAKING));
    suite_add_tcase(suite, breaks);
    return suite;
}
