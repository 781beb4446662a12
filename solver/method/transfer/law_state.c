/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/transfer/law_state.h"

#include "base/exponential.h"
#include "method/transfer/extent.h"
#include "method/transfer/stress_work.h"
#include "model/laws/plane_stress.h"
#include "mpm_transport.h"

#include <math.h>
#include <string.h>

double mpm_free_strain(const struct mpm_material_spec *material,
                       const double value[MPM_SCALAR_COUNT])
{
    double sum = 0.0;
    for (int k = 0; k < MPM_SCALAR_COUNT; k++)
        if (material->expansion[k].coefficient != 0.0)
            sum += material->expansion[k].coefficient *
                   (value[k] - material->expansion[k].stress_free);
    return sum;
}

static void load_variables(const struct mpm_particles *particles, size_t p,
                           const struct mpm_material_law *law, double variables[MPM_LAW_STATES])
{
    for (size_t k = 0; k < law->variable_count; k++)
        variables[k] = *mpm_particle_law_state(particles, p, k);
}

/* ------------------------------------------------------------ one evaluation */

/* What a law is evaluated at: F with the free strain and the temperature; 0 and NaN if none. */
struct point {
    double f[MPM_GRADIENT_SIZE];
    double free_strain, temperature;
};

/* One evaluation: from `old` to `now`, without change of the particle. */
struct evaluation {
    const struct mpm_material *material;
    double duration, heat_capacity;
    double heating; /* part of plastic work that becomes heat */
    bool plane_stress;
    struct point old, now;
    double old_stress[MPM_SYMMETRIC_SIZE];
    double stress[MPM_SYMMETRIC_SIZE], wave_speed_squared;
    double variables[MPM_LAW_STATES];
    double work;                           /* of the stress, per mass */
    double viscous_pressure, viscous_work; /* q J / rho_0, which `stress` is without; per mass */
};

/* F_e */
static void elastic_part(const struct point *point, double f[MPM_GRADIENT_SIZE])
{
    const double scale = point->free_strain == 0.0 ? 1.0 : exp(-point->free_strain);
    for (int k = 0; k < MPM_GRADIENT_SIZE; k++)
        f[k] = scale * point->f[k];
}

/* From F to F as the law has it. */
static struct mpm_law_step step_of(const struct evaluation *at, const double *old_f,
                                   const double *f)
{
    return (struct mpm_law_step){.old_f = old_f,
                                 .f = f,
                                 .duration = at->duration,
                                 .temperature = at->now.temperature,
                                 .heat_capacity = at->heat_capacity,
                                 .heat = at->viscous_work,
                                 .start_temperature = at->old.temperature};
}

/* F_zz of a point in plane stress, from that of its F_e */
static double whole_thickness(const struct point *point, double elastic)
{
    return point->free_strain == 0.0 ? elastic : elastic * exp(point->free_strain);
}

/* False: the law of the path has no end of the step; without an F_zz, that of now.f is NaN. */
static bool update_path(const struct mpm_particles *particles, size_t p, struct evaluation *at,
                        const struct mpm_law_step *step, double f[MPM_GRADIENT_SIZE])
{
    const struct mpm_material_law *const law = at->material->law;
    load_variables(particles, p, law, at->variables);
    if (!at->plane_stress)
        return law->update(at->material, step, at->variables, at->stress, &at->wave_speed_squared);
    double old[MPM_LAW_STATES];
    memcpy(old, at->variables, sizeof old);
    const bool found = mpm_plane_stress_update(at->material, step, f, old, at->variables,
                                               at->stress, &at->wave_speed_squared);
    at->now.f[MPM_ZZ] = whole_thickness(&at->now, f[MPM_ZZ]);
    return found;
}

static void update_elastic(struct evaluation *at, double f[MPM_GRADIENT_SIZE])
{
    const struct mpm_material_law *const law = at->material->law;
    if (at->plane_stress) {
        f[MPM_ZZ] = law->thickness_stretch(at->material, f);
        at->now.f[MPM_ZZ] = whole_thickness(&at->now, f[MPM_ZZ]);
    }
    law->stress(at->material, f, at->stress, &at->wave_speed_squared);
}

