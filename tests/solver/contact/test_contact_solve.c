/* Impulses between the velocity fields of a node.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/contact/contact_solve.h"
#include "suites.h"
#include "support/near.h"

#include <float.h>
#include <glib.h>
#include <math.h>

/* Sums of some products of numbers of order 1; of many sweeps in the exchanges of several. */
static const double ROUND_OFF = 1e-14, SETTLED = 1e-11;

static struct mpm_contact_side side(double vx, double vy, double mass)
{
    return (struct mpm_contact_side){{vx, vy}, {1.0 / mass, 1.0 / mass}};
}

static struct mpm_solve_pair pair(int one, int other, double angle, enum mpm_pair_law law)
{
    return (struct mpm_solve_pair){.of = {one, other},
                                   .normal = {cos(angle), sin(angle)},
                                   .law = law,
                                   .friction = 0.3,
                                   .static_friction = 0.3};
}

static double along(const double v[2], double angle)
{
    return v[0] * cos(angle) + v[1] * sin(angle);
}

static const double angles[] = {0.0, 0.3, 1.2, 2.5, -0.7, 3.9};

/* What is left of the difference of two velocities, along the normal and across. */
static void difference(const struct mpm_contact_side sides[2], double angle, double left[2])
{
    const double v[2] = {sides[0].velocity[0] - sides[1].velocity[0],
                         sides[0].velocity[1] - sides[1].velocity[1]};
    left[0] = along(v, angle);
    left[1] = along(v, angle + 0.5 * G_PI);
}

START_TEST(each_law_stops_the_approach_and_what_it_says_of_the_sliding)
{
    static const enum mpm_pair_law laws[] = {MPM_PAIR_BONDED, MPM_PAIR_STICK, MPM_PAIR_FRICTIONLESS,
                                             MPM_PAIR_FRICTION};
    const double angle = angles[_i];
    for (size_t k = 0; k < G_N_ELEMENTS(laws); k++) {
        struct mpm_contact_side sides[2] = {
            side(2.0 * cos(angle) - 3.0 * sin(angle), 2.0 * sin(angle) + 3.0 * cos(angle), 2.0),
            side(0.0, 0.0, 3.0)};
        struct mpm_solve_pair solved = pair(0, 1, angle, laws[k]);
        double left[2];
        mpm_contact_solve(sides, &solved, 1);
        difference(sides, angle, left);
        ck_assert_near(left[0], 0.0, ROUND_OFF);
        /* reduced mass 1.2: p = 2.4, and friction takes 0.3 * 2.4/1.2 of the sliding speed */
        ck_assert_near(along(solved.impulse, angle), -2.4, ROUND_OFF);
        const double sliding[] = {0.0, 0.0, 3.0, 3.0 - 0.3 * 2.0};
        ck_assert_near(left[1], sliding[k], ROUND_OFF);
        for (int axis = 0; axis < 2; axis++) { /* momentum */
            const double before = 2.0 * (axis == 0 ? 2.0 * cos(angle) - 3.0 * sin(angle)
                                                   : 2.0 * sin(angle) + 3.0 * cos(angle));
            ck_assert_near(2.0 * sides[0].velocity[axis] + 3.0 * sides[1].velocity[axis], before,
                           ROUND_OFF);
        }
    }
}
END_TEST

START_TEST(pressure_of_round_off_does_not_make_fields_stick)
{
    for (int sign = -1; sign <= 1; sign += 2) {
        const double n[2] = {cos(angles[_i]), sin(angles[_i])};
        const double approach = sign * 1e-16;
        struct mpm_contact_side sides[2] = {
            side(approach * n[0] - 3.0 * n[1], approach * n[1] + 3.0 * n[0], 2.0),
            side(0.0, 0.0, 3.0)};
        struct mpm_solve_pair solved = pair(0, 1, angles[_i], MPM_PAIR_STICK);
        double left[2];
        mpm_contact_solve(sides, &solved, 1);
        difference(sides, angles[_i], left);
        ck_assert_near(left[1], 3.0, ROUND_OFF);
    }
}
END_TEST

