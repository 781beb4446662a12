/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/transport/transport_exchange.h"

#include "method/grid/grid_update.h"
#include "method/transport/scalar_exchange.h"
#include "method/transport/scalar_nodes.h"

/* ------------------------------------------------------------------------ a node */

/* A node with the fields of its passages. */
struct node {
    struct mpm_scalar_meeting meeting;
    int64_t fields[MPM_CONTACT_SIDES];
    bool settles[MPM_CONTACT_SIDES];
    struct mpm_scalar_passage *passages;
};

/* The place of a field among those of the node, where it is put if it is not there. */
static int side_of(const struct mpm_nodal_scalar *scalar, struct node *node, int64_t field)
{
    struct mpm_scalar_meeting *const meeting = &node->meeting;
    for (int k = 0; k < meeting->side_count; k++)
        if (node->fields[k] == field)
            return k;
    node->fields[meeting->side_count] = field;
    meeting->sides[meeting->side_count] = (struct mpm_scalar_side){
        .capacity = scalar->capacity[field],
        .content = scalar->content[field],
        .inflow = scalar->inflow[field],
    };
    node->settles[meeting->side_count] = false;
    return meeting->side_count++;
}

static bool has_capacity(const struct mpm_nodal_scalar *scalar,
                         const struct mpm_scalar_passage *passage)
{
    return scalar->capacity[passage->fields[0]] > 0.0 && scalar->capacity[passage->fields[1]] > 0.0;
}

/* Those of one node from place `first` on; returns the place of the next one's. */
static size_t collect(const struct mpm_nodal_scalar *scalar, size_t first, struct node *node)
{
    struct mpm_scalar_meeting *const meeting = &node->meeting;
    size_t k = first;
    meeting->side_count = meeting->link_count = 0;
    node->passages = &scalar->passages[first];
    for (; k < scalar->passage_count && scalar->passages[k].node == node->passages->node; k++) {
        const struct mpm_scalar_passage *const passage = &scalar->passages[k];
        struct mpm_scalar_link link = {{0, 0}, passage->perfect, passage->conductance, 0.0};
        for (int end = 0; end < 2 && has_capacity(scalar, passage); end++) {
            link.of[end] = side_of(scalar, node, passage->fields[end]);
            meeting->sides[link.of[end]].settling = passage->settling[end];
            node->settles[link.of[end]] = node->settles[link.of[end]] || passage->settles;
        }
        if (!has_capacity(scalar, passage)) /* passes nothing from a field to itself */
            link = (struct mpm_scalar_link){{0, 0}, true, 0.0, 0.0};
        meeting->links[meeting->link_count++] = link;
    }
    if (meeting->side_count > 0)
        mpm_scalar_meeting_join(meeting);
    return k;
}

/* Does the field follow another one? */
static bool is_one_of_several(const struct mpm_scalar_meeting *meeting, int side)
{
    for (int k = 0; k < meeting->side_count; k++)
        if (k != side && meeting->group[k] == meeting->group[side])
            return true;
    return false;
}

/* ------------------------------------------------------------------ of the step */

void mpm_scalar_exchange_values(const struct mpm_state *state,
                                const struct mpm_nodal_scalar *scalar)
{
    struct node node;
    for (size_t k = 0; k < scalar->passage_count;) {
        k = collect(scalar, k, &node);
        for (int i = 0; i < node.meeting.side_count; i++) {
            const double value = node.meeting.sides[i].value;
            if (!is_one_of_several(&node.meeting, i))
                continue;
            mpm_scalar_set(state, scalar->value, node.fields[i], value);
        }
    }
}

/* Numbers of fields that are one, in `result`: their sum. */
static void add_up(const struct mpm_state *state, const struct mpm_nodal_scalar *scalar,
                   const struct node *node)
{
    const struct mpm_scalar_meeting *const meeting = &node->meeting;
    double sums[MPM_CONTACT_SIDES] = {0.0};
    for (int i = 0; i < meeting->side_count; i++)
        sums[meeting->group[i]] += scalar->result[node->fields[i]];
    for (int i = 0; i < meeting->side_count; i++)
        mpm_scalar_set(state, scalar->result, node->fields[i], sums[meeting->group[i]]);
}

/* Gives the node's passages what their fields settle by. */
static void keep(const struct node *node, const double settling[MPM_CONTACT_SIDES])
{
    for (int i = 0; i < node->meeting.link_count && node->meeting.side_count > 0; i++)
        for (int end = 0; end < 2; end++)
            node->passages[i].settling[end] = settling[node->meeting.links[i].of[end]];
}

void mpm_scalar_exchange_lags(const struct mpm_state *state, struct mpm_nodal_scalar *scalar)
{
    struct node node;
    for (size_t k = 0; k < scalar->passage_count;) {
        double lags[MPM_CONTACT_SIDES];
        k = collect(scalar, k, &node);
        for (int i = 0; i < node.meeting.side_count; i++) {
            lags[i] = node.settles[i] ? scalar->result[node.fields[i]] : 0.0;
            if (node.settles[i])
                mpm_scalar_set(state, scalar->inflow, node.fields[i], 1.0);
        }
        keep(&node, lags);
        add_up(state, scalar, &node);
    }
}

