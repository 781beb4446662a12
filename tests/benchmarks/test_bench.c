/* mpm-bench: statistics, verdicts, records, comparison of runs, commands.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/folder.h"
#include "support/verify.h"

#include "benchmarks/cli/commands.h"
#include "benchmarks/common/bench.h"
#include "verification/common/record.h"

#include <glib.h>
#include <glib/gstdio.h>
#include <math.h>
#include <string.h>

/* --------------------------------------------------------------- statistics */

START_TEST(a_median_is_the_middle_or_the_mean_of_the_middle_two)
{
    const double odd[] = {5, 1, 4, 2, 3}, even[] = {4, 1, 3, 2};
    ck_assert_double_eq(bench_median(odd, 5), 3);
    ck_assert_double_eq(bench_median(even, 4), 2.5);
    ck_assert_double_eq(bench_median(odd, 1), 5);
    ck_assert_double_eq(odd[0], 5); /* the samples stay as they were */
}
END_TEST

/* The median of resamples of n values is the k-th or less with the probability that at least
 * (n + 1) / 2 of n draws are. */
static double probability_up_to(int n, int k)
{
    double sum = 0, choose = 1;
    for (int m = 0; m <= n; m++) {
        if (m >= (n + 1) / 2)
            sum += choose * pow((double)k / n, m) * pow(1 - (double)k / n, n - m);
        choose = choose * (n - m) / (m + 1);
    }
    return sum;
}

/* 2000 resamples place a probability to sqrt(0.025 0.975 / 2000) = 0.0035: where a percentile
 * is nearer to a step of the distribution than four of these, it may be on either side. */
START_TEST(the_interval_holds_the_percentiles_of_the_exact_bootstrap_distribution)
{
    static const double slack = 4 * 0.0035;
    for (int n = 1; n <= 31; n += 2) {
        double values[31];
        for (int i = 0; i < n; i++)
            values[i] = (32 * i + 3) % n + 1; /* 1 .. n in another order, as n is odd */
        int least = 1, most = 1;
        while (probability_up_to(n, least) < 0.025 - slack)
            least++;
        while (probability_up_to(n, most) < 0.025 + slack)
            most++;
        const struct bench_interval interval = bench_interval_of(values, (size_t)n);
        ck_assert_double_eq(interval.median, 0.5 * (n + 1));
        ck_assert_double_ge(interval.low, least);
        ck_assert_double_le(interval.low, most);
        ck_assert_double_le(interval.high, n + 1 - least);
        ck_assert_double_ge(interval.high, n + 1 - most);
    }
}
END_TEST

START_TEST(the_same_samples_give_the_same_interval)
{
    const double values[] = {1.0, 1.3, 0.9, 1.1, 1.2, 1.05, 0.97};
    const struct bench_interval one = bench_interval_of(values, 7),
                                other = bench_interval_of(values, 7);
    ck_assert_double_eq(one.low, other.low);
    ck_assert_double_eq(one.high, other.high);
}
END_TEST

/* Rounds that are slowed down by up to five, both points alike: a factor of 1.1 between them
 * is the ratio of every pair to round-off, and is lost when the pairs are broken up. */
START_TEST(pairs_cancel_what_slows_a_whole_round_down)
{
    const double against[] = {1, 5, 2, 3, 4};
    double values[5];
    for (int i = 0; i < 5; i++)
        values[i] = 1.1 * against[i];
    const struct bench_interval paired = bench_ratio_paired(values, against, 5);
    const struct bench_interval broken = bench_ratio_unpaired(values, 5, against, 5);
    ck_assert_double_eq_tol(paired.low, 1.1, 1e-15);
    ck_assert_double_eq_tol(paired.high, 1.1, 1e-15);
    ck_assert_double_eq_tol(broken.median, 1.1, 1e-15);
    ck_assert(broken.low < 1 && broken.high > 1);
}
END_TEST

