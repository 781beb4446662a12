/* The arena, tensors, orientation and strips.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/arena.h"
#include "base/orientation.h"
#include "base/strips.h"
#include "base/tensor.h"
#include "suites.h"
#include "support/near.h"

#include <float.h>
#include <glib.h>

START_TEST(an_arena_gives_aligned_zeroed_arrays_of_the_size_measured)
{
    struct mpm_arena arena = {0};
    struct mpm_error error = {0};
    ck_assert_ptr_null(MPM_TAKE(&arena, double, 3));
    ck_assert_ptr_null(MPM_TAKE(&arena, char, 100));
    ck_assert_uint_eq(arena.used, 64 + 128);
    ck_assert_int_eq(mpm_arena_allocate(&arena, &error), MPM_OK);
    double *const first = MPM_TAKE(&arena, double, 3);
    char *const second = MPM_TAKE(&arena, char, 100);
    ck_assert_uint_eq((uintptr_t)first % 64, 0);
    ck_assert_uint_eq((uintptr_t)second % 64, 0);
    ck_assert(first[2] == 0.0 && second[99] == 0);
    ck_assert_uint_le(arena.used, arena.capacity);
    mpm_arena_free(&arena);
}
END_TEST

START_TEST(more_memory_than_the_machine_has_is_refused_with_the_estimate)
{
    struct mpm_arena arena = {0};
    struct mpm_error error = {0};
    (void)MPM_TAKE(&arena, double, SIZE_MAX / 16);
    ck_assert_int_eq(mpm_arena_allocate(&arena, &error), MPM_ENVIRONMENT_FAILED);
    ck_assert_ptr_nonnull(strstr(error.message, "the scene needs 9.22e+09 GB"));
    ck_assert_ptr_null(arena.base);
}
END_TEST

START_TEST(sizes_beyond_the_address_space_do_not_wrap_around)
{
    struct mpm_arena arena = {0};
    for (int k = 0; k < 4; k++)
        (void)MPM_TAKE(&arena, double, SIZE_MAX / 8 - 100);
    ck_assert_uint_ge(arena.used, SIZE_MAX - 64);
}
END_TEST

START_TEST(the_inverse_cube_root_is_right_to_two_roundings)
{
    /* one step of the guess covers a decade; the exponents cover the range of J */
    for (double x = 1e-9; x < 1e9; x *= 1.0007)
        ck_assert_near(mpm_inverse_cube_root(x) * cbrt(x), 1.0, 4 * DBL_EPSILON);
}
END_TEST

/* exp(h) of the plane part by 30 products of matrices */
static void series(const double h[MPM_GRADIENT_SIZE], int terms, double sum[MPM_GRADIENT_SIZE])
{
    double power[MPM_GRADIENT_SIZE] = {1, 0, 0, 1, 1};
    for (int k = 0; k < MPM_GRADIENT_SIZE; k++)
        sum[k] = power[k];
    for (int n = 1; n <= terms; n++) {
        mpm_deformation_compose(h, power);
        for (int k = 0; k < MPM_GRADIENT_SIZE; k++) {
            power[k] /= n;
            sum[k] += power[k];
        }
    }
}

START_TEST(cayley_hamilton_gives_the_series_for_any_number_of_terms)
{
    static const double gradients[][MPM_GRADIENT_SIZE] = {{0.1, 0.2, -0.3, 0.05, 0.07},
                                                          {0, -1, 1, 0, 0},
                                                          {0.5, 0, 0, -0.5, 0.2},
                                                          {0, 0.3, 0, 0, -0.4},
                                                          {1e-9, 0, 0, 0, 1e-9}};
    for (size_t g = 0; g < sizeof gradients / sizeof gradients[0]; g++)
        for (int terms = 1; terms <= 20; terms++) {
            double df[MPM_GRADIENT_SIZE], expected[MPM_GRADIENT_SIZE];
            mpm_deformation_increment(gradients[g], terms, df);
            series(gradients[g], terms, expected);
            for (int k = 0; k < MPM_GRADIENT_SIZE; k++)
                ck_assert_near(df[k], expected[k], 8 * DBL_EPSILON);
        }
}
END_TEST

START_TEST(the_exponential_of_a_spin_is_a_rotation)
{
    const double angle = 0.7, h[MPM_GRADIENT_SIZE] = {0, -angle, angle, 0, 0};
    double df[MPM_GRADIENT_SIZE];
    mpm_deformation_increment(h, 20, df);
    ck_assert_near(df[MPM_XX], cos(angle), 4 * DBL_EPSILON);
    ck_assert_near(df[MPM_YX], sin(angle), 4 * DBL_EPSILON);
    ck_assert_near(mpm_determinant(df), 1.0, 4 * DBL_EPSILON);
}
END_TEST

