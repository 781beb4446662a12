/* Loads on the edges of particles: tractions and particle forces of a scene.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/scene/scene_build.h"

#include <stdio.h>
#include <string.h>

static enum mpm_status find_body(const struct mpm_reading *reading, const char *path,
                                 const char *text, size_t *body)
{
    const struct mpm_scene *const scene = reading->scene;
    char key[MPM_PATH_SIZE], name[MPM_EXCERPT_SIZE];
    (void)mpm_path_join(path, "body", key);
    for (*body = 0; *body < scene->body_count; (*body)++)
        if (strcmp(scene->bodies[*body].name, text) == 0)
            break;
    if (*body == scene->body_count)
        return mpm_reading_fault(reading, key, "no such body, got %s; allowed: a name in bodies",
                                 mpm_excerpt(text, name));
    if (scene->bodies[*body].rigid)
        return mpm_reading_fault(reading, key,
                                 "%s is rigid and feels no force; allowed: a deformable body",
                                 mpm_excerpt(text, name));
    return MPM_OK;
}

static enum mpm_status build_load(const struct mpm_reading *reading, const char *path,
                                  const struct mpm_raw_traction *raw,
                                  struct mpm_edge_load_spec *load)
{
    char key[MPM_PATH_SIZE];
    double place[2];
    load->edge = (enum mpm_edge)raw->edge;
    load->frame = (enum mpm_frame)raw->frame;
    load->line = mpm_reading_line(reading, path);
    MPM_TRY(find_body(reading, path, raw->body, &load->body));
    mpm_region_sample(reading->scene, &reading->scene->bodies[load->body].region, place);
    MPM_TRY(mpm_build_expressions(reading, mpm_path_join(path, "value", key), raw->value, true,
                                  place, &load->value));
    mpm_drop_zero(&load->value.text[0]);
    mpm_drop_zero(&load->value.text[1]);
    return MPM_OK;
}

enum mpm_status mpm_build_edge_loads(const struct mpm_reading *reading)
{
    const struct mpm_raw_loads *const raw = reading->raw->loads;
    struct mpm_scene *const scene = reading->scene;
    const struct {
        const char *path;
        const struct mpm_raw_traction *entries;
        size_t count;
    } lists[] = {
        {"loads.tractions", raw->tractions, raw->tractions_count},
        {"loads.particle_forces", raw->particle_forces, raw->particle_forces_count},
    };
    const size_t count = lists[0].count + lists[1].count;
    if (count == 0)
        return MPM_OK;
    scene->edge_loads = mpm_reading_allocate(reading, count, sizeof *scene->edge_loads, "loads");
    if (scene->edge_loads == NULL)
        return MPM_ENVIRONMENT_FAILED;
    for (size_t list = 0; list < 2; list++)
        for (size_t i = 0; i < lists[list].count; i++) {
            struct mpm_edge_load_spec *const load = &scene->edge_loads[scene->edge_load_count++];
            char path[MPM_PATH_SIZE];
            load->on_particles = list == 1;
            (void)snprintf(load->key, sizeof load->key, "%s",
                           mpm_path_entry(lists[list].path, i, path));
            MPM_TRY(build_load(reading, path, &lists[list].entries[i], load));
        }
    return MPM_OK;
}