/* D of the fields, less that of their group. */
static void find_settling(const struct mpm_nodal_scalar *scalar, const struct node *node,
                          double settling[MPM_CONTACT_SIDES])
{
    const struct mpm_scalar_meeting *const meeting = &node->meeting;
    double capacity[MPM_CONTACT_SIDES] = {0.0}, moved[MPM_CONTACT_SIDES] = {0.0};
    for (int i = 0; i < meeting->side_count; i++) {
        const double lag = meeting->sides[i].settling;
        settling[i] = node->settles[i] ? lag / scalar->result[node->fields[i]] : 0.0;
        capacity[meeting->group[i]] += meeting->sides[i].capacity;
        moved[meeting->group[i]] += meeting->sides[i].capacity * settling[i];
    }
    for (int i = 0; i < meeting->side_count; i++)
        settling[i] -= moved[meeting->group[i]] / capacity[meeting->group[i]];
}

void mpm_scalar_exchange_settle(const struct mpm_state *state, struct mpm_nodal_scalar *scalar)
{
    struct node node;
    for (size_t k = 0; k < scalar->passage_count;) {
        double settling[MPM_CONTACT_SIDES];
        k = collect(scalar, k, &node);
        find_settling(scalar, &node, settling);
        keep(&node, settling);
        add_up(state, scalar, &node);
    }
}

static bool is_held(const struct mpm_nodal_scalar *scalar, int64_t node)
{
    size_t low = 0, high = scalar->hold_count;
    while (low < high) {
        const size_t middle = low + (high - low) / 2;
        if (scalar->holds[middle].node < node)
            low = middle + 1;
        else
            high = middle;
    }
    return low < scalar->hold_count && scalar->holds[low].node == node;
}

/* What particles read; with XPIC `smoothed` has what takes the place of the values. */
static double result_of(const struct mpm_nodal_scalar *scalar, const struct node *node, int side,
                        double time_step)
{
    const struct mpm_scalar_side *const of = &node->meeting.sides[side];
    if (!mpm_scalar_takes_values(scalar))
        return of->rate;
    const double value =
        scalar->transfer == MPM_SCALAR_XPIC ? scalar->smoothed[node->fields[side]] : of->value;
    return value + time_step * of->rate;
}

void mpm_scalar_exchange_results(const struct mpm_state *state,
                                 const struct mpm_nodal_scalar *scalar)
{
    const bool values = mpm_scalar_takes_values(scalar);
    struct node node;
    for (size_t k = 0; k < scalar->passage_count;) {
        k = collect(scalar, k, &node);
        const struct mpm_scalar_meeting *const meeting = &node.meeting;
        if (meeting->side_count == 0 || is_held(scalar, node.passages->node))
            continue;
        mpm_scalar_meeting_exchange(&node.meeting, state->time_step, values);
        for (int i = 0; i < meeting->side_count; i++)
            mpm_scalar_set(state, scalar->result, node.fields[i],
                           result_of(scalar, &node, i, state->time_step));
        for (int i = 0; i < meeting->link_count; i++) {
            if (node.passages[i].total != NULL)
                *node.passages[i].total += meeting->links[i].passed;
            node.passages[i].settling[0] = node.passages[i].settling[1] = 0.0;
        }
    }
}

/* `smoothed` in the place of values, of which nothing flows but between fields that are one. */
static void take_smoothed(const struct mpm_nodal_scalar *scalar, struct node *node)
{
    struct mpm_scalar_meeting *const meeting = &node->meeting;
    for (int i = 0; i < meeting->side_count; i++) {
        struct mpm_scalar_side *const side = &meeting->sides[i];
        side->content = side->capacity * scalar->smoothed[node->fields[i]];
        side->inflow = side->settling = 0.0;
    }
    for (int i = 0; i < meeting->link_count; i++)
        meeting->links[i].conductance = 0.0;
    mpm_scalar_meeting_join(meeting);
}

void mpm_scalar_exchange_smoothed(const struct mpm_state *state,
                                  const struct mpm_nodal_scalar *scalar, bool counts)
{
    struct node node;
    for (size_t k = 0; k < scalar->passage_count;) {
        k = collect(scalar, k, &node);
        struct mpm_scalar_meeting *const meeting = &node.meeting;
        if (meeting->side_count == 0 || is_held(scalar, node.passages->node))
            continue;
        take_smoothed(scalar, &node);
        mpm_scalar_meeting_exchange(meeting, state->time_step, true);
        for (int i = 0; i < meeting->side_count; i++)
            if (is_one_of_several(meeting, i))
                mpm_scalar_set(state, scalar->smoothed, node.fields[i], meeting->sides[i].value);
        for (int i = 0; i < meeting->link_count && counts; i++)
            if (node.passages[i].total != NULL)
                *node.passages[i].total += meeting->links[i].passed;
    }
}
