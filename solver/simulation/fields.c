/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/status.h"
#include "method/transfer/law_state.h"
#include "simulation/simulation.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* ------------------------------------------------------- of a deformable particle */

static double determinant_of(const struct mpm_particles *particles, size_t p)
{
    double f[MPM_GRADIENT_SIZE];
    for (int k = 0; k < MPM_GRADIENT_SIZE; k++)
        f[k] = particles->deformation[k][p];
    return mpm_determinant(f);
}

static double density_of(const struct mpm_simulation *simulation, size_t p)
{
    return simulation->state.bodies[simulation->state.particles.body[p]].material.density;
}

/* From Kirchhoff stress over initial density to Cauchy stress. */
static double stress_scale(const struct mpm_simulation *simulation, size_t p)
{
    return density_of(simulation, p) / determinant_of(&simulation->state.particles, p);
}

static void find_stress(const struct mpm_simulation *simulation, size_t p, double *out)
{
    const double scale = stress_scale(simulation, p);
    for (int k = 0; k < MPM_SYMMETRIC_SIZE; k++)
        out[k] = simulation->state.particles.stress[k][p] * scale;
}

static void find_volume(const struct mpm_simulation *simulation, size_t p, double *out)
{
    const struct mpm_particles *const particles = &simulation->state.particles;
    out[0] = particles->mass[p] * (determinant_of(particles, p) / density_of(simulation, p));
}

static void find_plastic_strain(const struct mpm_simulation *simulation, size_t p, double *out)
{
    const struct mpm_particles *const particles = &simulation->state.particles;
    const struct mpm_material_law *const law =
        simulation->state.bodies[particles->body[p]].material.law;
    out[0] =
        law->dissipation == NULL ? 0.0 : *mpm_particle_law_state(particles, p, law->plastic_strain);
}

static void find_internal_energy(const struct mpm_simulation *simulation, size_t p, double *out)
{
    out[0] = mpm_particle_internal_energy(&simulation->state, p);
}

static void find_state_temperature(const struct mpm_simulation *simulation, size_t p, double *out)
{
    out[0] = mpm_particle_state_temperature(&simulation->state, p);
}

static void find_viscous_pressure(const struct mpm_simulation *simulation, size_t p, double *out)
{
    const double *const viscous = simulation->state.particles.viscous[0];
    out[0] = viscous == NULL ? 0.0 : viscous[p] * stress_scale(simulation, p);
}

static double not_known(const struct mpm_simulation *simulation)
{
    (void)simulation;
    return (double)NAN;
}

static void find_displacement(const struct mpm_simulation *simulation, size_t p, double *out)
{
    const struct mpm_particles *const particles = &simulation->state.particles;
    for (int k = 0; k < 2; k++)
        out[k] = particles->origin[k] == NULL ? (double)NAN
                                              : particles->position[k][p] - particles->origin[k][p];
}

static void find_von_mises(const struct mpm_simulation *simulation, size_t p, double *out)
{
    double s[MPM_SYMMETRIC_SIZE];
    find_stress(simulation, p, s);
    const double xy = s[MPM_SYM_XX] - s[MPM_SYM_YY], yz = s[MPM_SYM_YY] - s[MPM_SYM_ZZ],
                 zx = s[MPM_SYM_ZZ] - s[MPM_SYM_XX];
    out[0] = sqrt(0.5 * (xy * xy + yz * yz + zx * zx) + 3.0 * s[MPM_SYM_XY] * s[MPM_SYM_XY]);
}

static void find_pressure(const struct mpm_simulation *simulation, size_t p, double *out)
{
    double s[MPM_SYMMETRIC_SIZE];
    find_stress(simulation, p, s);
    out[0] = -(s[MPM_SYM_XX] + s[MPM_SYM_YY] + s[MPM_SYM_ZZ]) / 3.0;
}

/* CRAMP (23) */
static void find_fringe(const struct mpm_simulation *simulation, size_t p, double *out)
{
    double *const *const stress = simulation->state.particles.stress;
    const double constant = simulation->scene->fringe;
    const double scale = stress_scale(simulation, p);
    const double difference = stress[MPM_SYM_XX][p] - stress[MPM_SYM_YY][p];
    out[0] = constant > 0.0 ? cos(constant * scale * hypot(difference, 2.0 * stress[MPM_SYM_XY][p]))
                            : (double)NAN;
}

static double fringe_without_stress(const struct mpm_simulation *simulation)
{
    return simulation->scene->fringe > 0.0 ? 1.0 : (double)NAN;
}

/* ---------------------------------------------------------------------- the table */

/* What snapshots have: a row of mpm_particle_rows, or a function of the particle, `find`. Of rigid
 * particles, which do not deform and carry no mass, every component of such a function is `rigid`;
 * NULL: 0. */
