/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/transport/transport_steps.h"

#include "method/transport/transport.h"
#include "method/transport/transport_coupling.h"
#include "method/transport/transport_rest.h"

/* A step at a limit is not divided for the sake of round-off. */
static const double SLACK = 1e-9;

/* What one step of conduction may take, as far as the last one knows. */
static double allowed(const struct mpm_state *state)
{
    const struct mpm_scene *const scene = state->scene;
    const double courant = scene->step > 0.0 ? 1.0 : scene->courant;
    return courant * (1.0 + SLACK) *
           mpm_transport_stable_step(&state->grid, state->transport.diffusivity,
                                     state->transport.film);
}

static bool is_due(const struct mpm_state *state)
{
    const struct mpm_transport *const transport = &state->transport;
    return transport->steps_waited >= state->scene->transport_every || transport->flush ||
           transport->waited + state->time_step > allowed(state);
}

static int64_t parts_of(const struct mpm_state *state, double span)
{
    const int64_t most = state->scene->transport_substeps;
    int64_t parts = 1;
    while (parts < most && span > (double)parts * allowed(state))
        parts++;
    return parts;
}

/* Conduction over the time that it has waited for, up to the end of the step. */
static enum mpm_status conduct(struct mpm_state *state, int workers, struct mpm_error *error)
{
    const double time = state->time, time_step = state->time_step;
    const double span = state->transport.waited, start = time + time_step - span;
    const int64_t parts = parts_of(state, span);
    enum mpm_status status = MPM_OK;
    for (int64_t k = 0; k < parts && status == MPM_OK; k++) {
        state->time =
            parts == 1 && span == time_step ? time : start + (double)k * (span / (double)parts);
        state->time_step = span / (double)parts;
        status = mpm_transport_advance(state, workers, error);
    }
    if (status == MPM_OK)
        mpm_transport_couple(state, workers);
    state->time = time;
    state->time_step = time_step;
    return status;
}

enum mpm_status mpm_transport_take(struct mpm_state *state, int workers, struct mpm_error *error)
{
    struct mpm_transport *const transport = &state->transport;
    transport->waited += state->time_step;
    transport->steps_waited++;
    if (!is_due(state)) {
        mpm_transport_couple_nothing(state);
        return MPM_OK;
    }
    MPM_TRY(conduct(state, workers, error));
    mpm_transport_measure_rest(state);
    transport->waited = 0.0;
    transport->steps_waited = 0;
    return MPM_OK;
}
