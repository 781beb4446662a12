/* When conduction takes place beside mechanics: in each step once; in `substeps` equal ones, where
 * its limit is below the waves'; or after `every` steps over their time, where it is far above.
 *
 * A longer step of the mechanics is divided into as few as transport's limit allows, up to
 * `substeps`; places, F and given fluxes are those of its start. Conduction that waits takes place
 * earlier where its limit requires it, and in a step that results follow, at a time of them or the
 * last one of the scene: these are of one time. Laws see new temperatures when conduction has taken
 * place.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_TRANSPORT_STEPS_H
#define MPM_METHOD_TRANSPORT_STEPS_H

#include "method/state.h"

/* All of transport in a step of the mechanics: mpm_transport_advance and what follows from it. */
enum mpm_status mpm_transport_take(struct mpm_state *state, int workers, struct mpm_error *error);

#endif
