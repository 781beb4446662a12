/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/measures/particle_set.h"

#include <stdlib.h>

enum { POSITION = 2, GRADIENT = 5, STRESS = 4 };

static enum mpm_status no_memory(struct mpm_error *error)
{
    if (error != NULL)
        *error = (struct mpm_error){.status = MPM_ENVIRONMENT_FAILED,
                                    .message = "out of memory for particle fields"};
    return MPM_ENVIRONMENT_FAILED;
}

static void find_members(struct particle_set *set, const struct mpm_simulation *simulation,
                         size_t body)
{
    mpm_simulation_field(simulation, MPM_FIELD_BODY, set->all);
    for (size_t p = 0; p < set->all_count; p++)
        if ((size_t)set->all[p] == body)
            set->index[set->count++] = p;
    mpm_simulation_field(simulation, MPM_FIELD_POSITION, set->all);
    for (size_t k = 0; k < set->count; k++)
        for (size_t axis = 0; axis < POSITION; axis++)
            set->start[POSITION * k + axis] = set->all[POSITION * set->index[k] + axis];
}

enum mpm_status particle_set_create(const struct mpm_simulation *simulation, size_t body,
                                    struct particle_set *set, struct mpm_error *error)
{
    const size_t n = mpm_simulation_particle_count(simulation);
    *set = (struct particle_set){
        .all_count = n,
        .index = calloc(n, sizeof *set->index),
        .start = calloc(n * POSITION, sizeof *set->start),
        .relative_volume = calloc(n, sizeof *set->relative_volume),
        .stress = calloc(n * STRESS, sizeof *set->stress),
        .position = calloc(n * POSITION, sizeof *set->position),
        .all = calloc(n * GRADIENT, sizeof *set->all),
    };
    if (set->index == NULL || set->start == NULL || set->relative_volume == NULL ||
        set->stress == NULL || set->position == NULL || set->all == NULL) {
        particle_set_free(set);
        return no_memory(error);
    }
    find_members(set, simulation, body);
    return MPM_OK;
}

void particle_set_free(struct particle_set *set)
{
    free(set->index);
    free(set->start);
    free(set->relative_volume);
    free(set->stress);
    free(set->position);
    free(set->all);
    *set = (struct particle_set){0};
}

static void pick(const struct particle_set *set, size_t components, double *out)
{
    for (size_t k = 0; k < set->count; k++)
        for (size_t c = 0; c < components; c++)
            out[components * k + c] = set->all[components * set->index[k] + c];
}

void particle_set_read(struct particle_set *set, const struct mpm_simulation *simulation)
{
    mpm_simulation_field(simulation, MPM_FIELD_STRESS, set->all);
    pick(set, STRESS, set->stress);
    mpm_simulation_field(simulation, MPM_FIELD_POSITION, set->all);
    pick(set, POSITION, set->position);
    mpm_simulation_field(simulation, MPM_FIELD_DEFORMATION_GRADIENT, set->all);
    for (size_t k = 0; k < set->count; k++) {
        const double *const f = &set->all[GRADIENT * set->index[k]];
        set->relative_volume[k] = (f[0] * f[3] - f[1] * f[2]) * f[4];
    }
}

size_t particle_set_inner_first(struct particle_set *set, double limit)
{
    size_t *const index = malloc(set->count * sizeof *index);
    double *const start = malloc(set->count * POSITION * sizeof *start);
    size_t place = 0, inner = 0;
    for (int outer = 0; index != NULL && start != NULL && outer < 2; outer++) {
        for (size_t k = 0; k < set->count; k++)
            if ((set->start[POSITION * k] < limit) == (outer == 0)) {
                index[place] = set->index[k];
                start[POSITION * place] = set->start[POSITION * k];
                start[POSITION * place + 1] = set->start[POSITION * k + 1];
                place++;
            }
        inner = outer == 0 ? place : inner;
    }
    for (size_t k = 0; k < place; k++) {
        set->index[k] = index[k];
        set->start[POSITION * k] = start[POSITION * k];
        set->start[POSITION * k + 1] = start[POSITION * k + 1];
    }
    free(index);
    free(start);
    return inner;
}
