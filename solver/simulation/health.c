/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/transfer/law_state.h"
#include "method/transport/transport_edges.h"
#include "simulation/simulation.h"

#include <stdarg.h>
#include <stdio.h>

/* A wave speed grown by this factor has taken the time step with it: the run would go on
 * for ever. No solid gets there; J would be 1e-12. */
static const double RUNAWAY_WAVE = 1e4;

/* NULL: there is no such particle. */
static const struct mpm_body_spec *body_of(const struct mpm_simulation *simulation, uint32_t id)
{
    const struct mpm_particles *const particles = &simulation->state.particles;
    for (size_t p = 0; p < particles->count; p++)
        if (particles->id[p] == id)
            return &simulation->scene->bodies[particles->body[p]];
    return NULL;
}

const char *mpm_body_of_particle(const struct mpm_simulation *simulation, uint32_t id)
{
    const struct mpm_body_spec *const body = body_of(simulation, id);
    return body == NULL ? "?" : body->name;
}

static enum mpm_cause cause_of(enum mpm_failure_kind kind)
{
    static const enum mpm_cause causes[] = {
        [MPM_NO_FAILURE] = MPM_CAUSE_NONE,
        [MPM_INVERTED] = MPM_CAUSE_INVERTED,
        [MPM_NOT_FINITE] = MPM_CAUSE_NOT_FINITE,
        [MPM_LEFT_GRID] = MPM_CAUSE_LEFT_GRID,
        [MPM_PAST_AXIS] = MPM_CAUSE_PASSED_AXIS,
        [MPM_OUTRAN_CELL] = MPM_CAUSE_OUTRAN_CELL,
        [MPM_DOMAIN_TOO_BIG] = MPM_CAUSE_DOMAIN,
        [MPM_LOAD_NOT_FINITE] = MPM_CAUSE_LOAD,
        [MPM_UNIFORM_LOAD_NOT_FINITE] = MPM_CAUSE_LOAD,
        [MPM_RATE_REFUSED] = MPM_CAUSE_DAMPING,
        [MPM_TRACTION_NOT_FINITE] = MPM_CAUSE_LOAD,
        [MPM_TWO_CRACKS] = MPM_CAUSE_CRACK,
        [MPM_USER_FORCE_NOT_FINITE] = MPM_CAUSE_LOAD,
        [MPM_SOURCE_NOT_FINITE] = MPM_CAUSE_LOAD,
        [MPM_BELOW_ZERO] = MPM_CAUSE_TEMPERATURE,
        [MPM_CAPACITY_NEGATIVE] = MPM_CAUSE_TEMPERATURE,
        [MPM_TEMPERATURE_NEGATIVE] = MPM_CAUSE_TEMPERATURE,
        [MPM_NO_TEMPERATURE] = MPM_CAUSE_TEMPERATURE,
        [MPM_OUTSIDE_TABLE] = MPM_CAUSE_TEMPERATURE,
        [MPM_NO_RETURN] = MPM_CAUSE_PLASTIC,
        [MPM_NO_THICKNESS] = MPM_CAUSE_PLASTIC,
        [MPM_NO_STATE] = MPM_CAUSE_STATE,
        [MPM_STRAIN_TOO_LARGE] = MPM_CAUSE_PLASTIC,
        [MPM_COLD] = MPM_CAUSE_TEMPERATURE,
    };
    return causes[kind];
}

enum { TEXT_SIZE = 256 };

__attribute__((format(printf, 2, 3))) static const char *print(char text[TEXT_SIZE],
                                                               const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    (void)vsnprintf(text, TEXT_SIZE, format, arguments);
    va_end(arguments);
    return text;
}