/* False: the law has no end of the step; `at->stress` is then that of its trial state. */
static bool evaluate(const struct mpm_particles *particles, size_t p, struct evaluation *at)
{
    const struct mpm_material_law *const law = at->material->law;
    double old_f[MPM_GRADIENT_SIZE], f[MPM_GRADIENT_SIZE];
    elastic_part(&at->old, old_f);
    elastic_part(&at->now, f);
    const struct mpm_law_step step = step_of(at, old_f, f);
    if (law->update == NULL)
        update_elastic(at, f);
    else if (!update_path(particles, p, at, &step, f))
        return false;
    at->work = law->energy == NULL || law->reads_temperature
                   ? mpm_stress_work(at->old_stress, at->stress, &step)
                   : 0.0;
    return true;
}

/* The same evaluation with the work of viscosity as heat. */
static bool evaluate_heated(const struct mpm_particles *particles, size_t p, struct evaluation *at)
{
    const struct mpm_material_law *const law = at->material->law;
    if (law->reheat == NULL)
        return evaluate(particles, p, at);
    double old[MPM_LAW_STATES];
    const struct mpm_law_step step = step_of(at, at->old.f, at->now.f);
    load_variables(particles, p, law, old);
    return law->reheat(at->material, &step, old, at->variables, at->stress,
                       &at->wave_speed_squared);
}

static void add_pressure(double pressure, double stress[MPM_SYMMETRIC_SIZE])
{
    stress[MPM_SYM_XX] -= pressure;
    stress[MPM_SYM_YY] -= pressure;
    stress[MPM_SYM_ZZ] -= pressure;
}

static struct evaluation at_hand(const struct mpm_state *state, size_t p)
{
    const struct mpm_particles *const particles = &state->particles;
    struct evaluation at = {
        .material = &state->bodies[particles->body[p]].material,
        .heat_capacity = (double)NAN,
        .plane_stress = false,
    };
    if (state->scene->scalars[MPM_TEMPERATURE].heats) {
        at.heat_capacity =
            state->bodies[particles->body[p]].given->conduction[MPM_TEMPERATURE].capacity;
        at.heating = mpm_material_plastic_heating(at.material->law, at.material->parameter);
    }
    mpm_particle_deformation(particles, p, at.old.f);
    at.old.free_strain = particles->free_strain == NULL ? 0.0 : particles->free_strain[p];
    at.old.temperature =
        particles->law_temperature == NULL ? (double)NAN : particles->law_temperature[p];
    for (int k = 0; k < MPM_SYMMETRIC_SIZE; k++)
        at.old_stress[k] = particles->stress[k][p];
    if (particles->viscous[0] != NULL)
        at.viscous_pressure = particles->viscous[0][p];
    add_pressure(-at.viscous_pressure, at.old_stress);
    at.now = at.old;
    return at;
}

static double trace(const double stress[MPM_SYMMETRIC_SIZE])
{
    return stress[MPM_SYM_XX] + stress[MPM_SYM_YY] + stress[MPM_SYM_ZZ];
}

/* sqrt(3/2 s : s) of the deviator s */
static double equivalent(const double stress[MPM_SYMMETRIC_SIZE])
{
    const double mean = trace(stress) / 3.0, xy = stress[MPM_SYM_XY];
    const double xx = stress[MPM_SYM_XX] - mean, yy = stress[MPM_SYM_YY] - mean;
    const double zz = stress[MPM_SYM_ZZ] - mean;
    return sqrt(1.5 * (xx * xx + yy * yy + zz * zz + 2.0 * xy * xy));
}

/* ------------------------------------------------------------ heat of deformation */

enum { HEAT_ITERATIONS = 1000 };
static const double HEAT_ROUND_OFF = 1e-12;

/* What plastic work between the particle's state and that at hand heats by. */
static double plastic_rise(const struct mpm_particles *particles, size_t p,
                           const struct evaluation *at)
{
    const struct mpm_material_law *const law = at->material->law;
    double old[MPM_LAW_STATES];
    if (at->heating == 0.0)
        return 0.0;
    load_variables(particles, p, law, old);
    return at->heating / at->heat_capacity *
           (law->dissipation(at->material, at->variables) - law->dissipation(at->material, old));
}

/* The temperature that deformation alone leads to from `start`, given the stress at hand. */
static double adiabatic(const struct mpm_particles *particles, size_t p,
                        const struct evaluation *at, double alpha, double start)
{
    const struct mpm_material_law *const law = at->material->law;
    if (law->adiabatic != NULL) {
        const struct mpm_law_step step = {at->old.f,         at->now.f, at->duration, start,
                                          at->heat_capacity, 0.0,       start};
        return law->adiabatic(at->material, &step);
    }
    return start * exp(-alpha / at->heat_capacity * (trace(at->stress) - trace(at->old_stress))) +
           plastic_rise(particles, p, at);
}

