/* A scene from a text, run with an observer: two disks collide and part. Each 0.4 ms, and at the
 * times of a list, the observer computes how far the disks' centres are apart, from the arrays of
 * the particles. With a folder as argument the run writes its results there too.
 *
 *     cc disks.c -o disks $(pkg-config --cflags --libs touchstone) -lm
 *     ./disks [FOLDER]
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <mpm.h>

#include <math.h>
#include <stdio.h>
#include <string.h>

static const char text[] =
    "format: 1\n"
    "geometry: plane_strain\n"
    "units: {length: mm, mass: g, time: ms}\n"
    "grid: {origin: [-0.4, -0.4], cell: [0.1, 0.1], cells: [18, 18]}\n"
    "time: {end: 3.6, courant: 0.4}\n"
    "materials:\n"
    "  - {name: rubber, law: neo_hookean, density: 1000, young: 1000, poisson: 0.3}\n"
    "bodies:\n"
    "  - {name: left, material: rubber, region: {disk: {center: [0.2, 0.2], radius: 0.2}},\n"
    "     velocity: [0.1, 0.1]}\n"
    "  - {name: right, material: rubber, region: {disk: {center: [0.8, 0.8], radius: 0.2}},\n"
    "     velocity: [-0.1, -0.1]}\n";

struct centres {
    double nearest; /* least distance so far */
    int calls;
};

static enum mpm_status observe(void *context, struct mpm_observation *observation,
                               struct mpm_error *error)
{
    struct centres *const centres = context;
    struct mpm_field_view body, position;
    enum mpm_status status = mpm_observation_field(observation, MPM_FIELD_BODY, &body, error);
    if (status == MPM_OK)
        status = mpm_observation_field(observation, MPM_FIELD_POSITION, &position, error);
    if (status != MPM_OK)
        return status;
    double sum[2][3] = {{0.0}};
    for (size_t id = 0; id < position.count; id++) {
        double *const of = sum[body.values[id * body.stride] > 0.5];
        of[0] += position.values[id * position.stride];
        of[1] += position.values[id * position.stride + 1];
        of[2] += 1.0;
    }
    const double distance = hypot(sum[1][0] / sum[1][2] - sum[0][0] / sum[0][2],
                                  sum[1][1] / sum[1][2] - sum[0][1] / sum[0][2]);
    printf("time %.3f  distance %.4f\n",
           mpm_simulation_time(mpm_observation_simulation(observation)), distance);
    centres->nearest = fmin(centres->nearest, distance);
    centres->calls++;
    return MPM_OK;
}

int main(int argc, char **argv)
{
    static const double times[] = {1.0, 1.5};
    struct mpm_error error = {.status = MPM_OK};
    struct mpm_scene *scene = NULL;
    struct centres centres = {.nearest = INFINITY};
    const struct mpm_observer observer = {
        .interval = 0.4, .times = times, .time_count = 2, .observe = observe, .context = &centres};
    const struct mpm_run_options options = {
        .output = argc > 1 ? argv[1] : NULL,
        .simulation = {.threads = 2},
        .observers = &observer,
        .observer_count = 1,
    };
    enum mpm_status status = mpm_scene_parse("disks", text, strlen(text), NULL, 0, &scene, &error);
    if (status == MPM_OK)
        status = mpm_scene_run(scene, &options, &error);
    mpm_scene_free(scene);
    if (status != MPM_OK)
        fprintf(stderr, "disks: %s\n", error.message);
    else
        printf("nearest %.4f in %d calls\n", centres.nearest, centres.calls);
    return (int)status;
}
