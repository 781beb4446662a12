/* What is known of contact between bodies. Part of the public interface: mpm.h includes it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_CONTACT_H
#define MPM_CONTACT_H

#include "mpm_api.h"

#include <stdbool.h>
#include <stddef.h>

MPM_API_BEGIN

struct mpm_scene;
struct mpm_simulation;
struct mpm_quantity_info; /* mpm.h */

/* Has the scene contact between bodies: has its history the columns of contact energies? */
bool mpm_scene_has_contact(const struct mpm_scene *scene);

/* Values of the history, as those of cracks, of pairs of velocity fields with contact,
 * "contact_0_1_force_x": between fields 0 and 1 of mpm_scene_contact_field_name. */
size_t mpm_scene_contact_quantity_count(const struct mpm_scene *scene);
struct mpm_quantity_info mpm_scene_contact_quantity(const struct mpm_scene *scene, size_t index);
double mpm_simulation_contact_quantity(const struct mpm_simulation *simulation, size_t index);
/* Name of the material or body that a field is of, the first one if it is of several; NULL: there
 * is no such field. */
const char *mpm_scene_contact_field_name(const struct mpm_scene *scene, size_t field);

/* What contact between bodies found at a node for a pair of velocity fields with a law, at the
 * start of the last step. */
struct mpm_contact_point {
    double position[2]; /* of the node */
    size_t of[2];       /* fields of mpm_scene_contact_field_name */
    bool has_normal;
    bool touches;     /* with detection: extent wherever there is a normal; the gap decides */
    double normal[2]; /* unit vector from the first to the second; 0 without */
    double gap;  /* of the surfaces, positive if they are apart; 0 but with detection: extent */
    double area; /* of the surfaces at the node, for the thickness or per radian */
};
/* How many there are: 0 before the first step and in scenes without contact. */
size_t mpm_simulation_contact_point_count(const struct mpm_simulation *simulation);
/* The one of an index below that, in the order of nodes. Cost: a look at the nodes before. */
struct mpm_contact_point mpm_simulation_contact_point(const struct mpm_simulation *simulation,
                                                      size_t index);

MPM_API_END

#endif
