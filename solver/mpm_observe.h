/* Observers: functions of the caller that a run calls at steps or at times, with the particles'
 * fields as arrays. Steps land on the times of an observer, and it can end the run. For simulations
 * that are advanced without a run, there is mpm_monitor.h. Part of the public interface: mpm.h
 * includes it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_OBSERVE_H
#define MPM_OBSERVE_H

#include "mpm_error.h"
#include "mpm_fields.h"

#include <stdint.h>

MPM_API_BEGIN

/* Values of all particles, sorted by id: component k of the particle `id` is
 * values[id * stride + k]. */
struct mpm_field_view {
    const double *values;
    size_t count; /* of particles, rigid ones included */
    size_t components;
    size_t stride; /* from one particle to the next, in numbers */
};

/* The state that an observer is called in: valid until the observer returns. */
struct mpm_observation;

/* The simulation that runs: for its time, its ledger and all else that reads. */
const struct mpm_simulation *mpm_observation_simulation(const struct mpm_observation *observation);

/* A field in that state. The array belongs to the observation, and is valid until the
 * observer returns. MPM_BAD_INPUT: a field that the scene does not have. MPM_ENVIRONMENT_FAILED: no
 * memory. Cost: one copy the first time that the observation is asked for the field; nothing after
 * that. */
enum mpm_status mpm_observation_field(struct mpm_observation *observation, enum mpm_field field,
                                      struct mpm_field_view *view, struct mpm_error *error);

/* When to call which function. Conditions add up: a state that meets several is observed once. The
 * start of a run is always observed, unless it goes on from a checkpoint, and so is its end, unless
 * it fails or a signal ends it. */
struct mpm_observer {
    uint64_t steps;      /* after each so many steps; 0: not by steps */
    double interval;     /* at t = 0, interval, 2 interval, ...; 0: not by an interval */
    const double *times; /* at these, which ascend; may be NULL */
    size_t time_count;
    /* Returns MPM_OK to go on, or another status with a message in *error: the run ends with it. */
    enum mpm_status (*observe)(void *context, struct mpm_observation *observation,
                               struct mpm_error *error);
    void *context;
};

MPM_API_END

#endif
