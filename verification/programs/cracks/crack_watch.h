/* A crack of a running simulation under watch: how far its faces are apart, and whether particles
 * have crossed it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_PROGRAMS_CRACKS_CRACK_WATCH_H
#define VERIFICATION_PROGRAMS_CRACKS_CRACK_WATCH_H

#include "verification/measures/crack_faces.h"
#include "verification/programs/programs.h"

struct crack_watch {
    size_t crack, first, point_count; /* which points of the simulation's it has */
    double (*points)[2];              /* where they are now */
    struct crack_faces faces;
    struct crack_gap now;
    double widest,
        overlap;    /* so far, of the stations: furthest apart, furthest through each other */
    size_t crossed; /* so far, most particles that were on the other side at a time */
    double depth;   /* and the furthest of them from the crack */
};

/* Of crack number `crack` of the scene, at t = 0; see crack_faces_create for the rest.
 * MPM_BAD_INPUT: the crack has no station. */
enum mpm_status crack_watch_create(const struct mpm_simulation *simulation, size_t crack,
                                   double reach, double spacing, struct crack_watch *watch,
                                   struct mpm_error *error);
void crack_watch_free(struct crack_watch *watch);

/* Samples the crack now; the fields position and deformation_gradient are the caller's. */
void crack_watch_look(struct crack_watch *watch, const struct mpm_simulation *simulation,
                      const double *position, const double *gradient);

#endif
