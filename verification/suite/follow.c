/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/suite/follow.h"

enum mpm_status follow_to(struct measurement *measurement, struct mpm_simulation *simulation,
                          double time, bool *alive, struct mpm_error *error)
{
    *alive = true;
    while (mpm_simulation_time(simulation) < time) {
        const enum mpm_status status = mpm_simulation_advance(simulation, time, error);
        if (status == MPM_RUN_FAILED) {
            *alive = false;
            measurement_note(measurement, "the run ended: %s", error->message);
            return MPM_OK;
        }
        TRY(status);
    }
    return MPM_OK;
}

void follow_count_work(struct measurement *measurement, const struct mpm_simulation *simulation)
{
    measurement_work(measurement,
                     mpm_simulation_step(simulation) * mpm_simulation_particle_count(simulation));
}
