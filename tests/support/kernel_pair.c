/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "support/kernel_pair.h"

#include "model/scene.h"
#include "support/folder.h"
#include "support/near.h"

#include <float.h>
#include <glib.h>
#include <inttypes.h>
#include <math.h>
#include <string.h>

const enum mpm_field kernel_pair_fields[KERNEL_PAIR_FIELDS] = {
    MPM_FIELD_POSITION, MPM_FIELD_VELOCITY, MPM_FIELD_DEFORMATION_GRADIENT, MPM_FIELD_STRESS,
    MPM_FIELD_TEMPERATURE};

bool kernel_pair_is_long(void)
{
    return g_getenv("MPM_TEST_LONG") != NULL;
}

static double stiffness(const struct mpm_material_spec *material)
{
    return material->parameter[MPM_PARAMETER_BULK] +
           4.0 / 3.0 * material->parameter[MPM_PARAMETER_SHEAR];
}

static void set_floors(struct kernel_pair *pair)
{
    const struct mpm_scene *scene = pair->scene[0];
    for (size_t k = 0; k < scene->material_count; k++) {
        const struct mpm_material_spec *spec = &scene->materials[k];
        for (int index = 0; index < KERNEL_PAIR_FIELDS; index++) {
            double *floor = &pair->floors[index];
            if (kernel_pair_fields[index] == MPM_FIELD_STRESS)
                *floor = fmax(*floor, stiffness(spec));
            else if (kernel_pair_fields[index] == MPM_FIELD_VELOCITY)
                *floor = fmax(*floor, sqrt(stiffness(spec) / spec->density));
        }
    }
}

/* --------------------------------------------------------------- comparison */

static double largest(const double *values, size_t count)
{
    double found = 0.0;
    for (size_t i = 0; i < count; i++)
        found = fmax(found, fabs(values[i]));
    return found;
}

/* Not a number on one side only is a difference without bound. */
static double difference(double one, double other, double scale)
{
    if (one == other || (isnan(one) && isnan(other)))
        return 0.0;
    const double part = fabs(one - other) / scale;
    return isnan(part) ? HUGE_VAL : part;
}

static void compare_field(struct kernel_pair *pair, int index)
{
    const enum mpm_field field = kernel_pair_fields[index];
    const size_t components = mpm_field_describe(field)->components;
    const size_t count = components * mpm_simulation_particle_count(pair->simulation[0]);
    struct kernel_difference *const worst = &pair->worst[index];
    for (int k = 0; k < 2; k++)
        mpm_simulation_field(pair->simulation[k], field, pair->values[k]);
    const size_t bytes = count * sizeof(double);
    pair->same_bits = pair->same_bits && memcmp(pair->values[0], pair->values[1], bytes) == 0;
    const double own = largest(pair->values[0], count), scale = fmax(own, pair->floors[index]);
    for (size_t i = 0; i < count; i++) {
        const double part = difference(pair->values[0][i], pair->values[1][i], scale);
        if (part > worst->part)
            *worst = (struct kernel_difference){
                .part = part,
                .of_largest = part * scale / own,
                .step = mpm_simulation_step(pair->simulation[0]),
                .particle = i / components,
                .component = i % components,
                .values = {pair->values[0][i], pair->values[1][i]},
            };
    }
}

static void compare(struct kernel_pair *pair)
{
    const double times[2] = {mpm_simulation_time(pair->simulation[0]),
                             mpm_simulation_time(pair->simulation[1])};
    pair->time_difference =
        fmax(pair->time_difference, difference(times[0], times[1], fabs(times[0])));
    pair->same_bits = pair->same_bits && times[0] == times[1];
    for (int index = 0; index < KERNEL_PAIR_FIELDS; index++)
        compare_field(pair, index);
}

/* ------------------------------------------------------------------ a pair */

