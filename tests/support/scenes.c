/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "support/scenes.h"

#include "support/folder.h"

#include <check.h>
#include <glib.h>
#include <math.h>
#include <stdlib.h>

struct test_run test_run_open(const char *text, const char *const *settings, int threads)
{
    struct test_run run = {0};
    struct mpm_error error = {0};
    size_t count = 0;
    while (settings != NULL && settings[count] != NULL)
        count++;
    char *const folder = test_folder_create();
    char *const path = test_folder_write(folder, "scene.yaml", text);
    enum mpm_status status = mpm_scene_read(path, settings, count, &run.scene, &error);
    ck_assert_msg(status == MPM_OK, "scene refused: %s", error.message);
    status = mpm_simulation_create(run.scene, &(struct mpm_simulation_options){.threads = threads},
                                   &run.simulation, &error);
    ck_assert_msg(status == MPM_OK, "simulation refused: %s", error.message);
    g_free(path);
    test_folder_remove(folder);
    return run;
}

void test_run_close(struct test_run *run)
{
    mpm_simulation_free(run->simulation);
    mpm_scene_free(run->scene);
    *run = (struct test_run){0};
}

void test_run_steps(struct test_run *run, int steps)
{
    struct mpm_error error = {0};
    for (int k = 0; k < steps; k++) {
        const enum mpm_status status = mpm_simulation_advance(run->simulation, HUGE_VAL, &error);
        ck_assert_msg(status == MPM_OK, "step %d: %s", k + 1, error.message);
    }
}

double *test_run_field(const struct test_run *run, enum mpm_field field, size_t *count)
{
    const size_t n = mpm_simulation_particle_count(run->simulation);
    double *const values = calloc(n * mpm_field_describe(field)->components, sizeof *values);
    ck_assert_ptr_nonnull(values);
    mpm_simulation_field(run->simulation, field, values);
    if (count != NULL)
        *count = n;
    return values;
}
