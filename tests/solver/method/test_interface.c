/* Imperfect interfaces: a vibration across one keeps its energy, at any stiffness and in every
 * order of update; displacement fits.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/contact/displacement_fit.h"
#include "suites.h"
#include "support/near.h"
#include "support/scenes.h"

#include <glib.h>
#include <math.h>
#include <string.h>

/* Two layers, the lower one held at its foot, which starts in something like its first mode. */
#define LAYERS                                                                                     \
    "format: 1\n"                                                                                  \
    "geometry: plane_strain\n"                                                                     \
    "grid: {origin: [0, 0], cell: [1, 1], cells: [1, 18]}\n"                                       \
    "time: {end: 1000, courant: 0.4}\n"                                                            \
    "materials:\n"                                                                                 \
    "  - {name: soft, law: linear_elastic, density: 1, bulk: 0.6, shear: 0.3}\n"                   \
    "  - {name: stiff, law: linear_elastic, density: 1, bulk: 2, shear: 1.5}\n"                    \
    "bodies:\n"                                                                                    \
    "  - {name: soft, material: soft, region: {rectangle: {from: [0, 0], to: [1, 8]}},\n"          \
    "     velocity: [0, '0.001*y/8']}\n"                                                           \
    "  - {name: stiff, material: stiff, region: {rectangle: {from: [0, 8], to: [1, 16]}},\n"       \
    "     velocity: [0, '0.001']}\n"                                                               \
    "contact: {law: interface, tension: 1, compression: 1, shear: 1}\n"                            \
    "boundary:\n"                                                                                  \
    "  - {region: {line: {from: [0, 0], to: [1, 0]}}, velocity: [0, 0]}\n"                         \
    "  - {region: {line: {from: [0, 0], to: [0, 18]}}, symmetry: true}\n"                          \
    "  - {region: {line: {from: [1, 0], to: [1, 18]}}, symmetry: true}\n"

static const char *const orders[] = {"usl", "musl", "usf", "usavg"};
static const char *const shapes[] = {"classic", "ugimp"};
static const double stiffness[] = {1, 5, 100};
enum {
    ORDERS = G_N_ELEMENTS(orders),
    SHAPES = G_N_ELEMENTS(shapes),
    STIFFNESSES = G_N_ELEMENTS(stiffness)
};

/* Fifteen periods. USL loses 1.5 % in them, classic or not; what waves between particles and
 * nodes hold is another 1.5 % of the sum in MUSL. A jump that is ahead of the strains gains 20 %
 * (stiffness 1) to more than 1000 %. */
static const double KEPT = 0.035;

START_TEST(a_vibration_across_an_interface_keeps_its_energy)
{
    char *const order = g_strdup_printf("method.stress_update=%s", orders[_i % ORDERS]);
    char *const shape = g_strdup_printf("method.shape=%s", shapes[_i / ORDERS % SHAPES]);
    const double d = stiffness[_i / ORDERS / SHAPES];
    char *const law = g_strdup_printf("contact={law: interface, tension: %g, shear: %g}", d, d);
    const char *const settings[] = {order, shape, law, NULL};
    struct test_run run = test_run_open(LAYERS, settings, 1);
    const struct mpm_ledger start = test_run_ledger(&run);
    struct mpm_ledger now = start;
    while (now.time < 500.0) {
        test_run_steps(&run, 50);
        now = test_run_ledger(&run);
        ck_assert_near(now.kinetic_energy + now.strain_energy + now.contact_stored,
                       start.kinetic_energy, KEPT * start.kinetic_energy);
    }
    g_free(order);
    g_free(shape);
    g_free(law);
    test_run_close(&run);
}
END_TEST

/* u = a + B x at some places, H = B as well or not. */
static const double A[2] = {0.3, -0.2}, B[4] = {0.5, -0.7, 0.2, 0.4};

static void value_at(const double x[2], double u[2])
{
    for (int i = 0; i < 2; i++)
        u[i] = A[i] + B[2 * i] * x[0] + B[2 * i + 1] * x[1];
}