START_TEST(fields_that_part_exchange_nothing_unless_they_are_bonded_or_adhere)
{
    const double angle = angles[_i];
    const struct mpm_contact_side parting[2] = {side(-cos(angle), -sin(angle), 1.0),
                                                side(0.0, 0.0, 1.0)};
    /* the impulse that would hold them is 1/2 */
    static const struct {
        enum mpm_pair_law law;
        double pull, impulse;
    } rows[] = {
        {MPM_PAIR_FRICTIONLESS, 0.0, 0.0}, {MPM_PAIR_STICK, 0.0, 0.0},
        {MPM_PAIR_FRICTION, 0.0, 0.0},     {MPM_PAIR_FRICTIONLESS, 0.499, 0.0},
        {MPM_PAIR_STICK, 0.501, 0.5},      {MPM_PAIR_FRICTIONLESS, 0.501, 0.5},
        {MPM_PAIR_BONDED, 0.0, 0.5},
    };
    for (size_t k = 0; k < G_N_ELEMENTS(rows); k++) {
        struct mpm_contact_side sides[2] = {parting[0], parting[1]};
        struct mpm_solve_pair solved = pair(0, 1, angle, rows[k].law);
        solved.pull = rows[k].pull;
        mpm_contact_solve(sides, &solved, 1);
        ck_assert_near(along(solved.impulse, angle), rows[k].impulse, ROUND_OFF);
    }
}
END_TEST

/* Sliding speed s, approach 1, masses 1: p = 1/2; friction can take a speed of 2 mu p. */
START_TEST(what_is_below_static_friction_sticks_and_what_is_above_slides_with_the_other)
{
    static const struct {
        double sliding, left;
    } rows[] = {{0.39, 0.0}, {0.41, 0.21}, {-0.39, 0.0}, {-0.41, -0.21}};
    for (size_t k = 0; k < G_N_ELEMENTS(rows); k++) {
        struct mpm_contact_side sides[2] = {side(1.0, rows[k].sliding, 1.0), side(0.0, 0.0, 1.0)};
        struct mpm_solve_pair solved = pair(0, 1, 0.0, MPM_PAIR_FRICTION);
        solved.friction = 0.2;
        solved.static_friction = 0.4;
        mpm_contact_solve(sides, &solved, 1);
        ck_assert_near(sides[0].velocity[1] - sides[1].velocity[1], rows[k].left, ROUND_OFF);
    }
}
END_TEST

START_TEST(a_gap_allows_the_approach_that_closes_it)
{
    struct mpm_contact_side sides[2] = {side(1.0, 0.0, 1.0), side(0.0, 0.0, 1.0)};
    struct mpm_solve_pair solved = pair(0, 1, 0.0, MPM_PAIR_FRICTIONLESS);
    solved.approach = 0.25;
    mpm_contact_solve(sides, &solved, 1);
    ck_assert_near(sides[0].velocity[0] - sides[1].velocity[0], 0.25, ROUND_OFF);
    solved.approach = 1.5;
    sides[0] = side(1.0, 0.0, 1.0);
    sides[1] = side(0.0, 0.0, 1.0);
    mpm_contact_solve(sides, &solved, 1);
    ck_assert_double_eq(sides[0].velocity[0], 1.0);
}
END_TEST

START_TEST(held_components_stay_and_the_other_field_takes_it_all)
{
    struct mpm_contact_side sides[2] = {side(1.0, 0.5, 1.0), side(0.0, 0.0, 1.0)};
    struct mpm_solve_pair solved = pair(0, 1, 0.0, MPM_PAIR_STICK);
    sides[1].mobility[0] = sides[1].mobility[1] = 0.0;
    mpm_contact_solve(sides, &solved, 1);
    for (int axis = 0; axis < 2; axis++) {
        ck_assert_near(sides[0].velocity[axis], 0.0, ROUND_OFF);
        ck_assert_double_eq(sides[1].velocity[axis], 0.0);
    }
    sides[0].mobility[0] = sides[0].mobility[1] = 0.0;
    sides[0].velocity[0] = 1.0;
    mpm_contact_solve(sides, &solved, 1);
    ck_assert_double_eq(sides[0].velocity[0], 1.0); /* both held */
}
END_TEST

