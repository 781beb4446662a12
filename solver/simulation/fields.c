/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "simulation/simulation.h"

#include <math.h>
#include <string.h>

static const struct mpm_field_info infos[MPM_FIELD_COUNT] = {
    [MPM_FIELD_ID] = {"id", 1, true, MPM_DIMENSION_NONE,
                      "number of the particle in creation order"},
    [MPM_FIELD_BODY] = {"body", 1, true, MPM_DIMENSION_NONE,
                        "index of the particle's body in the scene"},
    [MPM_FIELD_POSITION] = {"position", 2, false, MPM_DIMENSION_LENGTH,
                            "centre of the particle: x y, or r z"},
    [MPM_FIELD_VELOCITY] = {"velocity", 2, false, MPM_DIMENSION_VELOCITY,
                            "velocity of the particle"},
    [MPM_FIELD_DEFORMATION_GRADIENT] = {"deformation_gradient", 5, false, MPM_DIMENSION_NONE,
                                        "xx xy yx yy zz; in axisymmetry rr rz zr zz tt"},
    [MPM_FIELD_STRESS] = {"stress", 4, false, MPM_DIMENSION_STRESS,
                          "Cauchy stress xx yy zz xy; in axisymmetry rr zz tt rz"},
    [MPM_FIELD_VOLUME] = {"volume", 1, false, MPM_DIMENSION_VOLUME,
                          "current volume, for the thickness or per radian"},
    [MPM_FIELD_MASS] = {"mass", 1, false, MPM_DIMENSION_MASS,
                        "mass, for the thickness or per radian"},
    [MPM_FIELD_FRINGE] = {"fringe", 1, false, MPM_DIMENSION_NONE,
                          "photoelastic fringes: cos(k sqrt((xx - yy)^2 + 4 xy^2)) of the Cauchy "
                          "stress, k the scene's output.fringe"},
};

const struct mpm_field_info *mpm_field_describe(enum mpm_field field)
{
    return &infos[field];
}

bool mpm_scene_has_field(const struct mpm_scene *scene, enum mpm_field field)
{
    return field != MPM_FIELD_FRINGE || scene->fringe > 0.0;
}

static double determinant_of(const struct mpm_particles *particles, size_t p)
{
    double f[MPM_GRADIENT_SIZE];
    for (int k = 0; k < MPM_GRADIENT_SIZE; k++)
        f[k] = particles->deformation[k][p];
    return mpm_determinant(f);
}

/* CRAMP (23), of Kirchhoff stress over initial density and its scale to Cauchy stress. */
static double fringe_of(const struct mpm_simulation *simulation, size_t p, double scale)
{
    double *const *const stress = simulation->state.particles.stress;
    const double constant = simulation->scene->fringe;
    const double difference = stress[MPM_SYM_XX][p] - stress[MPM_SYM_YY][p];
    if (!(constant > 0.0))
        return (double)NAN;
    return cos(constant * scale * hypot(difference, 2.0 * stress[MPM_SYM_XY][p]));
}

static void copy(const struct mpm_simulation *simulation, enum mpm_field field, size_t p,
                 double *out)
{
    const struct mpm_particles *const particles = &simulation->state.particles;
    const struct mpm_body *const body = &simulation->state.bodies[particles->body[p]];
    double scale;
    switch (field) {
    case MPM_FIELD_ID:
        out[0] = particles->id[p];
        return;
    case MPM_FIELD_BODY:
        out[0] = particles->body[p];
        return;
    case MPM_FIELD_POSITION:
    case MPM_FIELD_VELOCITY:
        for (int k = 0; k < 2; k++)
            out[k] =
                (field == MPM_FIELD_POSITION ? particles->position : particles->velocity)[k][p];
        return;
    case MPM_FIELD_DEFORMATION_GRADIENT:
        for (int k = 0; k < MPM_GRADIENT_SIZE; k++)
            out[k] = particles->deformation[k][p];
        return;
    case MPM_FIELD_STRESS:
        scale = body->material.density / determinant_of(particles, p);
        for (int k = 0; k < MPM_SYMMETRIC_SIZE; k++)
            out[k] = particles->stress[k][p] * scale;
        return;
    case MPM_FIELD_VOLUME:
        out[0] = particles->mass[p] * (determinant_of(particles, p) / body->material.density);
        return;
    case MPM_FIELD_MASS:
        out[0] = particles->mass[p];
        return;
    case MPM_FIELD_FRINGE:
        out[0] = fringe_of(simulation, p, body->material.density / determinant_of(particles, p));
        return;
    case MPM_FIELD_COUNT:
        return;
    }
}

/* Rigid particles do not deform and carry no mass. */
static void copy_rigid(const struct mpm_simulation *simulation, enum mpm_field field, size_t p,
                       double *out)
{
    const struct mpm_rigid_particles *const rigid = &simulation->state.rigid;
    for (size_t k = 0; k < infos[field].components; k++)
        out[k] = 0.0;
    if (field == MPM_FIELD_ID)
        out[0] = rigid->id[p];
    else if (field == MPM_FIELD_BODY)
        out[0] = rigid->body[p];
    else if (field == MPM_FIELD_FRINGE) /* of no stress */
        out[0] = simulation->scene->fringe > 0.0 ? 1.0 : (double)NAN;
    else if (field == MPM_FIELD_DEFORMATION_GRADIENT)
        out[MPM_XX] = out[MPM_YY] = out[MPM_ZZ] = 1.0;
    else if (field == MPM_FIELD_POSITION || field == MPM_FIELD_VELOCITY)
        for (int k = 0; k < 2; k++)
            out[k] = (field == MPM_FIELD_POSITION ? rigid->position : rigid->velocity)[k][p];
}

void mpm_simulation_field(const struct mpm_simulation *simulation, enum mpm_field field,
                          double *values)
{
    const size_t components = infos[field].components;
    const struct mpm_particles *const particles = &simulation->state.particles;
    for (size_t p = 0; p < particles->count; p++)
        copy(simulation, field, p, values + components * particles->id[p]);
    const struct mpm_rigid_particles *const rigid = &simulation->state.rigid;
    for (size_t p = 0; p < rigid->count; p++)
        copy_rigid(simulation, field, p, values + components * rigid->id[p]);
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
    for (size_t p = 0; p < particles->count; p++)
        particles->order[particles->id[p] - rigid_before(rigid, particles->id[p])] = (uint32_t)p;
}

/* A place that a step has made worthless betrays itself: another id is there. */
static size_t place_of(const struct mpm_simulation *simulation, size_t id, size_t rank)
{
    const struct mpm_particles *const particles = &simulation->state.particles;
    uint32_t p;
    memcpy(&p, &particles->order[rank], sizeof p); /* within a step, numbers stand there */
    if (p < particles->count && particles->id[p] == id)
        return p;
    find_places(simulation);
    return particles->order[rank];
}

void mpm_simulation_field_range(const struct mpm_simulation *simulation, enum mpm_field field,
                                size_t first, size_t count, double *values)
{
    const struct mpm_rigid_particles *const rigid = &simulation->state.rigid;
    size_t next = rigid_before(rigid, first);
    for (size_t id = first; id < first + count; id++, values += infos[field].components)
        if (next < rigid->count && rigid->id[next] == id)
            copy_rigid(simulation, field, next++, values);
        else
            copy(simulation, field, place_of(simulation, id, id - next), values);
}
