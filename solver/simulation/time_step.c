/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/transfer/law_state.h"
#include "method/transport/transport.h"
#include "simulation/simulation.h"

#include <math.h>

/* The rest of the way is taken in one step if it is longer than a step by no more than
 * this part, and in two equal ones if it is shorter than two steps: no sliver is left. */
static const double LANDING_SLACK = 1e-9;

/* Particles below half the wave speed are checked now and then: in bodies that waves outrun by
 * far, a check in each step would cost some percent of it. Should one of them get too fast between
 * two checks, the run fails as soon as it outruns a cell. */
enum { STEPS_BETWEEN_LOOKS = 32 };

double mpm_lightest_particle(const struct mpm_particles *particles)
{
    double mass = particles->mass[0];
    for (size_t p = 1; p < particles->count; p++)
        mass = fmin(mass, particles->mass[p]);
    return mass;
}

double mpm_particle_speed(const struct mpm_particles *particles, size_t first, size_t end)
{
    double square = 0.0;
    for (size_t p = first; p < end; p++) {
        const double vx = particles->velocity[0][p], vy = particles->velocity[1][p];
        square = fmax(square, vx * vx + vy * vy);
    }
    return sqrt(square);
}

static double fastest_wave(const struct mpm_state *state)
{
    double square = 0.0;
    for (int64_t s = 0; s < state->strip_count; s++)
        square = fmax(square, state->strips[s].wave_speed_squared);
    return sqrt(square);
}

double mpm_fastest_wave(const struct mpm_state *state)
{
    const struct mpm_particles *const particles = &state->particles;
    double fastest = 0.0;
    for (size_t p = 0; p < particles->count; p++) {
        double stress[MPM_SYMMETRIC_SIZE], square;
        mpm_particle_find_stress(state, p, stress, &square);
        fastest = fmax(fastest, square);
    }
    return sqrt(fastest);
}

/* Checks the particles of a strip only if its kinetic energy could make one of them as fast. */
static double fastest_particle(const struct mpm_simulation *simulation, double wave_speed)
{
    const struct mpm_state *const state = &simulation->state;
    const double enough = simulation->lightest * wave_speed * wave_speed;
    double speed = 0.0;
    for (int64_t s = 0; s < state->strip_count; s++) {
        const struct mpm_strip *const strip = &state->strips[s];
        if (2.0 * strip->kinetic_energy > enough)
            speed = fmax(speed, mpm_particle_speed(&state->particles, strip->begin, strip->end));
    }
    return speed;
}

void mpm_speeds_update(struct mpm_simulation *simulation)
{
    const bool close = 2.0 * simulation->particle_speed > simulation->wave_speed;
    simulation->wave_speed = fastest_wave(&simulation->state);
    simulation->diffusivity = simulation->state.transport.diffusivity;
    simulation->film = simulation->state.transport.film;
    if (close || simulation->step % STEPS_BETWEEN_LOOKS == 0)
        simulation->particle_speed = fastest_particle(simulation, simulation->wave_speed);
}

/* Waves run through a cell of the grid relative to the material, which the grid moves with in a
 * step: their speed bounds the step. Particles must not outrun a cell: so does theirs. */
static double crossing_time(const struct mpm_simulation *simulation)
{
    return fmin(simulation->state.grid.cell[0], simulation->state.grid.cell[1]) /
           fmax(simulation->wave_speed, simulation->particle_speed);
}

/* The bound of explicit conduction, which is that of the step too. */
static double conduction_time(const struct mpm_simulation *simulation)
{
    return mpm_transport_stable_step(&simulation->state.grid, simulation->diffusivity,
                                     simulation->film);
}

static double longest_step(const struct mpm_simulation *simulation)
{
    const double parts = (double)simulation->scene->transport_substeps;
    return fmin(crossing_time(simulation), parts * conduction_time(simulation));
}

/* The scene's, or the Courant number times the bound. */
static double whole_step(const struct mpm_simulation *simulation)
{
    const struct mpm_scene *const scene = simulation->scene;
    return scene->step > 0.0 ? scene->step : scene->courant * longest_step(simulation);
}

