/* Contact between bodies: settled when the simulation is created, and what it adds to the history
 * and the ledger.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/contact/body_contact.h"
#include "method/cracks/crack_contact.h"
#include "method/cracks/crack_fields.h"
#include "method/fields/fields.h"
#include "method/loads/damping.h"
#include "simulation/quantity_rows.h"
#include "simulation/simulation.h"

#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* ----------------------------------------------------------------- creating */

void mpm_contacts_create(struct mpm_state *state)
{
    const struct mpm_contact_spec *const spec = &state->scene->contact;
    if (spec->deformable_fields < 2)
        return;
    _Static_assert((int)MPM_CONTACT_FIELDS <= (int)MPM_LAYERS, "each field may have a layer");
    const int64_t first = mpm_fields_claim_layers(state, (int64_t)spec->deformable_fields - 1);
    assert(first == 1);
    (void)first;
}

/* The field that cracks cut is in the grid itself, where packed fields have their parents; without
 * cracks the first one is. */
static int64_t layer_of(const struct mpm_state *state, size_t field)
{
    const size_t cracked = state->scene->contact.cracked_field;
    const size_t base = cracked == MPM_NO_FIELD ? 0 : cracked;
    return (int64_t)(field == base ? 0 : field < base ? field + 1 : field);
}

bool mpm_contacts_have_interfaces(const struct mpm_scene *scene)
{
    for (size_t k = 0; k < scene->contact.pair_count; k++)
        if (scene->contact.pairs[k].law == MPM_PAIR_INTERFACE)
            return true;
    return false;
}

bool mpm_contacts_join(const struct mpm_scene *scene, enum mpm_scalar which)
{
    for (size_t k = 0; k < scene->contact.pair_count; k++)
        if (scene->contact.pairs[k].law != MPM_PAIR_BONDED &&
            scene->contact.pairs[k].surfaces[which].law == MPM_SURFACE_PERFECT)
            return true;
    return false;
}

static void fill_body(struct mpm_state *state, size_t body)
{
    const struct mpm_contact_spec *const spec = &state->scene->contact;
    struct mpm_body_contact *const contact = &state->contact;
    const size_t field = spec->field_of[spec->group_of[body]];
    contact->field_of[body] = field == SIZE_MAX ? MPM_CONTACT_FIELDS : (uint8_t)field;
    if (!state->scene->bodies[body].rigid) {
        state->bodies[body].layer = layer_of(state, field);
        return;
    }
    for (size_t k = 0; k < spec->pair_count && field != SIZE_MAX; k++)
        if (spec->pairs[k].of[1] == field)
            contact->touched[body] |= (uint8_t)(1u << layer_of(state, spec->pairs[k].of[0]));
}

void mpm_contacts_fill(struct mpm_state *state)
{
    const struct mpm_contact_spec *const spec = &state->scene->contact;
    if (!mpm_body_contact_is_used(state))
        return;
    state->contact.follow_impulse = mpm_damping_follow_contact;
    for (size_t k = 0; k < spec->pair_count; k++) {
        const enum mpm_pair_normal normal = spec->pairs[k].normal;
        if (spec->pairs[k].law == MPM_PAIR_BONDED)
            state->contact.exchange_smoothed = mpm_body_contact_smoothed;
        if (normal == MPM_NORMAL_VOLUME || spec->pairs[k].detection == MPM_TOUCH_VOLUME)
            state->contact.sums_volume = true;
        if (normal == MPM_NORMAL_LINEAR || normal == MPM_NORMAL_LOGISTIC)
            state->contact.sums_moments = true;
    }
    state->contact.sums_displacement = mpm_contacts_have_interfaces(state->scene);
    if (mpm_cracks_have_contact(state->scene))
        state->contact.crack_touches = mpm_crack_contact_touches;
    for (size_t k = 0; k < spec->deformable_fields; k++)
        state->contact.shift[k] = mpm_layer_shift(state, layer_of(state, k));
    for (size_t body = 0; body < state->scene->body_count; body++)
        fill_body(state, body);
}

/* ------------------------------------------------------------------- ledger */

void mpm_contact_energies(const struct mpm_state *state, double *stored, double *dissipated)
{
    *stored = *dissipated = 0.0;
    for (size_t k = 0; k < state->scene->contact.pair_count; k++) {
        const double in_springs = state->contact.samples[k].stored;
        *stored += in_springs;
        *dissipated +=
            state->contact.totals[k].dissipated + state->contact.totals[k].work - in_springs;
    }
}

double mpm_contact_held(const struct mpm_state *state)
{
    double held = 0.0;
    for (size_t k = 0; k < state->scene->contact.pair_count; k++) {
        const struct mpm_contact_totals *const totals = &state->contact.totals[k];
        held += totals->dissipated + totals->work;
    }
    return fmax(held, 0.0);
}

/* ------------------------------------------------------------------ history */

static double force_x(const struct mpm_state *state, size_t pair)
{
    return state->contact.samples[pair].force[0];
}

static double force_y(const struct mpm_state *state, size_t pair)
{
    return state->contact.samples[pair].force[1];
}

static double area(const struct mpm_state *state, size_t pair)
{
    return state->contact.samples[pair].area;
}

static double nodes(const struct mpm_state *state, size_t pair)
{
    return (double)state->contact.samples[pair].nodes;
}

