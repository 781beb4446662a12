/* Loads of a scene: body force, and tractions and particle forces on the edges of particles.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/scene/scene_build.h"

#include <stdio.h>
#include <string.h>

enum mpm_status mpm_build_loaded_body(const struct mpm_reading *reading, const char *path,
                                      const char *text, size_t *body)
{
    const struct mpm_scene *const scene = reading->scene;
    char name[MPM_EXCERPT_SIZE];
    while (*body < scene->body_count && strcmp(scene->bodies[*body].name, text) != 0)
        (*body)++;
    if (*body == scene->body_count)
        return mpm_reading_fault(reading, path, "no such body, got %s; allowed: a name in bodies",
                                 mpm_excerpt(text, name));
    if (scene->bodies[*body].rigid)
        return mpm_reading_fault(reading, path,
                                 "%s is rigid and feels no force; allowed: a deformable body",
                                 mpm_excerpt(text, name));
    return MPM_OK;
}

static enum mpm_status build_load(const struct mpm_reading *reading, const char *path,
                                  const struct mpm_raw_traction *raw,
                                  struct mpm_edge_load_spec *load)
{
    double place[2];
    load->edge = (enum mpm_edge)raw->edge;
    load->frame = (enum mpm_frame)raw->frame;
    load->line = mpm_reading_line(reading, path);
    MPM_TRY(
        mpm_build_loaded_body(reading, mpm_path_join(path, "body").text, raw->body, &load->body));
    mpm_region_sample(reading->scene, &reading->scene->bodies[load->body].region, place);
    MPM_TRY(mpm_build_expressions(reading, mpm_path_join(path, "value").text, raw->value, true,
                                  place, &load->value));
    for (int axis = 0; axis < 2; axis++)
        mpm_drop_constant(&load->value.text[axis], 0.0);
    return MPM_OK;
}

static enum mpm_status build_edge_loads(const struct mpm_reading *reading)
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
    const struct mpm_raw_temperature *const heat = reading->raw->transport->temperature;
    const struct mpm_raw_concentration *const solvent = reading->raw->transport->concentration;
    const size_t fluxes =
        (heat == NULL ? 0 : heat->fluxes_count) + (solvent == NULL ? 0 : solvent->fluxes_count);
    const size_t count = lists[0].count + lists[1].count + fluxes; /* by mpm_build_transport */
    if (count == 0)
        return MPM_OK;
    MPM_TRY(mpm_reading_allocate(reading, count, sizeof *scene->edge_loads, "loads",
                                 &scene->edge_loads));
    for (size_t list = 0; list < 2; list++)
        for (size_t i = 0; i < lists[list].count; i++) {
            struct mpm_edge_load_spec *const load = &scene->edge_loads[scene->edge_load_count++];
            load->on_particles = list == 1;
            (void)snprintf(load->key, sizeof load->key, "%s.%zu", lists[list].path, i);
            MPM_TRY(mpm_reading_note(
                reading, build_load(reading, load->key, &lists[list].entries[i], load)));
        }
    return MPM_OK;
}

enum mpm_status mpm_build_loads(const struct mpm_reading *reading)
{
    struct mpm_scene *scene = reading->scene;
    const struct mpm_region everywhere = {.kind = MPM_REGION_ALL};
    double place[2];
    mpm_region_sample(scene, &everywhere, place);
    MPM_TRY(build_edge_loads(reading));
    scene->line_body_force = mpm_reading_line(reading, "loads.body_force");
    MPM_TRY(mpm_build_expressions(reading, "loads.body_force", reading->raw->loads->body_force,
                                  true, place, &scene->body_force));
    for (int axis = 0; axis < 2; axis++)
        mpm_drop_constant(&scene->body_force.text[axis], 0.0);
    scene->body_force_at = (enum mpm_body_force_place)reading->raw->loads->body_force_at;
    if (scene->body_force_at == MPM_BODY_FORCE_AT_NODES &&
        !mpm_reading_given(reading, "loads.body_force"))
        return mpm_reading_fault(reading, "loads.body_force_at",
                                 "without loads.body_force, which it is of");
    return MPM_OK;
}
