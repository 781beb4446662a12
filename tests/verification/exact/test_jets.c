/* Automatic differentiation: each operation of jets and slopes against derivatives by the complex
 * step, and the functions of lanes against the C library's.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/near.h"
#include "verification/exact/manufactured/jet.h"

#include <complex.h>
#include <float.h>
#include <math.h>

/* A few roundings of numbers of order 10. */
static const double ROUND_OFF = 1e-13;

/* -------------------------------------------------------------------- lanes */

START_TEST(sine_and_cosine_are_right_to_a_rounding_or_two_in_every_quadrant)
{
    for (int k = -20000; k <= 20000; k++) {
        const double x = 0.0171 * k, y = 0.37 * k + 1e-9;
        lanes s, c;
        lanes_sin_cos((lanes){x, y}, &s, &c);
        ck_assert_near(s[0], sin(x), 2.0 * DBL_EPSILON);
        ck_assert_near(c[0], cos(x), 2.0 * DBL_EPSILON);
        ck_assert_near(s[1], sin(y), 2.0 * DBL_EPSILON);
        ck_assert_near(c[1], cos(y), 2.0 * DBL_EPSILON);
    }
    lanes s, c;
    lanes_sin_cos((lanes){0.0, 1e-12}, &s, &c);
    ck_assert(s[0] == 0.0 && s[1] == 1e-12 && c[0] == 1.0 && c[1] == 1.0);
}
END_TEST

START_TEST(an_inverse_cube_root_is_right_to_two_roundings)
{
    for (int k = -3000; k <= 3000; k++) {
        const double x = exp(0.01 * k), y = exp(0.03 * k);
        const lanes root = lanes_inverse_cube_root((lanes){x, y});
        ck_assert_near(root[0] * cbrt(x), 1.0, 3.0 * DBL_EPSILON);
        ck_assert_near(root[1] * cbrt(y), 1.0, 3.0 * DBL_EPSILON);
    }
}
END_TEST

START_TEST(a_selection_takes_lane_by_lane)
{
    const lanes a = {1.0, -2.0}, b = {(double)NAN, 4.0};
    const lanes chosen = lanes_select(a > 0.0, a, b);
    ck_assert(chosen[0] == 1.0 && chosen[1] == 4.0);
    const lanes root = lanes_root((lanes){4.0, 9.0});
    ck_assert(root[0] == 2.0 && root[1] == 3.0);
}
END_TEST

/* --------------------------------------------------------------- operations
 *
 * Each operation is done on two jets a and b, which are functions of X, Y and t with all their
 * derivatives: sines of places and time. The same in complex numbers gives first derivatives by a
 * step of i e, exact to e^2, and second ones by differences of those: (f'(x + h) - f'(x - h)) / 2h,
 * which is off by h^2 / 6 of the fourth derivative. */

struct point {
    double complex x, y, t;
};

static double complex first_value(struct point p)
{
    return 1.5 + 0.4 * csin(1.1 * p.x + 0.3) * csin(0.7 * p.y + 1.9) + 0.3 * csin(p.t);
}

static double complex second_value(struct point p)
{
    return 2.0 + 0.5 * csin(0.8 * p.x - p.y) + 0.25 * csin(1.3 * p.t + 0.4) * csin(p.x);
}

/* In both lanes, the second one at 0.25 more of X. */
static void make_jets(struct jet jets[2])
{
    const struct jet x = jet_place(0, (lanes){0.6, 0.85}), y = jet_place(1, lanes_splat(-0.4));
    const struct jet t = jet_time(0.9);
    const struct jet along = jet_sin(jet_shift(jet_scale(1.1, x), 0.3));
    const struct jet across = jet_sin(jet_shift(jet_scale(0.7, y), 1.9));
    jets[0] = jet_shift(
        jet_add(jet_scale(0.4, jet_multiply(along, across)), jet_scale(0.3, jet_sin(t))), 1.5);
    const struct jet turn = jet_sin(jet_shift(jet_scale(1.3, t), 0.4));
    jets[1] = jet_shift(jet_add(jet_scale(0.5, jet_sin(jet_subtract(jet_scale(0.8, x), y))),
                                jet_scale(0.25, jet_multiply(turn, jet_sin(x)))),
                        2.0);
}

struct operation {
    const char *name;
    struct jet (*of_jets)(struct jet a, struct jet b);
    double complex (*of_numbers)(double complex a, double complex b);
    struct slope (*of_slopes)(struct slope a, struct slope b); /* NULL: slopes do not have it */
};

#define OPERATION(name, jets, numbers, slopes)                                                     \
    static struct jet name##_jets(struct jet a, struct jet b)                                      \
    {                                                                                              \
        (void)b;                                                                                   \
        return jets;                                                                               \
    }                                                                                              \
    static double complex name##_numbers(double complex a, double complex b)                       \
    {                                                                                              \
        (void)b;                                                                                   \
        return numbers;                                                                            \
    }                                                                                              \
    static struct slope name##_slopes(struct slope a, struct slope b)                              \
    {                                                                                              \
        (void)b;                                                                                   \
        return slopes;                                                                             \
    }

static struct slope none(struct slope a)
{
    (void)a;
    return (struct slope){0};
}

static struct jet jet_cosine_of_both(struct jet a)
{
    struct jet s, c;
    jet_sin_cos(a, &s, &c);
    return c;
}

