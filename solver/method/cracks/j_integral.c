/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/cracks/j_integral.h"

#include "method/cracks/crack_fields.h"
#include "method/cracks/crack_map.h"
#include "method/cracks/stress_intensity.h"
#include "method/transfer/law_state.h"
#include "method/transfer/transfer.h"

#include <math.h>
#include <string.h>

/* Particles so many cells from the contour give something to the nodes in its margin. */
enum { PARTICLE_MARGIN = MPM_J_MARGIN + 2 };
/* The margins are for particles that reach nodes up to two cells away: domains whose edges are no
 * farther than one from their particle, in cells. */
static const double LONGEST_REACH = 1.0;
static const char *const axis_names[] = {"first", "second"};

size_t mpm_j_nodes(const struct mpm_j_integral_spec *spec)
{
    const size_t side = (size_t)(2 * spec->contour + 1 + 2 * MPM_J_MARGIN);
    return side * side;
}

/* ------------------------------------------------------------------ placing */

/* Of grid lines: the one nearest to the tip. */
static int64_t nearest_line(const struct mpm_grid *grid, const double tip[2], int axis)
{
    return mpm_floor((tip[axis] - grid->origin[axis]) * grid->inverse_cell[axis] + 0.5);
}

void mpm_j_contour_box(const struct mpm_state *state, const struct mpm_j_integral_spec *spec,
                       const double tip[2], struct mpm_crack_box *box)
{
    const struct mpm_grid *const grid = &state->grid;
    for (int axis = 0; axis < 2; axis++) {
        const double nearest = (double)nearest_line(grid, tip, axis);
        const double cells = (double)spec->contour;
        box->low[axis] = grid->origin[axis] + grid->cell[axis] * (nearest - cells);
        box->high[axis] = grid->origin[axis] + grid->cell[axis] * (nearest + cells);
    }
}

static enum mpm_status place_contour(struct mpm_j_contour *contour, struct mpm_error *error)
{
    const struct mpm_state *const state = contour->state;
    const struct mpm_grid *const grid = &state->grid;
    const int64_t cells = contour->spec->contour;
    double tip[2];
    mpm_j_tip_place(state, contour->spec, tip);
    for (int axis = 0; axis < 2; axis++) {
        const int64_t nearest = nearest_line(grid, tip, axis);
        const bool radius = axis == 0 && state->scene->geometry == MPM_AXISYMMETRIC;
        const double lowest = grid->origin[axis] + (double)(nearest - cells) * grid->cell[axis];
        if (radius && lowest < 1e-9 * grid->cell[axis])
            return mpm_error_set(error, MPM_RUN_FAILED,
                                 "%s: the contour of %lld cells around the tip (%g, %g) reaches "
                                 "the axis r = 0, which has particles on one side alone; allowed: "
                                 "r > 0",
                                 contour->spec->key, (long long)cells, tip[0], tip[1]);
        if (nearest - cells < 0 || nearest + cells > grid->cells[axis])
            return mpm_error_set(error, MPM_RUN_FAILED,
                                 "%s: the contour of %lld cells around the tip (%g, %g) leaves the "
                                 "grid along its %s axis; allowed: inside",
                                 contour->spec->key, (long long)cells, tip[0], tip[1],
                                 axis_names[axis]);
        contour->low[axis] = nearest - cells + MPM_GHOST_ROWS;
        contour->high[axis] = nearest + cells + MPM_GHOST_ROWS;
    }
    contour->width = 2 * cells + 1 + 2 * (int64_t)MPM_J_MARGIN;
    return MPM_OK;
}

/* Where columns or rows at that distance from the contour are. */
static struct mpm_crack_box box_around(const struct mpm_j_contour *contour, int64_t cells)
{
    const struct mpm_grid *const grid = &contour->state->grid;
    struct mpm_crack_box box;
    for (int axis = 0; axis < 2; axis++) {
        box.low[axis] = grid->origin[axis] +
                        grid->cell[axis] * (double)(contour->low[axis] - cells - MPM_GHOST_ROWS);
        box.high[axis] = grid->origin[axis] +
                         grid->cell[axis] * (double)(contour->high[axis] + cells - MPM_GHOST_ROWS);
    }
    return box;
}