/* Finds temperature and stress together; false: there is no such temperature. Changes shrink by a
 * constant factor until they are round-off of the stress. */
static bool heat_up(const struct mpm_particles *particles, size_t p, double alpha,
                    struct evaluation *at)
{
    const double start = at->now.temperature, strain = at->now.free_strain;
    double last = HUGE_VAL;
    for (int k = 0; k < HEAT_ITERATIONS; k++) {
        const double next = adiabatic(particles, p, at, alpha, start);
        const double change = fabs(next - at->now.temperature);
        if (!isfinite(next))
            return false;
        at->now.temperature = next;
        at->now.free_strain = strain + alpha * (next - start);
        if (!evaluate(particles, p, at))
            return false;
        if (change == 0.0 || (change >= last && change <= HEAT_ROUND_OFF * fabs(next)))
            return true;
        last = change;
    }
    return false;
}

/* c_v / c_p of small strains at the temperature T. */
static double capacity_ratio(const struct mpm_material *material, double alpha, double capacity,
                             double temperature)
{
    return 1.0 - 9.0 * alpha * alpha * material->bulk * temperature / capacity;
}

/* What waves without flow of heat are slower by, at least, squared: K_s = K c_p / c_v. */
static double stiffening(const struct mpm_state *state, size_t p, const struct evaluation *at)
{
    const double alpha =
        state->bodies[state->particles.body[p]].given->expansion[MPM_TEMPERATURE].coefficient;
    return alpha == 0.0 || isnan(at->heat_capacity)
               ? 1.0
               : capacity_ratio(at->material, alpha, at->heat_capacity, at->now.temperature);
}

/* What is wrong with a temperature, if anything. */
static enum mpm_failure_kind judge_temperature(const struct mpm_state *state, size_t p,
                                               const struct evaluation *at)
{
    const double alpha =
        state->bodies[state->particles.body[p]].given->expansion[MPM_TEMPERATURE].coefficient;
    const double temperature = at->now.temperature;
    const bool heats = alpha != 0.0 && !isnan(at->heat_capacity);
    if ((heats || at->material->law->reads_temperature) && !(temperature >= 0.0))
        return MPM_TEMPERATURE_NEGATIVE;
    if (heats && !(capacity_ratio(at->material, alpha, at->heat_capacity, temperature) > 0.0))
        return MPM_CAPACITY_NEGATIVE;
    return MPM_NO_FAILURE;
}

void mpm_strip_judge_tables(struct mpm_strip *strip, enum mpm_scalar which,
                            const struct mpm_property *tables, uint32_t id, double value)
{
    for (int k = 0; k < MPM_TABLE_COUNT; k++)
        if (!mpm_property_covers(&tables[k], value))
            mpm_strip_record(strip, MPM_OUTSIDE_TABLE, id, mpm_table_place(which, k), value);
}

static bool add_heat(const struct mpm_state *state, size_t p, struct evaluation *at,
                     struct mpm_strip *strip)
{
    const struct mpm_particles *const particles = &state->particles;
    const struct mpm_material_spec *const given = state->bodies[particles->body[p]].given;
    const double alpha = given->expansion[MPM_TEMPERATURE].coefficient;
    const double start = at->now.temperature;
    if (alpha == 0.0 && at->material->law->adiabatic == NULL) {
        at->now.temperature += plastic_rise(particles, p, at);
    } else if (!heat_up(particles, p, alpha, at)) {
        mpm_strip_record(strip, MPM_NO_TEMPERATURE, particles->id[p], 0, start);
        return false;
    }
    const double change = at->now.temperature - start;
    particles->temperature[p] += change;
    mpm_strip_judge_tables(strip, MPM_TEMPERATURE, given->conduction[MPM_TEMPERATURE].tables,
                           particles->id[p], particles->temperature[p]);
    strip->deformation_heat += particles->mass[p] * at->heat_capacity * change;
    return true;
}

/* ------------------------------------------------------------ artificial viscosity */

static const struct mpm_viscosity *viscosity_of(const struct mpm_state *state, size_t p)
{
    return &state->bodies[state->particles.body[p]].given->viscosity;
}

