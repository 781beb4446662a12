/* What is the same to the last bit whatever the number of threads, and domains that end where
 * the grid's memory does; with both sets of kernels.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/folder.h"
#include "support/kernel_pair.h"
#include "support/near.h"

#include "base/strips.h"

#include <glib.h>
#include <math.h>
#include <string.h>

/* The scene `text` twice, as the sides state. */
static struct kernel_pair open_pair(const char *text, const struct kernel_side sides[2])
{
    char *folder = test_folder_create();
    char *path = test_folder_write(folder, "scene.yaml", text);
    struct kernel_pair pair;
    struct mpm_error error = {.message = ""};
    const enum mpm_status status = kernel_pair_open(path, sides, &pair, &error);
    g_free(path);
    test_folder_remove(folder);
    ck_assert_msg(status == MPM_OK, "%s", error.message);
    return pair;
}

/* -------------------------------------------------------------------- threads */

/* Columns side by side with particles of other sizes and numbers each, over 112 rows of cells
 * at this refinement; two of them share cells. They rise by a few rows, each at its own speed,
 * and stretch. */
#define COLUMNS(X, Y)                                                                              \
    "format: 1\n"                                                                                  \
    "title: Columns\n"                                                                             \
    "grid: {origin: [0, 0], cell: [1, 1], cells: [10, 37], refine: 4}\n"                           \
    "time: {end: 1000, courant: 0.4}\n"                                                            \
    "method: {shape: ugimp, stress_update: musl}\n"                                                \
    "materials:\n"                                                                                 \
    "  - {name: rubber, law: neo_hookean, density: 1, bulk: 80, shear: 48}\n"                      \
    "  - {name: steel, law: linear_elastic, density: 3, bulk: 200, shear: 90}\n"                   \
    "bodies:\n"                                                                                    \
    "  - {name: one, material: rubber, particles_per_cell: [1, 1],\n"                              \
    "     region: {rectangle: {from: [1, 2], to: [3, 30]}}, velocity: ['sin(" Y ")', 3]}\n"        \
    "  - {name: usual, material: steel, particles_per_cell: [2, 2],\n"                             \
    "     region: {rectangle: {from: [3, 2], to: [4.5, 30]}}, velocity: [0, '2*cos(" Y ")']}\n"    \
    "  - {name: fine, material: rubber, particles_per_cell: [4, 3],\n"                             \
    "     region: {rectangle: {from: [4.5, 2], to: [5, 30]}}, velocity: [1, '3*sin(" X ")']}\n"    \
    "  - {name: flat, material: steel, particles_per_cell: [2, 3],\n"                              \
    "     region: {rectangle: {from: [6, 2], to: [7, 30]}}, velocity: ['-1', 'cos(" Y ")']}\n"
static const char PLANE[] = COLUMNS("x", "y"), RING[] = COLUMNS("r", "z");
_Static_assert(112 >= 6 * MPM_STRIP_ROWS, "each of three workers has strips of both colours");
enum { ENOUGH_FOR_THREE = 2 * 4096 }; /* particles; with fewer, two threads do it */

static const struct {
    enum mpm_kernels kernels;
    int threads; /* against one */
    const char *scene;
    const char *settings[4]; /* to NULL */
} columns[] = {
    {MPM_KERNELS_FAST, 3, PLANE, {"geometry=plane_strain", "method.shape=classic"}},
    {MPM_KERNELS_FAST, 3, PLANE, {"geometry=plane_strain", "method.shape=cpdi"}},
    {MPM_KERNELS_FAST, 2, PLANE, {"geometry=plane_strain", "method.shape=cpdi"}},
    {MPM_KERNELS_FAST, 3, PLANE, {"geometry=plane_stress", "method.stress_update=usf"}},
    {MPM_KERNELS_FAST, 3, RING, {"geometry=axisymmetric", "method.stress_update=usavg"}},
    {MPM_KERNELS_FAST, 3, RING, {"geometry=axisymmetric", "method.axis=untruncated"}},
    {MPM_KERNELS_FAST, 3, RING, {"geometry=axisymmetric", "method.shape=cpdi"}},
    {MPM_KERNELS_FAST,
     3,
     RING,
     {"geometry=axisymmetric", "method.transfer={kind: apic}",
      "materials.rubber={name: rubber, law: von_mises, density: 1, bulk: 80, shear: 48, "
      "yield_stress: 0.5, viscosity: {linear: 0.3, quadratic: 1}}"}},
    {MPM_KERNELS_REFERENCE, 2, RING, {"geometry=axisymmetric", "method.stress_update=usavg"}},
    {MPM_KERNELS_REFERENCE, 3, PLANE, {"geometry=plane_strain", "method.shape=cpdi"}},
};