/* ------------------------------------------------------------------- several */

enum { THREE = 3 };

static void three(struct mpm_contact_side sides[THREE], double middle)
{
    sides[0] = side(1.0, 0.2, 2.0);
    sides[1] = side(-0.3, 0.5, middle);
    sides[2] = side(-1.1, -0.4, 0.7);
}

static double momentum_of(const struct mpm_contact_side *sides, int count, int axis)
{
    double sum = 0.0;
    for (int k = 0; k < count; k++)
        sum += sides[k].velocity[axis] / sides[k].mobility[axis];
    return sum;
}

START_TEST(bonded_fields_all_get_the_velocity_of_their_centre_of_mass)
{
    static const double middles[] = {1.0, 1000.0, 0.001};
    struct mpm_contact_side sides[THREE];
    three(sides, middles[_i]);
    const double mass = 2.0 + middles[_i] + 0.7;
    const double mean[2] = {momentum_of(sides, THREE, 0) / mass,
                            momentum_of(sides, THREE, 1) / mass};
    struct mpm_solve_pair pairs[THREE] = {pair(0, 1, 0.1, MPM_PAIR_BONDED),
                                          pair(0, 2, 0.9, MPM_PAIR_BONDED),
                                          pair(1, 2, 2.0, MPM_PAIR_BONDED)};
    mpm_contact_solve(sides, pairs, THREE);
    for (int k = 0; k < THREE; k++)
        for (int axis = 0; axis < 2; axis++)
            ck_assert_near(sides[k].velocity[axis], mean[axis], SETTLED);
}
END_TEST

/* Three fields at a node, two of which touch: the third does not change what these exchange. */
START_TEST(a_field_that_touches_none_changes_nothing)
{
    struct mpm_contact_side sides[THREE], alone[2];
    three(sides, 1.3);
    alone[0] = sides[0];
    alone[1] = sides[1];
    struct mpm_solve_pair beside = pair(0, 1, 0.2, MPM_PAIR_FRICTION), lone = beside;
    mpm_contact_solve(sides, &beside, 1);
    mpm_contact_solve(alone, &lone, 1);
    for (int axis = 0; axis < 2; axis++) {
        ck_assert_near(sides[0].velocity[axis], alone[0].velocity[axis], ROUND_OFF);
        ck_assert_near(sides[1].velocity[axis], alone[1].velocity[axis], ROUND_OFF);
    }
}
END_TEST

/* In any order of fields and of pairs; no pair is left with approach, none pulls. */
START_TEST(contact_of_several_fields_does_not_depend_on_their_order)
{
    static const enum mpm_pair_law laws[] = {MPM_PAIR_FRICTIONLESS, MPM_PAIR_FRICTION,
                                             MPM_PAIR_STICK};
    static const int orders[][THREE] = {{0, 1, 2}, {2, 1, 0}, {1, 0, 2}, {1, 2, 0}};
    double first[THREE][2] = {{0.0}};
    for (size_t k = 0; k < G_N_ELEMENTS(orders); k++) {
        const int *const order = orders[k]; /* where a field is now */
        struct mpm_contact_side fields[THREE], sides[THREE];
        three(fields, 1.3);
        for (int i = 0; i < THREE; i++)
            sides[order[i]] = fields[i];
        struct mpm_solve_pair pairs[THREE] = {pair(order[0], order[1], 0.2, laws[_i]),
                                              pair(order[1], order[2], -0.4, laws[_i]),
                                              pair(order[0], order[2], 0.1, laws[_i])};
        if (k % 2 == 1) { /* the same pair, named the other way round, and the last first */
            pairs[0] = pair(order[0], order[2], 0.1, laws[_i]);
            pairs[2] = pair(order[1], order[0], 0.2 + G_PI, laws[_i]);
        }
        mpm_contact_solve(sides, pairs, THREE);
        for (int i = 0; i < THREE; i++)
            for (int axis = 0; axis < 2; axis++) {
                if (k == 0)
                    first[i][axis] = sides[order[i]].velocity[axis];
                ck_assert_near(sides[order[i]].velocity[axis], first[i][axis], SETTLED);
            }
        for (int i = 0; i < THREE; i++) {
            const double *const n = pairs[i].normal;
            double approach = 0.0, pressed = 0.0;
            for (int axis = 0; axis < 2; axis++) {
                approach += n[axis] * (sides[pairs[i].of[0]].velocity[axis] -
                                       sides[pairs[i].of[1]].velocity[axis]);
                pressed -= n[axis] * pairs[i].impulse[axis];
            }
            ck_assert_double_le(approach, SETTLED);
            ck_assert_double_ge(pressed, -ROUND_OFF);
            ck_assert_double_le(fabs(approach * pressed), SETTLED);
        }
    }
}
END_TEST

