/* What loads on edges keep; see edge_loads.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_EDGE_LOADS_STATE_H
#define MPM_METHOD_EDGE_LOADS_STATE_H

#include "method/shape/edge.h"
#include "method/vector_field.h"

/* An edge of a particle that a load acts on; by ascending id. */
struct mpm_edge_site {
    uint32_t id; /* of the particle */
    uint32_t load;
    enum mpm_edge edge;
    double area; /* undeformed */
};

/* The same, in the order of the particles, with what it gives to the nodes in this step. */
struct mpm_loaded_edge {
    size_t particle;
    const struct mpm_edge_site *site;
    double traction[2];
    struct mpm_edge_weights weights;
};

/* Tractions and particle forces; all empty where a scene has none. See edge_loads.h. */
struct mpm_edge_loads {
    struct mpm_vector_field *value; /* per load of the scene */
    size_t count;
    struct mpm_edge_site *sites;
    struct mpm_loaded_edge *edges;
    size_t *first; /* per strip: its first edge; one more entry, `count` */
};

#endif
