/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/measures/shapes/raster.h"

#include <math.h>
#include <stdlib.h>

bool raster_create(const double from[2], const double to[2], double pixel, struct raster *raster)
{
    *raster = (struct raster){.from = {from[0], from[1]}, .pixel = pixel};
    if (!(pixel > 0.0 && to[0] > from[0] && to[1] > from[1]))
        return false;
    raster->columns = (size_t)ceil((to[0] - from[0]) / pixel * (1.0 - 1e-12));
    raster->rows = (size_t)ceil((to[1] - from[1]) / pixel * (1.0 - 1e-12));
    raster->values = malloc(raster->columns * raster->rows * sizeof *raster->values);
    for (size_t i = 0; raster->values != NULL && i < raster->columns * raster->rows; i++)
        raster->values[i] = RASTER_EMPTY;
    return raster->values != NULL;
}

void raster_free(struct raster *raster)
{
    free(raster->values);
    *raster = (struct raster){0};
}

/* Pixels first..end - 1 along an axis that reach from low to high. */
static void pixels_between(const struct raster *raster, int axis, double low, double high,
                           size_t *first, size_t *end)
{
    const double all = (double)(axis == 0 ? raster->columns : raster->rows);
    const double a = floor((low - raster->from[axis]) / raster->pixel);
    const double b = floor((high - raster->from[axis]) / raster->pixel) + 1.0;
    *first = (size_t)fmin(fmax(a, 0.0), all);
    *end = (size_t)fmin(fmax(b, 0.0), all);
}

void raster_add(struct raster *raster, const double centre[2], const double edges[4], double value)
{
    const double determinant = edges[0] * edges[3] - edges[1] * edges[2];
    size_t first[2], end[2];
    for (int axis = 0; axis < 2; axis++) {
        const double reach = fabs(edges[2 * axis]) + fabs(edges[2 * axis + 1]);
        pixels_between(raster, axis, centre[axis] - reach, centre[axis] + reach, &first[axis],
                       &end[axis]);
    }
    for (size_t row = first[1]; row < end[1]; row++)
        for (size_t column = first[0]; column < end[0]; column++) {
            const double x = raster->from[0] + raster->pixel * ((double)column + 0.5) - centre[0];
            const double y = raster->from[1] + raster->pixel * ((double)row + 0.5) - centre[1];
            const double along = (edges[3] * x - edges[1] * y) / determinant;
            const double across = (edges[0] * y - edges[2] * x) / determinant;
            if (fabs(along) <= 1.0 && fabs(across) <= 1.0)
                raster->values[row * raster->columns + column] = value;
        }
}