START_TEST(a_difference_is_called_only_beyond_noise_and_five_per_cent)
{
    static const struct {
        struct bench_interval ratio;
        size_t rounds;
        enum bench_sense sense;
        enum bench_verdict verdict;
    } rows[] = {
        {{1.10, 1.06, 1.12}, 5, BENCH_RATE, BENCH_FASTER},
        {{1.10, 1.06, 1.12}, 5, BENCH_COST, BENCH_SLOWER},
        {{0.90, 0.85, 0.95}, 5, BENCH_RATE, BENCH_SLOWER},
        {{0.90, 0.85, 0.95}, 5, BENCH_COST, BENCH_FASTER},
        {{1.10, 0.99, 1.20}, 9, BENCH_RATE, BENCH_NOT_RESOLVED}, /* within noise */
        {{0.90, 0.80, 1.01}, 9, BENCH_RATE, BENCH_NOT_RESOLVED},
        {{1.04, 1.03, 1.05}, 9, BENCH_RATE, BENCH_NOT_RESOLVED}, /* resolved, but small */
        {{0.96, 0.95, 0.97}, 9, BENCH_RATE, BENCH_NOT_RESOLVED},
        {{1.05, 1.04, 1.06}, 9, BENCH_RATE, BENCH_NOT_RESOLVED},
        {{1.10, 1.00, 1.20}, 9, BENCH_RATE, BENCH_NOT_RESOLVED}, /* 1 is inside */
        {{2.00, 1.90, 2.10}, 4, BENCH_RATE, BENCH_NOT_RESOLVED}, /* too few rounds */
        {{(double)NAN, (double)NAN, (double)NAN}, 9, BENCH_RATE, BENCH_NOT_RESOLVED},
    };
    for (size_t i = 0; i < G_N_ELEMENTS(rows); i++)
        ck_assert_msg(bench_verdict_of(rows[i].ratio, rows[i].rounds, rows[i].sense) ==
                          rows[i].verdict,
                      "row %zu", i);
}
END_TEST

/* ------------------------------------------------------------------- records */

static const double sample_rounds[] = {1.25e6, 1.5e6, 1.0e6, 1.125e6, 1.375e6};
enum { SAMPLES = sizeof sample_rounds / sizeof sample_rounds[0] };

/* A run with one line of each kind; every round is multiplied by `factor`. */
static struct bench_records sample_records(double factor)
{
    struct bench_records records = bench_records_make("quick", "mpm-bench run", 9);
    json_t *settings = json_pack("{s:s, s:i}", "shape", "cpdi", "particles", 100);
    const struct bench_subject subject = {"throughput", "cpdi", settings};
    double rounds[SAMPLES];
    for (size_t i = 0; i < SAMPLES; i++)
        rounds[i] = factor * sample_rounds[i];
    (void)bench_records_result(&records, &subject, "particle_steps_per_second", "1/s", rounds,
                               SAMPLES);
    (void)bench_records_value(&records, &subject, "bytes_per_particle", "B", 240);
    (void)bench_records_value(&records, &subject, "error", "%", (double)NAN);
    (void)bench_records_comparison(&records, &subject, "ugimp", "particle_steps_per_second",
                                   (struct bench_interval){2, 1.5, 2.5}, BENCH_FASTER);
    json_decref(settings);
    return records;
}

static char *sample_folder(double factor)
{
    char *folder = test_folder_create();
    struct mpm_error error;
    struct bench_records records = sample_records(factor);
    ck_assert_int_eq(bench_records_write(folder, &records, &error), MPM_OK);
    bench_records_clear(&records);
    return folder;
}

START_TEST(records_are_read_back_as_they_were_written)
{
    char *folder = sample_folder(1);
    struct mpm_error error;
    struct bench_records written = sample_records(1), read;
    ck_assert_int_eq(bench_records_read(folder, &read, &error), MPM_OK);
    json_object_del(written.run, "load");
    json_object_del(read.run, "load");
    ck_assert(json_equal(written.run, read.run));
    ck_assert(json_equal(written.lines, read.lines));
    size_t count;
    const json_t *line = bench_records_find(&read, "result", "throughput", "cpdi", NULL);
    double *rounds = bench_record_rounds(line, &count);
    ck_assert_uint_eq(count, SAMPLES);
    ck_assert_mem_eq(rounds, sample_rounds, sizeof sample_rounds);
    ck_assert_double_eq(record_number(line, "median"), 1.25e6);
    ck_assert_ptr_null(bench_records_find(&read, "result", "limit", NULL, NULL));
    g_free(rounds);
    bench_records_clear(&read);
    bench_records_clear(&written);
    test_folder_remove(folder);
}
END_TEST

START_TEST(lines_have_the_promised_keys)
{
    static const char *const run[] = {"kind",     "format",       "tier",  "command",   "version",
                                      "revision", "compiler",     "flags", "libraries", "processor",
                                      "cores",    "memory_bytes", "simd",  "rounds"};
    static const char *const result[] = {"kind", "group",  "point", "settings", "quantity",
                                         "unit", "median", "low",   "high",     "rounds"};
    static const char *const value[] = {"kind",     "group", "point", "settings",
                                        "quantity", "unit",  "value"};
    static const char *const comparison[] = {"kind",  "group", "point", "against", "quantity",
                                             "ratio", "low",   "high",  "verdict"};
    struct bench_records records = sample_records(1);
    const struct {
        const json_t *line;
        const char *const *keys;
        size_t count;
    } rows[] = {
        {records.run, run, G_N_ELEMENTS(run)},
        {json_array_get(records.lines, 0), result, G_N_ELEMENTS(result)},
        {json_array_get(records.lines, 1), value, G_N_ELEMENTS(value)},
        {json_array_get(records.lines, 3), comparison, G_N_ELEMENTS(comparison)},
    };
    for (size_t i = 0; i < G_N_ELEMENTS(rows); i++)
        for (size_t k = 0; k < rows[i].count; k++)
            ck_assert_msg(json_object_get(rows[i].line, rows[i].keys[k]) != NULL,
                          "no %s in line %zu", rows[i].keys[k], i);
    bench_records_clear(&records);
}
END_TEST

