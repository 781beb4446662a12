/* Bodies, boundaries and loads of a scene.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/scene/scene_build.h"

#include "base/expression.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ------------------------------------------------------------- expressions */

const char *const *mpm_coordinate_names(const struct mpm_scene *scene)
{
    static const char *const planar[2] = {"x", "y"};
    static const char *const axisymmetric[2] = {"r", "z"};
    return scene->geometry == MPM_AXISYMMETRIC ? axisymmetric : planar;
}

static enum mpm_status check_expression(const struct mpm_reading *reading, const char *path,
                                        const char *text, bool has_time, const double place[2],
                                        double *value)
{
    const char *const *names = mpm_coordinate_names(reading->scene);
    char excerpt[MPM_EXCERPT_SIZE];
    struct mpm_expression *expression = NULL;
    struct mpm_error mistake;
    const enum mpm_status status =
        mpm_expression_create(text, names, has_time, 1, &expression, &mistake);
    if (status == MPM_BAD_INPUT)
        return mpm_reading_fault(reading, path, "%s: %s", mpm_excerpt(text, excerpt),
                                 mistake.message);
    if (status != MPM_OK)
        return mpm_error_set(reading->error, status, "%s", mistake.message);
    *value = mpm_expression_value(expression, 0, place, 0.0);
    mpm_expression_free(expression);
    if (isfinite(*value))
        return MPM_OK;
    return mpm_reading_fault(reading, path, "%s is %s at %s = %g, %s = %g%s; allowed: finite",
                             mpm_excerpt(text, excerpt),
                             isnan(*value) ? "not a number" : "infinite", names[0], place[0],
                             names[1], place[1], has_time ? ", t = 0" : "");
}

enum mpm_status mpm_build_expression(const struct mpm_reading *reading, const char *path,
                                     const char *text, bool has_time, const double place[2],
                                     char **copy, double *value)
{
    MPM_TRY(check_expression(reading, path, text, has_time, place, value));
    return mpm_reading_copy(reading, text, copy);
}

enum mpm_status mpm_build_expressions(const struct mpm_reading *reading, const char *path,
                                      char *const texts[2], bool has_time, const double place[2],
                                      struct mpm_vector_expression *vector)
{
    for (size_t i = 0; i < 2; i++) {
        char component[MPM_PATH_SIZE];
        double value;
        if (strcmp(texts[i], "free") == 0)
            continue;
        MPM_TRY(mpm_build_expression(reading, mpm_path_entry(path, i, component), texts[i],
                                     has_time, place, &vector->text[i], &value));
    }
    return MPM_OK;
}

/* A velocity that drives nodes: at least one component. */
static enum mpm_status build_drive(const struct mpm_reading *reading, const char *path,
                                   char *const texts[2], const struct mpm_region *region,
                                   struct mpm_vector_expression *velocity)
{
    double place[2];
    mpm_region_sample(reading->scene, region, place);
    MPM_TRY(mpm_build_expressions(reading, path, texts, true, place, velocity));
    if (velocity->text[0] != NULL || velocity->text[1] != NULL)
        return MPM_OK;
    return mpm_reading_fault(reading, path,
                             "both components are free, so it drives nothing; allowed: free in "
                             "one of them");
}

/* ------------------------------------------------------------------ bodies */

struct body_paths {
    char body[MPM_PATH_SIZE], velocity[MPM_PATH_SIZE], material[MPM_PATH_SIZE],
        region[MPM_PATH_SIZE], rigid_velocity[MPM_PATH_SIZE];
};

static struct body_paths body_paths(size_t position)
{
    struct body_paths paths = {.body = ""};
    (void)mpm_path_entry("bodies", position, paths.body);
    (void)mpm_path_join(paths.body, "velocity", paths.velocity);
    (void)mpm_path_join(paths.body, "material", paths.material);
    (void)mpm_path_join(paths.body, "region", paths.region);
    (void)mpm_path_join(paths.body, "rigid.velocity", paths.rigid_velocity);
    return paths;
}

static enum mpm_status build_rigid(const struct mpm_reading *reading,
                                   const struct body_paths *paths, const struct mpm_raw_body *raw,
                                   struct mpm_body_spec *body)
{
    body->rigid = true;
    if (mpm_reading_given(reading, paths->velocity))
        return mpm_reading_fault(reading, paths->velocity,
                                 "an initial velocity for a rigid body; allowed: rigid.velocity");
    return build_drive(reading, paths->rigid_velocity, raw->rigid->velocity, &body->region,
                       &body->velocity);
}

static enum mpm_status build_deformable(const struct mpm_reading *reading,
                                        const struct body_paths *paths,
                                        const struct mpm_raw_body *raw,
                                        const struct mpm_indexed_name *materials,
                                        struct mpm_body_spec *body)
{
    char name[MPM_EXCERPT_SIZE];
    double place[2];
    if (!mpm_names_find(materials, reading->scene->material_count, raw->material, &body->material))
        return mpm_reading_fault(reading, paths->material,
                                 "no such material, got %s; allowed: a name in materials",
                                 mpm_excerpt(raw->material, name));
    mpm_region_sample(reading->scene, &body->region, place);
    return mpm_build_expressions(reading, paths->velocity, raw->velocity, false, place,
                                 &body->velocity);
}