/* Four blocks around a point (case C9): sweeps of stick alone go round in circles here. */
enum { FOUR = 4, SIX = 6 };

static void around_a_point(struct mpm_contact_side sides[FOUR], struct mpm_solve_pair pairs[SIX],
                           enum mpm_pair_law law)
{
    static const struct {
        int of[2];
        double angle, approach;
    } rows[SIX] = {
        {{0, 1}, 0.27937614225915652, 0.0010689854333093742},
        {{0, 2}, 0.27937614225915652, 0.0},
        {{0, 3}, 0.27937614225915652, 13.960233837424404},
        {{1, 2}, 2.8635796405789833, 13.901165915543515},
        {{1, 3}, 2.8635796405789833, 0.0},
        {{2, 3}, -1.1124469242114432, 0.0},
    };
    sides[0] = side(0.0056741227103868719, 0.0052395420480553234, 440.73334626076451);
    sides[1] = side(-0.0053281037773667758, -0.00016348836683164348, 0.43863655468398283);
    sides[2] = side(0.0051231608409257464, -0.0099219714893043764, 0.62355476274313282);
    sides[3] = side(-0.034873950040852197, -0.028114143243122138, 0.062452656823458623);
    for (int k = 0; k < SIX; k++) {
        pairs[k] = pair(rows[k].of[0], rows[k].of[1], rows[k].angle, law);
        pairs[k].approach = rows[k].approach;
        pairs[k].friction = pairs[k].static_friction = 10.0;
    }
}

/* What is left of pair k: approach beyond what is allowed, sliding, and both parts of its impulse.
 */
struct left {
    double approach, sliding, pressed, dragged;
};

static struct left left_of(const struct mpm_contact_side *sides,
                           const struct mpm_solve_pair *solved)
{
    const double *const n = solved->normal, *const impulse = solved->impulse;
    const double *const one = sides[solved->of[0]].velocity, *const other =
                                                                 sides[solved->of[1]].velocity;
    const double v[2] = {one[0] - other[0], one[1] - other[1]};
    return (struct left){
        .approach = n[0] * v[0] + n[1] * v[1] - solved->approach,
        .sliding = n[0] * v[1] - n[1] * v[0],
        .pressed = -n[0] * impulse[0] - n[1] * impulse[1],
        .dragged = n[0] * impulse[1] - n[1] * impulse[0],
    };
}

START_TEST(laws_hold_where_sweeps_of_stick_alone_go_round_in_circles)
{
    static const enum mpm_pair_law laws[] = {MPM_PAIR_STICK, MPM_PAIR_FRICTION,
                                             MPM_PAIR_FRICTIONLESS};
    struct mpm_contact_side sides[FOUR];
    struct mpm_solve_pair pairs[SIX];
    around_a_point(sides, pairs, laws[_i]);
    mpm_contact_solve(sides, pairs, SIX);
    for (int k = 0; k < SIX; k++) {
        const struct left left = left_of(sides, &pairs[k]);
        const bool slides = laws[_i] == MPM_PAIR_FRICTIONLESS || left.pressed < SETTLED;
        ck_assert_double_le(left.approach, SETTLED);
        ck_assert_double_ge(left.pressed, -SETTLED);
        ck_assert_double_le(fabs(left.approach * left.pressed), SETTLED);
        if (slides)
            ck_assert_near(left.dragged, 0.0, SETTLED);
        else
            ck_assert_near(left.sliding, 0.0, SETTLED);
    }
}
END_TEST