START_TEST(a_file_that_is_no_record_is_refused_with_its_line)
{
    static const struct {
        const char *text, *message;
    } rows[] = {
        {"", "is empty"},
        {"{}\n", ":1: is no record of a run"},
        {"{\"kind\":\"run\",\"format\":2}\n", ":1: is no record of a run"},
        {"{\"kind\":\"run\",\"format\":1}\nnonsense\n", ":2: is no line"},
        {"{\"kind\":\"run\",\"format\":1}\n{\"kind\":\"value\",\"group\":\"g\"}\n",
         ":2: is no line"},
    };
    for (size_t i = 0; i < G_N_ELEMENTS(rows); i++) {
        char *folder = test_folder_create();
        g_free(test_folder_write(folder, "bench.jsonl", rows[i].text));
        struct bench_records records;
        struct mpm_error error;
        ck_assert_int_eq(bench_records_read(folder, &records, &error), MPM_BAD_INPUT);
        ck_assert_msg(strstr(error.message, rows[i].message) != NULL, "%s", error.message);
        test_folder_remove(folder);
    }
}
END_TEST

/* ------------------------------------------------------------------- commands */

static struct test_said bench(const char *line)
{
    char **argv = g_strsplit(line, " ", -1);
    struct test_said said = {0};
    size_t out_size, err_size;
    FILE *out = open_memstream(&said.out, &out_size), *err = open_memstream(&said.err, &err_size);
    ck_assert(out != NULL && err != NULL);
    const struct bench_world world = {out, err, false};
    said.exit_status = bench_command((int)g_strv_length(argv), argv, &world);
    (void)fclose(out);
    (void)fclose(err);
    g_strfreev(argv);
    return said;
}

static struct test_said compare(const char *one, const char *other)
{
    char *line = g_strdup_printf("mpm-bench compare %s %s", one, other);
    const struct test_said said = bench(line);
    g_free(line);
    return said;
}

START_TEST(a_run_compared_with_itself_does_not_differ)
{
    char *folder = sample_folder(1);
    struct test_said said = compare(folder, folder);
    ck_assert_int_eq(said.exit_status, 0);
    ck_assert_ptr_nonnull(strstr(said.out, "same machine, same revision"));
    ck_assert_ptr_nonnull(strstr(said.out, "3 compared: 0 faster, 0 slower, 0 figures changed"));
    test_said_free(&said);
    test_folder_remove(folder);
}
END_TEST

START_TEST(a_run_twice_as_fast_is_called_faster_and_the_other_way_round_slower)
{
    char *one = sample_folder(1), *twice = sample_folder(2);
    struct test_said faster = compare(one, twice), slower = compare(twice, one);
    ck_assert_int_eq(faster.exit_status, 0);
    ck_assert_ptr_nonnull(strstr(faster.out, "3 compared: 1 faster, 0 slower"));
    ck_assert_ptr_nonnull(strstr(slower.out, "3 compared: 0 faster, 1 slower"));
    test_said_free(&faster);
    test_said_free(&slower);
    test_folder_remove(one);
    test_folder_remove(twice);
}
END_TEST

/* A run of one figure and one result with the same number in every round. */
static char *folder_with(double figure, double round)
{
    char *folder = test_folder_create();
    struct mpm_error error;
    struct bench_records records = bench_records_make("quick", "mpm-bench run", 9);
    const struct bench_subject subject = {"overhead", "plain", NULL};
    const double rounds[] = {round, round, round, round, round};
    (void)bench_records_value(&records, &subject, "branches", "1", figure);
    (void)bench_records_result(&records, &subject, "rate", "1/s", rounds, G_N_ELEMENTS(rounds));
    ck_assert_int_eq(bench_records_write(folder, &records, &error), MPM_OK);
    bench_records_clear(&records);
    return folder;
}