/* The ledger of the end as well: it is summed over all particles. */
static void check_same(const struct kernel_pair *pair, int row)
{
    unsigned char ledgers[2][sizeof(struct mpm_ledger)];
    for (int k = 0; k < 2; k++) {
        struct mpm_ledger ledger;
        memset(&ledger, 0, sizeof ledger);
        mpm_simulation_ledger(pair->simulation[k], &ledger);
        memcpy(ledgers[k], &ledger, sizeof ledger);
    }
    char *found = kernel_pair_text(pair);
    ck_assert_msg(pair->same_bits && memcmp(ledgers[0], ledgers[1], sizeof ledgers[0]) == 0,
                  "%s, %s, %s kernels, %d threads: %s", columns[row].settings[0],
                  columns[row].settings[1], mpm_simulation_kernels(pair->simulation[0]),
                  columns[row].threads, found);
    g_free(found);
}

START_TEST(any_number_of_threads_gives_the_same_bits_for_particles_of_several_sizes)
{
    enum { STEPS = 34 }; /* a sort is among them */
    const char *const *settings = columns[_i].settings;
    const struct kernel_side sides[2] = {
        {settings, {.threads = 1, .kernels = columns[_i].kernels}},
        {settings, {.threads = columns[_i].threads, .kernels = columns[_i].kernels}},
    };
    struct kernel_pair pair = open_pair(columns[_i].scene, sides);
    ck_assert_uint_ge(mpm_simulation_particle_count(pair.simulation[0]), ENOUGH_FOR_THREE);
    for (int step = 1; step < STEPS; step++)
        for (int k = 0; k < 2; k++)
            ck_assert_int_eq(mpm_simulation_advance(pair.simulation[k], HUGE_VAL, NULL), MPM_OK);
    ck_assert(kernel_pair_step(&pair)); /* compares, too */
    check_same(&pair, _i);
    kernel_pair_close(&pair);
}
END_TEST

/* ----------------------------------------------------------------- ghost rows */

/* A particle that fills the cell at (0.5, 0.5) of a grid of 6 cells each way, or the one at the
 * other end; the field stretches it about its centre. Powers of two: F is exact. Soft, so that the
 * energy of a strain that comes in one step, without work, is small beside the kinetic energy. */
static const char STRETCHED[] =
    "format: 1\n"
    "title: A particle that is stretched\n"
    "geometry: plane_strain\n"
    "grid: {origin: [0, 0], cell: [1, 1], cells: [6, 6]}\n"
    "time: {end: 100, step: 0.125, allow_unstable: true}\n"
    "method: {shape: cpdi, stress_update: musl, deformation_terms: 1}\n"
    "materials: [{name: soft, law: neo_hookean, density: 1, bulk: 1.2e-3, shear: 0.9e-3}]\n"
    "bodies:\n"
    "  - {name: body, material: soft, region: {rectangle: {from: [0, 0], to: [1, 1]}},\n"
    "     particles_per_cell: [1, 1]}\n";

/* The corner comes to (1 - short) of two cells, the ghost rows, beyond the grid. */
static const struct {
    double short_of;
    bool fails; /* in the step that takes it there; else it rests there for two more */
} corners[] = {{0.0, true}, {1e-10, true}, {-1e-10, true}, {1e-8, false}};
enum { CORNERS = G_N_ELEMENTS(corners), ENDS = 2, AXES = 2 };