struct quantity {
    const struct mpm_particle_row *stored; /* or NULL */
    struct mpm_field_info info;
    void (*find)(const struct mpm_simulation *simulation, size_t p, double *out);
    double (*rigid)(const struct mpm_simulation *simulation);
};

static const struct quantity quantities[MPM_FIELD_COUNT] = {
    [MPM_FIELD_STRESS] = {.info = {"stress", 4, false, MPM_DIMENSION_STRESS,
                                   "Cauchy stress xx yy zz xy; in axisymmetry rr zz tt rz"},
                          .find = find_stress},
    [MPM_FIELD_VOLUME] = {.info = {"volume", 1, false, MPM_DIMENSION_VOLUME,
                                   "current volume, for the thickness or per radian"},
                          .find = find_volume},
    [MPM_FIELD_PLASTIC_STRAIN] = {.info = {"plastic_strain", 1, false, MPM_DIMENSION_NONE,
                                           "equivalent plastic strain"},
                                  .find = find_plastic_strain},
    [MPM_FIELD_FRINGE] = {.info = {"fringe", 1, false, MPM_DIMENSION_NONE,
                                   "photoelastic fringes: cos(k sqrt((xx - yy)^2 + 4 xy^2)) of the "
                                   "Cauchy stress, k the scene's output.fringe"},
                          .find = find_fringe,
                          .rigid = fringe_without_stress},
    [MPM_FIELD_INTERNAL_ENERGY] = {.info = {"internal_energy", 1, false,
                                            MPM_DIMENSION_SPECIFIC_ENERGY,
                                            "of the equation of state, per mass"},
                                   .find = find_internal_energy},
    [MPM_FIELD_STATE_TEMPERATURE] = {.info = {"state_temperature", 1, false,
                                              MPM_DIMENSION_TEMPERATURE,
                                              "of the equation of state, with specific_heat"},
                                     .find = find_state_temperature},
    [MPM_FIELD_VISCOUS_PRESSURE] = {.info = {"viscous_pressure", 1, false, MPM_DIMENSION_STRESS,
                                             "artificial viscosity, part of the stress"},
                                    .find = find_viscous_pressure},
    [MPM_FIELD_DISPLACEMENT] = {.info = {"displacement", 2, false, MPM_DIMENSION_LENGTH,
                                         "position minus that at t = 0: x y, or r z"},
                                .find = find_displacement,
                                .rigid = not_known},
    [MPM_FIELD_VON_MISES] = {.info = {"von_mises", 1, false, MPM_DIMENSION_STRESS,
                                      "equivalent stress of von Mises, of the Cauchy stress"},
                             .find = find_von_mises},
    [MPM_FIELD_PRESSURE] = {.info = {"pressure", 1, false, MPM_DIMENSION_STRESS,
                                     "minus the mean of the three normal stresses"},
                            .find = find_pressure},
#define MPM_ROW(name, ...) [MPM_FIELD_##name] = {.stored = &mpm_particle_rows[MPM_PARTICLE_##name]},
    MPM_WRITTEN_PARTICLE_FIELDS(MPM_ROW)
#undef MPM_ROW
};
_Static_assert(MPM_FIELD_COUNT == MPM_PARTICLE_WRITTEN_COUNT + 10, "one row for each field");

const struct mpm_field_info *mpm_field_describe(enum mpm_field field)
{
    const struct quantity *const quantity = &quantities[field];
    return quantity->stored != NULL ? &quantity->stored->info : &quantity->info;
}

enum mpm_status mpm_field_find(const char *name, enum mpm_field *field, struct mpm_error *error)
{
    char names[MPM_MESSAGE_SIZE / 2] = "";
    size_t length = 0;
    for (int k = 0; k < MPM_FIELD_COUNT; k++) {
        const char *const known = mpm_field_describe((enum mpm_field)k)->name;
        if (strcmp(name, known) == 0) {
            *field = (enum mpm_field)k;
            return MPM_OK;
        }
        if (length < sizeof names)
            length += (size_t)snprintf(names + length, sizeof names - length, "%s%s",
                                       k > 0 ? ", " : "", known);
    }
    return mpm_error_set(error, MPM_BAD_INPUT, "'%.64s' is no field; allowed: %s", name, names);
}

static bool has_equation_of_state(const struct mpm_scene *scene, bool with_temperature)
{
    bool any = false;
    for (size_t k = 0; k < scene->material_count; k++) {
        const struct mpm_material_spec *const material = &scene->materials[k];
        any = any ||
              (with_temperature ? mpm_material_has_temperature(material->law, material->parameter)
                                : material->law->keeps_heat);
    }
    return any;
}

