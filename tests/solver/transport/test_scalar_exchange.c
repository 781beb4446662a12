/* Exchange of a scalar between the fields of one node.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/transport/scalar_exchange.h"
#include "suites.h"
#include "support/near.h"

#include <glib.h>
#include <math.h>

/* Contents of order 1; sums of ten products. */
static const double ROUND_OFF = 1e-14;
static const double STEP = 0.3;

/* Four fields: the first two perfect, conductances from there on in a ring. */
enum { SIDES = 4, LINKS = 5 };

static struct mpm_scalar_meeting four(double conductance)
{
    static const double capacity[SIDES] = {2.0, 0.5, 1e-3, 1.5};
    static const double value[SIDES] = {1.0, -2.0, 4.0, 0.3};
    static const double inflow[SIDES] = {0.1, -0.4, 0.002, 0.7};
    static const struct mpm_scalar_link links[LINKS] = {
        {.of = {0, 1}, .perfect = true},      {.of = {1, 2}, .conductance = 1.0},
        {.of = {2, 3}, .conductance = 0.5},   {.of = {3, 0}, .conductance = 2.0},
        {.of = {0, 2}, .conductance = 0.125},
    };
    struct mpm_scalar_meeting made = {.side_count = SIDES, .link_count = LINKS};
    for (int k = 0; k < SIDES; k++)
        made.sides[k] = (struct mpm_scalar_side){
            .capacity = capacity[k], .content = capacity[k] * value[k], .inflow = inflow[k]};
    for (int k = 0; k < LINKS; k++) {
        made.links[k] = links[k];
        made.links[k].conductance *= conductance;
    }
    return made;
}

static void exchange(struct mpm_scalar_meeting *meeting, double step, bool values)
{
    mpm_scalar_meeting_join(meeting);
    mpm_scalar_meeting_exchange(meeting, step, values);
}

static double gained(const struct mpm_scalar_side *side)
{
    return STEP * (side->capacity * side->rate - side->inflow);
}

static const double conductances[] = {0.0, 1e-6, 1.0, 1e3, 1e8, 1e15};

START_TEST(content_is_conserved_whatever_the_conductance)
{
    struct mpm_scalar_meeting meeting = four(conductances[_i]);
    double sum = 0.0;
    exchange(&meeting, STEP, false);
    for (int k = 0; k < SIDES; k++)
        sum += gained(&meeting.sides[k]);
    ck_assert_near(sum, 0.0, ROUND_OFF);
}
END_TEST

/* What links pass is what fields gain. */
START_TEST(what_links_pass_adds_up_to_what_fields_gain)
{
    for (int values = 0; values < 2; values++) {
        struct mpm_scalar_meeting meeting = four(conductances[_i]);
        double came[SIDES] = {0.0};
        exchange(&meeting, STEP, values != 0);
        for (int k = 0; k < LINKS; k++) {
            came[meeting.links[k].of[0]] -= meeting.links[k].passed;
            came[meeting.links[k].of[1]] += meeting.links[k].passed;
        }
        for (int k = 0; k < SIDES; k++) {
            const struct mpm_scalar_side *const side = &meeting.sides[k];
            const double taken = values == 0 ? 0.0 : side->capacity * side->value - side->content;
            ck_assert_near(came[k], gained(side) + taken, 10.0 * ROUND_OFF);
        }
    }
}
END_TEST

START_TEST(fields_that_are_one_have_the_value_and_the_rate_of_all_together)
{
    struct mpm_scalar_meeting meeting = four(0.0);
    exchange(&meeting, STEP, false);
    for (int k = 0; k < 2; k++) {
        ck_assert_near(meeting.sides[k].value, (2.0 * 1.0 - 0.5 * 2.0) / 2.5, ROUND_OFF);
        ck_assert_near(meeting.sides[k].rate, (0.1 - 0.4) / 2.5, ROUND_OFF);
    }
    ck_assert_near(meeting.sides[3].rate, 0.7 / 1.5, ROUND_OFF);
}
END_TEST

