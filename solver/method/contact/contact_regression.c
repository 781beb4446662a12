/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/contact/contact_regression.h"

#include "base/strips.h"
#include "method/contact/contact_particles.h"
#include "method/contact/contact_sums.h"

#include <math.h>
#include <string.h>

/* Below this part of the product of its diagonal a determinant is round-off: no plane. */
static const double SINGULAR = 1e-10;

/* Solves for c with the symmetric matrix of {00, 01, 02, 11, 12, 22}; false: singular. */
static bool solve_plane(const double m[6], const double r[3], double singular, double c[3])
{
    const double a = m[0], b = m[1], d = m[2], e = m[3], f = m[4], g = m[5];
    const double minor[3] = {e * g - f * f, d * f - b * g, b * f - d * e};
    const double determinant = a * minor[0] + b * minor[1] + d * minor[2];
    if (!(determinant > singular * a * e * g))
        return false;
    c[0] = (minor[0] * r[0] + minor[1] * r[1] + minor[2] * r[2]) / determinant;
    c[1] = (minor[1] * r[0] + (a * g - d * d) * r[1] + (b * d - a * f) * r[2]) / determinant;
    c[2] = (minor[2] * r[0] + (b * d - a * f) * r[1] + (a * e - b * b) * r[2]) / determinant;
    return true;
}

bool mpm_contact_linear_plane(const struct mpm_contact_sums *first,
                              const struct mpm_contact_sums *second, double c[3])
{
    double m[6], r[3];
    for (int k = 0; k < 6; k++)
        m[k] = first->moments[k] + second->moments[k];
    for (int k = 0; k < 3; k++)
        r[k] = second->moments[k] - first->moments[k];
    return solve_plane(m, r, SINGULAR, c);
}

double mpm_contact_plane_normal(const struct mpm_grid *grid, const double c[3], double normal[2])
{
    const double *const scale = grid->inverse_cell;
    for (int axis = 0; axis < 2; axis++)
        normal[axis] = c[1 + axis] * scale[axis];
    return fmin(scale[0], scale[1]);
}

/* ------------------------------------------------------------------ logistic */

static const double LAMBDA = 1e-7;
/* Newton's steps, and the change of c at which they end. */
enum { STEPS = 100 };
static const double CONVERGED = 1e-10;
/* The longest step: of steeper planes the sums are round-off. */
static const double LONGEST = 8.0;

/* Gradient and second derivatives of a pair's sum, at its plane. */
static void add_to_plane(const double terms[3], double sign, double weight,
                         struct mpm_contact_plane *plane)
{
    const double phi = plane->c[0] + plane->c[1] * terms[1] + plane->c[2] * terms[2];
    const double missed = 1.0 / (1.0 + exp(sign * phi));
    const double slope = weight * missed * (1.0 - missed);
    for (int k = 0; k < 3; k++)
        plane->slope[k] -= weight * sign * missed * terms[k];
    plane->curvature[0] += slope;
    plane->curvature[1] += slope * terms[1];
    plane->curvature[2] += slope * terms[2];
    plane->curvature[3] += slope * terms[1] * terms[1];
    plane->curvature[4] += slope * terms[1] * terms[2];
    plane->curvature[5] += slope * terms[2] * terms[2];
}

static void add_particle(struct mpm_state *state, const struct mpm_contact_particle *particle,
                         const double from[2], struct mpm_contact_node *node)
{
    const double *const scale = state->grid.inverse_cell;
    const double weight = particle->area * scale[0] * scale[1];
    const double terms[3] = {1.0, from[0] * scale[0], from[1] * scale[1]};
    for (uint32_t k = node->first_pair; k < node->first_pair + node->pairs; k++) {
        const struct mpm_contact_pair *const pair = &state->contact.pairs[k];
        struct mpm_contact_plane *const plane = &state->contact.planes[k];
        for (int side = 0; side < 2 && plane->moves; side++)
            if (state->contact.fields[pair->fields[side]].field == particle->field)
                add_to_plane(terms, side == 0 ? -1.0 : 1.0, weight, plane);
    }
}

static void add_strip(void *context, int64_t index, int worker)
{
    (void)worker;
    mpm_contact_strip_visit(context, index, true, add_particle);
}

static void add_rigid(struct mpm_state *state, const struct mpm_contact_particle *particle,
                      const struct mpm_stencil *stencil)
{
    mpm_contact_stencil_visit(state, particle, stencil, add_particle);
}

