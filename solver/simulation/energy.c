/* Is the energy of a run what was put into it? The total energy that the ledger knows, kinetic +
 * strain + dissipated by damping, plastic strain and artificial viscosity + of cohesive cracks +
 * stored and dissipated by contact, may differ from that of the start by the work done alone. Of
 * contact, what all pairs of bodies have stored and dissipated is what they have taken; where they
 * have given more than that, and the sum in the ledger is negative, they have none: else what
 * contact makes would balance itself, and a run that ends in it would pass. (Stored energy alone is
 * no measure: that of the jump of a stiff interface can be large for a step, and its dissipation is
 * minus that. Nor is a single pair: where three bodies meet, one gives to another.) What is above
 * that the scheme has made:
 *
 *   factor = 1 + (E - W - E_0) / (E_0 + the larger of largest |W| and 8 largest K_c so far),
 *
 * K_c: kinetic energy of the changes of velocity that conditions make at their nodes in a step, of
 * a node not more than that of the velocity it is given. A condition that starts at once strains a
 * body before it does any work: with the stiffness K of the nodes, their masses M and the changes
 * v, by dt^2 v.K v/2, which is (omega dt)^2 K_c at most, omega^2 being the largest v.K v / v.M v. A
 * step that is stable has omega dt <= 2. (A whole side of a body that jumps by v strains its cells
 * by v dt/h: with a Courant number C, by 2 C^2 K_c.) A condition that moves a body with which its
 * particles already move changes nothing, and does not hide what grows. The factor is 1 in an exact
 * run and E / E_0 in one without work. Strain energy costs too much for each step: it is judged
 * before each sort, which is when the last good state is replaced, and wherever results are
 * written; first its upper bound, and itself only where that is not low enough. A run that failed,
 * or whose energy is found too large, is repeated from the last good state with a look at each
 * step.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/strips.h"
#include "method/cracks/cohesive_traction.h"
#include "method/transfer/law_state.h"
#include "simulation/simulation.h"

#include <math.h>

/* In the catalogue, with 18 combinations of functions and order and all transfers, sound runs stay
 * below 1.05 and below 1.3 in the first steps of a load that starts from nothing. Weak methods pass
 * 1.5, for some time (momentum form), or on their way beyond any bound (classic USF). */
static const double FACTOR_GROWING = 1.5;
/* Runs that came back from more than this were those of classic functions alone. */
static const double FACTOR_UNSTABLE = 10.0;
/* Round-off alone moves a body at rest: energies below this part of m c^2 mean nothing. */
static const double NOISE = 1e-12;

/* Of K_c: twice the 4 that a condition makes by starting at once, at most, so that this alone does
 * not pass for growth. */
static const double SUDDEN = 8.0;

static double put_in(const struct mpm_simulation *simulation)
{
    const double speed = simulation->wave_speed_start;
    return simulation->energy_start +
           fmax(simulation->largest_work, SUDDEN * simulation->state.sudden_energy) +
           NOISE * simulation->mass * speed * speed;
}

/* The total energy at which the factor has that value. */
static double energy_at(const struct mpm_simulation *simulation, double factor)
{
    return simulation->energy_start + simulation->state.external_work +
           (factor - 1.0) * put_in(simulation);
}

/* One past the last particle from `begin` on that is of the same body. */
static size_t end_of_body(const struct mpm_particles *particles, size_t begin, size_t end)
{
    size_t p = begin + 1;
    while (p < end && particles->body[p] == particles->body[begin])
        p++;
    return p;
}

static void bound_strain_energy(void *context, int64_t index, int worker)
{
    struct mpm_state *const state = context;
    struct mpm_strip *const strip = &state->strips[index];
    const struct mpm_particles *const particles = &state->particles;
    double sum = 0.0;
    (void)worker;
    for (size_t p = strip->begin, next; p < strip->end; p = next) {
        next = end_of_body(particles, p, strip->end);
        const struct mpm_material *const material = &state->bodies[particles->body[p]].material;
        sum += material->law->energy_bound == NULL || particles->free_strain != NULL ||
                       particles->viscous[0] != NULL
                   ? HUGE_VAL /* so that the sum itself is taken */
                   : material->law->energy_bound(material, particles->deformation, particles->mass,
                                                 p, next);
    }
    strip->strain_energy = sum;
}

