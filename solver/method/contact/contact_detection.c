/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/contact/contact_detection.h"

#include "method/contact/contact_sums.h"
#include "method/contact/displacement_fit.h"

#include <math.h>

bool mpm_contact_needs_edges(const struct mpm_contact_spec *spec)
{
    if (spec->cracked_field != MPM_NO_FIELD)
        return true;
    for (size_t k = 0; k < spec->pair_count; k++)
        if (spec->pairs[k].detection == MPM_TOUCH_EXTENT ||
            spec->pairs[k].law == MPM_PAIR_INTERFACE)
            return true;
    return false;
}

double mpm_node_seen_length(const struct mpm_state *state, int64_t node, int axis)
{
    const struct mpm_grid *const grid = &state->grid;
    const int64_t columns = grid->columns;
    const int64_t place = axis == 0 ? node % columns : node / columns;
    const int64_t first = MPM_GHOST_ROWS, last = MPM_GHOST_ROWS + grid->cells[axis];
    const int64_t zero = axis == 0 && state->shape_grid.axisymmetric
                             ? llround(-grid->origin[0] * grid->inverse_cell[0]) + first
                             : first;
    const int64_t low = zero > first ? zero : first;
    const double past = state->family->past_next;
    if (place <= low || place >= last) /* on a plane of symmetry too */
        return 0.5 + 2.0 * past;
    for (size_t k = 0; k < state->symmetries.count; k++)
        if (state->symmetries.planes[k].axis == axis && state->symmetries.planes[k].line == place)
            return 0.5;
    return place == low + 1 || place == last - 1 ? 1.0 - 2.0 * past : 1.0;
}

/* Of a limit: closer to it round-off must not decide. */
static const double EVEN = 1e-9;
/* Of a cell: as near to another body is the surface of a side of a crack that touches it. */
static const double BESIDE = 0.5;

static double area_of(const struct mpm_contact_pair *pair, const struct mpm_contact_sums *one,
                      const struct mpm_contact_sums *other)
{
    const double *const n = pair->normal;
    const double first = n[0] * one->surface[0] + n[1] * one->surface[1];
    const double second = -n[0] * other->surface[0] - n[1] * other->surface[1];
    return fmax(fmin(first, second), 0.0);
}

/* A vector along the normal and along the surface. */
static void turn(const double n[2], const double by[2], double turned[2])
{
    turned[0] = by[0] * n[0] + by[1] * n[1];
    turned[1] = by[1] * n[0] - by[0] * n[1];
}

/* At the place of the surface that is nearest to the node. */
static void find_jump(const struct mpm_state *state, struct mpm_contact_pair *pair,
                      const struct mpm_contact_sums *one, const struct mpm_contact_sums *other)
{
    const double *const n = pair->normal;
    const double away = 0.5 * (pair->edge[0] + pair->edge[1]);
    const double surface[2] = {away * n[0], away * n[1]};
    const double unit = fmin(state->grid.cell[0], state->grid.cell[1]);
    const struct mpm_displacement_fit first =
                                          mpm_displacement_fit(&one->displacement, unit, surface),
                                      second =
                                          mpm_displacement_fit(&other->displacement, unit, surface);
    double jump[2];
    mpm_displacement_jump(&first, &second, jump);
    turn(n, jump, pair->jump);
    turn(n, (const double[2]){second.v[0] - first.v[0], second.v[1] - first.v[1]}, pair->rate);
}

static bool fills_cell(const struct mpm_state *state, const struct mpm_contact_node *node,
                       const struct mpm_contact_pair *pair, double limit)
{
    const double *const cell = state->grid.cell;
    const double whole = cell[0] * mpm_node_seen_length(state, node->node, 0) * cell[1] *
                         mpm_node_seen_length(state, node->node, 1);
    struct mpm_contact_sums room;
    double seen = 0.0;
    for (int k = 0; k < 2; k++)
        seen += mpm_contact_whole_sums(state, node, pair->fields[k], &room)->seen;
    return seen >= (1.0 - EVEN) * limit * whole;
}

/* A field that reaches the node by round-off alone has no edge there: contact_sums.h. */
static bool has_edges(const struct mpm_contact_pair *pair)
{
    return pair->edge[0] > -HUGE_VAL && pair->edge[1] < HUGE_VAL;
}

/* Is the surface of a crack's side near the other body, or is the crack between them? Beside a
 * body's edge the normal may be along the surface, where the places that both fill decide. */
static bool is_behind_crack(const struct mpm_state *state, const struct mpm_contact_pair *pair)
{
    const struct mpm_contact_field *const one = &state->contact.fields[pair->fields[0]];
    const struct mpm_contact_field *const other = &state->contact.fields[pair->fields[1]];
    const double *const n = pair->normal, *const cell = state->grid.cell, *const jump = pair->jump;
    const double opened[2] = {jump[0] * n[0] - jump[1] * n[1], jump[0] * n[1] + jump[1] * n[0]};
    const double gap = pair->edge[1] - pair->edge[0] - jump[0];
    bool beside = gap <= BESIDE * hypot(n[0] * cell[0], n[1] * cell[1]);
    for (int axis = 0; axis < 2; axis++) {
        const double apart =
            fmax(other->low[axis] - one->high[axis], one->low[axis] - other->high[axis]);
        beside = beside && apart - fabs(opened[axis]) <= BESIDE * cell[axis];
    }
    return !beside;
}

static void detect(const struct mpm_state *state, const struct mpm_contact_node *node,
                   struct mpm_contact_pair *pair)
{
    const struct mpm_pair_spec *const spec = &mpm_contact_spec(state)->pairs[pair->spec];
    const struct mpm_contact_sums *const one = &state->contact.fields[pair->fields[0]].sums;
    const struct mpm_contact_sums *const other = &state->contact.fields[pair->fields[1]].sums;
    if (spec->law == MPM_PAIR_INTERFACE && !has_edges(pair))
        pair->has_normal = false;
    pair->touches = pair->has_normal || spec->law == MPM_PAIR_BONDED;
    pair->gap = 0.0;
    if (!pair->has_normal)
        return;
    pair->area = area_of(pair, one, other);
    if (spec->law == MPM_PAIR_INTERFACE)
        find_jump(state, pair, one, other);
    if (node->cut && is_behind_crack(state, pair))
        pair->touches = pair->has_normal = false;
    else if (spec->law == MPM_PAIR_INTERFACE || spec->law == MPM_PAIR_BONDED ||
             spec->detection == MPM_TOUCH_SHARED)
        return;
    else if (spec->detection == MPM_TOUCH_VOLUME)
        pair->touches = fills_cell(state, node, pair, spec->touching);
    else
        pair->gap = pair->edge[1] - pair->edge[0];
}

void mpm_contact_detect(struct mpm_state *state)
{
    for (size_t k = 0; k < state->contact.node_count; k++) {
        const struct mpm_contact_node *const node = &state->contact.nodes[k];
        for (uint32_t i = node->first_pair; i < node->first_pair + node->pairs; i++)
            detect(state, node, &state->contact.pairs[i]);
    }
}
