/* J and stress intensities where free strain (of heat, of a solvent) varies from place to place, of
 * fields that particles are given.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/combinations.h"
#include "support/crack_blocks.h"
#include "support/near.h"
#include "support/scenes.h"
#include "support/settings.h"
#include "verification/exact/cracks/williams_field.h"

#include <glib.h>
#include <math.h>
#include <stdlib.h>

enum { AXES = 2, GRADIENT = 5, SIZES = 4 };

static const char BLOCK[] = BLOCK_OF_J;
static const double BULK = 80.0, SHEAR = 48.0;
static const int CONTOURS[SIZES] = {3, 5, 7, 9};

/* Free strain is 0.01 times the value, or as much with the other sign. */
#define MATERIAL(more)                                                                             \
    "materials=[{name: stiff, law: linear_elastic, density: 2, bulk: 80, shear: 48, " more "}]"
static const struct scalar {
    const char *material, *transport, *start;
    double coefficient;
} SCALARS[] = {
    {MATERIAL("heat_capacity: 1, conductivity: 0, thermal_expansion: 0.01, "
              "stress_free_temperature: 0"),
     "transport={temperature: {}}", "bodies.block.temperature", 0.01},
    {MATERIAL("saturation: 1, diffusivity: 0, swelling: -0.01, stress_free_concentration: 0"),
     "transport={concentration: {}}", "bodies.block.concentration", -0.01},
};
enum { SCALAR_COUNT = G_N_ELEMENTS(SCALARS) };

static struct test_run open_block(const struct scalar *scalar, const char *value,
                                  const char *geometry, const char *shape, const char *more)
{
    struct settings settings = {.count = 0};
    settings_add(&settings, scalar->material);
    settings_add(&settings, scalar->transport);
    settings_add_formatted(&settings, "%s='%s'", scalar->start, value);
    settings_add_formatted(&settings, "geometry=%s", geometry);
    settings_add_formatted(&settings, "method.shape=%s", shape);
    settings_add_formatted(&settings,
                           "cracks=[{points: [[0.2, 18.1], [18.3, 18.1]], contact: none, "
                           "j_integral: [{contour: %d%s}, {contour: %d%s}, {contour: %d%s}, "
                           "{contour: %d%s}]}]",
                           CONTOURS[0], more, CONTOURS[1], more, CONTOURS[2], more, CONTOURS[3],
                           more);
    const struct test_run run = test_run_open(BLOCK, settings.texts, 1);
    settings_clear(&settings);
    return run;
}

/* F - I at a place. */
typedef void given_gradient(const void *context, const double place[AXES],
                            double gradient[GRADIENT]);

static void give(struct test_run *run, given_gradient *gradient, const void *context)
{
    struct mpm_error error = {.message = ""};
    size_t count;
    double *const place = test_run_field(run, MPM_FIELD_POSITION, &count);
    double *const f = g_new0(double, GRADIENT *count);
    double *const v = g_new0(double, AXES *count);
    for (size_t p = 0; p < count; p++) {
        double *const own = f + GRADIENT * p;
        gradient(context, place + AXES * p, own);
        own[0] += 1.0;
        own[3] += 1.0;
        own[4] += 1.0;
    }
    const enum mpm_status status = mpm_simulation_set_start(run->simulation, v, f, &error);
    ck_assert_msg(status == MPM_OK, "%s", error.message);
    g_free(f);
    g_free(v);
    free(place);
}

/* ------------------------------------------------------------------- even F */

/* F is the same everywhere, and only the free strain varies: whatever it is, J is 0, and so are
 * K_I and K_II where the faces are free, as they are with F = 1 and no free strain on them. With e
 * the largest free strain, the bounds are errors of second order in the cell of sums over K e^2
 * and, stretched by 0.25, over 0.25 K e. */
#define UNEVEN(first, second) "(0.1*(" second "-18.1))^2*sin(0.2*" first "+0.3)"
static const double J_BOUND = 0.04, STRETCHED_BOUND = 0.08, INTENSITY_BOUND = 0.02;

static const struct even {
    const char *geometry, *form;
    double f[GRADIENT];
} EVEN[] = {
    {"plane_strain", "", {0, 0, 0, 0, 0}},
    {"plane_stress", "", {0, 0, 0, 0, 0}},
    {"axisymmetric", ", form: bergkvist_huong", {0, 0, 0, 0, 0}},
    {"axisymmetric", ", form: broberg", {0, 0, 0, 0, 0}},
    {"plane_strain", "", {0.25, 0, 0, -0.2, 0}},
    {"plane_strain", "", {0.25, 0.3, 0, -0.2, 0}},
    {"axisymmetric", ", form: broberg", {0.25, 0, 0, -0.2, 0.25}},
};
enum { EVEN_COUNT = G_N_ELEMENTS(EVEN) };

static void even_gradient(const void *context, const double place[AXES], double gradient[GRADIENT])
{
    const struct even *const even = context;
    for (int k = 0; k < GRADIENT; k++)
        gradient[k] = even->f[k];
    (void)place;
}

