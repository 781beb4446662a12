/* J integrals of a scene: rectangles of grid lines around the tips of its cracks.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/scene/scene_build.h"

#include <math.h>
#include <stdio.h>

/* Both tips of a chain are places in bodies, or a contour around it would leave them; that is found
 * when the simulation is created. Here: the same integral twice. */
static enum mpm_status check_others(const struct mpm_reading *reading, const char *path,
                                    size_t index)
{
    const struct mpm_j_integral_spec *const all = reading->scene->j_integrals;
    const struct mpm_j_integral_spec *const own = &all[index];
    for (size_t i = 0; i < index; i++)
        if (all[i].crack == own->crack && all[i].at_start == own->at_start &&
            all[i].contour == own->contour && all[i].dynamic == own->dynamic &&
            all[i].form == own->form)
            return mpm_reading_fault(reading, path,
                                     "the same integral as %s; allowed: another tip, contour, form "
                                     "or dynamic",
                                     all[i].key);
    return MPM_OK;
}

static enum mpm_status check_growing(const struct mpm_reading *reading, const char *path,
                                     size_t index)
{
    const struct mpm_scene *const scene = reading->scene;
    const struct mpm_j_integral_spec *const own = &scene->j_integrals[index];
    for (size_t i = 0; i < index; i++)
        if (scene->j_integrals[i].crack == own->crack &&
            scene->j_integrals[i].at_start == own->at_start &&
            scene->j_integrals[i].growth.toughness > 0.0)
            return mpm_reading_fault(reading, path,
                                     "the tip grows by %s already; allowed: one propagation a tip",
                                     scene->j_integrals[i].key);
    return MPM_OK;
}

static enum mpm_status build_growth(const struct mpm_reading *reading,
                                    const struct mpm_raw_propagation *raw, size_t index)
{
    struct mpm_j_integral_spec *const own = &reading->scene->j_integrals[index];
    const struct mpm_path key = mpm_path_join(own->key, "propagation");
    const char *const path = key.text;
    if (raw == NULL)
        return MPM_OK;
    MPM_TRY(check_growing(reading, path, index));
    own->growth = (struct mpm_growth_spec){
        .toughness = mpm_raw_double(raw->toughness),
        .increment = mpm_raw_double(raw->increment),
        .longest = mpm_raw_double(raw->longest),
        .direction = (enum mpm_growth_direction)raw->direction,
        .every = raw->every,
    };
    const double increment =
        own->growth.increment * fmin(reading->scene->cell[0], reading->scene->cell[1]);
    if (!(own->growth.longest >= increment * (1.0 - 1e-9)))
        return mpm_reading_fault(reading, path,
                                 "longest is %g; allowed: at least one increment, %g",
                                 own->growth.longest, increment);
    if (!(own->growth.longest / increment <= MPM_POINTS_MAX))
        return mpm_reading_fault(reading, path, "longest is %g increments; allowed: up to %d",
                                 own->growth.longest / increment, MPM_POINTS_MAX);
    return MPM_OK;
}

/* Stress intensity factors follow from J with the moduli of the material around the tip. */
static enum mpm_status check_moduli(const struct mpm_reading *reading)
{
    const struct mpm_scene *const scene = reading->scene;
    for (size_t k = 0; k < scene->material_count; k++) {
        const struct mpm_material_law *const law = scene->materials[k].law;
        if (mpm_law_parameter(law, MPM_PARAMETER_BULK) == NULL ||
            mpm_law_parameter(law, MPM_PARAMETER_SHEAR) == NULL || law->update != NULL)
            return mpm_reading_fault(reading, scene->j_integrals[0].key,
                                     "the law %s of material %s is not elastic; allowed with J "
                                     "integrals: laws of F alone with bulk and shear",
                                     law->name, scene->materials[k].name);
    }
    return MPM_OK;
}

/* Scratch memory goes with its size. */
static enum mpm_status check_contour(const struct mpm_reading *reading,
                                     const struct mpm_j_integral_spec *made)
{
    const int64_t *const cells = reading->scene->cells;
    const int64_t fewest = cells[0] < cells[1] ? cells[0] : cells[1];
    if (made->contour <= fewest / 2)
        return MPM_OK;
    return mpm_reading_fault(reading, made->key,
                             "a contour of %lld cells to each side; allowed: up to half of the "
                             "grid's, %lld",
                             (long long)made->contour, (long long)(fewest / 2));
}

static enum mpm_status build_one(const struct mpm_reading *reading, size_t crack, size_t i)
{
    struct mpm_scene *const scene = reading->scene;
    const struct mpm_raw_j_integral *const raw = &reading->raw->cracks[crack].j_integral[i];
    const size_t index = scene->j_integral_count++;
    struct mpm_j_integral_spec *const made = &scene->j_integrals[index];
    (void)snprintf(made->key, sizeof made->key, "cracks.%zu.j_integral.%zu", crack, i);
    made->crack = crack;
    made->at_start = raw->tip != 0;
    made->contour = raw->contour;
    made->dynamic = raw->dynamic;
    made->form = scene->geometry == MPM_AXISYMMETRIC ? (enum mpm_j_form)raw->form : MPM_J_CONTOUR;
    made->line = mpm_reading_line(reading, made->key);
    MPM_TRY(check_contour(reading, made));
    MPM_TRY(check_others(reading, made->key, index));
    return build_growth(reading, raw->propagation, index);
}

enum mpm_status mpm_build_j_integrals(const struct mpm_reading *reading)
{
    struct mpm_scene *const scene = reading->scene;
    size_t count = 0;
    for (size_t k = 0; k < scene->crack_count; k++)
        count += reading->raw->cracks[k].j_integral_count;
    if (count == 0)
        return MPM_OK;
    MPM_TRY(mpm_reading_allocate(reading, count, sizeof *scene->j_integrals, "J integrals",
                                 &scene->j_integrals));
    for (size_t k = 0; k < scene->crack_count; k++)
        for (size_t i = 0; i < reading->raw->cracks[k].j_integral_count; i++)
            MPM_TRY(build_one(reading, k, i));
    return check_moduli(reading);
}
