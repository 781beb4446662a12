/* What runs of bodies with cracks that hit each other have in common: the cracks under watch, the
 * mirror symmetry about y = 0, and pictures at given times.
 *
 * Parameters: cell (length, the unit of results), reach (of the faces, in cells), spacing (of
 * the stations, in cells); for pictures `picture` (picture.h) and `frames`, times in ascending
 * order.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_PROGRAMS_IMPACT_H
#define VERIFICATION_PROGRAMS_IMPACT_H

#include "verification/programs/cracks/crack_watch.h"
#include "verification/programs/picture.h"

enum { IMPACT_FRAMES_MAX = 8 };

struct impact {
    struct measurement *measurement;
    const struct mpm_simulation *simulation;
    size_t count;
    double cell;
    double *position, *gradient; /* of the last sample */
    size_t *mirror;              /* per particle: the one at (x, -y) at t = 0 */
    double asymmetry;            /* so far: largest distance of a particle to its mirror's image */
    struct crack_watch *cracks;
    size_t crack_count;
    struct picture picture;
    double frames[IMPACT_FRAMES_MAX];
    size_t frame_count, frame; /* the next one */
    enum mpm_field field;      /* that pictures show, its first component */
    enum mpm_status status;    /* the first failure to write a picture, with its message */
    struct mpm_error error;
};

/* At t = 0. MPM_BAD_INPUT: a parameter, a crack without faces, a scene that is not its own image.
 */
enum mpm_status impact_open(struct impact *impact, struct measurement *measurement,
                            const struct mpm_simulation *simulation, enum mpm_field field,
                            struct mpm_error *error);
void impact_close(struct impact *impact);

/* Samples the moment. */
void impact_look(struct impact *impact);

/* Reports asymmetry (cells) and of each crack k = 1, 2, ... opening_k (length), overlap_k
 * and depth_k (cells; of particles that crossed), range_k = 1 + overlap/opening, and kept_k (% of
 * the faces' particles that were on their side at all sampled times). Returns the first failure of
 * the samples. */
enum mpm_status impact_report(const struct impact *impact, struct mpm_error *error);

#endif
