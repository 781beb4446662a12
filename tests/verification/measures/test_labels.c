/* Labels of pictures: whatever the numbers, none overlaps another or leaves the picture.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"

#include "verification/measures/comparison/axis_tics.h"
#include "verification/measures/comparison/label_places.h"

#include <glib.h>
#include <math.h>
#include <string.h>

static const unsigned SEED = 760520;

/* -------------------------------------------------------------------- widths */

/* DejaVu Sans, from ' ' to '~', in thousandths of the size: the font that a Linux machine without
 * others takes for Helvetica, and wider than Helvetica. */
static const int dejavu[] = {
    318, 401, 460, 838, 636, 950, 780, 275, 390, 390, 500, 838, 318, 361,  318, 337, 636, 636, 636,
    636, 636, 636, 636, 636, 636, 636, 337, 337, 838, 838, 838, 531, 1000, 684, 686, 698, 770, 632,
    575, 775, 752, 295, 295, 656, 557, 863, 748, 787, 603, 787, 695, 635,  611, 732, 684, 989, 685,
    611, 685, 390, 337, 390, 838, 500, 500, 613, 635, 550, 635, 615, 352,  635, 634, 278, 278, 579,
    278, 974, 634, 612, 635, 635, 411, 521, 392, 634, 592, 818, 592, 592,  525, 636, 337, 636, 838};

START_TEST(widths_are_at_least_those_of_a_wide_font)
{
    for (int letter = ' '; letter <= '~'; letter++) {
        const char text[] = {(char)letter, '\0'};
        const double width = axis_text_width(text, 1000);
        ck_assert_msg(width >= dejavu[letter - ' '] && width <= 3 * dejavu[letter - ' '],
                      "'%s': %g, the font has %d", text, width, dejavu[letter - ' ']);
    }
    ck_assert(axis_text_width("2·10^{-5}", 10) < axis_text_width("2·10-5", 10));
    ck_assert(axis_text_width("", 10) == 0.0);
}
END_TEST

/* ---------------------------------------------------------------------- tics */

static const struct axis_room rooms[] = {
    {.length = 650, .along = true, .beyond = 15, .font = 14},
    {.length = 370, .across = 60, .font = 14},
    {.length = 40, .along = true, .beyond = 0, .font = 14}, /* hardly any */
};
enum { ROOMS = sizeof rooms / sizeof *rooms };

/* The number of a label: "0.02", "2·10^{-5}", "-10^{6}". */
static double number_of(const char *text)
{
    char *power = strstr(text, "10^{"), *point = strstr(text, "·");
    ck_assert_msg(strchr(text, 'e') == NULL, "%s", text);
    if (power == NULL)
        return g_ascii_strtod(text, NULL);
    const double sign = *text == '-' ? -1.0 : 1.0;
    return (point == NULL ? sign : g_ascii_strtod(text, NULL)) *
           pow(10, g_ascii_strtod(power + 4, NULL));
}

static void check_tics(double low, double high, const struct axis_room *room, size_t least)
{
    struct axis_tic tics[AXIS_TICS_MAX];
    const struct axis_range range = axis_range_of(low, high);
    ck_assert_msg(isfinite(range.low) && isfinite(range.high) && range.low < range.high,
                  "%g to %g: %g .. %g", low, high, range.low, range.high);
    const size_t count = axis_tics(&range, room, tics);
    ck_assert_msg(count >= least && count <= AXIS_TICS_MAX, "%.17g to %.17g: %zu tics", low, high,
                  count);
    double end = room->along ? -room->beyond : -HUGE_VAL;
    for (size_t i = 0; i < count; i++) {
        const double at = room->length * axis_place(&range, tics[i].value);
        const double width = axis_text_width(tics[i].text, room->font);
        const double half = 0.5 * (room->along ? width : room->font);
        ck_assert_msg(at - half >= end, "%.17g to %.17g: '%s' is on '%s'", low, high, tics[i].text,
                      i == 0 ? "the margin" : tics[i - 1].text);
        ck_assert(tics[i].value >= range.low && tics[i].value <= range.high);
        ck_assert_msg(fabs(number_of(tics[i].text) - tics[i].value) <=
                          1e-3 * (range.high / 2 - range.low / 2) + 1e-12 * fabs(tics[i].value),
                      "'%s' is at %.17g", tics[i].text, tics[i].value);
        ck_assert(room->along || width <= room->across);
        end = at + half;
    }
    ck_assert(!room->along || end <= room->length + room->beyond);
}

START_TEST(tics_of_usual_numbers_are_several)
{
    static const double ranges[][2] = {
        {1, 2},    {0.013, 0.094}, {1e-4, 5e-4}, {2, 2.3},      {-3, 40},     {1e-6, 1}, {0, 0.05},
        {0.3, 45}, {1e3, 9e3},     {-2, -1},     {1e-15, 1e-2}, {2e6, 1.1e7}, {0.9, 11}};
    for (size_t i = 0; i < G_N_ELEMENTS(ranges); i++)
        for (size_t room = 0; room < 2; room++)
            check_tics(ranges[i][0], ranges[i][1], &rooms[room], 2);
}
END_TEST