START_TEST(free_strain_alone_has_no_j)
{
    const struct even *const even = &EVEN[_i / TEST_SHAPES];
    const struct scalar *const scalar = &SCALARS[_i % SCALAR_COUNT];
    const char *const shape = test_shapes[_i % TEST_SHAPES];
    const bool curved = even->geometry[0] == 'a';
    struct test_run run = open_block(scalar, curved ? UNEVEN("r", "z") : UNEVEN("x", "y"),
                                     even->geometry, shape, even->form);
    const double e = fabs(scalar->coefficient);
    const double bound = BULK * e * (even->f[0] == 0.0 ? e * J_BOUND : STRETCHED_BOUND);
    give(&run, even_gradient, even);
    for (size_t k = 0; k < SIZES; k++) {
        const struct mpm_j_integral found = test_run_j_integral(&run, k);
        for (int axis = 0; axis < AXES; axis++) {
            ck_assert_near(found.j[axis], 0.0, bound);
            if (even->f[0] == 0.0)
                ck_assert_near(found.stress_intensity[axis], 0.0, BULK * e * INTENSITY_BOUND);
        }
    }
    test_run_close(&run);
}
END_TEST

/* ----------------------------------------------------- a value linear in place */

/* It stresses nothing in the plane, and adds nothing to the field of a tip: J, K_I and K_II are
 * those of the tip. With e = a x + b y from the tip, u_i,k is e times 1, and 1 + nu in plane
 * strain, and a turn, a y - b x. */
struct warm_tip {
    struct williams_field field;
    double a, b;
    double share; /* of u_1,1 over e */
};

static void warm_gradient(const void *context, const double place[AXES], double gradient[GRADIENT])
{
    const struct warm_tip *const warm = context;
    const double x = place[0] - 18.3, y = place[1] - 18.1;
    const double stretch = warm->share * (warm->a * x + warm->b * y);
    const double spin = warm->share * (warm->a * y - warm->b * x);
    williams_field_gradient(&warm->field, place, gradient);
    gradient[0] += stretch;
    gradient[1] -= spin;
    gradient[2] += spin;
    gradient[3] += stretch;
    gradient[4] = 0.0;
}

/* K is 1e-4 and h = 1: strains of a tip are 1e-6 a cell from it; those of heat as large 5 cells
 * from it. */
static const double SMALL = 1e-4, WARMTH = 4e-5; /* value per length */
/* Of K: the sum over particles around the tip. Of J: means over a cell; where the stress jumps
 * across the crack (mode II) it jumps between two rows of particles, 0.1 away from it, which is of
 * first order in the cell. */
static const double INTENSITY_PART = 0.05, OPENED_PART = 0.12, SHEARED_PART = 0.35;

static const struct mode {
    double one, two, a, b;
} MODES[] = {{0, 0, 1, 0}, {0, 0, 0, 1}, {1, 0, 1, 0}, {1, 0, -1, 0.5}, {0.6, 0.8, 0.5, 1}};
enum { MODE_COUNT = G_N_ELEMENTS(MODES) };

START_TEST(a_value_linear_in_place_changes_neither_j_nor_stress_intensities)
{
    const struct mode *const mode = &MODES[_i % MODE_COUNT];
    const int index = _i / MODE_COUNT;
    const bool stressed = index != 0;
    const struct scalar *const scalar = &SCALARS[index];
    const double poisson = (3.0 * BULK - 2.0 * SHEAR) / (2.0 * (3.0 * BULK + SHEAR));
    struct settings value = {.count = 0};
    settings_add_formatted(&value, "%.17g*(x-18.3)+%.17g*(y-18.1)", WARMTH * mode->a,
                           WARMTH * mode->b);
    struct test_run run =
        open_block(scalar, value.texts[0], stressed ? "plane_stress" : "plane_strain", "ugimp",
                   ", dynamic: false");
    struct warm_tip warm = {
        .field = {.mode_1 = SMALL * mode->one,
                  .mode_2 = SMALL * mode->two,
                  .shear = SHEAR,
                  .kappa = stressed ? (3.0 - poisson) / (1.0 + poisson) : 3.0 - 4.0 * poisson,
                  .tip = {18.3, 18.1},
                  .direction = {1.0, 0.0}},
        .a = scalar->coefficient * WARMTH * mode->a,
        .b = scalar->coefficient * WARMTH * mode->b,
        .share = stressed ? 1.0 : 1.0 + poisson,
    };
    const double unit = SMALL * SMALL / williams_field_modulus(&warm.field);
    const double j = unit * (mode->one * mode->one + mode->two * mode->two);
    give(&run, warm_gradient, &warm);
    for (size_t k = 0; k < SIZES; k++) {
        const struct mpm_j_integral found = test_run_j_integral(&run, k);
        ck_assert_near(found.j[0], j, unit * (mode->two == 0.0 ? OPENED_PART : SHEARED_PART));
        ck_assert_near(found.stress_intensity[0], SMALL * mode->one, SMALL * INTENSITY_PART);
        ck_assert_near(found.stress_intensity[1], SMALL * mode->two, SMALL * INTENSITY_PART);
    }
    test_run_close(&run);
    settings_clear(&value);
}
END_TEST

Suite *suite_j_free_strain(void)
{
    Suite *suite = suite_create("j_free_strain");
    TCase *fields = tcase_create("fields");
    tcase_add_loop_test(fields, free_strain_alone_has_no_j, 0, EVEN_COUNT * TEST_SHAPES);
    tcase_add_loop_test(fields, a_value_linear_in_place_changes_neither_j_nor_stress_intensities, 0,
                        MODE_COUNT * SCALAR_COUNT);
    suite_add_tcase(suite, fields);
    return suite;
}
