/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "method/transport/scalar_nodes.h"

#include "method/grid/grid_update.h"
#include "method/grid/symmetry.h"

int mpm_scalar_fields(const struct mpm_state *state)
{
    return 1 + (int)state->fields.layers + state->fields.keys;
}

int64_t mpm_scalar_field_at(const struct mpm_state *state, const struct mpm_nodal_scalar *scalar,
                            int64_t node, int k)
{
    const int layers = (int)state->fields.layers;
    const struct mpm_field_node *const cut = k > layers ? mpm_field_node_at(state, node) : NULL;
    const int64_t field = k <= layers   ? node + mpm_layer_shift(state, k)
                          : cut != NULL ? mpm_field_of(state, cut, k - layers)
                                        : -1;
    return field >= 0 && mpm_node_is_active(state, field) && mpm_node_is_inside(state, field) &&
                   scalar->capacity[field] != 0.0
               ? field
               : -1;
}

void mpm_scalar_set(const struct mpm_state *state, double *numbers, int64_t field, double number)
{
    struct mpm_symmetry_image images[MPM_SYMMETRY_IMAGES];
    const bool packed = field >= mpm_fields_first(state);
    numbers[field] = number;
    if (state->symmetries.count == 0 || (packed && !state->symmetries.passed))
        return;
    const int count =
        mpm_symmetry_images(state, packed ? mpm_field_parent(state, field) : field, images);
    for (int i = 0; i < count; i++) {
        const int64_t image =
            packed ? mpm_symmetry_packed_image(state, field, &images[i]) : images[i].node;
        if (image >= 0)
            numbers[image] = number;
    }
}