START_TEST(a_displacement_fit_is_exact_for_linear_fields)
{
    static const double places[][2] = {{-0.25, -0.25}, {0.2, -0.3}, {-0.7, -0.1}, {-0.3, -0.8}};
    static const double x[2] = {0.1, 0.2};
    struct mpm_displacement_sums sums = {.weight = 0.0};
    double exact[2];
    for (size_t k = 0; k < G_N_ELEMENTS(places); k++) {
        double u[2];
        value_at(places[k], u);
        const double v[2] = {3.0 * u[0], 3.0 * u[1]};
        mpm_displacement_add(
            &sums, &(struct mpm_displacement_sample){0.3 + 0.1 * (double)k, places[k], u, B, v});
    }
    const struct mpm_displacement_fit fit = mpm_displacement_fit(&sums, 1.0, x);
    value_at(x, exact);
    const double mean[2] = {sums.x[0] / sums.weight, sums.x[1] / sums.weight};
    const struct mpm_displacement_fit at_mean = mpm_displacement_fit(&sums, 1.0, mean);
    double there[2];
    value_at(mean, there);
    for (int i = 0; i < 2; i++) { /* velocities have no gradient to go by: exact in the middle */
        ck_assert_near(fit.u[i], exact[i], 1e-13);
        ck_assert_near(at_mean.v[i], 3.0 * there[i], 1e-13);
    }
}
END_TEST

START_TEST(the_gradient_decides_where_places_do_not)
{
    static const double places[][2] = {{-0.5, -0.25}, {0.5, -0.25}}, x[2] = {0.1, 0.2};
    struct mpm_displacement_sums sums = {.weight = 0.0};
    double exact[2];
    for (size_t k = 0; k < 2; k++) {
        double u[2];
        value_at(places[k], u);
        mpm_displacement_add(&sums, &(struct mpm_displacement_sample){1.0, places[k], u, B, u});
    }
    const struct mpm_displacement_fit fit = mpm_displacement_fit(&sums, 1.0, x);
    value_at(x, exact);
    for (int i = 0; i < 2; i++)
        ck_assert_near(fit.u[i], exact[i], 1e-5);
}
END_TEST

/* Of a field u_x odd and u_y even in x, sums folded at x = 0 are those of both sides. */
START_TEST(mirrored_displacements_are_folded)
{
    static const double h[4] = {0.1, 0.2, 0.3, 0.4}, mirrored_h[4] = {0.1, -0.2, -0.3, 0.4};
    static const double at[2] = {0.3, -0.2}, mirrored_at[2] = {-0.3, -0.2};
    static const double u[2] = {0.5, 0.7}, mirrored_u[2] = {-0.5, 0.7};
    struct mpm_displacement_sums inside = {.weight = 0.0}, beyond = inside, both = inside;
    mpm_displacement_add(&inside, &(struct mpm_displacement_sample){2.0, at, u, h, u});
    mpm_displacement_add(&both, &(struct mpm_displacement_sample){2.0, at, u, h, u});
    mpm_displacement_add(&beyond, &(struct mpm_displacement_sample){1.0, at, u, h, u});
    mpm_displacement_add(&both, &(struct mpm_displacement_sample){1.0, mirrored_at, mirrored_u,
                                                                  mirrored_h, mirrored_u});
    mpm_displacement_fold(&inside, &beyond, 0);
    double one[sizeof inside / sizeof(double)], other[sizeof both / sizeof(double)];
    memcpy(one, &inside, sizeof inside);
    memcpy(other, &both, sizeof both);
    for (size_t k = 0; k < G_N_ELEMENTS(one); k++)
        ck_assert_near(one[k], other[k], 1e-15);
}
END_TEST

Suite *suite_interface(void)
{
    Suite *suite = suite_create("interface");
    TCase *tests = tcase_create("imperfect interfaces");
    tcase_add_loop_test(tests, a_vibration_across_an_interface_keeps_its_energy, 0,
                        ORDERS * SHAPES * STIFFNESSES);
    tcase_add_test(tests, a_displacement_fit_is_exact_for_linear_fields);
    tcase_add_test(tests, the_gradient_decides_where_places_do_not);
    tcase_add_test(tests, mirrored_displacements_are_folded);
    suite_add_tcase(suite, tests);
    return suite;
}
