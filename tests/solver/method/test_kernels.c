/* Fast kernels against reference kernels on every scene of the catalogue that has them.
 *
 * The short tier takes the first steps of each; the long one (`make test-kernels`) runs each
 * to its end and prints what it finds.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "suites.h"
#include "support/kernel_pair.h"

#include "verification/suite/plan.h"

#include <glib.h>
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

enum { LONG_TIMEOUT = 7200 };

/* Some scenes have nothing to compare in their first steps, or many particles in many variants:
 * these settings bring forward what they are about. Not in the long tier, which goes the whole way.
 */
static const struct {
    const char *name, *setting;
} brought_forward[] = {
    {"E1", "bodies.impactor.region.disk.center=[0, 16.2]"}, /* in free flight until t = 0.8 */
    {"D4", "grid.cell=[4, 4]"},
};

static GPtrArray *settings_of(const struct planned_job *job)
{
    GPtrArray *settings = g_ptr_array_new_with_free_func(g_free);
    for (unsigned i = 0; i < job->variant->settings_count; i++)
        g_ptr_array_add(settings, g_strdup(job->variant->settings[i]));
    for (size_t i = 0; i < G_N_ELEMENTS(brought_forward) && !kernel_pair_is_long(); i++)
        if (strcmp(job->entry->file->name, brought_forward[i].name) == 0)
            g_ptr_array_add(settings, g_strdup(brought_forward[i].setting));
    g_ptr_array_add(settings, NULL);
    return settings;
}

/* -------------------------------------------------------------- comparisons */

struct comparison {
    bool compared;   /* both sets of kernels take the scene, */
    bool has_none;   /* or it has no fast ones, and that is what they were refused for */
    double early;    /* largest difference in the first KERNEL_PAIR_STEPS steps, */
    double all;      /* and in all of them */
    uint64_t steps;  /* taken, */
    uint64_t within; /* and those before the difference first passed the bound */
    char *text;
};

static bool has_no_fast_ones(const struct mpm_error *error)
{
    return g_str_has_prefix(error->message, "kernels: fast: there are no fast kernels");
}

/* Steps of the short tier: fewer of scenes with many particles. */
static uint64_t short_steps(const struct kernel_pair *pair)
{
    static const double PARTICLE_STEPS = 3e4, FEWEST = 6.0;
    const double particles = (double)mpm_simulation_particle_count(pair->simulation[0]);
    return (uint64_t)fmin(fmax(PARTICLE_STEPS / particles, FEWEST), (double)KERNEL_PAIR_STEPS);
}

static struct comparison follow(struct kernel_pair *pair)
{
    struct comparison comparison = {.compared = true, .early = kernel_pair_worst(pair)};
    for (uint64_t step = 1; kernel_pair_step(pair); step++) {
        comparison.steps = step;
        comparison.all = kernel_pair_worst(pair);
        if (comparison.all <= KERNEL_PAIR_BOUND)
            comparison.within = step;
        if (step <= KERNEL_PAIR_STEPS)
            comparison.early = comparison.all;
        if (step == short_steps(pair) && !kernel_pair_is_long())
            break;
    }
    comparison.text = kernel_pair_text(pair);
    return comparison;
}

static struct comparison compare_kernels(const char *path, char **settings)
{
    const char *const *given = (const char *const *)(void *)settings;
    const struct kernel_side sides[2] = {
        {given, {.threads = 1, .kernels = MPM_KERNELS_REFERENCE}},
        {given, {.threads = 1, .kernels = KERNEL_PAIR_OTHER}},
    };
    struct kernel_pair pair;
    struct mpm_error error;
    const enum mpm_status status = kernel_pair_open(path, sides, &pair, &error);
    if (status != MPM_OK)
        return (struct comparison){
            .has_none = status == MPM_BAD_INPUT && has_no_fast_ones(&error),
            .text = g_strdup(error.message),
        };
    const struct comparison comparison = follow(&pair);
    kernel_pair_close(&pair);
    return comparison;
}

/* How far a run gets from itself when it begins with a rounding error: what is in no code's
 * hands. */
static struct comparison compare_with_noise(const char *path, char **settings)
{
    struct kernel_pair pair;
    struct mpm_error error = {.message = ""};
    ck_assert_msg(kernel_pair_open_noisy(path, (const char *const *)(void *)settings, &pair,
                                         &error) == MPM_OK,
                  "%s", error.message);
    const struct comparison comparison = follow(&pair);
    kernel_pair_close(&pair);
    return comparison;
}

/* -------------------------------------------------------------------- tests */

static struct catalogue *catalogue;
static struct plan plan;

static void set_up(void)
{
    const struct plan_selection selection = {.tier = TIER_FULL};
    struct mpm_error error;
    ck_assert_msg(catalogue_read("verification/catalogue", programs_all(), &catalogue, &error) ==
                      MPM_OK,
                  "%s", error.message);
    ck_assert_int_eq(plan_make(catalogue, &selection, &plan, &error), MPM_OK);
}

