/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/contact/contact_regression.h"

#include "base/strips.h"
#include "method/contact/contact_particles.h"
#include "method/contact/contact_sums.h"

#include <math.h>

/* Below this part of the product of its diagonal a determinant is round-off: no plane. */
static const double SINGULAR = 1e-10;

bool mpm_contact_linear_plane(const struct mpm_contact_sums *first,
                              const struct mpm_contact_sums *second, double c[3])
{
    double m[6], r[3];
    for (int k = 0; k < 6; k++)
        m[k] = first->moments[k] + second->moments[k];
    for (int k = 0; k < 3; k++)
        r[k] = second->moments[k] - first->moments[k];
    return mpm_solve_plane(m, r, SINGULAR, c);
}

double mpm_contact_plane_normal(const struct mpm_grid *grid, const double c[3], double normal[2])
{
    const double *const scale = grid->inverse_cell;
    for (int axis = 0; axis < 2; axis++)
        normal[axis] = c[1 + axis] * scale[axis];
    return fmin(scale[0], scale[1]);
}

/* ------------------------------------------------------------------ logistic */

/* Of Newton's method, halved ones too. */
enum { STEPS = 200 };

static void add_particle(struct mpm_state *state, const struct mpm_contact_particle *particle,
                         const double from[2], struct mpm_contact_node *node)
{
    const double *const scale = state->grid.inverse_cell;
    const double weight = particle->area * scale[0] * scale[1];
    const double terms[3] = {1.0, from[0] * scale[0], from[1] * scale[1]};
    for (uint32_t k = node->first_pair; k < node->first_pair + node->pairs; k++) {
        const struct mpm_contact_pair *const pair = &state->contact.pairs[k];
        struct mpm_logistic_plane *const plane = &state->contact.planes[k];
        for (int side = 0; side < 2 && plane->moves; side++)
            if (state->contact.fields[pair->fields[side]].field == particle->field)
                mpm_logistic_add(plane, terms, side == 0 ? -1.0 : 1.0, weight);
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
    struct mpm_logistic_plane *const plane = &state->contact.planes[k];
    struct mpm_contact_sums room[2];
    double c[3];
    *plane = (struct mpm_logistic_plane){.used = false};
    if (mpm_contact_spec(state)->pairs[pair->spec].normal == MPM_NORMAL_LOGISTIC &&
        mpm_contact_linear_plane(mpm_contact_whole_sums(state, node, pair->fields[0], &room[0]),
                                 mpm_contact_whole_sums(state, node, pair->fields[1], &room[1]), c))
        *plane = mpm_logistic_begin(c);
}

/* On planes of symmetry the whole model has nothing that is odd across them. */
static void clear_odd(struct mpm_logistic_plane *plane, int axis)
{
    plane->slope[1 + axis] = 0.0;
    plane->curvature[1 + axis] = plane->curvature[4] = 0.0;
}

/* Pair by pair what the particles at a node beyond a plane of symmetry add at the one inside; or
 * the plane of the one inside, mirrored. */
static void share_planes(struct mpm_state *state, int axis, const struct mpm_contact_node *inside,
                         const struct mpm_contact_node *beyond, bool back)
{
    for (uint32_t i = 0; i < inside->pairs * (uint32_t)beyond->pairs; i++) {
        const uint32_t k = inside->first_pair + i / beyond->pairs;
        const uint32_t m = beyond->first_pair + i % beyond->pairs;
        struct mpm_logistic_plane *const one = &state->contact.planes[k];
        struct mpm_logistic_plane *const other = &state->contact.planes[m];
        if (!mpm_contact_is_image(state, &state->contact.pairs[k], &state->contact.pairs[m]))
            continue;
        other->moves = one->moves;
        one->value += back ? 0.0 : other->value;
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
            struct mpm_logistic_plane *const plane = &state->contact.planes[i];
            for (int axis = 0; axis < 2 && plane->moves; axis++)
                if (mpm_contact_is_on_plane(state, node->node, axis))
                    clear_odd(plane, axis);
            if (plane->moves)
                mpm_logistic_step(plane);
            any = any || plane->moves;
        }
    }
    mpm_contact_images_visit(state, mirror_planes);
    return any;
}

static enum mpm_status report_moving(const struct mpm_state *state, struct mpm_error *error)
{
    const struct mpm_body_contact *const contact = &state->contact;
    for (size_t i = 0; i < contact->node_count; i++) {
        const struct mpm_contact_node *const node = &contact->nodes[i];
        double at[2];
        mpm_grid_position(&state->grid, node->node, at);
        for (uint32_t k = node->first_pair; k < node->first_pair + node->pairs; k++)
            if (contact->planes[k].moves)
                return mpm_error_set(error, MPM_RUN_FAILED,
                                     "%s.normal: logistic regression has no plane at (%g, %g) "
                                     "after %d steps; allowed: another normal, linear is near it",
                                     mpm_contact_spec(state)->pairs[contact->pairs[k].spec].key,
                                     at[0], at[1], STEPS);
    }
    return MPM_OK;
}

enum mpm_status mpm_contact_logistic_find(struct mpm_state *state, int workers,
                                          struct mpm_error *error)
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
    return any ? report_moving(state, error) : MPM_OK;
}