static enum mpm_status open_side(const char *path, const struct kernel_side *side,
                                 struct mpm_scene **scene, struct mpm_simulation **simulation,
                                 struct mpm_error *error)
{
    size_t count = 0;
    while (side->settings != NULL && side->settings[count] != NULL)
        count++;
    const enum mpm_status status = mpm_scene_read(path, side->settings, count, scene, error);
    return status == MPM_OK ? mpm_simulation_create(*scene, &side->options, simulation, error)
                            : status;
}

enum mpm_status kernel_pair_open(const char *path, const struct kernel_side sides[2],
                                 struct kernel_pair *pair, struct mpm_error *error)
{
    enum mpm_status status = MPM_OK;
    *pair = (struct kernel_pair){.same_bits = true};
    for (int k = 0; k < 2 && status == MPM_OK; k++)
        status = open_side(path, &sides[k], &pair->scene[k], &pair->simulation[k], error);
    if (status != MPM_OK) {
        kernel_pair_close(pair);
        return status;
    }
    const size_t widest = mpm_field_describe(MPM_FIELD_DEFORMATION_GRADIENT)->components;
    const size_t particles = mpm_simulation_particle_count(pair->simulation[0]);
    for (int k = 0; k < 2; k++)
        pair->values[k] = g_new(double, widest *particles);
    set_floors(pair);
    compare(pair);
    return MPM_OK;
}

/* Settings that add a noise to the initial velocity of every deformable body: a rounding error
 * of the wave speed, another one at each particle. */
static void add_noise(const struct mpm_scene *scene, GPtrArray *settings)
{
    const bool axisymmetric = scene->geometry == MPM_AXISYMMETRIC;
    const char *x = axisymmetric ? "r" : "x", *y = axisymmetric ? "z" : "y";
    for (size_t k = 0; k < scene->body_count; k++) {
        const struct mpm_body_spec *body = &scene->bodies[k];
        char e[G_ASCII_DTOSTR_BUF_SIZE];
        if (body->rigid)
            continue;
        const struct mpm_material_spec *material = &scene->materials[body->material];
        g_ascii_dtostr(e, sizeof e, DBL_EPSILON * sqrt(stiffness(material) / material->density));
        g_ptr_array_add(settings,
                        g_strdup_printf("bodies.%zu.velocity=['%s+%s*sin(1000*%s+777*%s)',"
                                        " '%s+%s*cos(777*%s-1000*%s)']",
                                        k, body->velocity.text[0], e, x, y, body->velocity.text[1],
                                        e, x, y));
    }
}

enum mpm_status kernel_pair_open_noisy(const char *path, const char *const *settings,
                                       struct kernel_pair *pair, struct mpm_error *error)
{
    const struct mpm_simulation_options options = {.threads = 1, .kernels = KERNEL_PAIR_OTHER};
    GPtrArray *noisy = g_ptr_array_new_with_free_func(g_free);
    struct mpm_scene *scene = NULL;
    for (size_t i = 0; settings != NULL && settings[i] != NULL; i++)
        g_ptr_array_add(noisy, g_strdup(settings[i]));
    enum mpm_status status = mpm_scene_read(path, settings, noisy->len, &scene, error);
    if (status == MPM_OK) {
        add_noise(scene, noisy);
        g_ptr_array_add(noisy, NULL);
        const struct kernel_side sides[2] = {{settings, options},
                                             {(const char *const *)noisy->pdata, options}};
        status = kernel_pair_open(path, sides, pair, error);
    }
    mpm_scene_free(scene);
    g_ptr_array_unref(noisy);
    return status;
}

void kernel_pair_close(struct kernel_pair *pair)
{
    for (int k = 0; k < 2; k++) {
        mpm_simulation_free(pair->simulation[k]);
        mpm_scene_free(pair->scene[k]);
        g_free(pair->values[k]);
    }
    *pair = (struct kernel_pair){.time_difference = 0.0};
}

