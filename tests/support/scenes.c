/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "support/scenes.h"

#include "support/folder.h"
#include "support/marks.h"

#include <glib.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

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

double test_run_largest_difference(const struct test_run *one, const struct test_run *other)
{
    static const enum mpm_field fields[] = {MPM_FIELD_POSITION, MPM_FIELD_VELOCITY,
                                            MPM_FIELD_DEFORMATION_GRADIENT};
    double largest = 0.0;
    for (size_t f = 0; f < G_N_ELEMENTS(fields); f++) {
        size_t count, others;
        double *const a = test_run_field(one, fields[f], &count);
        double *const b = test_run_field(other, fields[f], &others);
        ck_assert_uint_eq(count, others);
        for (size_t k = 0; k < mpm_field_describe(fields[f])->components * count; k++)
            largest = fmax(largest, fabs(a[k] - b[k]));
        free(a);
        free(b);
    }
    return largest;
}

double test_run_contact_quantity(const struct test_run *run, const char *name)
{
    for (size_t k = 0; k < mpm_scene_contact_quantity_count(run->scene); k++)
        if (g_strcmp0(mpm_scene_contact_quantity(run->scene, k).name, name) == 0)
            return mpm_simulation_contact_quantity(run->simulation, k);
    ck_abort_msg("no quantity %s", name);
    return 0.0;
}

struct mpm_ledger test_run_ledger(const struct test_run *run)
{
    struct mpm_ledger ledger;
    mpm_simulation_ledger(run->simulation, &ledger);
    return ledger;
}

struct mpm_j_integral test_run_j_integral(const struct test_run *run, size_t index)
{
    struct mpm_j_integral value;
    struct mpm_error error = {.message = ""};
    const enum mpm_status status =
        mpm_simulation_j_integral(run->simulation, index, &value, &error);
    ck_assert_msg(status == MPM_OK, "%s", error.message);
    return value;
}

static bool same_bytes(const void *a, const void *b, size_t size)
{
    return memcmp(a, b, size) == 0;
}

static bool same_field(const struct test_run *one, const struct test_run *other,
                       enum mpm_field field)
{
    size_t n, m;
    double *const a = test_run_field(one, field, &n), *const b = test_run_field(other, field, &m);
    const size_t size = n * mpm_field_describe(field)->components * sizeof *a;
    const bool same = n == m && same_bytes(a, b, size);
    free(a);
    free(b);
    return same;
}

/* Every member of a ledger has 8 bytes: there is no padding to differ. */
bool test_run_same_bits(const struct test_run *one, const struct test_run *other)
{
    const struct mpm_ledger a = test_run_ledger(one), b = test_run_ledger(other);
    return same_field(one, other, MPM_FIELD_POSITION) &&
           same_field(one, other, MPM_FIELD_VELOCITY) &&
           same_field(one, other, MPM_FIELD_DEFORMATION_GRADIENT) &&
           same_field(one, other, MPM_FIELD_STRESS) &&
           same_field(one, other, MPM_FIELD_TEMPERATURE) && same_bytes(&a, &b, sizeof a);
}

void test_same_bits_over_threads(const char *text, const char *const *settings, int steps,
                                 void (*prepare)(struct test_run *run))
{
    struct test_run runs[3];
    for (int k = 0; k < 3; k++) {
        runs[k] = test_run_open(text, settings, k + 1);
        if (prepare != NULL)
            prepare(&runs[k]);
        test_run_steps(&runs[k], steps);
        ck_assert_msg(test_run_same_bits(&runs[0], &runs[k]), "bits differ with %d threads", k + 1);
    }
    for (int k = 0; k < 3; k++)
        test_run_close(&runs[k]);
}