/* F = 1 + 4 (1 - short) along the axis in a step of 1/8, half size 1/2: the corner is at
 * 1/2 - F/2, or as far beyond the other end. */
static struct kernel_pair open_stretched(int corner, int axis, int end)
{
    const char *last = end == 0 ? "0" : "5", *next = end == 0 ? "1" : "6";
    const double middle = end == 0 ? 0.5 : 5.5, rate = 32.0 * (1.0 - corners[corner].short_of);
    char number[G_ASCII_DTOSTR_BUF_SIZE], centre[G_ASCII_DTOSTR_BUF_SIZE];
    g_ascii_dtostr(number, sizeof number, rate);
    g_ascii_dtostr(centre, sizeof centre, middle);
    char *body = g_strdup_printf("bodies.body.region.rectangle={from: [%s, %s], to: [%s, %s]}",
                                 last, last, next, next);
    char *field = g_strdup_printf("'%s*(%s-%s)*(t<0.2)'", number, axis == 0 ? "x" : "y", centre);
    char *boundary = g_strdup_printf("boundary=[{region: all, velocity: [%s, %s]}]",
                                     axis == 0 ? field : "0", axis == 0 ? "0" : field);
    const char *const settings[] = {body, boundary, NULL};
    const struct kernel_side sides[2] = {
        {settings, {.threads = 1, .kernels = MPM_KERNELS_REFERENCE}},
        {settings, {.threads = 1, .kernels = MPM_KERNELS_FAST}},
    };
    const struct kernel_pair pair = open_pair(STRETCHED, sides);
    g_free(body);
    g_free(field);
    g_free(boundary);
    return pair;
}

static double stretch_of(const struct mpm_simulation *simulation, int axis)
{
    double f[5];
    mpm_simulation_field(simulation, MPM_FIELD_DEFORMATION_GRADIENT, f);
    return f[3 * axis]; /* xx, yy of xx xy yx yy zz */
}

START_TEST(a_corner_on_the_line_where_the_ghost_rows_end_is_refused_and_one_before_it_is_right)
{
    static const double ROUND_OFF = 1e-14; /* F is 5; one multiplication by 1 + L dt */
    const int corner = _i / AXES / ENDS, axis = _i / ENDS % AXES;
    struct kernel_pair pair = open_stretched(corner, axis, _i % ENDS);
    enum { STEPS = 3 };
    const bool fails = corners[corner].fails;
    int good = 0;
    while (good < STEPS && kernel_pair_step(&pair))
        good++;
    char *found = kernel_pair_text(&pair);
    ck_assert_msg(kernel_pair_ended_alike(&pair) && kernel_pair_worst(&pair) <= KERNEL_PAIR_BOUND,
                  "%s", found);
    ck_assert_int_eq(good, fails ? 0 : STEPS);
    ck_assert_msg(strstr(pair.error[0].message, fails ? "has a domain that reaches" : "") != NULL,
                  "%s", pair.error[0].message);
    const double stretch = fails ? 1.0 : 5.0 - 4.0 * corners[corner].short_of;
    ck_assert_near(stretch_of(pair.simulation[0], axis), stretch, ROUND_OFF);
    g_free(found);
    kernel_pair_close(&pair);
}
END_TEST

Suite *suite_kernel_bits(void)
{
    Suite *suite = suite_create("kernel_bits");
    TCase *threads = tcase_create("threads");
    tcase_add_loop_test(threads,
                        any_number_of_threads_gives_the_same_bits_for_particles_of_several_sizes, 0,
                        G_N_ELEMENTS(columns));
    suite_add_tcase(suite, threads);
    TCase *ghosts = tcase_create("ghosts");
    tcase_add_loop_test(
        ghosts, a_corner_on_the_line_where_the_ghost_rows_end_is_refused_and_one_before_it_is_right,
        0, CORNERS * AXES * ENDS);
    suite_add_tcase(suite, ghosts);
    return suite;
}
