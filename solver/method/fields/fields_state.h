/* What additional velocity fields keep; see fields.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_FIELDS_STATE_H
#define MPM_METHOD_FIELDS_STATE_H

#include "method/shape/shape.h"

#include <stdatomic.h>
#include <stdint.h>

/* Fields that a node may have besides its own, layers not counted: a key has four bits. */
enum { MPM_FIELD_KEYS = 15 };

/* Copies of the grid's nodes, the grid itself counted. */
enum { MPM_LAYERS = 8 };

/* Particles begin..end - 1. */
struct mpm_span {
    size_t begin, end;
};

/* For each row of cells or nodes the columns between which some are marked; none: low > high. */
struct mpm_bands {
    int64_t *low, *high;
};

struct mpm_node_box;

/* A field of a node besides its own. */
struct mpm_additional_field {
    uint32_t node;  /* the parent's place in `nodes` */
    uint8_t key;    /* of its owner: 1..keys */
    uint8_t held;   /* bits of the components that conditions hold */
    uint8_t free;   /* bits of the axes across which it is on a free surface, where its parent is on
                     * a plane of symmetry */
    uint8_t passes; /* bits of the axes across which it has images beyond planes of symmetry */
};

/* A node of the grid that has several fields. */
struct mpm_field_node {
    int64_t node; /* its own field */
    double position[2];
    uint32_t first; /* of `list`: its others, by ascending key */
    uint8_t count;
    uint8_t held; /* of its own field */
};

/* A node of a plain stencil, and the field that the particle has there instead. */
struct mpm_field_detour {
    uint32_t node, field; /* indices of nodes */
};

/* A particle with additional fields in its stencil; from the start of a step to its end. */
struct mpm_field_use {
    uint32_t particle;
    int detours;
    struct mpm_field_detour detour[MPM_STENCIL_MAX]; /* for the fast kernels: fast_patches.h */
    /* Of the fast kernels: a block of nodes from `first` on, in rows of four, and the particle's
     * fields there; `first` below 0: not yet known. */
    int64_t first;
    uint32_t block[MPM_STENCIL_MAX];
    uint64_t keys;              /* four bits for each node of its plain stencil; 0: its own field */
    struct mpm_stencil stencil; /* its nodes in its fields */
};

struct mpm_fields {
    int64_t layers;             /* whole copies of the grid's nodes */
    int keys;                   /* that clients have claimed */
    struct mpm_node_box *boxes; /* of scenes with layers: mpm_layer_boxes; or NULL */
    /* Per row of the grid the columns of its nodes that particles reach in any layer, and of scenes
     * with layers per row of each of them what was active in the step before. */
    struct mpm_bands reached, before;
    /* Of the step */
    int64_t rows; /* behind those of the grid: of all layers, then of packed fields */
    struct mpm_field_use *uses;
    _Atomic size_t use_count;
    size_t use_capacity;
    uint32_t *use_of;       /* per particle: one more than its place in `uses`, or 0 */
    struct mpm_span *spans; /* see mpm_field_spans */
    uint16_t *asked;        /* per node of the grid: bits of the keys that some particle requests */
    struct mpm_bands asked_at;
    struct mpm_bands beside; /* cells with a corner that has several fields */
    uint32_t *node_of;       /* per node of the grid: one more than its place in `nodes`, or 0 */
    struct mpm_field_node *nodes; /* in the order of the grid */
    size_t node_count, node_capacity;
    struct mpm_additional_field *list;
    int64_t count;
    /* Where a crack passes a plane of symmetry, nodes beyond it come last: those before them, and
     * their fields; else all. */
    size_t nodes_inside;
    int64_t inside;
};

#endif