bool mpm_scene_has_field(const struct mpm_scene *scene, enum mpm_field field)
{
    if (field == MPM_FIELD_TEMPERATURE)
        return scene->scalars[MPM_TEMPERATURE].asked;
    if (field == MPM_FIELD_CONCENTRATION)
        return scene->scalars[MPM_CONCENTRATION].asked;
    if (field >= MPM_FIELD_DISPLACEMENT)
        return scene->derived;
    if (field == MPM_FIELD_PLASTIC_STRAIN)
        return mpm_scene_is_plastic(scene);
    if (field == MPM_FIELD_INTERNAL_ENERGY || field == MPM_FIELD_STATE_TEMPERATURE)
        return has_equation_of_state(scene, field == MPM_FIELD_STATE_TEMPERATURE);
    if (field == MPM_FIELD_VISCOUS_PRESSURE)
        return mpm_scene_is_viscous(scene);
    return field != MPM_FIELD_FRINGE || scene->fringe > 0.0;
}

/* -------------------------------------------------------------------------- copies */

/* What the particles carry; of a field that they do not have, the value of a rigid one. */
static void copy_stored(const struct mpm_particle_row *row, const struct mpm_particles *particles,
                        size_t p, double *out)
{
    const size_t field = (size_t)(row - mpm_particle_rows);
    const size_t carried = particles->components[field];
    for (size_t k = 0; k < row->info.components; k++)
        if (k >= carried)
            out[k] = (row->ones >> k & 1U) != 0 ? 1.0 : 0.0;
        else if (row->info.integer)
            out[k] = ((const uint32_t *)mpm_particle_array(particles, field, k))[p];
        else
            out[k] = ((const double *)mpm_particle_array(particles, field, k))[p];
}

static void copy(const struct mpm_simulation *simulation, enum mpm_field field,
                 const struct mpm_particles *particles, size_t p, double *out)
{
    const struct quantity *const quantity = &quantities[field];
    if (quantity->stored != NULL)
        copy_stored(quantity->stored, particles, p, out);
    else if (particles == &simulation->state.particles)
        quantity->find(simulation, p, out);
    else
        for (size_t k = 0; k < quantity->info.components; k++)
            out[k] = quantity->rigid == NULL ? 0.0 : quantity->rigid(simulation);
}

void mpm_simulation_field(const struct mpm_simulation *simulation, enum mpm_field field,
                          double *values)
{
    const size_t components = mpm_field_describe(field)->components;
    const struct mpm_particles *const particles = &simulation->state.particles;
    for (size_t p = 0; p < particles->count; p++)
        copy(simulation, field, particles, p, values + components * particles->id[p]);
    const struct mpm_particles rigid = mpm_rigid_particles_set(&simulation->state.rigid);
    for (size_t p = 0; p < rigid.count; p++)
        copy(simulation, field, &rigid, p, values + components * rigid.id[p]);
}

/* -------------------------------------------------------------- by ranges of ids */

/* How many rigid particles have a smaller id: theirs ascend. */
static size_t rigid_before(const struct mpm_rigid_particles *rigid, size_t id)
{
    size_t low = 0, high = rigid->count;
    while (low < high) {
        const size_t middle = low + (high - low) / 2;
        if (rigid->id[middle] < id)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

/* A deformable particle's rank is its number in creation order without the rigid ones. The
 * sort's scratch keeps the places by rank until the next step. */
static void find_places(const struct mpm_simulation *simulation)
{
    const struct mpm_particles *const particles = &simulation->state.particles;
    const struct mpm_rigid_particles *const rigid = &simulation->state.rigid;
    uint32_t *const order = mpm_particles_order(particles);
    for (size_t p = 0; p < particles->count; p++)
        order[particles->id[p] - rigid_before(rigid, particles->id[p])] = (uint32_t)p;
}

/* A place that a step has made worthless betrays itself: another id is there. */
static size_t place_of(const struct mpm_simulation *simulation, size_t id, size_t rank)
{
    const struct mpm_particles *const particles = &simulation->state.particles;
    uint32_t p;
    const uint32_t *const order = mpm_particles_order(particles);
    memcpy(&p, &order[rank], sizeof p); /* within a step, numbers stand there */
    if (p < particles->count && particles->id[p] == id)
        return p;
    find_places(simulation);
    return order[rank];
}

void mpm_simulation_field_range(const struct mpm_simulation *simulation, enum mpm_field field,
                                size_t first, size_t count, double *values)
{
    const struct mpm_particles rigid = mpm_rigid_particles_set(&simulation->state.rigid);
    const size_t components = mpm_field_describe(field)->components;
    size_t next = rigid_before(&simulation->state.rigid, first);
    for (size_t id = first; id < first + count; id++, values += components)
        if (next < rigid.count && rigid.id[next] == id)
            copy(simulation, field, &rigid, next++, values);
        else
            copy(simulation, field, &simulation->state.particles,
                 place_of(simulation, id, id - next), values);
}