static double dissipated(const struct mpm_state *state, size_t pair)
{
    const struct mpm_contact_totals *const totals = &state->contact.totals[pair];
    return totals->dissipated + totals->work - state->contact.samples[pair].stored;
}

static double stored(const struct mpm_state *state, size_t pair)
{
    return state->contact.samples[pair].stored;
}

static double stiff_nodes(const struct mpm_state *state, size_t pair)
{
    return (double)state->contact.samples[pair].stiff;
}

static double heat(const struct mpm_state *state, size_t pair)
{
    return state->contact.totals[pair].passed[MPM_TEMPERATURE];
}

/* Which pairs have a column. */
enum holder { OF_MOTION, OF_INTERFACE, OF_HEAT };

static const struct quantity {
    const char *name, *description;
    double (*value)(const struct mpm_state *state, size_t pair);
    struct mpm_dimension dimension;
    enum holder of;
} quantities[] = {
    {"force_x", "force of contact on the first field in the last step", force_x,
     MPM_DIMENSION_FORCE, OF_MOTION},
    {"force_y", "force of contact on the first field in the last step", force_y,
     MPM_DIMENSION_FORCE, OF_MOTION},
    {"area", "area of the surfaces in contact in the last step", area, MPM_DIMENSION_AREA,
     OF_MOTION},
    {"nodes", "nodes in contact in the last step", nodes, MPM_DIMENSION_NONE, OF_MOTION},
    {"dissipated", "energy that contact has dissipated", dissipated, MPM_DIMENSION_ENERGY,
     OF_MOTION},
    {"stored", "energy that the interface has stored", stored, MPM_DIMENSION_ENERGY, OF_INTERFACE},
    {"stiff_nodes", "nodes of the last step where the interface is too stiff for an explicit step",
     stiff_nodes, MPM_DIMENSION_NONE, OF_INTERFACE},
    {"heat", "heat that has gone from the first field to the second since t = 0", heat,
     MPM_DIMENSION_ENERGY, OF_HEAT},
};

static bool has_row(const struct mpm_scene *scene, size_t pair, size_t row)
{
    const struct mpm_pair_spec *const spec = &scene->contact.pairs[pair];
    switch (quantities[row].of) {
    case OF_INTERFACE:
        return spec->law == MPM_PAIR_INTERFACE;
    case OF_HEAT:
        return spec->surfaces[MPM_TEMPERATURE].law != MPM_SURFACE_INSULATES;
    case OF_MOTION:
        break;
    }
    return !scene->at_rest;
}

static struct mpm_quantity_rows rows_of(const struct mpm_scene *scene)
{
    return (struct mpm_quantity_rows){scene->contact.pair_count,
                                      sizeof quantities / sizeof quantities[0], has_row};
}

size_t mpm_scene_contact_quantity_count(const struct mpm_scene *scene)
{
    const struct mpm_quantity_rows rows = rows_of(scene);
    return mpm_quantity_rows_count(&rows, scene);
}

struct mpm_quantity_info mpm_scene_contact_quantity(const struct mpm_scene *scene, size_t index)
{
    const struct mpm_quantity_rows rows = rows_of(scene);
    const struct mpm_quantity_place place = mpm_quantity_rows_place(&rows, scene, index);
    const struct quantity *const quantity = &quantities[place.row];
    const size_t *const of = scene->contact.pairs[place.member].of;
    struct mpm_quantity_info info = {
        .dimension = quantity->dimension,
        .description = quantity->description,
    };
    (void)snprintf(info.name, sizeof info.name, "contact_%zu_%zu_%s", of[0], of[1], quantity->name);
    return info;
}

double mpm_simulation_contact_quantity(const struct mpm_simulation *simulation, size_t index)
{
    const struct mpm_quantity_rows rows = rows_of(simulation->scene);
    const struct mpm_quantity_place place =
        mpm_quantity_rows_place(&rows, simulation->scene, index);
    return quantities[place.row].value(&simulation->state, place.member);
}

const char *mpm_scene_contact_field_name(const struct mpm_scene *scene, size_t field)
{
    const struct mpm_contact_spec *const contact = &scene->contact;
    for (size_t k = 0; k < contact->group_count; k++)
        if (contact->field_of[k] == field)
            return contact->groups[k].name;
    return NULL;
}

/* ------------------------------------------------------------------- points */

size_t mpm_simulation_contact_point_count(const struct mpm_simulation *simulation)
{
    return simulation->state.contact.pair_count;
}

struct mpm_contact_point mpm_simulation_contact_point(const struct mpm_simulation *simulation,
                                                      size_t index)
{
    const struct mpm_state *const state = &simulation->state;
    const struct mpm_contact_pair *const pair = &state->contact.pairs[index];
    const struct mpm_contact_node *node = state->contact.nodes;
    while (index >= node->first_pair + node->pairs)
        node++;
    struct mpm_contact_point point = {
        .of = {state->contact.fields[pair->fields[0]].field,
               state->contact.fields[pair->fields[1]].field},
        .has_normal = pair->has_normal,
        .touches = pair->touches,
        .normal = {pair->normal[0], pair->normal[1]},
        .gap = pair->gap,
        .area = pair->area,
    };
    mpm_grid_position(&state->grid, node->node, point.position);
    return point;
}