/* Where four of eight wedges meet (case C9). In one of both, sweeps are about to settle when they
 * have been enough; in the other, those with a friction of 10 go round in circles. */
enum { MEETINGS = 2 };
static const struct {
    double vx, vy, mass;
} of_wedges[MEETINGS][FOUR] = {
    {{0.0061438253866587722, -0.006571570731407619, 21.4248191100078},
     {0.0052055381946600424, -0.0043274964600307237, 737.312655192265},
     {0.0011261980973459103, 0.008554065960448512, 0.05574670734169856},
     {0.0045615858700690662, 0.010506203043053185, 5.926465619985813e-06}},
    {{0.0033690948159583794, -0.0046471581158278171, 21.309226818451144},
     {0.0052312923731072805, -0.0025576638679235862, 731.93419415627613},
     {0.0047930144338814984, 0.0011670510464691787, 0.055555887576859843},
     {-9.7001481225542435e-05, 0.0026716520755194467, 5.3111678991417142e-09}},
};
static const struct {
    int of[2];
    double angle, approach;
} between_wedges[MEETINGS][SIX] = {
    {{{0, 1}, -2.7187535423658269, 0.0},
     {{0, 2}, -2.2786307358606073, 130.97261935229747},
     {{0, 3}, -2.2786307358606073, 75.272833404652118},
     {{1, 2}, 0.42283911122396645, 0.0},
     {{1, 3}, 0.42283911122396645, 0.0},
     {{2, 3}, 1.5722282219345844, 0.0}},
    {{{0, 1}, -2.7266323099269907, 0.0},
     {{0, 2}, -2.2820927292269837, 131.97618675743391},
     {{0, 3}, -2.2820927292269837, 76.176180657927574},
     {{1, 2}, 0.41496034366280271, 0.0},
     {{1, 3}, 0.41496034366280271, 0.0},
     {{2, 3}, 1.570850038137156, 0.0}},
};

static void wedges_meet(int meeting, enum mpm_pair_law law, double shake,
                        struct mpm_contact_side sides[FOUR], struct mpm_solve_pair pairs[SIX])
{
    for (int i = 0; i < FOUR; i++) {
        sides[i] =
            side(of_wedges[meeting][i].vx, of_wedges[meeting][i].vy, of_wedges[meeting][i].mass);
        for (int axis = 0; axis < 2; axis++)
            sides[i].velocity[axis] *= 1.0 + ((3 * i + axis) % 4 - 1.5) * shake;
    }
    for (int k = 0; k < SIX; k++) {
        const int *const of = between_wedges[meeting][k].of;
        pairs[k] = pair(of[0], of[1], between_wedges[meeting][k].angle, law);
        pairs[k].approach = between_wedges[meeting][k].approach;
        pairs[k].friction = pairs[k].static_friction = 10.0;
    }
}

static double energy_of(const struct mpm_contact_side sides[FOUR])
{
    double energy = 0.0;
    for (int i = 0; i < FOUR; i++)
        for (int axis = 0; axis < 2; axis++)
            energy +=
                0.5 * sides[i].velocity[axis] * sides[i].velocity[axis] / sides[i].mobility[axis];
    return energy;
}