enum { STRIPS = 9 };
struct visits {
    int count[STRIPS], colour_at_visit[STRIPS], odd_seen;
};

static void visit(void *context, int64_t strip, int worker)
{
    struct visits *const visits = context;
    ck_assert_int_eq(worker, 0);
    visits->count[strip]++;
    visits->odd_seen |= (int)(strip % 2);
    visits->colour_at_visit[strip] = visits->odd_seen;
}

START_TEST(every_strip_runs_once_even_ones_first)
{
    struct visits visits = {0};
    mpm_strips_run(STRIPS, 1, visit, &visits);
    for (int s = 0; s < STRIPS; s++) {
        ck_assert_int_eq(visits.count[s], 1);
        ck_assert_int_eq(visits.colour_at_visit[s], s % 2);
    }
}
END_TEST

static void count_row(void *context, int64_t row, int worker)
{
    (void)worker;
    ((int *)context)[row]++;
}

START_TEST(rows_run_once_whatever_the_number_of_workers)
{
    for (int workers = 1; workers <= 5; workers++) {
        int count[20] = {0};
        mpm_rows_run(3, 16, workers, count_row, count);
        for (int row = 0; row < 20; row++)
            ck_assert_int_eq(count[row], row >= 3 && row <= 16);
    }
}
END_TEST

/* ------------------------------------------------------------------ orientation */

__extension__ typedef __int128 wide_t; /* holds products of differences of 53 bits */

static int sign_of(double value)
{
    return (value > 0.0) - (value < 0.0);
}

static int sign_of_area(const int64_t a[2], const int64_t b[2], const int64_t c[2])
{
    const wide_t area =
        (wide_t)(a[0] - c[0]) * (b[1] - c[1]) - (wide_t)(a[1] - c[1]) * (b[0] - c[0]);
    return (area > 0) - (area < 0);
}

START_TEST(the_sign_of_an_area_is_that_of_wide_integers)
{
    GRand *const random = g_rand_new_with_seed(1997);
    int missed = 0; /* by rounded products */
    for (int time = 0; time < 20000; time++) {
        int64_t at[3][2];
        double place[3][2];
        const double part = g_rand_double(random);
        for (int axis = 0; axis < 2; axis++) {
            for (int k = 0; k < 2; k++)
                at[k][axis] = (int64_t)ldexp(g_rand_double_range(random, -1, 1), 52);
            at[2][axis] = at[0][axis] + llrint(part * (double)(at[1][axis] - at[0][axis])) +
                          g_rand_int_range(random, -1, 2);
            for (int k = 0; k < 3; k++)
                place[k][axis] = (double)at[k][axis];
        }
        const int sign = sign_of_area(at[0], at[1], at[2]);
        ck_assert_int_eq(sign_of(mpm_orientation(place[0], place[1], place[2])), sign);
        missed += sign_of((place[0][0] - place[2][0]) * (place[1][1] - place[2][1]) -
                          (place[0][1] - place[2][1]) * (place[1][0] - place[2][0])) != sign;
    }
    ck_assert_int_gt(missed, 100);
    g_rand_free(random);
}
END_TEST

Suite *suite_base(void)
{
    Suite *const suite = suite_create("base");
    TCase *const arena = tcase_create("arena");
    tcase_add_test(arena, an_arena_gives_aligned_zeroed_arrays_of_the_size_measured);
    tcase_add_test(arena, more_memory_than_the_machine_has_is_refused_with_the_estimate);
    tcase_add_test(arena, sizes_beyond_the_address_space_do_not_wrap_around);
    suite_add_tcase(suite, arena);
    TCase *const tensor = tcase_create("tensor");
    tcase_add_test(tensor, the_inverse_cube_root_is_right_to_two_roundings);
    tcase_add_test(tensor, cayley_hamilton_gives_the_series_for_any_number_of_terms);
    tcase_add_test(tensor, the_exponential_of_a_spin_is_a_rotation);
    suite_add_tcase(suite, tensor);
    TCase *const orientation = tcase_create("orientation");
    tcase_add_test(orientation, the_sign_of_an_area_is_that_of_wide_integers);
    suite_add_tcase(suite, orientation);
    TCase *const strips = tcase_create("strips");
    tcase_add_test(strips, every_strip_runs_once_even_ones_first);
    tcase_add_test(strips, rows_run_once_whatever_the_number_of_workers);
    suite_add_tcase(suite, strips);
    return suite;
}