static double cell_size(const struct mpm_state *state)
{
    return fmin(state->grid.cell[0], state->grid.cell[1]);
}

/* viscosity.h, with the wave speed of the step's end without its heat. An equation of state then
 * has the step again, with the heat. */
static bool add_viscosity(const struct mpm_state *state, size_t p, struct evaluation *at)
{
    const struct mpm_particles *const particles = &state->particles;
    const struct mpm_viscosity *const viscosity = viscosity_of(state, p);
    const double strain = mpm_logarithm(mpm_determinant(at->now.f) / mpm_determinant(at->old.f));
    const double rate = strain / at->duration, h = cell_size(state);
    at->viscous_pressure = mpm_viscous_pressure(viscosity, h, at->wave_speed_squared, rate);
    at->viscous_work = -at->viscous_pressure * strain;
    if (at->viscous_work > 0.0 && at->material->law->keeps_heat &&
        !evaluate_heated(particles, p, at))
        return false;
    at->wave_speed_squared = mpm_viscous_wave_squared(viscosity, h, at->wave_speed_squared, rate);
    particles->viscous[0][p] = at->viscous_pressure;
    particles->viscous[1][p] += at->viscous_work;
    return true;
}

/* ---------------------------------------------------------------- a step's part */

/* The free strain and temperature that transport leads to by the end of this part. */
static void take_scalars(const struct mpm_state *state, size_t p, double part,
                         struct evaluation *at)
{
    const struct mpm_particles *const particles = &state->particles;
    if (!state->transport.couples)
        return;
    if (particles->free_strain != NULL)
        at->now.free_strain += part * particles->free_strain_step[p];
    if (particles->law_temperature != NULL)
        at->now.temperature += part * particles->law_temperature_step[p];
}

static void keep_scalars(const struct mpm_particles *particles, size_t p,
                         const struct evaluation *at, struct mpm_strip *strip)
{
    const double gained = at->material->law->reads_temperature
                              ? -at->work
                              : -0.5 * (trace(at->old_stress) + trace(at->stress)) *
                                    (at->now.free_strain - at->old.free_strain);
    strip->expansion_work += particles->mass[p] * gained;
    if (particles->free_strain != NULL)
        particles->free_strain[p] = at->now.free_strain;
    if (particles->law_temperature != NULL)
        particles->law_temperature[p] = at->now.temperature;
}

static void keep_variables(const struct mpm_particles *particles, size_t p,
                           const struct evaluation *at)
{
    const struct mpm_material_law *const law = at->material->law;
    for (size_t k = 0; k < law->variable_count; k++)
        *mpm_particle_law_state(particles, p, k) = at->variables[k];
    if (law->energy == NULL)
        *mpm_particle_law_state(particles, p, law->variable_count) += at->work;
}

/* What the law lacks of the step, from the particle's state. */
static enum mpm_law_fault fault_of(const struct mpm_particles *particles, size_t p,
                                   const struct evaluation *at)
{
    const struct mpm_material_law *const law = at->material->law;
    if (law->fault_of == NULL)
        return law->keeps_heat ? MPM_LAW_NO_STATE : MPM_LAW_NO_RETURN;
    double old_f[MPM_GRADIENT_SIZE], f[MPM_GRADIENT_SIZE], variables[MPM_LAW_STATES];
    elastic_part(&at->old, old_f);
    elastic_part(&at->now, f);
    load_variables(particles, p, law, variables);
    const struct mpm_law_step step = step_of(at, old_f, f);
    return law->fault_of(at->material, &step, variables);
}

/* No return from the trial stress at hand; where that is no number F is what is too large. */
static void record_no_return(const struct evaluation *at, uint32_t id, struct mpm_strip *strip)
{
    const double trial = at->material->density * equivalent(at->stress);
    double largest = 0.0;
    for (int k = 0; k < MPM_GRADIENT_SIZE; k++)
        largest = fmax(largest, fabs(at->now.f[k]));
    if (isfinite(trial))
        mpm_strip_record(strip, MPM_NO_RETURN, id, 0, trial);
    else
        mpm_strip_record(strip, MPM_STRAIN_TOO_LARGE, id, 0, largest);
}