START_TEST(tics_of_degenerate_numbers_do_not_overlap)
{
    static const double ranges[][2] = {{0, 0},
                                       {1, 1},
                                       {-1e-300, 1e-300},
                                       {5e-324, 5e-324},
                                       {0, 5e-324},
                                       {1e300, 1e308},
                                       {-1.7e308, 1.7e308},
                                       {1e-308, 1.7e308},
                                       {123456.1, 123456.2},
                                       {1, 1 + 1e-9},
                                       {1234567.1, 1234569.9},
                                       {-1e-12, 1e12},
                                       {1e-290, 1e290},
                                       {0.1, 1.0000001}};
    for (size_t i = 0; i < G_N_ELEMENTS(ranges); i++)
        for (size_t room = 0; room < ROOMS; room++)
            check_tics(ranges[i][0], ranges[i][1], &rooms[room], 0);
}
END_TEST

static double draw(GRand *random)
{
    const double size = pow(10, g_rand_double_range(random, -12, 12));
    return (g_rand_boolean(random) ? 1 : -1) * size * g_rand_double_range(random, 1, 10);
}

START_TEST(tics_of_any_numbers_do_not_overlap)
{
    enum { RANGES = 4000 };
    GRand *const random = g_rand_new_with_seed(SEED);
    for (int k = 0; k < RANGES; k++) {
        const double one = draw(random);
        /* as likely far away as next to the first */
        const double other =
            k % 2 == 0 ? draw(random) : one * (1 + pow(10, g_rand_double_range(random, -9, 1)));
        check_tics(fmin(one, other), fmax(one, other), &rooms[k % ROOMS], 0);
    }
    g_rand_free(random);
}
END_TEST

/* -------------------------------------------------------------------- labels */

enum { POINTS = 60 };
static const struct label_frame frame = {650, 370, 6};

static bool overlap(const struct label_place *one, const struct label_place *other)
{
    return one->left < other->left + other->width && other->left < one->left + one->width &&
           one->low < other->low + other->height && other->low < one->low + one->height;
}

static size_t check_labels(struct label_place *labels, size_t count)
{
    const size_t placed = label_places_find(labels, count, &frame);
    for (size_t i = 0; i < count; i++) {
        if (!labels[i].placed)
            continue;
        ck_assert(labels[i].left >= 0 && labels[i].left + labels[i].width <= frame.width);
        ck_assert(labels[i].low >= 0 && labels[i].low + labels[i].height <= frame.height);
        for (size_t j = 0; j < count; j++) {
            ck_assert_msg(i == j || !labels[j].placed || !overlap(&labels[i], &labels[j]),
                          "label %zu is on %zu", i, j);
            const struct label_place mark = {.left = labels[j].x - frame.mark,
                                             .low = labels[j].y - frame.mark,
                                             .width = 2 * frame.mark,
                                             .height = 2 * frame.mark};
            ck_assert_msg(!overlap(&labels[i], &mark), "label %zu is on point %zu", i, j);
        }
    }
    return placed;
}

/* Where points are: anywhere, in one place, on a line, in a corner, in a few places, close. */
static void draw_point(GRand *random, int kind, struct label_place *label)
{
    const double x = g_rand_double(random), y = g_rand_double(random);
    const double places[][2] = {{x, y},
                                {0.4, 0.6},
                                {x, 0.5},
                                {floor(2 * x), floor(2 * y)},
                                {floor(4 * x) / 4, 0},
                                {0.5 + 0.03 * x, 0.5 + 0.03 * y}};
    label->x = frame.width * places[kind][0];
    label->y = frame.height * places[kind][1];
    label->width = axis_text_width("ugimp_musl_xpic2", 12) * (0.1 + g_rand_double(random));
    label->height = 14;
}

START_TEST(labels_of_any_points_do_not_overlap)
{
    enum { SETS = 40 };
    GRand *const random = g_rand_new_with_seed(SEED);
    size_t placed = 0;
    for (int set = 0; set < SETS; set++) {
        struct label_place labels[POINTS];
        for (int i = 0; i < POINTS; i++)
            draw_point(random, _i, &labels[i]);
        placed += check_labels(labels, POINTS);
    }
    ck_assert_uint_ge(placed, SETS); /* the first one finds room wherever it is */
    g_rand_free(random);
}
END_TEST

Suite *suite_labels(void)
{
    Suite *suite = suite_create("labels");
    TCase *tics = tcase_create("tics"), *labels = tcase_create("labels");
    tcase_add_test(tics, widths_are_at_least_those_of_a_wide_font);
    tcase_add_test(tics, tics_of_usual_numbers_are_several);
    tcase_add_test(tics, tics_of_degenerate_numbers_do_not_overlap);
    tcase_add_test(tics, tics_of_any_numbers_do_not_overlap);
    suite_add_tcase(suite, tics);
    tcase_add_loop_test(labels, labels_of_any_points_do_not_overlap, 0, 6);
    suite_add_tcase(suite, labels);
    return suite;
}