/* Why the particle's scalars or its law have no next state. */
static const char *describe_update(const struct mpm_failure *failure, char text[TEXT_SIZE])
{
    if (failure->kind == MPM_SOURCE_NOT_FINITE)
        return print(text, "has a source in transport that is not finite: %g", failure->value);
    if (failure->kind == MPM_BELOW_ZERO)
        return print(text, "radiates %s temperature of %g; allowed: absolute, at least 0",
                     failure->axis == MPM_RADIATES_TO ? "to an ambient" : "at a", failure->value);
    if (failure->kind == MPM_CAPACITY_NEGATIVE)
        return print(text,
                     "is at a temperature of %g, at which thermal_expansion makes the heat "
                     "capacity at constant volume negative; allowed: 9 alpha^2 K T below "
                     "density times heat_capacity",
                     failure->value);
    if (failure->kind == MPM_TEMPERATURE_NEGATIVE)
        return print(text,
                     "is at a temperature of %g; allowed with transport.temperature.heating and "
                     "for gases: absolute, at least 0",
                     failure->value);
    if (failure->kind == MPM_NO_RETURN)
        return print(text,
                     "has an equivalent trial stress of %g, from which no plastic strain "
                     "leads back to yield; allowed: finite, of a body that is not stretched beyond "
                     "what numbers hold",
                     failure->value);
    if (failure->kind == MPM_STRAIN_TOO_LARGE)
        return print(text,
                     "has a component of F of size %g, beside which its elastic strain is no "
                     "number; allowed: stretches whose squares numbers hold with it",
                     failure->value);
    if (failure->kind == MPM_COLD)
        return print(text,
                     "is at a temperature of %g by its equation of state, on which its strength "
                     "depends; allowed: absolute, at least 0",
                     failure->value);
    if (failure->kind == MPM_NO_THICKNESS)
        return print(text,
                     "has a stress of %g across the plane, which no thickness takes away; allowed "
                     "in plane stress: 0",
                     failure->value);
    return print(text, "has no temperature that fits its stress after the step, from %g before",
                 failure->value);
}

static const char *describe_outside(const struct mpm_simulation *simulation,
                                    const struct mpm_failure *failure, char text[TEXT_SIZE])
{
    const struct mpm_body_spec *const body = body_of(simulation, failure->particle);
    if (body == NULL)
        return print(text, "is at a value of %g, outside of a table", failure->value);
    const int scalar = failure->axis / MPM_TABLE_COUNT, which = failure->axis % MPM_TABLE_COUNT;
    const struct mpm_material_spec *const material = &simulation->scene->materials[body->material];
    const struct mpm_property *const table = &material->conduction[scalar].tables[which];
    return print(text, "is at a %s of %g; allowed: %g to %g, the range of the %s of '%s'",
                 mpm_scalar_rows[scalar].name, failure->value, table->points[0][0],
                 table->points[table->count - 1][0], mpm_scalar_rows[scalar].tables[which],
                 material->name);
}

static const char *describe_no_state(const struct mpm_simulation *simulation,
                                     const struct mpm_failure *failure, char text[TEXT_SIZE])
{
    const struct mpm_particles *const particles = &simulation->state.particles;
    double least = 0.0;
    for (size_t p = 0; p < particles->count; p++)
        if (particles->id[p] == failure->particle) {
            const struct mpm_material *const material =
                &simulation->state.bodies[particles->body[p]].material;
            least = material->law->least_volume(material);
        }
    if (failure->value > least)
        return print(text,
                     "has J = %g, where its equation of state has no energy that fits, or sound no "
                     "speed; allowed: shorter steps, less tension",
                     failure->value);
    return print(text, "has J = %g; allowed by its equation of state: above %g", failure->value,
                 least);
}

static const char *describe_rate(const struct mpm_simulation *simulation,
                                 const struct mpm_failure *failure, char text[TEXT_SIZE])
{
    return print(text,
                 "has damping.%s = %g; allowed: at least 0 and below %g, 1 over the time step",
                 failure->axis == 0 ? "particle" : "grid", failure->value,
                 1.0 / simulation->state.time_step);
}

/* What is wrong with the particle. */
static const char *describe(const struct mpm_simulation *simulation,
                            const struct mpm_failure *failure, char text[TEXT_SIZE])
{
    const int axis = failure->kind == MPM_OUTSIDE_TABLE ? 0 : failure->axis;
    const char *const name = mpm_scene_coordinates(simulation->scene)[axis];
    const struct mpm_grid *const grid = &simulation->state.grid;
    const double low = grid->origin[axis];
    const double high = low + (double)grid->cells[axis] * grid->cell[axis];
    switch (failure->kind) {
    case MPM_INVERTED:
        return print(text, "has det F = %g; allowed: above 0", failure->value);
    case MPM_NOT_FINITE:
        return print(text, "has a velocity, position or stress that is not finite: %g",
                     failure->value);
    case MPM_LEFT_GRID:
        return print(text, "is at %s = %g; allowed: %g to %g", name, failure->value, low, high);
    case MPM_PAST_AXIS:
        return print(text, "is at r = %g; allowed: above 0", failure->value);
    case MPM_OUTRAN_CELL:
        return print(text, "moved %g cells along %s in one step; allowed: up to 1", failure->value,
                     name);
    case MPM_DOMAIN_TOO_BIG:
        return print(text,
                     "has a domain that reaches %g cells along %s, beyond the ghost rows of "
                     "the grid",
                     failure->value, name);
    case MPM_LOAD_NOT_FINITE:
        return print(text, "has a body force that is not finite: loads.body_force.%d = %g",
                     failure->axis, failure->value);
    case MPM_TRACTION_NOT_FINITE:
        return print(text, "bears a load that is not finite: %s.value.%d = %g",
                     simulation->scene->edge_loads[failure->load].key, failure->axis,
                     failure->value);
    case MPM_TWO_CRACKS:
        return print(text, "reaches a node past two cracks; allowed: past one");
    case MPM_USER_FORCE_NOT_FINITE:
        return print(text, "is given a body force that is not finite: %g along %s", failure->value,
                     name);
    case MPM_SOURCE_NOT_FINITE:
    case MPM_BELOW_ZERO:
    case MPM_CAPACITY_NEGATIVE:
    case MPM_TEMPERATURE_NEGATIVE:
    case MPM_NO_TEMPERATURE:
    case MPM_NO_RETURN:
    case MPM_NO_THICKNESS:
    case MPM_STRAIN_TOO_LARGE:
    case MPM_COLD:
        return describe_update(failure, text);
    case MPM_NO_STATE:
        return describe_no_state(simulation, failure, text);
    case MPM_OUTSIDE_TABLE:
        return describe_outside(simulation, failure, text);
    case MPM_RATE_REFUSED:
        return describe_rate(simulation, failure, text);
    case MPM_UNIFORM_LOAD_NOT_FINITE:
    case MPM_NO_FAILURE:
        break;
    }
    return "is sound";
}