START_TEST(a_shake_does_not_decide_what_fields_of_many_masses_do)
{
    const enum mpm_pair_law law = _i / MEETINGS == 0 ? MPM_PAIR_STICK : MPM_PAIR_FRICTION;
    enum { SHAKES = 20 };
    static const double SHAKE = 1e-9, ALLOWED = 3e-8; /* ten times what it does */
    struct mpm_contact_side sides[FOUR], shaken[FOUR];
    struct mpm_solve_pair pairs[SIX];
    wedges_meet(_i % MEETINGS, law, 0.0, sides, pairs);
    const double before = energy_of(sides);
    mpm_contact_solve(sides, pairs, SIX);
    ck_assert_double_le(energy_of(sides), before);
    for (int k = 0; k < SIX; k++) {
        const struct left left = left_of(sides, &pairs[k]);
        ck_assert_double_le(left.approach, SETTLED);
        if (fabs(left.sliding) > SETTLED) /* as much drag as there is pressure, at least */
            ck_assert_double_ge(fabs(left.dragged), 0.999 * left.pressed);
    }
    for (int n = -SHAKES; n <= SHAKES; n++) {
        wedges_meet(_i % MEETINGS, law, n * SHAKE, shaken, pairs);
        mpm_contact_solve(shaken, pairs, SIX);
        for (int i = 0; i < FOUR; i++)
            for (int axis = 0; axis < 2; axis++)
                ck_assert_near(shaken[i].velocity[axis], sides[i].velocity[axis], ALLOWED);
    }
}
END_TEST

/* Held along y: both parts of a pair move the fields along x, and two pairs share the same fields
 * (materials of one field, each with a pair of its own). The difference is round-off of a velocity,
 * which sweeps do not bring down any further, so that those within bounds follow. */
START_TEST(fields_that_are_held_along_an_axis_keep_their_velocities)
{
    enum { LAST_DIGITS = 60 };
    static const double VELOCITY = 0.0058604048888202297, oblique = -2.3561200244;
    const enum mpm_pair_law law = _i % 2 == 0 ? MPM_PAIR_BONDED : MPM_PAIR_STICK;
    const double angle = _i / 2 == 0 ? oblique : angles[_i / 2 - 1];
    for (int n = 1; n < LAST_DIGITS; n++) {
        struct mpm_contact_side sides[2] = {
            side(VELOCITY, 0.0, 0.031245), side(VELOCITY * (1.0 - n * DBL_EPSILON), 0.0, 0.031217)};
        sides[0].mobility[1] = sides[1].mobility[1] = 0.0;
        struct mpm_solve_pair pairs[2] = {pair(0, 1, angle, law), pair(1, 0, angle + G_PI, law)};
        mpm_contact_solve(sides, pairs, 2);
        for (int i = 0; i < 2; i++) {
            ck_assert_near(sides[i].velocity[0], VELOCITY, 1e-15);
            ck_assert_near(sides[i].velocity[1], 0.0, 0.0);
        }
    }
}
END_TEST

Suite *suite_contact_solve(void)
{
    Suite *suite = suite_create("contact_solve");
    TCase *two = tcase_create("two");
    tcase_add_loop_test(two, each_law_stops_the_approach_and_what_it_says_of_the_sliding, 0,
                        G_N_ELEMENTS(angles));
    tcase_add_loop_test(two, pressure_of_round_off_does_not_make_fields_stick, 0,
                        G_N_ELEMENTS(angles));
    tcase_add_loop_test(two, fields_that_part_exchange_nothing_unless_they_are_bonded_or_adhere, 0,
                        G_N_ELEMENTS(angles));
    tcase_add_test(two,
                   what_is_below_static_friction_sticks_and_what_is_above_slides_with_the_other);
    tcase_add_test(two, a_gap_allows_the_approach_that_closes_it);
    tcase_add_test(two, held_components_stay_and_the_other_field_takes_it_all);
    suite_add_tcase(suite, two);
    TCase *several = tcase_create("several");
    tcase_add_loop_test(several, bonded_fields_all_get_the_velocity_of_their_centre_of_mass, 0, 3);
    tcase_add_test(several, a_field_that_touches_none_changes_nothing);
    tcase_add_loop_test(several, contact_of_several_fields_does_not_depend_on_their_order, 0, 3);
    tcase_add_loop_test(several, laws_hold_where_sweeps_of_stick_alone_go_round_in_circles, 0, 3);
    tcase_add_loop_test(several, a_shake_does_not_decide_what_fields_of_many_masses_do, 0,
                        2 * MEETINGS);
    tcase_add_loop_test(several, fields_that_are_held_along_an_axis_keep_their_velocities, 0,
                        2 * (1 + (int)G_N_ELEMENTS(angles)));
    suite_add_tcase(suite, several);
    return suite;
}
