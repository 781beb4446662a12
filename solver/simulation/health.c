/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "simulation/simulation.h"

#include <stdio.h>

/* Kinetic energy may exceed all energy ever put in by this factor: a sound run stays
 * below 1, an unstable one grows without bound. */
static const double RUNAWAY_FACTOR = 10.0;
/* Round-off alone moves a body at rest: energies below this part of m c^2 mean nothing. */
static const double NOISE = 1e-12;

/* A wave speed grown by this factor has taken the time step with it: the run would go on
 * for ever. No solid gets there; J would be 1e-12. */
static const double RUNAWAY_WAVE = 1e4;

static const char *body_of(const struct mpm_simulation *simulation, uint32_t id)
{
    const struct mpm_particles *const particles = &simulation->state.particles;
    for (size_t p = 0; p < particles->count; p++)
        if (particles->id[p] == id)
            return simulation->scene->bodies[particles->body[p]].name;
    return "?";
}

static uint32_t fastest_particle(const struct mpm_particles *particles)
{
    size_t fastest = 0;
    double largest = 0.0;
    for (size_t p = 0; p < particles->count; p++) {
        const double vx = particles->velocity[0][p], vy = particles->velocity[1][p];
        const double square = vx * vx + vy * vy;
        if (square > largest) {
            largest = square;
            fastest = p;
        }
    }
    return particles->id[fastest];
}

static void describe(const struct mpm_simulation *simulation, const struct mpm_failure *failure,
                     char *text, size_t size)
{
    const bool axisymmetric = simulation->scene->geometry == MPM_AXISYMMETRIC;
    const char *const names[2] = {axisymmetric ? "r" : "x", axisymmetric ? "z" : "y"};
    const char *const name = names[failure->axis];
    const struct mpm_grid *const grid = &simulation->state.grid;
    const double low = grid->origin[failure->axis];
    const double high = low + (double)grid->cells[failure->axis] * grid->cell[failure->axis];
    switch (failure->kind) {
    case MPM_INVERTED:
        (void)snprintf(text, size, "is inverted: det F = %g; allowed: above 0", failure->value);
        return;
    case MPM_NOT_FINITE:
        (void)snprintf(text, size, "is not finite: %g", failure->value);
        return;
    case MPM_LEFT_GRID:
        (void)snprintf(text, size, "left the grid: %s = %g; allowed: %g to %g", name,
                       failure->value, low, high);
        return;
    case MPM_PAST_AXIS:
        (void)snprintf(text, size, "passed the axis: r = %g; allowed: above 0", failure->value);
        return;
    case MPM_OUTRAN_CELL:
        (void)snprintf(text, size, "moved %g cells along %s in one step; allowed: up to 1",
                       failure->value, name);
        return;
    case MPM_DOMAIN_TOO_BIG:
        (void)snprintf(text, size,
                       "has a domain that reaches %g cells along %s, beyond the ghost rows of "
                       "the grid",
                       failure->value, name);
        return;
    case MPM_LOAD_NOT_FINITE:
        (void)snprintf(text, size, "has a body force that is not finite: loads.body_force.%d = %g",
                       failure->axis, failure->value);
        return;
    case MPM_TRACTION_NOT_FINITE:
        (void)snprintf(text, size, "bears a load that is not finite: %s.value.%d = %g",
                       simulation->scene->edge_loads[failure->load].key, failure->axis,
                       failure->value);
        return;
    case MPM_TWO_CRACKS:
        (void)snprintf(text, size, "reaches a node past two cracks; allowed: past one");
        return;
    case MPM_GIVEN_FORCE_NOT_FINITE:
        (void)snprintf(text, size, "is given a body force that is not finite: %g along %s",
                       failure->value, name);
        return;
    case MPM_RATE_REFUSED:
        (void)snprintf(text, size,
                       "has damping.particle = %g; allowed: at least 0 and below %g, 1 over the "
                       "time step",
                       failure->value, 1.0 / simulation->state.time_step);
        return;
    case MPM_UNIFORM_LOAD_NOT_FINITE:
    case MPM_NO_FAILURE:
        break;
    }
    (void)snprintf(text, size, "is sound");
}

enum mpm_status mpm_health_refuse_start(const struct mpm_simulation *simulation,
                                        struct mpm_error *error)
{
    const struct mpm_failure *const failure = &simulation->state.failure;
    char text[256];
    describe(simulation, failure, text, sizeof text);
    return mpm_error_set(error, MPM_BAD_INPUT, "start: particle %u (body '%s') %s",
                         failure->particle, body_of(simulation, failure->particle), text);
}

enum mpm_status mpm_health_check(const struct mpm_simulation *simulation, double kinetic_energy,
                                 struct mpm_error *error)
{
    const struct mpm_failure *const failure = &simulation->state.failure;
    const unsigned long long step = (unsigned long long)simulation->step + 1;
    const double time = simulation->state.time + simulation->state.time_step;
    if (failure->kind == MPM_UNIFORM_LOAD_NOT_FINITE)
        return mpm_error_set(error, MPM_RUN_FAILED,
                             "unstable at step %llu, time %g: the body force is not finite: "
                             "loads.body_force.%d = %g",
                             step, time, failure->axis, failure->value);
    if (failure->kind != MPM_NO_FAILURE) {
        char text[256];
        describe(simulation, failure, text, sizeof text);
        return mpm_error_set(error, MPM_RUN_FAILED,
                             "unstable at step %llu, time %g: particle %u (body '%s') %s", step,
                             time, failure->particle, body_of(simulation, failure->particle), text);
    }
    if (!(simulation->wave_speed <= RUNAWAY_WAVE * simulation->wave_speed_start))
        return mpm_error_set(error, MPM_RUN_FAILED,
                             "unstable at step %llu, time %g: wave speed %g; allowed: up to %g, %g "
                             "times that of the start",
                             step, time, simulation->wave_speed,
                             RUNAWAY_WAVE * simulation->wave_speed_start, RUNAWAY_WAVE);
    const double scale = simulation->mass * simulation->wave_speed * simulation->wave_speed;
    const double limit =
        RUNAWAY_FACTOR * (simulation->energy_start + simulation->work_scale) + NOISE * scale;
    if (kinetic_energy <= limit)
        return MPM_OK;
    const uint32_t fastest = fastest_particle(&simulation->state.particles);
    return mpm_error_set(error, MPM_RUN_FAILED,
                         "unstable at step %llu, time %g: runaway kinetic energy %g; allowed: up "
                         "to %g, %g times all energy put in; fastest is particle %u (body '%s')",
                         step, time, kinetic_energy, limit, RUNAWAY_FACTOR, fastest,
                         body_of(simulation, fastest));
}