static void tear_down(void)
{
    plan_clear(&plan);
    catalogue_free(catalogue);
}

/* A run rounds in each step, not once: independent errors add up as the square root of their
 * number. Ten times one of them, and a twentieth of that sum where runs have over 40 000 steps. */
static double times_noise(uint64_t steps)
{
    return fmax(10.0, sqrt((double)steps) / 20.0);
}

/* A run, or its first steps, may differ by more than the bound only if a rounding error at its
 * start grows past it, too; and by no more than a few times as much. */
static bool holds(const struct comparison *comparison, const char *path, char **settings,
                  const char *name)
{
    bool good = comparison->compared && comparison->early <= KERNEL_PAIR_BOUND;
    if ((kernel_pair_is_long() || !good) && comparison->compared) {
        struct comparison noise = compare_with_noise(path, settings);
        const double times = times_noise(comparison->steps);
        good = comparison->early <= fmax(KERNEL_PAIR_BOUND, times * noise.early) &&
               comparison->all <= fmax(KERNEL_PAIR_BOUND, times * noise.all);
        (void)printf("%-26s %s; first steps %.1e, all %.1e, within the bound for %" PRIu64
                     " of %" PRIu64 " steps; a rounding error at the start: %.1e\n",
                     name, good ? "good" : "BAD", comparison->early, comparison->all,
                     comparison->within, comparison->steps, noise.all);
        (void)fflush(stdout);
        g_free(noise.text);
    }
    return good;
}

/* In shares, which take turns with the scenes: together they take minutes under sanitizers. */
enum { SHARES = 16 };

START_TEST(fast_kernels_agree_with_reference_kernels_on_every_scene_that_has_them)
{
    size_t compared = 0, wrong = 0;
    for (size_t i = (size_t)_i; i < plan.job_count; i += SHARES) {
        const struct planned_job *job = &plan.jobs[i];
        char *path = catalogue_scene_path(job->entry, job->variant);
        if (path == NULL)
            continue;
        GPtrArray *settings = settings_of(job);
        char **texts = (char **)settings->pdata;
        char *name = g_strconcat(job->entry->file->name, " ", job->variant->name, NULL);
        struct comparison comparison = compare_kernels(path, texts);
        compared += comparison.compared;
        if (!comparison.has_none && !holds(&comparison, path, texts, name)) {
            (void)fprintf(stderr, "%s: %s\n", name, comparison.text);
            wrong++;
        }
        g_free(comparison.text);
        g_free(name);
        g_free(path);
        g_ptr_array_unref(settings);
    }
    ck_assert_uint_gt(compared, 0);
    ck_assert_msg(wrong == 0, "%zu of %zu scenes differ", wrong, compared);
}
END_TEST

/* The first variant of each case. */
START_TEST(automatic_kernels_are_the_fast_ones_to_the_bit)
{
    enum { STEPS = 10 };
    const struct kernel_side sides[2] = {
        {NULL, {.threads = 1, .kernels = MPM_KERNELS_FAST}},
        {NULL, {.threads = 1, .kernels = MPM_KERNELS_AUTO}},
    };
    size_t compared = 0;
    for (size_t i = 0; i < plan.job_count; i++) {
        const struct catalogue_case *entry = plan.jobs[i].entry;
        if (entry->scene_path == NULL || (i > 0 && plan.jobs[i - 1].entry == entry))
            continue;
        struct kernel_pair pair;
        struct mpm_error error = {.message = ""};
        const enum mpm_status status = kernel_pair_open(entry->scene_path, sides, &pair, &error);
        if (status == MPM_BAD_INPUT && has_no_fast_ones(&error))
            continue;
        ck_assert_msg(status == MPM_OK, "%s: %s", entry->file->name, error.message);
        for (int step = 0; step < STEPS && kernel_pair_step(&pair); step++)
            ;
        char *found = kernel_pair_text(&pair);
        ck_assert_msg(pair.same_bits && kernel_pair_ended_alike(&pair), "%s: %s", entry->file->name,
                      found);
        ck_assert_str_eq(mpm_simulation_kernels(pair.simulation[1]), "fast");
        g_free(found);
        kernel_pair_close(&pair);
        compared++;
    }
    ck_assert_uint_gt(compared, 2);
}
END_TEST

Suite *suite_kernels(void)
{
    Suite *suite = suite_create("kernels");
    TCase *scenes = tcase_create("catalogue");
    tcase_add_checked_fixture(scenes, set_up, tear_down);
    if (kernel_pair_is_long())
        tcase_set_timeout(scenes, LONG_TIMEOUT);
    tcase_add_loop_test(
        scenes, fast_kernels_agree_with_reference_kernels_on_every_scene_that_has_them, 0, SHARES);
    tcase_add_test(scenes, automatic_kernels_are_the_fast_ones_to_the_bit);
    suite_add_tcase(suite, scenes);
    return suite;
}
