/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/measures/crack_faces.h"

#include <math.h>
#include <stdlib.h>

enum { AXES = 2, GRADIENT = 5 };

/* The point of a crack that is nearest to a place. */
struct nearest {
    size_t segment;
    double way[AXES]; /* from the place to it */
    double distance;
    double along; /* from the first point of the crack to it */
    double side;  /* of the segment that the place is on: 1 left, -1 right */
    bool inside;  /* not one of the ends of the crack */
};

static struct nearest nearest_point(const double place[AXES], const double (*points)[AXES],
                                    size_t point_count)
{
    struct nearest best = {.distance = HUGE_VAL};
    double before = 0.0;
    for (size_t k = 0; k + 1 < point_count; k++) {
        const double *const a = points[k], *const b = points[k + 1];
        const double t[AXES] = {b[0] - a[0], b[1] - a[1]},
                     d[AXES] = {place[0] - a[0], place[1] - a[1]};
        const double length = hypot(t[0], t[1]);
        const double part = (d[0] * t[0] + d[1] * t[1]) / (length * length);
        const double bounded = fmin(fmax(part, 0.0), 1.0);
        const double way[AXES] = {bounded * t[0] - d[0], bounded * t[1] - d[1]};
        const double distance = hypot(way[0], way[1]);
        if (distance < best.distance)
            best = (struct nearest){
                .segment = k,
                .way = {way[0], way[1]},
                .distance = distance,
                .along = before + bounded * length,
                .side = t[0] * d[1] - t[1] * d[0] > 0.0 ? 1.0 : -1.0,
                .inside = (k > 0 || part > 0.0) && (k + 2 < point_count || part < 1.0),
            };
        before += length;
    }
    return best;
}

static void offer(const struct crack_faces *faces, size_t place, struct crack_station *station)
{
    const struct crack_face_particle *const particle = &faces->particles[place];
    size_t *const best = particle->side > 0.0 ? &station->above : &station->below;
    if (*best == faces->count || particle->distance < faces->particles[*best].distance)
        *best = place;
}

/* `along` is where on the crack the particles are. Stations without a pair are left out. */
static void find_stations(struct crack_faces *faces, const double *along, double spacing,
                          size_t bins)
{
    for (size_t s = 0; s < bins; s++)
        faces->stations[s] = (struct crack_station){faces->count, faces->count};
    for (size_t i = 0; i < faces->count; i++)
        offer(faces, i, &faces->stations[(size_t)(along[i] / spacing)]);
    for (size_t s = 0; s < bins; s++)
        if (faces->stations[s].above < faces->count && faces->stations[s].below < faces->count)
            faces->stations[faces->station_count++] = faces->stations[s];
}

static double length_of(const double (*points)[AXES], size_t point_count)
{
    double length = 0.0;
    for (size_t k = 0; k + 1 < point_count; k++)
        length += hypot(points[k + 1][0] - points[k][0], points[k + 1][1] - points[k][1]);
    return length;
}

bool crack_faces_create(const double *position, size_t particles, const double (*points)[AXES],
                        size_t point_count, double reach, double spacing, struct crack_faces *faces)
{
    const size_t bins = (size_t)(length_of(points, point_count) / spacing) + 1;
    double *const along = malloc(particles * sizeof *along);
    *faces = (struct crack_faces){.particles = malloc(particles * sizeof *faces->particles),
                                  .stations = malloc(bins * sizeof *faces->stations)};
    const bool good = along != NULL && faces->particles != NULL && faces->stations != NULL;
    for (size_t p = 0; good && p < particles; p++) {
        const struct nearest near = nearest_point(&position[AXES * p], points, point_count);
        if (!near.inside || near.distance > reach)
            continue;
        along[faces->count] = near.along;
        faces->particles[faces->count++] = (struct crack_face_particle){
            p, near.segment, near.side, {near.way[0], near.way[1]}, near.distance};
    }
    if (good)
        find_stations(faces, along, spacing, bins);
    free(along);
    return good;
}

void crack_faces_free(struct crack_faces *faces)
{
    free(faces->particles);
    free(faces->stations);
    *faces = (struct crack_faces){0};
}

static void face_at(const struct crack_face_particle *particle, const double *position,
                    const double *gradient, double place[AXES])
{
    const double *const x = &position[AXES * particle->index];
    const double *const f = &gradient[GRADIENT * particle->index];
    for (size_t axis = 0; axis < AXES; axis++)
        place[axis] = x[axis] + f[2 * axis] * particle->way[0] + f[2 * axis + 1] * particle->way[1];
}

static double opening_at(const struct crack_faces *faces, const struct crack_station *station,
                         const double *position, const double *gradient,
                         const double (*points)[AXES])
{
    const struct crack_face_particle *const pair[] = {&faces->particles[station->above],
                                                      &faces->particles[station->below]};
    const double *const a = points[pair[0]->segment], *const b = points[pair[0]->segment + 1];
    const double t[AXES] = {b[0] - a[0], b[1] - a[1]};
    double above[AXES], below[AXES];
    face_at(pair[0], position, gradient, above);
    face_at(pair[1], position, gradient, below);
    return ((above[1] - below[1]) * t[0] - (above[0] - below[0]) * t[1]) / hypot(t[0], t[1]);
}

struct crack_gap crack_faces_gap(const struct crack_faces *faces, const double *position,
                                 const double *gradient, const double (*points)[AXES],
                                 size_t point_count)
{
    struct crack_gap gap = {.widest = -HUGE_VAL, .narrowest = HUGE_VAL};
    for (size_t s = 0; s < faces->station_count; s++) {
        const double opening = opening_at(faces, &faces->stations[s], position, gradient, points);
        gap.widest = fmax(gap.widest, opening);
        gap.narrowest = fmin(gap.narrowest, opening);
        gap.mean += opening / (double)faces->station_count;
    }
    for (size_t i = 0; i < faces->count; i++) {
        const struct crack_face_particle *const particle = &faces->particles[i];
        const struct nearest near =
            nearest_point(&position[AXES * particle->index], points, point_count);
        if (!near.inside || near.side == particle->side)
            continue;
        gap.crossed++;
        gap.depth = fmax(gap.depth, near.distance);
    }
    return gap;
}
