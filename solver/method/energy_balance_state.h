/* What the energy balance keeps; see energy_balance.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_ENERGY_BALANCE_STATE_H
#define MPM_METHOD_ENERGY_BALANCE_STATE_H

#include <stdbool.h>

/* Energy between particles and nodes since t = 0, where a scene measures it; see
 * energy_balance.h. */
struct mpm_energy_balance {
    bool measured;
    double particles;     /* their kinetic energy */
    double lost;          /* kinetic energy, between particles and nodes */
    double internal_work; /* what internal and cohesive forces have taken from the nodes */
    double contact;       /* what contact of cracks has taken in momentum updates */
    double dissipated;    /* by damping, before that of the particles in this step */
};

#endif