static enum mpm_status build_body(const struct mpm_reading *reading, size_t position,
                                  const struct mpm_indexed_name *materials)
{
    const struct mpm_raw_body *raw = &reading->raw->bodies[position];
    struct mpm_body_spec *body = &reading->scene->bodies[position];
    const struct body_paths paths = body_paths(position);
    (void)snprintf(body->name, MPM_NAME_SIZE, "%s", raw->name);
    body->line = mpm_reading_line(reading, paths.body);
    for (int i = 0; i < 2; i++)
        body->particles_per_cell[i] = (int)raw->particles_per_cell[i];
    if ((raw->material == NULL) == (raw->rigid == NULL))
        return mpm_reading_fault(reading, paths.body,
                                 "%s of material and rigid given; allowed: exactly one",
                                 raw->rigid == NULL ? "none" : "both");
    MPM_TRY(mpm_build_body_region(reading, paths.region, raw->region, &body->region));
    if (raw->rigid != NULL)
        return build_rigid(reading, &paths, raw, body);
    return build_deformable(reading, &paths, raw, materials, body);
}

static enum mpm_status build_all_bodies(const struct mpm_reading *reading,
                                        const struct mpm_indexed_name *materials)
{
    const struct mpm_scene *scene = reading->scene;
    bool deformable = false;
    for (size_t i = 0; i < scene->body_count; i++) {
        MPM_TRY(build_body(reading, i, materials));
        deformable |= !scene->bodies[i].rigid;
    }
    if (!deformable)
        return mpm_reading_fault(reading, "bodies",
                                 "no deformable body; allowed: one at least with a material");
    struct mpm_indexed_name *names = NULL;
    MPM_TRY(mpm_reading_index(reading, "bodies", scene->body_count, scene->bodies[0].name,
                              sizeof scene->bodies[0], &names));
    free(names);
    return MPM_OK;
}

enum mpm_status mpm_build_bodies(const struct mpm_reading *reading)
{
    struct mpm_scene *scene = reading->scene;
    const size_t count = reading->raw->bodies_count;
    scene->bodies = mpm_reading_allocate(reading, count, sizeof *scene->bodies, "bodies");
    if (scene->bodies == NULL)
        return MPM_ENVIRONMENT_FAILED;
    scene->body_count = count;
    struct mpm_indexed_name *materials = NULL;
    MPM_TRY(mpm_reading_index(reading, "materials", scene->material_count, scene->materials[0].name,
                              sizeof scene->materials[0], &materials));
    const enum mpm_status status = build_all_bodies(reading, materials);
    free(materials);
    return status;
}

/* ----------------------------------------------------- boundaries and loads */

static enum mpm_status build_boundary(const struct mpm_reading *reading, const char *path,
                                      const struct mpm_raw_boundary *raw,
                                      struct mpm_boundary_spec *boundary)
{
    char key[MPM_PATH_SIZE];
    const bool symmetry = mpm_reading_given(reading, mpm_path_join(path, "symmetry", key));
    const bool velocity = mpm_reading_given(reading, mpm_path_join(path, "velocity", key));
    boundary->line = mpm_reading_line(reading, path);
    if (symmetry == velocity)
        return mpm_reading_fault(reading, path,
                                 "%s of velocity and symmetry given; allowed: exactly one",
                                 velocity ? "both" : "none");
    MPM_TRY(mpm_build_boundary_region(reading, mpm_path_join(path, "region", key), raw->region,
                                      &boundary->region));
    if (symmetry)
        return mpm_build_symmetry(reading, path, raw, boundary);
    return build_drive(reading, mpm_path_join(path, "velocity", key), raw->velocity,
                       &boundary->region, &boundary->velocity);
}

enum mpm_status mpm_build_boundaries(const struct mpm_reading *reading)
{
    struct mpm_scene *scene = reading->scene;
    const size_t count = reading->raw->boundary_count;
    scene->boundaries =
        mpm_reading_allocate(reading, count, sizeof *scene->boundaries, "boundaries");
    if (scene->boundaries == NULL)
        return MPM_ENVIRONMENT_FAILED;
    scene->boundary_count = count;
    for (size_t i = 0; i < count; i++) {
        char path[MPM_PATH_SIZE];
        MPM_TRY(build_boundary(reading, mpm_path_entry("boundary", i, path),
                               &reading->raw->boundary[i], &scene->boundaries[i]));
    }
    return MPM_OK;
}

void mpm_drop_zero(char **text)
{
    double value = 1.0;
    if (*text == NULL || !mpm_number_parse(*text, &value) || value != 0.0)
        return;
    free(*text);
    *text = NULL;
}

enum mpm_status mpm_build_loads(const struct mpm_reading *reading)
{
    struct mpm_scene *scene = reading->scene;
    const struct mpm_region everywhere = {.kind = MPM_REGION_ALL};
    double place[2];
    mpm_region_sample(scene, &everywhere, place);
    MPM_TRY(mpm_build_edge_loads(reading));
    scene->line_body_force = mpm_reading_line(reading, "loads.body_force");
    MPM_TRY(mpm_build_expressions(reading, "loads.body_force", reading->raw->loads->body_force,
                                  true, place, &scene->body_force));
    mpm_drop_zero(&scene->body_force.text[0]);
    mpm_drop_zero(&scene->body_force.text[1]);
    scene->body_force_at = (enum mpm_body_force_place)reading->raw->loads->body_force_at;
    if (scene->body_force_at == MPM_BODY_FORCE_AT_NODES &&
        !mpm_reading_given(reading, "loads.body_force"))
        return mpm_reading_fault(reading, "loads.body_force_at",
                                 "without loads.body_force, which it is of");
    return MPM_OK;
}
