/* The two faces of a crack, as the particles beside it see them.
 *
 * Each particle whose nearest point of the undeformed crack is inside of it (not one of its ends),
 * and not further than `reach`, belongs to the face above (left of the way along the crack) or
 * below. The face itself is where the particle's deformation carries the point: x_p + F_p w_p, with
 * the undeformed way w_p to it. At stations along the crack the two particles next to it, one on
 * each side, show how far the faces are apart along the crack's normal now; where they have passed
 * each other that is negative. Apart from that, a particle is on the side of the moved crack that
 * it was on at first, or it has crossed.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_MEASURES_CRACK_FACES_H
#define VERIFICATION_MEASURES_CRACK_FACES_H

#include <stdbool.h>
#include <stddef.h>

struct crack_face_particle {
    size_t index;    /* in the fields of the simulation */
    size_t segment;  /* of the crack, that it is nearest to */
    double side;     /* 1 above, -1 below */
    double way[2];   /* w_p */
    double distance; /* its length */
};

/* A station: the particles next to the crack, as places in `particles`. */
struct crack_station {
    size_t above, below;
};

struct crack_faces {
    struct crack_face_particle *particles;
    size_t count;
    struct crack_station *stations;
    size_t station_count;
};

/* From undeformed places (2 each) and the crack's points. Stations are `spacing` apart, and those
 * with a particle on each side count. False: out of memory. */
bool crack_faces_create(const double *position, size_t particles, const double (*points)[2],
                        size_t point_count, double reach, double spacing,
                        struct crack_faces *faces);
void crack_faces_free(struct crack_faces *faces);

struct crack_gap {
    double widest, narrowest, mean; /* of the stations; lengths */
    size_t crossed;                 /* particles of a face that are on the other side */
    double depth;                   /* the furthest of them from the crack */
};

/* Of places (2 each), deformation gradients (5 each) and the points of now. */
struct crack_gap crack_faces_gap(const struct crack_faces *faces, const double *position,
                                 const double *gradient, const double (*points)[2],
                                 size_t point_count);

#endif
