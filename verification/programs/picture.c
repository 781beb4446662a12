/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/programs/picture.h"

#include "verification/measures/shapes/raster.h"

#include <glib.h>
#include <math.h>
#include <stdio.h>

enum { AXES = 2, GRADIENT = 5 };

enum mpm_status picture_read(const struct measurement *measurement, struct picture *picture,
                             bool *asked, struct mpm_error *error)
{
    double numbers[5];
    size_t count;
    *asked = measurement_has(measurement, "picture");
    if (!*asked)
        return MPM_OK;
    TRY(measurement_list(measurement, "picture", G_N_ELEMENTS(numbers), numbers, &count, error));
    if (count < G_N_ELEMENTS(numbers))
        return failure_set(error, MPM_BAD_INPUT,
                           "picture: %zu numbers; allowed: \"x y x y pixel\", five", count);
    *picture = (struct picture){
        .from = {numbers[0], numbers[1]}, .to = {numbers[2], numbers[3]}, .pixel = numbers[4]};
    return MPM_OK;
}

/* Domains of neighbours leave slits where they deform unlike each other: drawn a little larger. */
static const double SWELL = 1.05;

/* Rounded to single precision: what an eye can see, in files of half the size. */
static void draw(struct raster *raster, const struct picture *picture,
                 const struct mpm_simulation *simulation, enum mpm_field field, size_t component)
{
    const double aspect = picture->aspect > 0.0 ? picture->aspect : 1.0;
    const size_t n = mpm_simulation_particle_count(simulation);
    const size_t components = mpm_field_describe(field)->components;
    double *const place = g_new(double, AXES *n), *const f = g_new(double, GRADIENT *n);
    double *const volume = g_new(double, n), *const values = g_new(double, components *n);
    mpm_simulation_field(simulation, MPM_FIELD_POSITION, place);
    mpm_simulation_field(simulation, MPM_FIELD_DEFORMATION_GRADIENT, f);
    mpm_simulation_field(simulation, MPM_FIELD_VOLUME, volume);
    mpm_simulation_field(simulation, field, values);
    for (size_t p = 0; p < n; p++) {
        const double *const g = &f[GRADIENT * p];
        /* volumes per radian grow with r, those of a slice with the stretch across */
        const double depth = picture->axisymmetric ? place[AXES * p] : g[4];
        const double side = sqrt(volume[p] / ((g[0] * g[3] - g[1] * g[2]) * depth));
        const double half[AXES] = {0.5 * SWELL * side * sqrt(aspect),
                                   0.5 * SWELL * side / sqrt(aspect)};
        raster_add(raster, &place[AXES * p],
                   (const double[]){half[0] * g[0], half[1] * g[1], half[0] * g[2], half[1] * g[3]},
                   (double)(float)values[components * p + component]);
    }
    g_free(place);
    g_free(f);
    g_free(volume);
    g_free(values);
}

static enum mpm_status write_cracks(struct measurement *measurement,
                                    const struct mpm_simulation *simulation, const char *name,
                                    struct mpm_error *error)
{
    enum { COLUMNS = 3 };
    const size_t count = mpm_simulation_crack_point_count(simulation);
    if (count == 0)
        return MPM_OK;
    double *const rows = g_new(double, COLUMNS *count);
    for (size_t k = 0; k < count; k++) {
        const struct mpm_crack_point point = mpm_simulation_crack_point(simulation, k);
        rows[COLUMNS * k] = point.position[0];
        rows[COLUMNS * k + 1] = point.position[1];
        rows[COLUMNS * k + 2] = (double)point.crack;
    }
    char *const series = g_strdup_printf("%s-cracks", name);
    const enum mpm_status status =
        measurement_series(measurement, series, "x y crack", COLUMNS, count, rows, error);
    g_free(series);
    g_free(rows);
    return status;
}

enum mpm_status picture_write(struct measurement *measurement, const struct picture *picture,
                              const struct mpm_simulation *simulation, enum mpm_field field,
                              size_t component, const char *name, struct mpm_error *error)
{
    struct raster raster;
    if (!raster_create(picture->from, picture->to, picture->pixel, &raster))
        return failure_set(error, MPM_BAD_INPUT,
                           "picture: no pixels of %g between (%g, %g) and (%g, %g)", picture->pixel,
                           picture->from[0], picture->from[1], picture->to[0], picture->to[1]);
    draw(&raster, picture, simulation, field, component);
    enum mpm_status status = measurement_series(measurement, name, "pixels", raster.columns,
                                                raster.rows, raster.values, error);
    if (status == MPM_OK)
        status = write_cracks(measurement, simulation, name, error);
    raster_free(&raster);
    return status;
}