enum mpm_status mpm_health_refuse_start(const struct mpm_simulation *simulation,
                                        struct mpm_error *error)
{
    const struct mpm_failure *const failure = &simulation->state.failure;
    char text[TEXT_SIZE];
    return mpm_error_set(error, MPM_BAD_INPUT, "start: particle %u (body '%s') %s",
                         failure->particle, mpm_body_of_particle(simulation, failure->particle),
                         describe(simulation, failure, text));
}

/* The particle whose waves are the fastest now. */
static size_t find_fastest(const struct mpm_state *state)
{
    size_t fastest = 0;
    double largest = 0.0;
    for (size_t p = 0; p < state->particles.count; p++) {
        double stress[MPM_SYMMETRIC_SIZE], square;
        mpm_particle_find_stress(state, p, stress, &square);
        if (square > largest) {
            largest = square;
            fastest = p;
        }
    }
    return fastest;
}

/* An equation of state with a pole comes near it in steps that get shorter and shorter. */
static enum mpm_status refuse_waves(const struct mpm_simulation *simulation,
                                    struct mpm_error *error)
{
    const struct mpm_state *const state = &simulation->state;
    const size_t p = find_fastest(state);
    const struct mpm_material *const material = &state->bodies[state->particles.body[p]].material;
    const double pole =
        material->law->least_volume != NULL ? material->law->least_volume(material) : 0.0;
    double f[MPM_GRADIENT_SIZE];
    mpm_particle_deformation(&state->particles, p, f);
    const double j = mpm_determinant(f), allowed = RUNAWAY_WAVE * simulation->wave_speed_start;
    const uint32_t id = state->particles.id[p];
    const char *const body = mpm_body_of_particle(simulation, id);
    if (pole > 0.0)
        return mpm_error_fail(error, MPM_CAUSE_STATE,
                              "particle %u (body '%s') has J = %g, before the pole of its equation "
                              "of state at J = %g, and a wave speed of %g; allowed: up to %g",
                              id, body, j, pole, simulation->wave_speed, allowed);
    return mpm_error_fail(error, MPM_CAUSE_WAVES,
                          "wave speed %g of particle %u (body '%s') with det F = %g; allowed: up "
                          "to %g, %g times that of the start",
                          simulation->wave_speed, id, body, j, allowed, RUNAWAY_WAVE);
}

enum mpm_status mpm_health_check(const struct mpm_simulation *simulation, struct mpm_error *error)
{
    const struct mpm_failure *const failure = &simulation->state.failure;
    const enum mpm_cause cause = cause_of(failure->kind);
    char text[TEXT_SIZE];
    if (failure->kind == MPM_UNIFORM_LOAD_NOT_FINITE)
        return mpm_error_fail(error, cause, "the body force loads.body_force.%d = %g",
                              failure->axis, failure->value);
    if (failure->kind != MPM_NO_FAILURE)
        return mpm_error_fail(error, cause, "particle %u (body '%s') %s", failure->particle,
                              mpm_body_of_particle(simulation, failure->particle),
                              describe(simulation, failure, text));
    return simulation->wave_speed <= RUNAWAY_WAVE * simulation->wave_speed_start
               ? MPM_OK
               : refuse_waves(simulation, error);
}