/* Any point of it inside; one that only crosses the contour is found there. */
static enum mpm_status check_alone(const struct mpm_j_contour *contour, size_t *met,
                                   struct mpm_error *error)
{
    const struct mpm_state *const state = contour->state;
    const struct mpm_crack_box box = box_around(contour, 0);
    for (size_t k = 0; k < state->scene->crack_count; k++) {
        const struct mpm_crack_chain *const chain = &state->cracks.chains[k];
        for (size_t i = 0; i < chain->count && k != contour->spec->crack; i++)
            if (chain->x[i] >= box.low[0] && chain->x[i] <= box.high[0] &&
                chain->y[i] >= box.low[1] && chain->y[i] <= box.high[1]) {
                *met = k;
                return mpm_error_set(error, MPM_RUN_FAILED,
                                     "%s: cracks.%zu lies inside the contour, near (%g, %g), and "
                                     "J would be that of both; allowed: its own crack alone",
                                     contour->spec->key, k, chain->x[i], chain->y[i]);
            }
    }
    return MPM_OK;
}

/* ---------------------------------------------------------------- particles */

static enum mpm_status check_reach(const struct mpm_j_contour *contour, struct mpm_error *error)
{
    const struct mpm_state *const state = contour->state;
    const struct mpm_crack_box box = box_around(contour, PARTICLE_MARGIN);
    for (size_t p = 0; state->family->convected && p < state->particles.count; p++) {
        const struct mpm_placement at = mpm_particle_placement(state, p);
        bool near = mpm_cracks_cut(state, p);
        for (int axis = 0; axis < 2; axis++)
            near = near && at.position[axis] + at.reach[axis] > box.low[axis] &&
                   at.position[axis] - at.reach[axis] < box.high[axis];
        for (int axis = 0; axis < 2 && near; axis++)
            if (!(at.reach[axis] * state->grid.inverse_cell[axis] <= LONGEST_REACH))
                return mpm_error_set(
                    error, MPM_RUN_FAILED,
                    "%s: the domain of the particle at (%g, %g), near the contour, reaches %g "
                    "cells along the %s axis; allowed: up to %g",
                    contour->spec->key, at.position[0], at.position[1],
                    at.reach[axis] * state->grid.inverse_cell[axis], axis_names[axis],
                    LONGEST_REACH);
    }
    return MPM_OK;
}

static struct mpm_j_particle carried_by(const struct mpm_j_contour *contour, size_t p)
{
    const struct mpm_particles *const particles = &contour->state->particles;
    const struct mpm_body *const body = &contour->state->bodies[particles->body[p]];
    const double density = body->material.density;
    struct mpm_j_particle made = {
        .p = p,
        .place = {particles->position[0][p], particles->position[1][p]},
        .v = {particles->velocity[0][p], particles->velocity[1][p]},
        .area = 4.0 * body->half_size[0] * body->half_size[1],
        .density = density,
    };
    mpm_particle_deformation(particles, p, made.f);
    for (int k = 0; k < MPM_SYMMETRIC_SIZE; k++)
        made.tau[k] = density * particles->stress[k][p];
    made.plane = made.f[MPM_XX] * made.f[MPM_YY] - made.f[MPM_XY] * made.f[MPM_YX];
    made.energy = density * mpm_particle_strain_energy(contour->state, p);
    if (particles->free_strain != NULL)
        made.free_strain = particles->free_strain[p];
    if (contour->spec->dynamic)
        made.energy += 0.5 * density * (made.v[0] * made.v[0] + made.v[1] * made.v[1]);
    return made;
}

static void add_to_sums(const struct mpm_state *state, const struct mpm_j_particle *own,
                        const struct mpm_stencil_node *entry, struct mpm_j_sums *sums)
{
    const double weight = own->area * own->plane * entry->s, inverse = weight / own->plane;
    const double mass = state->particles.mass[own->p];
    const double loaded = mass / own->density;
    sums->area += weight;
    sums->stress[0] += inverse * own->tau[MPM_SYM_XX];
    sums->stress[1] += inverse * own->tau[MPM_SYM_YY];
    sums->stress[2] += inverse * own->tau[MPM_SYM_XY];
    sums->energy += inverse * own->energy;
    sums->free_strain += weight * own->free_strain;
    for (int k = 0; k < MPM_GRADIENT_SIZE; k++)
        sums->gradient[k] += weight * (own->f[k] - (k == MPM_XY || k == MPM_YX ? 0.0 : 1.0));
    sums->mass += mass * entry->s;
    sums->momentum[0] += mass * entry->s * own->v[0];
    sums->momentum[1] += mass * entry->s * own->v[1];
    sums->force[0] -=
        loaded * (own->tau[MPM_SYM_XX] * entry->g[0] + own->tau[MPM_SYM_XY] * entry->g[1] +
                  own->tau[MPM_SYM_ZZ] * entry->t);
    sums->force[1] -=
        loaded * (own->tau[MPM_SYM_XY] * entry->g[0] + own->tau[MPM_SYM_YY] * entry->g[1]);
}

