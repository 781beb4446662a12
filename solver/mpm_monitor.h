/* Looking at simulations that other code makes and advances, with or without a run: a monitor sees
 * every step, and has no effect on the time step or on whether the simulation goes on. For a
 * caller of mpm_scene_run that needs states at certain times, there is mpm_observe.h. Part of the
 * public interface: mpm.h includes it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_MONITOR_H
#define MPM_MONITOR_H

#include "mpm_api.h"

MPM_API_BEGIN

struct mpm_scene;
struct mpm_simulation;

enum mpm_moment {
    MPM_AT_START,   /* it is made, at t = 0; of a run that goes on, before the checkpoint is read */
    MPM_AFTER_STEP, /* a step was taken and is good by all that was judged so far */
    MPM_AT_END,     /* it is freed next */
};

struct mpm_monitor {
    /* Called by the thread that makes, advances or frees the simulation. It reads fields, ledger
     * and scene, and neither changes nor advances anything: results do not depend on it. */
    void (*look)(void *context, enum mpm_moment moment, const struct mpm_simulation *simulation);
    void *context;
};

/* The scene that the simulation was made of. */
const struct mpm_scene *mpm_simulation_scene(const struct mpm_simulation *simulation);

MPM_API_END

#endif