START_TEST(what_has_no_ratio_is_compared_in_words)
{
    static const struct {
        double figures[2], rounds[2];
        const char *says[2];
    } rows[] = {
        {{8, 10}, {1, 1}, {"8 to 10  (+25.00 %)", "2 compared: 0 faster, 0 slower, 1 figures"}},
        {{8, 0}, {1, 1}, {"8 to 0  (-100.00 %)", "1 figures changed"}},
        {{0, 8}, {1, 1}, {"0 to 8  (from nothing, no ratio)", "1 figures changed"}},
        {{0, 0}, {1, 1}, {"2 compared: 0 faster, 0 slower, 0 figures changed", ""}},
        {{(double)NAN, 8}, {1, 1}, {"none to 8  (no number in one of the two)", ""}},
        {{8, (double)NAN}, {1, 1}, {"8 to none  (no number in one of the two)", ""}},
        {{8, 8}, {0, 1}, {"a round without a positive number: no ratio", "1 have a round"}},
        {{8, 8}, {1, 0}, {"1 compared: 0 faster, 0 slower, 0 figures", "1 have a round"}},
    };
    for (size_t i = 0; i < G_N_ELEMENTS(rows); i++) {
        char *one = folder_with(rows[i].figures[0], rows[i].rounds[0]);
        char *other = folder_with(rows[i].figures[1], rows[i].rounds[1]);
        struct test_said said = compare(one, other);
        ck_assert_int_eq(said.exit_status, 0);
        for (size_t k = 0; k < G_N_ELEMENTS(rows[i].says); k++)
            ck_assert_msg(strstr(said.out, rows[i].says[k]) != NULL, "'%s' is not in:\n%s",
                          rows[i].says[k], said.out);
        test_said_free(&said);
        test_folder_remove(one);
        test_folder_remove(other);
    }
}
END_TEST

START_TEST(bad_usage_is_exit_status_2_with_a_reason)
{
    static const struct {
        const char *line, *message;
    } rows[] = {
        {"mpm-bench", "a command is missing: list, run"},
        {"mpm-bench dance", "unknown command \"dance\""},
        {"mpm-bench list more", "unexpected argument"},
        {"mpm-bench run --tier huge", "--tier \"huge\"; allowed: quick, standard"},
        {"mpm-bench run --group speed", "--group \"speed\": allowed are those of mpm-bench list"},
        {"mpm-bench run --simd auto --simd auto", "run: --simd is given twice; allowed: once"},
        {"mpm-bench run --kernels quick", "allowed: auto, reference, fast"},
        {"mpm-bench run --simd mmx", "--simd \"mmx\""},
        {"mpm-bench run --rounds 3", "--rounds"},
        {"mpm-bench compare only_one", "compare: DIR_B is missing"},
        {"mpm-bench compare nowhere nowhere", "nowhere/bench.jsonl: cannot be read"},
        {"mpm-bench report nowhere", "nowhere/bench.jsonl: cannot be read"},
        {"mpm-bench run --output Makefile", "is a file"},
        {"mpm-bench run --output tests", "holds something else"},
    };
    for (size_t i = 0; i < G_N_ELEMENTS(rows); i++) {
        struct test_said said = bench(rows[i].line);
        ck_assert_msg(said.exit_status == 2, "%s: exit %d", rows[i].line, said.exit_status);
        ck_assert_msg(strstr(said.err, rows[i].message) != NULL, "%s: %s", rows[i].line, said.err);
        test_said_free(&said);
    }
}
END_TEST

START_TEST(the_list_names_every_group_once)
{
    struct test_said said = bench("mpm-bench list");
    size_t count;
    const struct bench_group *groups = bench_groups(&count);
    ck_assert_int_eq(said.exit_status, 0);
    for (size_t i = 0; i < count; i++) {
        const char *found = strstr(said.out, groups[i].name);
        ck_assert_ptr_nonnull(found);
        for (size_t k = 0; k < i; k++)
            ck_assert_str_ne(groups[i].name, groups[k].name);
    }
    test_said_free(&said);
}
END_TEST

Suite *suite_bench(void)
{
    Suite *suite = suite_create("bench");
    TCase *tcase = tcase_create("bench");
    tcase_add_test(tcase, a_median_is_the_middle_or_the_mean_of_the_middle_two);
    tcase_add_test(tcase, the_interval_holds_the_percentiles_of_the_exact_bootstrap_distribution);
    tcase_add_test(tcase, the_same_samples_give_the_same_interval);
    tcase_add_test(tcase, pairs_cancel_what_slows_a_whole_round_down);
    tcase_add_test(tcase, a_difference_is_called_only_beyond_noise_and_five_per_cent);
    tcase_add_test(tcase, records_are_read_back_as_they_were_written);
    tcase_add_test(tcase, lines_have_the_promised_keys);
    tcase_add_test(tcase, a_file_that_is_no_record_is_refused_with_its_line);
    tcase_add_test(tcase, a_run_compared_with_itself_does_not_differ);
    tcase_add_test(tcase, a_run_twice_as_fast_is_called_faster_and_the_other_way_round_slower);
    tcase_add_test(tcase, what_has_no_ratio_is_compared_in_words);
    tcase_add_test(tcase, bad_usage_is_exit_status_2_with_a_reason);
    tcase_add_test(tcase, the_list_names_every_group_once);
    suite_add_tcase(suite, tcase);
    return suite;
}