/* Of a stencil's node: its column and row. False: not one of those that are stored. */
static bool find_node(const struct mpm_j_contour *contour, const struct mpm_stencil_node *entry,
                      int64_t at[2])
{
    const struct mpm_state *const state = contour->state;
    const int64_t node = state->node_zero + entry->node;
    at[0] = node % state->grid.columns;
    at[1] = node / state->grid.columns;
    return mpm_j_is_within(contour, at, MPM_J_MARGIN);
}

static struct mpm_j_sums *sums_for(const struct mpm_j_contour *contour,
                                   const struct mpm_j_particle *own, const int64_t at[2])
{
    double place[2];
    mpm_j_place(contour, at, place);
    return &mpm_j_node_at(contour, at)->side[mpm_j_side(contour, own->place, place, NULL)];
}

/* One law and one set of constants, that of the first particle that reaches the contour. */
struct material_search {
    bool found;
    size_t material; /* of the scene */
    size_t body;
};

static enum mpm_status check_material(const struct mpm_j_contour *contour, size_t p,
                                      struct material_search *search, struct mpm_error *error)
{
    const struct mpm_state *const state = contour->state;
    const size_t body = state->particles.body[p];
    const size_t material = state->scene->bodies[body].material;
    if (!search->found)
        *search = (struct material_search){true, material, body};
    if (search->material == material)
        return MPM_OK;
    return mpm_error_set(error, MPM_RUN_FAILED,
                         "%s: the contour surrounds or meets two materials, %s and %s; allowed: "
                         "one",
                         contour->spec->key, state->scene->materials[search->material].name,
                         state->scene->materials[material].name);
}

static enum mpm_status gather(const struct mpm_j_contour *contour, struct material_search *search,
                              struct mpm_error *error)
{
    const struct mpm_state *const state = contour->state;
    const struct mpm_crack_box box = box_around(contour, PARTICLE_MARGIN);
    for (size_t p = 0; p < state->particles.count; p++) {
        const double x = state->particles.position[0][p], y = state->particles.position[1][p];
        if (!(x > box.low[0] && x < box.high[0] && y > box.low[1] && y < box.high[1]) ||
            !mpm_cracks_cut(state, p))
            continue;
        struct mpm_stencil stencil;
        const struct mpm_j_particle own = carried_by(contour, p);
        mpm_particle_plain_stencil(state, p, &stencil);
        for (int k = 0; k < stencil.count; k++) {
            int64_t at[2];
            if (!find_node(contour, &stencil.node[k], at))
                continue;
            if (mpm_j_is_within(contour, at, 0))
                MPM_TRY(check_material(contour, p, search, error));
            add_to_sums(state, &own, &stencil.node[k], sums_for(contour, &own, at));
        }
    }
    return MPM_OK;
}

/* -------------------------------------------------------------- area terms */

/* Inside 1, on an edge of the rectangle 1/2, at a corner 1/4, outside 0. */
static double share_of(const struct mpm_j_contour *contour, const int64_t at[2])
{
    double share = mpm_j_is_within(contour, at, 0) ? 1.0 : 0.0;
    for (int axis = 0; axis < 2; axis++)
        if (at[axis] == contour->low[axis] || at[axis] == contour->high[axis])
            share *= 0.5;
    return share;
}

/* Values of the nodes at a particle. */
struct nodal {
    double share;        /* of it inside the contour */
    double force[2];     /* per mass: a - b */
    double gradient[4];  /* of the velocity, at the particle: xx xy yx yy */
    double expansion[2]; /* gradient of the free strain, in the undeformed body */
};

