/* Expressions, bodies and boundaries of a scene.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/scene/scene_build.h"

#include "base/status.h"
#include "mpm_expression.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ------------------------------------------------------------- expressions */

enum mpm_status mpm_build_expression(const struct mpm_reading *reading, const char *path,
                                     const char *text, bool has_time, const double place[2],
                                     char **copy, double *value)
{
    const char *const *names = mpm_scene_coordinates(reading->scene);
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
        return mpm_reading_copy(reading, text, copy);
    return mpm_reading_fault(reading, path, "%s is %s at %s = %g, %s = %g%s; allowed: finite",
                             mpm_excerpt(text, excerpt),
                             isnan(*value) ? "not a number" : "infinite", names[0], place[0],
                             names[1], place[1], has_time ? ", t = 0" : "");
}

enum mpm_status mpm_build_expressions(const struct mpm_reading *reading, const char *path,
                                      char *const texts[2], bool has_time, const double place[2],
                                      struct mpm_vector_expression *vector)
{
    for (size_t i = 0; i < 2; i++) {
        double value;
        if (strcmp(texts[i], "free") == 0)
            continue;
        MPM_TRY(mpm_build_expression(reading, mpm_path_entry(path, i).text, texts[i], has_time,
                                     place, &vector->text[i], &value));
    }
    return MPM_OK;
}

void mpm_drop_constant(char **text, double idle)
{
    double value;
    if (*text == NULL || !mpm_number_parse(*text, &value) || value != idle)
        return;
    free(*text);
    *text = NULL;
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

static enum mpm_status build_rigid(const struct mpm_reading *reading, const char *path,
                                   const struct mpm_raw_body *raw, struct mpm_body_spec *body)
{
    body->rigid = true;
    if (mpm_reading_given(reading, mpm_path_join(path, "velocity").text))
        return mpm_reading_fault(reading, mpm_path_join(path, "velocity").text,
                                 "an initial velocity for a rigid body; allowed: rigid.velocity");
    return build_drive(reading, mpm_path_join(path, "rigid.velocity").text, raw->rigid->velocity,
                       &body->region, &body->velocity);
}

static enum mpm_status build_deformable(const struct mpm_reading *reading, const char *path,
                                        const struct mpm_raw_body *raw, struct mpm_body_spec *body)
{
    const struct mpm_scene *const scene = reading->scene;
    char name[MPM_EXCERPT_SIZE], hint[MPM_HINT_SIZE];
    struct mpm_nearest nearest = {.word = raw->material};
    double place[2];
    for (; body->material < scene->material_count &&
           strcmp(scene->materials[body->material].name, raw->material) != 0;
         body->material++)
        mpm_nearest_offer(&nearest, scene->materials[body->material].name);
    if (body->material == scene->material_count)
        return mpm_reading_fault(reading, mpm_path_join(path, "material").text,
                                 "no such material, got %s; allowed: a name in materials%s",
                                 mpm_excerpt(raw->material, name),
                                 mpm_nearest_hint(&nearest, hint));
    mpm_region_sample(scene, &body->region, place);
    return mpm_build_expressions(reading, mpm_path_join(path, "velocity").text, raw->velocity,
                                 false, place, &body->velocity);
}

static enum mpm_status build_body(const struct mpm_reading *reading, const char *path,
                                  const struct mpm_raw_body *raw, struct mpm_body_spec *body)
{
    (void)snprintf(body->name, MPM_NAME_SIZE, "%s", raw->name);
    body->line = mpm_reading_line(reading, path);
    for (int i = 0; i < 2; i++)
        body->particles_per_cell[i] = (int)raw->particles_per_cell[i];
    if ((raw->material == NULL) == (raw->rigid == NULL))
        return mpm_reading_fault(reading, path,
                                 "%s of material and rigid given; allowed: exactly one",
                                 raw->rigid == NULL ? "none" : "both");
    MPM_TRY(mpm_build_body_region(reading, mpm_path_join(path, "region").text, raw->region,
                                  &body->region));
    return (raw->rigid != NULL ? build_rigid : build_deformable)(reading, path, raw, body);
}

enum mpm_status mpm_build_bodies(const struct mpm_reading *reading)
{
    struct mpm_scene *scene = reading->scene;
    const size_t count = reading->raw->bodies_count;
    const size_t faults = reading->faults->count;
    bool deformable = false;
    MPM_TRY(mpm_reading_allocate(reading, count, sizeof *scene->bodies, "bodies", &scene->bodies));
    scene->body_count = count;
    for (size_t i = 0; i < count; i++) {
        MPM_TRY(mpm_reading_note(reading, build_body(reading, mpm_path_entry("bodies", i).text,
                                                     &reading->raw->bodies[i], &scene->bodies[i])));
        deformable |= !scene->bodies[i].rigid;
    }
    if (!deformable && reading->faults->count == faults)
        return mpm_reading_fault(reading, "bodies",
                                 "no deformable body; allowed: one at least with a material");
    return mpm_reading_check_names(reading, "bodies", count, scene->bodies[0].name,
                                   sizeof scene->bodies[0]);
}

/* -------------------------------------------------------------- boundaries */

static enum mpm_status build_boundary(const struct mpm_reading *reading, const char *path,
                                      const struct mpm_raw_boundary *raw,
                                      struct mpm_boundary_spec *boundary)
{
    const bool symmetry = mpm_reading_given(reading, mpm_path_join(path, "symmetry").text);
    const bool velocity = mpm_reading_given(reading, mpm_path_join(path, "velocity").text);
    boundary->line = mpm_reading_line(reading, path);
    if (symmetry == velocity)
        return mpm_reading_fault(reading, path,
                                 "%s of velocity and symmetry given; allowed: exactly one",
                                 velocity ? "both" : "none");
    MPM_TRY(mpm_build_boundary_region(reading, mpm_path_join(path, "region").text, raw->region,
                                      &boundary->region));
    if (symmetry)
        return mpm_build_symmetry(reading, path, raw, boundary);
    return build_drive(reading, mpm_path_join(path, "velocity").text, raw->velocity,
                       &boundary->region, &boundary->velocity);
}

enum mpm_status mpm_build_boundaries(const struct mpm_reading *reading)
{
    struct mpm_scene *scene = reading->scene;
    const size_t count = reading->raw->boundary_count;
    MPM_TRY(mpm_reading_allocate(reading, count, sizeof *scene->boundaries, "boundaries",
                                 &scene->boundaries));
    scene->boundary_count = count;
    for (size_t i = 0; i < count; i++)
        MPM_TRY(mpm_reading_note(
            reading, build_boundary(reading, mpm_path_entry("boundary", i).text,
                                    &reading->raw->boundary[i], &scene->boundaries[i])));
    return MPM_OK;
}
