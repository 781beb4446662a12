/* A picture of particles: pixels in rows, each with the value of the particle whose deformed
 * domain it lies in.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_MEASURES_RASTER_H
#define VERIFICATION_MEASURES_RASTER_H

#include <stdbool.h>
#include <stddef.h>

/* The value where there is no particle; a number, since data files of figures hold no NaN. */
#define RASTER_EMPTY (-1e30)

struct raster {
    double from[2]; /* lower left corner */
    double pixel;   /* its side */
    size_t columns, rows;
    double *values; /* row by row, upwards */
};

/* Pixels of that side from `from` to `to`, all empty; a part of one at the end counts. False: out
 * of memory, or nothing to draw on. */
bool raster_create(const double from[2], const double to[2], double pixel, struct raster *raster);
void raster_free(struct raster *raster);

/* Gives `value` to the pixels whose centres are inside the parallelogram about `centre` with the
 * columns of `edges` as its domain vectors: xx xy yx yy, so that edges[0], edges[2] is the first.
 * Overlapping ones: the last wins. Cost: pixels of its box. */
void raster_add(struct raster *raster, const double centre[2], const double edges[4], double value);

#endif
