/* The group `overhead`: the overhead of each feature that a scene uses.
 *
 * Every feature is timed against the same scene without it, in the rounds of timing.h, and
 * its instructions and branches are counted beside. Times are of this machine and its noise;
 * counts are not.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "benchmarks/common/findings.h"
#include "benchmarks/groups/overhead_features.h"
#include "benchmarks/measuring/instructions.h"
#include "benchmarks/measuring/timing.h"
#include "mpm_file.h"
#include "verification/common/failure.h"
#include "verification/common/resources.h"

static const char group[] = "overhead";

/* 10^4 particles; a count in the quick tier takes 3600. */
#define REFINE       "grid.refine=10"
#define REFINE_QUICK "grid.refine=6"

/* Steps in whole sort intervals of 32. A run of 100 k + 1 steps has k snapshots of one in a
 * hundred steps between its start and its end. */
enum { TIMED_STEPS = 160, COUNTED_STEPS = 32, TIMED_RUN = 501, COUNTED_RUN = 101 };

/* ------------------------------------------------------------------ whole runs */

struct run_probe {
    const struct overhead_feature *feature;
    struct mpm_simulation_options simulation;
    char *scene;
};

static void note_work(void *context, double fraction, const struct mpm_simulation *simulation)
{
    double *work = context;
    (void)fraction;
    *work =
        (double)mpm_simulation_step(simulation) * (double)mpm_simulation_particle_count(simulation);
}

static enum mpm_status time_run(const struct mpm_scene *scene, const struct run_probe *probe,
                                const char *folder, struct bench_sample *sample,
                                struct mpm_error *error)
{
    const struct mpm_run_options options = {
        .output = folder,
        .simulation = probe->simulation,
        .progress = note_work,
        .progress_context = &sample->work,
    };
    const double cpu = bench_clock_cpu(), wall = bench_clock_wall();
    TRY(mpm_scene_run(scene, &options, error));
    sample->cpu = bench_clock_cpu() - cpu;
    sample->wall = bench_clock_wall() - wall;
    return MPM_OK;
}

static enum mpm_status run_feature(const void *context, struct bench_sample *sample,
                                   struct mpm_error *error)
{
    const struct run_probe *probe = context;
    const char *settings[OVERHEAD_SETTINGS + 2];
    size_t count = 0;
    char *folder = NULL, *steps = g_strdup_printf("time.steps=%d", TIMED_RUN);
    struct mpm_scene *scene = NULL;
    settings[count++] = REFINE;
    for (size_t i = 0; i < OVERHEAD_SETTINGS && probe->feature->settings[i] != NULL; i++)
        settings[count++] = probe->feature->settings[i];
    settings[count++] = steps;
    enum mpm_status status = mpm_scene_read(probe->scene, settings, count, &scene, error);
    if (status == MPM_OK)
        status = mpm_folder_make_temporary(&folder, error);
    if (status == MPM_OK)
        status = time_run(scene, probe, folder, sample, error);
    if (folder != NULL)
        (void)mpm_folder_remove_all(folder, NULL);
    g_free(folder);
    mpm_scene_free(scene);
    g_free(steps);
    return status;
}

/* ---------------------------------------------------------------------- timing */

static struct bench_point *add_point(GArray *points, const struct run_probe *probe)
{
    const struct overhead_feature *feature = probe->feature;
    if (feature->writes)
        return bench_points_add_probe(points, run_feature, probe, "particle_steps_per_second",
                                      "1/s", feature->name);
    struct bench_point *point =
        bench_points_add(points, probe->scene, &probe->simulation, "%s", feature->name);
    point->steps = TIMED_STEPS;
    bench_point_set(point, REFINE);
    for (size_t i = 0; i < OVERHEAD_SETTINGS && feature->settings[i] != NULL; i++)
        bench_point_set(point, "%s", feature->settings[i]);
    return point;
}

