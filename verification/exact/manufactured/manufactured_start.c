/* The start of a simulation on a manufactured solution.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/common/failure.h"
#include "verification/exact/manufactured/manufactured.h"

#include <stdlib.h>
#include <string.h>

enum { AXES = 2, GRADIENT = 5 };

static void fill(const struct manufactured_problem *problem, const double *places, size_t count,
                 const double times[2], double *velocity, double *deformation)
{
    struct manufactured_state state;
    for (size_t p = 0; p < count; p++) {
        manufactured_evaluate(problem, &places[AXES * p], times[0], &state);
        memcpy(&velocity[AXES * p], state.velocity, AXES * sizeof *velocity);
        manufactured_evaluate(problem, &places[AXES * p], times[1], &state);
        memcpy(&deformation[GRADIENT * p], state.deformation, GRADIENT * sizeof *deformation);
    }
}

enum mpm_status manufactured_start(const struct manufactured_problem *problem, const double *places,
                                   const struct mpm_lags *lags, double step,
                                   struct mpm_simulation *simulation, struct mpm_error *error)
{
    const size_t count = mpm_simulation_particle_count(simulation);
    const double times[2] = {-lags->velocity * step, -lags->deformation * step};
    double *const velocity = malloc(count * AXES * sizeof *velocity);
    double *const deformation = malloc(count * GRADIENT * sizeof *deformation);
    enum mpm_status status;
    if (velocity != NULL && deformation != NULL) {
        fill(problem, places, count, times, velocity, deformation);
        status = mpm_simulation_set_start(simulation, velocity, deformation, error);
    } else {
        status = failure_set(error, MPM_ENVIRONMENT_FAILED, "out of memory for the start");
    }
    free(velocity);
    free(deformation);
    return status;
}