double mpm_time_step_next(const struct mpm_simulation *simulation, double limit, bool *lands)
{
    const double step = whole_step(simulation);
    const double rest = limit - simulation->state.time;
    *lands = rest <= step * (1.0 + LANDING_SLACK);
    if (*lands)
        return rest;
    return rest < step * (2.0 - LANDING_SLACK) ? 0.5 * rest : step;
}

double mpm_time_step_courant(const struct mpm_simulation *simulation)
{
    return whole_step(simulation) /
           (simulation->scene->at_rest ? conduction_time(simulation) : crossing_time(simulation));
}

/* A clock of 53 binary digits does not go on by less than 2^-53 of the time that it shows. */
static const double STEPS_MAX = 9007199254740992.0;

/* Can time.end be reached in steps like the first one? */
static enum mpm_status check_count(const struct mpm_simulation *simulation, struct mpm_error *error)
{
    const struct mpm_scene *const scene = simulation->scene;
    const double step = whole_step(simulation);
    if (scene->at_rest && !isfinite(step))
        return mpm_scene_error(error, scene, scene->line_time, "time",
                               "nothing conducts, and no time step follows from it; allowed: a "
                               "conductivity above 0, or time.step");
    if (!(step > 0.0) || !isfinite(step))
        return mpm_scene_error(error, scene, scene->line_time, "time",
                               "the first time step is %g, with waves of speed %g and particles "
                               "of up to %g; allowed: finite and above 0",
                               step, simulation->wave_speed, simulation->particle_speed);
    if (scene->steps > 0 || scene->end / STEPS_MAX <= step)
        return MPM_OK;
    return mpm_scene_error(error, scene, scene->line_time, "time.end",
                           "%g takes more than %.3g time steps of %g, and the clock cannot count "
                           "them; allowed: up to %g, or a number of steps, time.steps",
                           scene->end, STEPS_MAX, step, STEPS_MAX * step);
}

/* A fixed step beyond a bound, which is `of` what has the value. */
static enum mpm_status refuse_step(const struct mpm_simulation *simulation, double limit,
                                   const char *of, double value, struct mpm_error *error)
{
    const struct mpm_scene *const scene = simulation->scene;
    return mpm_scene_error(error, scene, scene->line_time, "time.step",
                           "%g is beyond the stability limit; allowed: up to %g (%s %g), or more "
                           "with time.allow_unstable: true",
                           scene->step, limit, of, value);
}

enum mpm_status mpm_time_step_check(const struct mpm_simulation *simulation,
                                    struct mpm_error *error)
{
    const struct mpm_scene *const scene = simulation->scene;
    const double crossing = crossing_time(simulation);
    const double conduction = (double)scene->transport_substeps * conduction_time(simulation);
    const bool particles = simulation->particle_speed > simulation->wave_speed;
    MPM_TRY(check_count(simulation, error));
    if (scene->step <= fmin(crossing, conduction) || scene->allow_unstable)
        return MPM_OK;
    if (conduction < crossing)
        return refuse_step(
            simulation, conduction,
            scene->transport_substeps == 1
                ? "1 / (2 kappa (1/h_x^2 + 1/h_y^2)) without fluxes on edges, diffusivity kappa"
                : "transport.substeps / (2 kappa (1/h_x^2 + 1/h_y^2)) without fluxes on edges, "
                  "diffusivity kappa",
            simulation->diffusivity, error);
    return refuse_step(simulation, crossing,
                       particles ? "cell size over the speed of particles,"
                                 : "cell size over wave speed",
                       particles ? simulation->particle_speed : simulation->wave_speed, error);
}

struct mpm_lags mpm_scene_lags(const struct mpm_scene *scene)
{
    return (struct mpm_lags){
        .position = scene->position_update == MPM_MIDPOINT ? 0.5 : 0.0,
        .velocity = 0.5,
        .deformation = mpm_stress_order(scene->stress_update)->before,
    };
}