static struct nodal nodal_values(const struct mpm_j_contour *contour,
                                 const struct mpm_j_particle *own)
{
    struct mpm_stencil stencil;
    struct nodal nodal = {.share = 0.0};
    double expansion[2] = {0.0, 0.0};
    mpm_particle_plain_stencil(contour->state, own->p, &stencil);
    for (int k = 0; k < stencil.count; k++) {
        const struct mpm_stencil_node *const entry = &stencil.node[k];
        int64_t at[2];
        if (!find_node(contour, entry, at))
            continue;
        const struct mpm_j_sums *const sums = sums_for(contour, own, at);
        nodal.share += share_of(contour, at) * entry->s;
        if (!(sums->mass > 0.0)) /* no weight on it: of a particle on a line of nodes */
            continue;
        for (int i = 0; i < 2; i++) {
            nodal.force[i] += entry->s * sums->force[i] / sums->mass;
            nodal.gradient[2 * i] += entry->g[0] * sums->momentum[i] / sums->mass;
            nodal.gradient[2 * i + 1] += entry->g[1] * sums->momentum[i] / sums->mass;
            expansion[i] += entry->g[i] * sums->free_strain / sums->area;
        }
    }
    for (int k = 0; k < 2; k++)
        nodal.expansion[k] = own->f[k] * expansion[0] + own->f[2 + k] * expansion[1];
    return nodal;
}

/* (F - C)_ik */
static double slope_of(const struct mpm_j_contour *contour, const struct mpm_j_particle *own, int i,
                       int k)
{
    return own->f[2 * i + k] - (i == k ? 1.0 : 0.0) - contour->common[2 * i + k];
}

/* rho_0 [ (a - b)_i (F - C)_ik - v_i v_i,k ] */
static void dynamic_term(const struct mpm_j_contour *contour, const struct mpm_j_particle *own,
                         const struct nodal *nodal, double term[2])
{
    for (int k = 0; k < 2; k++) {
        const double *const l = nodal->gradient;
        double sum = 0.0;
        for (int i = 0; i < 2; i++) {
            const double u = slope_of(contour, own, i, k);
            const double v = l[2 * i] * own->f[k] + l[2 * i + 1] * own->f[2 + k];
            sum += nodal->force[i] * u - own->v[i] * v;
        }
        term[k] = own->density * sum;
    }
}

/* P_tt (delta_kR u/R - (C - I)_Rk) */
static void hoop_term(const struct mpm_j_contour *contour, const struct mpm_j_particle *own,
                      double term[2])
{
    const double stretch = own->f[MPM_ZZ];
    for (int k = 0; k < 2; k++)
        term[k] =
            own->tau[MPM_SYM_ZZ] / stretch * ((k == 0 ? stretch - 1.0 : 0.0) - contour->common[k]);
}

/* 1/R P_iR (F - C)_ik */
static void broberg_term(const struct mpm_j_contour *contour, const struct mpm_j_particle *own,
                         double radius, double term[2])
{
    const double *const f = own->f, *const tau = own->tau;
    const double stress[2] = {
        (tau[MPM_SYM_XX] * f[MPM_YY] - tau[MPM_SYM_XY] * f[MPM_XY]) / own->plane,
        (tau[MPM_SYM_XY] * f[MPM_YY] - tau[MPM_SYM_YY] * f[MPM_XY]) / own->plane,
    };
    for (int k = 0; k < 2; k++)
        term[k] =
            (stress[0] * slope_of(contour, own, 0, k) + stress[1] * slope_of(contour, own, 1, k)) /
            radius;
}

/* What the divergence in polar coordinates leaves behind, and the weight of all else: R/a or 1. */
static double curved_term(const struct mpm_j_contour *contour, const struct mpm_j_particle *own,
                          double term[2])
{
    const double radius = own->place[0] / own->f[MPM_ZZ], front = contour->tip->place[0];
    const bool weighted = contour->spec->form == MPM_J_BERGKVIST_HUONG;
    double hoop[2];
    term[0] = term[1] = 0.0;
    if (contour->spec->form == MPM_J_CONTOUR)
        return 1.0;
    if (weighted)
        term[0] = own->energy / front;
    else
        broberg_term(contour, own, radius, term);
    hoop_term(contour, own, hoop);
    for (int k = 0; k < 2; k++)
        term[k] -= hoop[k] / (weighted ? front : radius);
    return weighted ? radius / front : 1.0;
}