/* The law has no end of the step. */
static void record_no_end(const struct mpm_state *state, size_t p, const struct evaluation *at,
                          struct mpm_strip *strip)
{
    const uint32_t id = state->particles.id[p];
    if (isnan(at->now.f[MPM_ZZ])) {
        mpm_strip_record(strip, MPM_NO_THICKNESS, id, 0,
                         at->material->density * at->stress[MPM_SYM_ZZ]);
        return;
    }
    switch (fault_of(&state->particles, p, at)) {
    case MPM_LAW_COLD:
        mpm_strip_record(strip, MPM_COLD, id, 0, mpm_particle_state_temperature(state, p));
        break;
    case MPM_LAW_NO_STATE:
        mpm_strip_record(strip, MPM_NO_STATE, id, 0, mpm_determinant(at->now.f));
        break;
    case MPM_LAW_NO_RETURN:
        record_no_return(at, id, strip);
        break;
    }
}

bool mpm_particle_update_law(const struct mpm_state *state, size_t p, double part,
                             double f[MPM_GRADIENT_SIZE], struct mpm_strip *strip,
                             double stress[MPM_SYMMETRIC_SIZE], double *wave_speed_squared)
{
    const struct mpm_particles *const particles = &state->particles;
    const bool heats = state->scene->scalars[MPM_TEMPERATURE].heats;
    struct evaluation at = at_hand(state, p);
    at.duration = part * state->time_step;
    at.plane_stress = state->scene->geometry == MPM_PLANE_STRESS;
    memcpy(at.now.f, f, sizeof at.now.f);
    take_scalars(state, p, part, &at);
    const enum mpm_failure_kind fault = judge_temperature(state, p, &at);
    if (fault != MPM_NO_FAILURE) {
        mpm_strip_record(strip, fault, particles->id[p], 0, at.now.temperature);
        return false;
    }
    if (!evaluate(particles, p, &at) ||
        (viscosity_of(state, p)->given && !add_viscosity(state, p, &at))) {
        record_no_end(state, p, &at, strip);
        return false;
    }
    if (heats && !add_heat(state, p, &at, strip))
        return false;
    keep_variables(particles, p, &at);
    keep_scalars(particles, p, &at, strip);
    f[MPM_ZZ] = at.now.f[MPM_ZZ];
    add_pressure(at.viscous_pressure, at.stress);
    memcpy(stress, at.stress, sizeof at.stress);
    *wave_speed_squared = at.wave_speed_squared / stiffening(state, p, &at);
    return true;
}

/* ---------------------------------------------------------------- without a step */

/* Has the particle nothing that a law of F alone does not know? */
static bool is_plain(const struct mpm_particles *particles)
{
    return particles->law_state == NULL && particles->free_strain == NULL &&
           particles->law_temperature == NULL && particles->viscous[0] == NULL;
}

void mpm_particle_find_stress(const struct mpm_state *state, size_t p,
                              double stress[MPM_SYMMETRIC_SIZE], double *wave_speed_squared)
{
    const struct mpm_particles *const particles = &state->particles;
    const struct mpm_material *const material = &state->bodies[particles->body[p]].material;
    if (is_plain(particles)) {
        double f[MPM_GRADIENT_SIZE];
        mpm_particle_deformation(particles, p, f);
        material->law->stress(material, f, stress, wave_speed_squared);
        return;
    }
    struct evaluation at = at_hand(state, p);
    (void)evaluate(particles, p, &at); /* without a step it has one */
    add_pressure(at.viscous_pressure, at.stress);
    memcpy(stress, at.stress, sizeof at.stress);
    *wave_speed_squared = at.wave_speed_squared / stiffening(state, p, &at);
    if (viscosity_of(state, p)->given)
        *wave_speed_squared = mpm_viscous_wave_squared(viscosity_of(state, p), cell_size(state),
                                                       *wave_speed_squared, 0.0);
}

double mpm_particle_thickness(const struct mpm_state *state, size_t p,
                              const double f[MPM_GRADIENT_SIZE])
{
    struct evaluation at = at_hand(state, p);
    memcpy(at.now.f, f, sizeof at.now.f);
    at.plane_stress = true;
    (void)evaluate(&state->particles, p, &at); /* without a step tau_zz is linear in ln F_zz */
    return at.now.f[MPM_ZZ];
}

enum mpm_failure_kind mpm_particle_judge_temperature(const struct mpm_state *state, size_t p,
                                                     double *temperature)
{
    const struct evaluation at = at_hand(state, p);
    *temperature = at.now.temperature;
    return judge_temperature(state, p, &at);
}