/* With what plastic strain and artificial viscosity have dissipated, as heat or not. */
static void add_strain_energy(void *context, int64_t index, int worker)
{
    struct mpm_state *const state = context;
    struct mpm_strip *const strip = &state->strips[index];
    const struct mpm_particles *const particles = &state->particles;
    double sum = 0.0;
    (void)worker;
    for (size_t p = strip->begin; p < strip->end; p++)
        sum += particles->mass[p] *
               (mpm_particle_strain_energy(state, p) + mpm_particle_dissipation(state, p) +
                mpm_particle_plastic_heat(state, p) + mpm_particle_viscous_work(state, p));
    strip->strain_energy = sum;
}

/* What the ledger has, or more; from sums of the strips, in which `strain_energy` leaves its part.
 */
static double total_energy(struct mpm_simulation *simulation,
                           void (*strain_energy)(void *context, int64_t strip, int worker))
{
    struct mpm_state *const state = &simulation->state;
    double stored, dissipated, strain = 0.0;
    mpm_strips_run(state->strip_count, state->workers, strain_energy, state);
    for (int64_t s = 0; s < state->strip_count; s++)
        strain += state->strips[s].strain_energy;
    mpm_cohesive_energies(state, &stored, &dissipated);
    return mpm_kinetic_energy(state) + strain + state->damping.totals.dissipated + stored +
           dissipated + mpm_contact_held(state) - state->transport.expansion.work;
}

static uint32_t fastest_particle(const struct mpm_particles *particles)
{
    size_t fastest = 0;
    double largest = 0.0;
    for (size_t p = 0; p < particles->count; p++) {
        const double speed = hypot(particles->velocity[0][p], particles->velocity[1][p]);
        if (speed > largest) {
            largest = speed;
            fastest = p;
        }
    }
    return particles->id[fastest];
}

/* Of the step that has just been counted. */
static enum mpm_status refuse(const struct mpm_simulation *simulation, double total,
                              struct mpm_error *error)
{
    const struct mpm_state *const state = &simulation->state;
    const bool finite = isfinite(total) && isfinite(state->external_work);
    const uint32_t fastest = fastest_particle(&state->particles);
    if (finite)
        (void)mpm_error_fail(
            error, MPM_CAUSE_ENERGY,
            "total energy %g; allowed: up to %g, where %g of it would come from nothing, %g times "
            "all that was put in; fastest is particle %u (body '%s')",
            total, energy_at(simulation, FACTOR_UNSTABLE),
            (FACTOR_UNSTABLE - 1.0) * put_in(simulation), FACTOR_UNSTABLE - 1.0, fastest,
            mpm_body_of_particle(simulation, fastest));
    else
        (void)mpm_error_fail(error, MPM_CAUSE_NOT_FINITE, "total energy is %g, external work %g",
                             total, state->external_work);
    mpm_error_locate(error, simulation->step, state->time);
    return MPM_RUN_FAILED;
}

static void note_growth(struct mpm_simulation *simulation, double total)
{
    struct mpm_energy_growth *const growth = &simulation->growth;
    const double made = total - simulation->state.external_work - simulation->energy_start;
    const double given = put_in(simulation); /* of a gas at absolute zero nothing */
    const double factor = given > 0.0 ? 1.0 + made / given : 1.0;
    growth->factor = factor;
    growth->largest = fmax(growth->largest, factor);
    if (factor <= FACTOR_GROWING || growth->seen)
        return;
    growth->seen = true;
    growth->step = simulation->step;
    growth->time = simulation->state.time;
}

enum mpm_status mpm_energy_judge(struct mpm_simulation *simulation, struct mpm_error *error)
{
    if (simulation->judged_step == simulation->step || simulation->scene->at_rest)
        return MPM_OK;
    double total = total_energy(simulation, bound_strain_energy);
    if (!(total <= energy_at(simulation, FACTOR_GROWING)))
        total = total_energy(simulation, add_strain_energy);
    if (!(total <= energy_at(simulation, FACTOR_UNSTABLE)) || !isfinite(total))
        return refuse(simulation, total, error);
    note_growth(simulation, total);
    simulation->judged_step = simulation->step;
    return MPM_OK;
}

bool mpm_energy_is_in_doubt(const struct mpm_simulation *simulation)
{
    const double known = mpm_kinetic_energy(&simulation->state) +
                         simulation->state.damping.totals.dissipated -
                         simulation->state.transport.expansion.work;
    return !(known <= energy_at(simulation, FACTOR_UNSTABLE)) || !isfinite(known);
}

bool mpm_simulation_energy_growth(const struct mpm_simulation *simulation,
                                  struct mpm_energy_growth *growth)
{
    if (growth != NULL)
        *growth = simulation->growth;
    return simulation->growth.seen;
}