static enum mpm_status time_features(struct bench_context *context, const struct run_probe *probes,
                                     struct mpm_error *error)
{
    const double seconds = context->tier == BENCH_QUICK ? 10.0 : 50.0;
    GArray *points = bench_points_new();
    for (size_t i = 0; i < overhead_feature_count; i++) {
        const struct overhead_feature *feature = &overhead_features[i];
        struct bench_point *point = add_point(points, &probes[i]);
        point->against = g_strdup(feature->against);
        bench_point_text(point, "feature", feature->name);
        bench_point_text(point, "expectation", feature->expectation);
    }
    const enum mpm_status status = bench_measure(context, group, points, seconds, NULL, error);
    g_array_unref(points);
    return status;
}

/* -------------------------------------------------------------------- counting */

static enum mpm_status count_feature(const struct run_probe *probe, enum bench_tier tier,
                                     const char *program, struct instructions *counted,
                                     struct mpm_error *error)
{
    static const char *const with_files[] = {"mpm_simulation_advance", "mpm_simulation_ledger",
                                             "mpm_history_write", "mpm_series_write", NULL};
    const struct overhead_feature *feature = probe->feature;
    const char *settings[OVERHEAD_SETTINGS + 2] = {tier == BENCH_QUICK ? REFINE_QUICK : REFINE};
    for (size_t i = 0; i < OVERHEAD_SETTINGS; i++)
        settings[i + 1] = feature->settings[i];
    const struct instructions_request request = {
        .program = program,
        .scene = probe->scene,
        .settings = settings,
        .simulation = probe->simulation,
        .steps = feature->writes ? COUNTED_RUN : COUNTED_STEPS,
        .functions = feature->writes ? with_files : NULL,
    };
    return instructions_count(&request, counted, error);
}

static void write_counts(struct bench_context *context, const struct overhead_feature *feature,
                         const struct instructions *counted, const struct instructions *base)
{
    json_t *settings =
        json_pack("{s:s, s:f, s:f, s:s, s:s, s:s}", "feature", feature->name, "particles",
                  (double)counted->particles, "steps", (double)counted->steps, "kernels",
                  counted->kernels, "simd", counted->simd, "expectation", feature->expectation);
    const struct bench_subject subject = {group, feature->name, settings};
    bench_value(context, &subject, "instructions_per_particle_step", "1",
                instructions_rate(counted));
    bench_value(context, &subject, "branches_per_particle_step", "1",
                instructions_branch_rate(counted));
    if (base != NULL) {
        json_object_set_new(settings, "against", json_string(feature->against));
        bench_value(context, &subject, "instructions_ratio", "1",
                    instructions_rate(counted) / instructions_rate(base));
    }
    json_decref(settings);
}

static enum mpm_status count_features(struct bench_context *context, const struct run_probe *probes,
                                      const char *program, struct mpm_error *error)
{
    struct instructions *counted = g_new0(struct instructions, overhead_feature_count);
    enum mpm_status status = MPM_OK;
    for (size_t i = 0; i < overhead_feature_count && status == MPM_OK; i++) {
        const struct overhead_feature *feature = &overhead_features[i];
        bench_console_progress(context->console, i + 1, overhead_feature_count, feature->name);
        status = count_feature(&probes[i], context->tier, program, &counted[i], error);
        if (status == MPM_OK)
            write_counts(context, feature, &counted[i],
                         feature->against == NULL
                             ? NULL
                             : &counted[overhead_feature_find(feature->against)]);
    }
    g_free(counted);
    return status;
}

/* ----------------------------------------------------------------------- group */

enum mpm_status bench_overhead(struct bench_context *context, struct mpm_error *error)
{
    struct run_probe *probes = g_new0(struct run_probe, overhead_feature_count);
    char *program = resources_program(context->executable, "mpm");
    for (size_t i = 0; i < overhead_feature_count; i++)
        probes[i] = (struct run_probe){&overhead_features[i], context->simulation,
                                       bench_scene(context, overhead_features[i].scene)};
    enum mpm_status status = time_features(context, probes, error);
    struct mpm_error missing;
    if (status == MPM_OK && instructions_available(&missing) != MPM_OK)
        fprintf(context->console->out, "  skipped: %s\n", missing.message);
    else if (status == MPM_OK)
        status = count_features(context, probes, program, error);
    for (size_t i = 0; i < overhead_feature_count; i++)
        g_free(probes[i].scene);
    g_free(probes);
    g_free(program);
    return status;
}