/* Adds what a particle gives to J, in its area terms, and to K_I and K_II. */
static void add_area(const struct mpm_j_contour *contour, const struct mpm_tip_frame *frame,
                     size_t p, double j[2], struct mpm_intensity_sums *sums)
{
    const struct mpm_j_integral_spec *const spec = contour->spec;
    const struct mpm_j_particle own = carried_by(contour, p);
    struct nodal nodal = {.share = 0.0};
    const double *const tau = own.tau;
    const double trace = tau[MPM_SYM_XX] + tau[MPM_SYM_YY] + tau[MPM_SYM_ZZ];
    const bool expands = contour->state->particles.free_strain != NULL;
    double curved[2] = {0.0, 0.0}, dynamic[2] = {0.0, 0.0}, weight = 1.0;
    if (spec->dynamic || expands || spec->form != MPM_J_CONTOUR)
        nodal = nodal_values(contour, &own);
    if (nodal.share > 0.0)
        weight = curved_term(contour, &own, curved);
    if (nodal.share > 0.0 && spec->dynamic)
        dynamic_term(contour, &own, &nodal, dynamic);
    for (int k = 0; k < 2; k++) {
        const double changes = dynamic[k] + trace * nodal.expansion[k];
        j[k] += nodal.share * own.area * (weight * changes - curved[k]);
        nodal.force[k] = spec->dynamic ? nodal.force[k] : 0.0;
    }
    mpm_stress_intensity_add(frame, &own, nodal.force, nodal.expansion, sums);
}

/* Particles outside of the contour by less than their reach have a share as well. */
static void integrate_area(const struct mpm_j_contour *contour, const struct mpm_tip_frame *frame,
                           double j[2], struct mpm_intensity_sums *sums)
{
    const struct mpm_particles *const particles = &contour->state->particles;
    const struct mpm_crack_box box = box_around(contour, MPM_J_MARGIN);
    for (size_t p = 0; p < particles->count; p++) {
        const double x = particles->position[0][p], y = particles->position[1][p];
        if (x > box.low[0] && x < box.high[0] && y > box.low[1] && y < box.high[1])
            add_area(contour, frame, p, j, sums);
    }
}

enum mpm_status mpm_j_evaluate(const struct mpm_state *state,
                               const struct mpm_j_integral_spec *spec, const struct mpm_j_tip *tip,
                               const struct mpm_j_scratch *scratch, struct mpm_j_value *value,
                               struct mpm_error *error)
{
    struct mpm_j_contour contour = {
        .state = state,
        .spec = spec,
        .tip = tip,
        .nodes = scratch->nodes,
        .parts = scratch->parts,
    };
    struct material_search search = {.found = false};
    struct mpm_intensity_sums sums = {.body = {0.0, 0.0}};
    double j[2];
    value->met = SIZE_MAX;
    MPM_TRY(place_contour(&contour, error));
    const struct mpm_crack_box box = box_around(&contour, PARTICLE_MARGIN);
    for (size_t k = 0; k < state->scene->crack_count; k++)
        if (!mpm_crack_part_near(&state->cracks.chains[k], &box, state->cracks.map->slack,
                                 &contour.parts[k]))
            contour.parts[k] = (struct mpm_crack_part){.first = 0, .end = 0};
    MPM_TRY(check_reach(&contour, error));
    memset(contour.nodes, 0, mpm_j_nodes(spec) * sizeof *contour.nodes);
    MPM_TRY(gather(&contour, &search, error));
    mpm_j_contour_find_common(&contour);
    MPM_TRY(mpm_j_contour_integrate(&contour, j, &value->met, error));
    MPM_TRY(check_alone(&contour, &value->met, error));
    const struct mpm_material *const material = &state->bodies[search.body].material;
    const struct mpm_tip_frame frame = mpm_tip_frame_of(
        &contour, material->density * material->bulk, material->density * material->shear);
    integrate_area(&contour, &frame, j, &sums);
    mpm_stress_intensity_add_faces(&frame, &sums);
    const double *const d = tip->direction;
    value->j[0] = d[0] * j[0] + d[1] * j[1];
    value->j[1] = d[0] * j[1] - d[1] * j[0];
    mpm_stress_intensity_find(&frame, &sums, value->stress_intensity);
    if (!isfinite(value->j[0]) || !isfinite(value->j[1]))
        return mpm_error_set(error, MPM_RUN_FAILED, "%s: J is not finite: %g, %g", spec->key,
                             value->j[0], value->j[1]);
    return MPM_OK;
}