OPERATION(add, jet_add(a, b), a + b, slope_add(a, b))
OPERATION(subtract, jet_subtract(a, b), a - b, slope_subtract(a, b))
OPERATION(scale, jet_scale(-3.5, a), -3.5 * a, slope_scale(-3.5, a))
OPERATION(shift, jet_shift(a, 2.5), a + 2.5, none(a))
OPERATION(multiply, jet_multiply(a, b), a *b, slope_multiply(a, b))
OPERATION(square, jet_square(a), a *a, slope_square(a))
OPERATION(inverse, jet_inverse(a), 1.0 / a, slope_inverse(a))
OPERATION(root, jet_root(a), csqrt(a), slope_root(a))
OPERATION(sine, jet_sin(a), csin(a), none(a))
OPERATION(cosine, jet_cos(a), ccos(a), none(a))
OPERATION(both, jet_cosine_of_both(a), ccos(a), none(a))
OPERATION(constant, jet_add(jet_constant(0.5), a), 0.5 + a, none(a))
OPERATION(power, jet_add(a, b), cpow(a, -2.0 / 3.0),
          slope_power_minus_two_thirds(a, slope_inverse(a)))

#define ROW(name, jets, slopes)                                                                    \
    {                                                                                              \
#name, (jets) ? name##_jets : NULL, name##_numbers, (slopes) ? name##_slopes : NULL        \
    }
static const struct operation OPERATIONS[] = {
    ROW(add, true, true),     ROW(subtract, true, true), ROW(scale, true, true),
    ROW(shift, true, false),  ROW(multiply, true, true), ROW(square, true, true),
    ROW(inverse, true, true), ROW(root, true, true),     ROW(sine, true, false),
    ROW(cosine, true, false), ROW(both, true, false),    ROW(constant, true, false),
    ROW(power, false, true),
};
enum { OPERATION_COUNT = sizeof OPERATIONS / sizeof *OPERATIONS };

static double complex value_at(const struct operation *op, struct point p)
{
    return op->of_numbers(first_value(p), second_value(p));
}

static struct point moved(struct point p, int axis, double complex by)
{
    p.x += axis == 0 ? by : 0.0;
    p.y += axis == 1 ? by : 0.0;
    p.t += axis == 2 ? by : 0.0;
    return p;
}

static double first_derivative(const struct operation *op, struct point p, int axis)
{
    const double step = 1e-20;
    return cimag(value_at(op, moved(p, axis, step * (double complex)I))) / step;
}

static double second_derivative(const struct operation *op, struct point p, int axis, int other)
{
    const double step = 1e-4;
    return (first_derivative(op, moved(p, other, step), axis) -
            first_derivative(op, moved(p, other, -step), axis)) /
           (2.0 * step);
}

/* h^2/6 of derivatives below 30 */
static const double DIFFERENCE = 5e-8;

START_TEST(every_operation_of_jets_carries_all_derivatives)
{
    const struct operation *const op = &OPERATIONS[_i];
    struct jet jets[2];
    if (op->of_jets == NULL)
        return;
    make_jets(jets);
    const struct jet out = op->of_jets(jets[0], jets[1]);
    for (int lane = 0; lane < LANES; lane++) {
        const struct point p = {.x = 0.6 + 0.25 * lane, .y = -0.4, .t = 0.9};
        ck_assert_near(out.f[lane], creal(value_at(op, p)), ROUND_OFF);
        ck_assert_near(out.x[lane], first_derivative(op, p, 0), ROUND_OFF);
        ck_assert_near(out.y[lane], first_derivative(op, p, 1), ROUND_OFF);
        ck_assert_near(out.t[lane], first_derivative(op, p, 2), ROUND_OFF);
        ck_assert_near(out.xx[lane], second_derivative(op, p, 0, 0), DIFFERENCE);
        ck_assert_near(out.xy[lane], second_derivative(op, p, 0, 1), DIFFERENCE);
        ck_assert_near(out.yy[lane], second_derivative(op, p, 1, 1), DIFFERENCE);
        ck_assert_near(out.tt[lane], second_derivative(op, p, 2, 2), DIFFERENCE);
    }
}
END_TEST

START_TEST(every_operation_of_slopes_carries_the_gradient)
{
    const struct operation *const op = &OPERATIONS[_i];
    struct jet jets[2];
    if (op->of_slopes == NULL)
        return;
    make_jets(jets);
    const struct slope a = {jets[0].f, jets[0].x, jets[0].y};
    const struct slope b = {jets[1].f, jets[1].x, jets[1].y};
    const struct slope out = op->of_slopes(a, b);
    for (int lane = 0; lane < LANES; lane++) {
        const struct point p = {.x = 0.6 + 0.25 * lane, .y = -0.4, .t = 0.9};
        ck_assert_near(out.f[lane], creal(value_at(op, p)), ROUND_OFF);
        ck_assert_near(out.x[lane], first_derivative(op, p, 0), ROUND_OFF);
        ck_assert_near(out.y[lane], first_derivative(op, p, 1), ROUND_OFF);
    }
}
END_TEST

Suite *suite_jets(void)
{
    Suite *suite = suite_create("jets");
    TCase *of_lanes = tcase_create("lanes");
    tcase_add_test(of_lanes, sine_and_cosine_are_right_to_a_rounding_or_two_in_every_quadrant);
    tcase_add_test(of_lanes, an_inverse_cube_root_is_right_to_two_roundings);
    tcase_add_test(of_lanes, a_selection_takes_lane_by_lane);
    suite_add_tcase(suite, of_lanes);
    TCase *operations = tcase_create("operations");
    tcase_add_loop_test(operations, every_operation_of_jets_carries_all_derivatives, 0,
                        OPERATION_COUNT);
    tcase_add_loop_test(operations, every_operation_of_slopes_carries_the_gradient, 0,
                        OPERATION_COUNT);
    suite_add_tcase(suite, operations);
    return suite;
}
