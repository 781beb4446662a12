/* Scenes: YAML, expressions and settings, as `mpm check` and the first steps of `mpm run` have
 * them. Lines "#set PATH=VALUE" at the beginning are given as --set.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "fuzz/fuzz.h"

#include "mpm_yaml.h"

#include <glib.h>
#include <math.h>
#include <string.h>

enum { SETTINGS_MAX = 8, STEPS = 3, PARTICLES_MAX = 2000, NODES_MAX = 20000 };

static size_t find_settings(const uint8_t *data, size_t size, char *settings[SETTINGS_MAX])
{
    static const char mark[] = "#set ";
    const size_t length = strlen(mark);
    size_t count = 0;
    while (count < SETTINGS_MAX && size > length && memcmp(data, mark, length) == 0) {
        const uint8_t *const end = memchr(data, '\n', size);
        if (end == NULL)
            break;
        settings[count++] = g_strndup((const char *)data + length, (gsize)(end - data) - length);
        size -= (size_t)(end + 1 - data);
        data = end + 1;
    }
    return count;
}

static void take_steps(const struct mpm_scene *scene, const struct mpm_simulation_options *options)
{
    struct mpm_error error = {.status = MPM_OK};
    struct mpm_simulation *simulation = NULL;
    enum mpm_status status = mpm_simulation_create(scene, options, &simulation, &error);
    for (int k = 0; k < STEPS && status == MPM_OK; k++) {
        struct mpm_ledger ledger;
        status = mpm_simulation_advance(simulation, mpm_scene_end_time(scene), &error);
        if (status == MPM_OK)
            status = mpm_simulation_judge(simulation, &error);
        mpm_simulation_ledger(simulation, &ledger);
    }
    (void)fuzz_judge(status, &error);
    mpm_simulation_free(simulation);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    const struct mpm_simulation_options options = {.threads = 1, .kernels = MPM_KERNELS_REFERENCE};
    struct mpm_error error = {.status = MPM_OK};
    struct mpm_scene *scene = NULL;
    struct mpm_plan plan;
    char *settings[SETTINGS_MAX];
    const size_t count = find_settings(data, size, settings);
    const enum mpm_status read = mpm_scene_read(
        fuzz_write("scene.yaml", data, size), (const char *const *)settings, count, &scene, &error);
    if (fuzz_judge(read, &error) &&
        fuzz_judge(mpm_scene_plan(scene, &options, &plan, &error), &error) &&
        plan.particles <= PARTICLES_MAX && plan.nodes <= NODES_MAX)
        take_steps(scene, &options);
    mpm_scene_free(scene);
    for (size_t k = 0; k < count; k++)
        g_free(settings[k]);
    return 0;
}