static void begin_plane(const struct mpm_state *state, const struct mpm_contact_node *node,
                        uint32_t k)
{
    const struct mpm_contact_pair *const pair = &state->contact.pairs[k];
    struct mpm_contact_plane *const plane = &state->contact.planes[k];
    struct mpm_contact_sums room[2];
    *plane = (struct mpm_contact_plane){.moves = false};
    plane->moves = mpm_contact_spec(state)->pairs[pair->spec].normal == MPM_NORMAL_LOGISTIC &&
                   mpm_contact_linear_plane(
                       mpm_contact_whole_sums(state, node, pair->fields[0], &room[0]),
                       mpm_contact_whole_sums(state, node, pair->fields[1], &room[1]), plane->c);
    plane->logistic = plane->moves;
}

/* On planes of symmetry the whole model has nothing that is odd across them. */
static void clear_odd(struct mpm_contact_plane *plane, int axis)
{
    plane->slope[1 + axis] = 0.0;
    plane->curvature[1 + axis] = plane->curvature[4] = 0.0;
}

/* One step; returns whether the plane has changed. */
static bool step_plane(struct mpm_contact_plane *plane)
{
    double step[3], right[3], largest = 0.0;
    plane->curvature[3] += LAMBDA;
    plane->curvature[5] += LAMBDA;
    for (int k = 0; k < 3; k++)
        right[k] = -plane->slope[k] - (k > 0 ? LAMBDA * plane->c[k] : 0.0);
    if (!solve_plane(plane->curvature, right, 0.0, step))
        return false;
    for (int k = 0; k < 3; k++)
        largest = fmax(largest, fabs(step[k]));
    for (int k = 0; k < 3; k++) {
        plane->c[k] += largest > LONGEST ? step[k] * LONGEST / largest : step[k];
        plane->slope[k] = 0.0;
    }
    memset(plane->curvature, 0, sizeof plane->curvature);
    return largest > CONVERGED;
}

/* Pair by pair what the particles at a node beyond a plane of symmetry add at the one inside; or
 * the plane of the one inside, mirrored. */
static void share_planes(struct mpm_state *state, int axis, const struct mpm_contact_node *inside,
                         const struct mpm_contact_node *beyond, bool back)
{
    for (uint32_t i = 0; i < inside->pairs * (uint32_t)beyond->pairs; i++) {
        const uint32_t k = inside->first_pair + i / beyond->pairs;
        const uint32_t m = beyond->first_pair + i % beyond->pairs;
        struct mpm_contact_plane *const one = &state->contact.planes[k];
        struct mpm_contact_plane *const other = &state->contact.planes[m];
        if (!mpm_contact_is_image(state, &state->contact.pairs[k], &state->contact.pairs[m]))
            continue;
        other->moves = one->moves;
        for (int n = 0; n < 3 && back; n++)
            other->c[n] = n == 1 + axis ? -one->c[n] : one->c[n];
        for (int n = 0; n < 3 && !back; n++)
            one->slope[n] += n == 1 + axis ? -other->slope[n] : other->slope[n];
        for (int n = 0; n < 6 && !back; n++)
            one->curvature[n] +=
                n == 1 + axis || n == 4 ? -other->curvature[n] : other->curvature[n];
    }
}

static void fold_planes(struct mpm_state *state, int axis, struct mpm_contact_node *inside,
                        const struct mpm_contact_node *beyond)
{
    share_planes(state, axis, inside, beyond, false);
}

static void mirror_planes(struct mpm_state *state, int axis, struct mpm_contact_node *inside,
                          const struct mpm_contact_node *beyond)
{
    share_planes(state, axis, inside, beyond, true);
}

static bool step_all(struct mpm_state *state)
{
    bool any = false;
    mpm_contact_images_visit(state, fold_planes);
    for (size_t k = 0; k < state->contact.node_count; k++) {
        const struct mpm_contact_node *const node = &state->contact.nodes[k];
        for (uint32_t i = node->first_pair; i < node->first_pair + node->pairs; i++) {
            struct mpm_contact_plane *const plane = &state->contact.planes[i];
            for (int axis = 0; axis < 2 && plane->moves; axis++)
                if (mpm_contact_is_on_plane(state, node->node, axis))
                    clear_odd(plane, axis);
            plane->moves = plane->moves && step_plane(plane);
            any = any || plane->moves;
        }
    }
    mpm_contact_images_visit(state, mirror_planes);
    return any;
}

void mpm_contact_logistic_find(struct mpm_state *state, int workers)
{
    bool any = state->contact.pair_count > 0;
    for (size_t i = 0; i < state->contact.node_count; i++) {
        const struct mpm_contact_node *const node = &state->contact.nodes[i];
        for (uint32_t k = node->first_pair; k < node->first_pair + node->pairs; k++)
            begin_plane(state, node, k);
    }
    mpm_contact_images_visit(state, mirror_planes);
    for (int k = 0; k < STEPS && any; k++) {
        mpm_strips_run(state->strip_count, workers, add_strip, state);
        mpm_contact_rigid_run(state, add_rigid);
        any = step_all(state);
    }
}