bool kernel_pair_step(struct kernel_pair *pair)
{
    const double end = mpm_scene_end_time(pair->scene[0]);
    bool going = true;
    for (int k = 0; k < 2; k++)
        going = going && mpm_simulation_time(pair->simulation[k]) < end;
    if (!going)
        return false;
    for (int k = 0; k < 2; k++)
        if (mpm_simulation_advance(pair->simulation[k], end, &pair->error[k]) != MPM_OK)
            going = false;
    if (going || kernel_pair_ended_alike(pair))
        compare(pair);
    return going;
}

bool kernel_pair_ended_alike(const struct kernel_pair *pair)
{
    return pair->error[0].status == pair->error[1].status &&
           strcmp(pair->error[0].message, pair->error[1].message) == 0 &&
           mpm_simulation_step(pair->simulation[0]) == mpm_simulation_step(pair->simulation[1]);
}

double kernel_pair_worst(const struct kernel_pair *pair)
{
    double part = pair->time_difference;
    for (int index = 0; index < KERNEL_PAIR_FIELDS; index++)
        part = fmax(part, pair->worst[index].part);
    return part;
}

char *kernel_pair_text(const struct kernel_pair *pair)
{
    GString *text = g_string_new(NULL);
    g_string_append_printf(text, "%" PRIu64 " steps, time %.2g",
                           mpm_simulation_step(pair->simulation[0]), pair->time_difference);
    for (int index = 0; index < KERNEL_PAIR_FIELDS; index++) {
        const struct kernel_difference *const worst = &pair->worst[index];
        g_string_append_printf(text, ", %s %.1e",
                               mpm_field_describe(kernel_pair_fields[index])->name, worst->part);
        if (worst->part > 0.0)
            g_string_append_printf(text,
                                   " (%.1e of the largest; step %" PRIu64
                                   ", particle %zu, component %zu: %.17g, %.17g)",
                                   worst->of_largest, worst->step, worst->particle,
                                   worst->component, worst->values[0], worst->values[1]);
    }
    if (!kernel_pair_ended_alike(pair))
        g_string_append_printf(text,
                               "; ended as '%s' at step %" PRIu64 " and as '%s' at step %" PRIu64,
                               pair->error[0].message, mpm_simulation_step(pair->simulation[0]),
                               pair->error[1].message, mpm_simulation_step(pair->simulation[1]));
    return g_string_free(text, FALSE);
}

/* ----------------------------------------------------------------- in tests */

struct kernel_pair kernel_pair_open_text(const char *text, const struct kernel_side sides[2])
{
    char *folder = test_folder_create();
    char *path = test_folder_write(folder, "scene.yaml", text);
    struct kernel_pair pair;
    struct mpm_error error = {.message = ""};
    const enum mpm_status status = kernel_pair_open(path, sides, &pair, &error);
    ck_assert_msg(status == MPM_OK, "%s", error.message);
    test_folder_remove(folder);
    g_free(path);
    return pair;
}

void kernel_pair_assert_alike(struct kernel_pair *pair, int steps)
{
    for (int step = 0; step < steps; step++)
        ck_assert_msg(kernel_pair_step(pair), "%s", pair->error[0].message);
    char *text = kernel_pair_text(pair);
    ck_assert_msg(kernel_pair_worst(pair) <= KERNEL_PAIR_BOUND, "%s", text);
    g_free(text);
}

void kernel_pair_assert_same_work(const struct kernel_pair *pair, double force, double wave_speed)
{
    struct mpm_ledger ledger[2];
    for (int k = 0; k < 2; k++)
        mpm_simulation_ledger(pair->simulation[k], &ledger[k]);
    const double bound = KERNEL_PAIR_BOUND * force * wave_speed * ledger[0].time;
    ck_assert(fabs(ledger[0].external_work) > 1e3 * bound);
    ck_assert_near(ledger[1].external_work, ledger[0].external_work, bound);
}
