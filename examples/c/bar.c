/* A scene made by calls, and run step by step: a bar that is held at both ends vibrates in its
 * first axial mode. The period is measured between two changes of sign of the velocity in the
 * middle, and compared with 2 L / c.
 *
 *     cc bar.c -o bar $(pkg-config --cflags --libs touchstone)
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <mpm.h>

#include <stdio.h>
#include <stdlib.h>

static const double length = 16.0, wave_speed = 1.0; /* mm, mm/ms */

/* Setters whose last argument is NULL leave their failure to mpm_draft_build. */
static struct mpm_scene *build_scene(struct mpm_error *error)
{
    struct mpm_draft *draft = NULL;
    struct mpm_scene *scene = NULL;
    if (mpm_draft_create("bar", NULL, 0, &draft, error) != MPM_OK)
        return NULL;
    mpm_draft_set_integer(draft, "format", 1, NULL);
    mpm_draft_set_text(draft, "geometry", "plane_strain", NULL);
    mpm_draft_set_pair(draft, "grid.cell", 1.0, 1.0, NULL);
    mpm_draft_set_pair(draft, "grid.cells", length, 1.0, NULL);
    mpm_draft_set_number(draft, "time.end", 80.0, NULL);
    mpm_draft_set_text(draft, "method.stress_update", "usavg", NULL);
    /* the modulus of waves is K + 4/3 G = 1, and so is the density */
    mpm_draft_set(draft, "materials.+", "{name: bar, law: linear_elastic, density: 1}", NULL);
    mpm_draft_set_number(draft, "materials.bar.bulk", 0.6, NULL);
    mpm_draft_set_number(draft, "materials.bar.shear", 0.3, NULL);
    mpm_draft_set_text(draft, "bodies.+.name", "bar", NULL);
    mpm_draft_set_text(draft, "bodies.bar.material", "bar", NULL);
    mpm_draft_set_pair(draft, "bodies.bar.region.rectangle.from", 0.0, 0.0, NULL);
    mpm_draft_set_pair(draft, "bodies.bar.region.rectangle.to", length, 1.0, NULL);
    mpm_draft_set(draft, "bodies.bar.velocity", "[1e-4*sin(pi*x/16), 0]", NULL);
    mpm_draft_set(draft, "boundary",
                  "[{region: all, velocity: [free, 0]},"
                  " {region: {line: {from: [0, 0], to: [0, 1]}}, velocity: [0, free]},"
                  " {region: {line: {from: [16, 0], to: [16, 1]}}, velocity: [0, free]}]",
                  NULL);
    (void)mpm_draft_build(draft, &scene, error);
    mpm_draft_free(draft);
    return scene;
}

/* The time between the first and the third change of sign; 0 if there are none, below 0 where a
 * step fails. */
static double measure_period(struct mpm_simulation *simulation, double end, struct mpm_error *error)
{
    const size_t middle = mpm_simulation_particle_count(simulation) / 2;
    double before = 0.0, first = 0.0, time_before = 0.0;
    int changes = 0;
    while (mpm_simulation_time(simulation) < end) {
        if (mpm_simulation_advance(simulation, end, error) != MPM_OK)
            return -1.0;
        const double time = mpm_simulation_time(simulation);
        double velocity[2];
        mpm_simulation_field_range(simulation, MPM_FIELD_VELOCITY, middle, 1, velocity);
        if (before * velocity[0] < 0.0) {
            const double zero =
                time_before + (time - time_before) * before / (before - velocity[0]);
            changes++;
            if (changes == 1)
                first = zero;
            if (changes == 3)
                return zero - first;
        }
        before = velocity[0];
        time_before = time;
    }
    return 0.0;
}

int main(void)
{
    struct mpm_error error = {.status = MPM_OK};
    const struct mpm_simulation_options options = {.threads = 1};
    struct mpm_simulation *simulation = NULL;
    struct mpm_scene *const scene = build_scene(&error);
    double period = -1.0;
    if (scene != NULL && mpm_simulation_create(scene, &options, &simulation, &error) == MPM_OK)
        period = measure_period(simulation, mpm_scene_end_time(scene), &error);
    if (period > 0.0)
        printf("period %.4f ms, 2 L / c = %.4f ms, %llu steps\n", period, 2.0 * length / wave_speed,
               (unsigned long long)mpm_simulation_step(simulation));
    else
        fprintf(stderr, "bar: %s\n", error.message);
    mpm_simulation_free(simulation);
    mpm_scene_free(scene);
    return period > 0.0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