/* The equations themselves in 2^20 steps of Heun's method, of error h^2. */
START_TEST(conductances_exchange_as_their_equations_do)
{
    enum { STEPS = 1 << 20 };
    struct mpm_scalar_meeting meeting = four(0.2);
    static const int group[SIDES] = {0, 0, 1, 2};
    double v[3] = {0.4, 4.0, 0.3}, start[3];
    static const double capacity[3] = {2.5, 1e-3, 1.5}, inflow[3] = {-0.3, 0.002, 0.7};
    const double h = STEP / STEPS, g[3] = {0.2 * 1.125, 0.2 * 0.5, 0.2 * 2.0};
    exchange(&meeting, STEP, false);
    for (int k = 0; k < 3; k++)
        start[k] = v[k];
    for (int step = 0; step < STEPS; step++) {
        double rate[2][3], w[3] = {v[0], v[1], v[2]};
        for (int stage = 0; stage < 2; stage++) {
            const double a = g[0] * (w[0] - w[1]), b = g[1] * (w[1] - w[2]),
                         c = g[2] * (w[2] - w[0]);
            rate[stage][0] = (inflow[0] - a + c) / capacity[0];
            rate[stage][1] = (inflow[1] + a - b) / capacity[1];
            rate[stage][2] = (inflow[2] + b - c) / capacity[2];
            for (int k = 0; k < 3; k++)
                w[k] = v[k] + h * rate[0][k];
        }
        for (int k = 0; k < 3; k++)
            v[k] += 0.5 * h * (rate[0][k] + rate[1][k]);
    }
    for (int k = 0; k < SIDES; k++)
        ck_assert_near(meeting.sides[k].rate, (v[group[k]] - start[group[k]]) / STEP, 1e-7);
}
END_TEST

/* With no more than round-off between them after the step. */
START_TEST(a_large_conductance_makes_values_one)
{
    struct mpm_scalar_meeting meeting = four(1e12);
    double end[SIDES];
    exchange(&meeting, STEP, false);
    for (int k = 0; k < SIDES; k++)
        end[k] = meeting.sides[k].value + STEP * meeting.sides[k].rate;
    for (int k = 1; k < SIDES; k++)
        ck_assert_near(end[k], end[0], 1e-9);
}
END_TEST

/* What flows through a steady state is kept, with any step. */
START_TEST(a_steady_state_stays)
{
    for (double step = 1e-3; step < 1e4; step *= 10.0) {
        struct mpm_scalar_meeting meeting = {.side_count = 2, .link_count = 1};
        meeting.sides[0] = (struct mpm_scalar_side){.capacity = 3.0, .content = 3.0, .inflow = 0.5};
        meeting.sides[1] =
            (struct mpm_scalar_side){.capacity = 0.2, .content = 0.1, .inflow = -0.5};
        meeting.links[0] = (struct mpm_scalar_link){.of = {0, 1}, .conductance = 1.0};
        exchange(&meeting, step, false);
        ck_assert_near(meeting.sides[0].rate, 0.0, ROUND_OFF);
        ck_assert_near(meeting.sides[1].rate, 0.0, 10.0 * ROUND_OFF);
        ck_assert_near(meeting.links[0].passed, 0.5 * step, ROUND_OFF * step);
    }
}
END_TEST

/* Backwards, and each link from the other end. */
START_TEST(the_order_of_fields_and_links_does_not_matter)
{
    struct mpm_scalar_meeting meeting = four(conductances[_i]), other = four(conductances[_i]);
    for (int k = 0; k < SIDES; k++)
        other.sides[k] = meeting.sides[SIDES - 1 - k];
    for (int k = 0; k < LINKS; k++) {
        other.links[k] = meeting.links[LINKS - 1 - k];
        for (int end = 0; end < 2; end++)
            other.links[k].of[end] = SIDES - 1 - meeting.links[LINKS - 1 - k].of[1 - end];
    }
    exchange(&meeting, STEP, false);
    exchange(&other, STEP, false);
    for (int k = 0; k < SIDES; k++)
        ck_assert_near(other.sides[SIDES - 1 - k].rate, meeting.sides[k].rate, 100.0 * ROUND_OFF);
    for (int k = 0; k < LINKS; k++)
        ck_assert_near(other.links[LINKS - 1 - k].passed, -meeting.links[k].passed,
                       10.0 * ROUND_OFF);
}
END_TEST

Suite *suite_scalar_exchange(void)
{
    Suite *const suite = suite_create("scalar_exchange");
    TCase *const tests = tcase_create("scalar_exchange");
    const int count = (int)G_N_ELEMENTS(conductances);
    tcase_add_loop_test(tests, content_is_conserved_whatever_the_conductance, 0, count);
    tcase_add_loop_test(tests, what_links_pass_adds_up_to_what_fields_gain, 0, count);
    tcase_add_test(tests, fields_that_are_one_have_the_value_and_the_rate_of_all_together);
    tcase_add_test(tests, conductances_exchange_as_their_equations_do);
    tcase_add_test(tests, a_large_conductance_makes_values_one);
    tcase_add_test(tests, a_steady_state_stays);
    tcase_add_loop_test(tests, the_order_of_fields_and_links_does_not_matter, 0, count);
    suite_add_tcase(suite, tests);
    return suite;
}
