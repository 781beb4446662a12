/* Fast kernels: particles that have packed velocity fields (fields.h) in their stencils.
 *
 * Kernels rely on the nodes of a stencil being neighbours in memory, which packed fields are not.
 * So each particle of such a block gets a patch: copies of its nodes side by side, each in the
 * field that the particle has there.
 *
 *     grid   . . . . .        packed           patch of p
 *            . n n n .   p    . F F F .        n n n
 *            . n n n .                         n n n     in four columns and four rows
 *            . N N N .                         F F F
 *
 * The stencils of the block are moved to the patches. What a pass reads is copied into them
 * before, and what it adds, to zeros there, is added to the fields after it, particle by particle:
 * the sums of all nodes are those of the particles' order, as without patches. A block of other
 * particles looks once whether it has patches.
 *
 * Cost: some hundred instructions for each pass and particle of such a block.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_FAST_PATCHES_H
#define MPM_METHOD_FAST_PATCHES_H

#include "method/fast/fast_block.h"
#include "method/fast/fast_cpdi.h"
#include "method/fast/fast_lines.h"
#include "method/fields/fields.h"

union fast_stencil {
    struct fast_lines lines;
    struct fast_cpdi cpdi;
};

enum {
    MPM_PATCH_EDGE = 4, /* room for the nodes of every family, and for the corners of CPDI */
    MPM_PATCH_NODES = MPM_PATCH_EDGE * MPM_PATCH_EDGE,
    MPM_PATCHES = MPM_BLOCK_VECTORS * MPM_VECTOR_SIZE,
};

/* Nodal arrays of vectors that a pass exchanges values with. */
enum fast_array { FAST_SUM, FAST_READ, FAST_GRADIENT, FAST_ARRAYS };

/* And those of single numbers: masses, then enum fast_numbers of the scalar. */
enum { FAST_MASS = FAST_NUMBERS, FAST_SINGLE_ARRAYS };

/* What a pass does with nodes: bits of the arrays. */
struct fast_traffic {
    unsigned reads, adds;               /* enum fast_array */
    unsigned reads_single, adds_single; /* arrays of single numbers */
};

/* Where the constants of a run say that nodes are. */
struct fast_place {
    int64_t stride, pitch;
    double *arrays[FAST_ARRAYS], *singles[FAST_SINGLE_ARRAYS];
};

struct fast_patches {
    const struct mpm_state *state;
    struct fast_traffic traffic;
    struct fast_place grid;
    size_t first,
        count;    /* the block's particles; free places of its last vector repeat the first */
    size_t lanes; /* of its vectors */
    int edge[MPM_PATCHES];
    /* Of each patch where its nodes are in the grid, or behind it; in its own rows, or kept for the
     * step in mpm_field_use */
    const uint32_t *node[MPM_PATCHES];
    uint32_t own[MPM_PATCHES][MPM_PATCH_NODES];
    double singles[FAST_SINGLE_ARRAYS][MPM_PATCHES * MPM_PATCH_NODES];
    double values[FAST_ARRAYS][MPM_PATCHES * MPM_PATCH_NODES][MPM_VECTOR_SIZE];
};

MPM_INLINE struct fast_place place_of_constants(const struct fast_constants *k)
{
    struct fast_place place = {
        .stride = k->stride,
        .pitch = k->pitch,
        .arrays = {(double *)k->sum, k->read, (double *)k->gradient},
        .singles = {[FAST_MASS] = k->mass},
    };
    for (int a = 0; a < FAST_NUMBERS; a++)
        place.singles[a] = k->scalar.nodes[a];
    return place;
}

MPM_INLINE void set_place(struct fast_constants *k, const struct fast_place *place)
{
    k->stride = place->stride;
    k->pitch = place->pitch;
    k->mass = place->singles[FAST_MASS];
    for (int a = 0; a < FAST_NUMBERS; a++)
        k->scalar.nodes[a] = place->singles[a];
    k->sum = (struct mpm_node_sum(*)[2])place->arrays[FAST_SUM];
    k->read = place->arrays[FAST_READ];
    k->gradient = (double(*)[2][2])place->arrays[FAST_GRADIENT];
}

/* For the particles of a run; k: its constants. */
MPM_INLINE void fast_patches_open(struct fast_patches *patches, const struct mpm_state *state,
                                  const struct fast_constants *k,
                                  const struct fast_traffic *traffic)
{
    patches->state = state;
    patches->traffic = *traffic;
    patches->grid = place_of_constants(k);
}

/* Has the constants name the patches, or again the grid. */
MPM_INLINE void fast_patches_aim(struct fast_patches *patches, bool at_patches,
                                 struct fast_constants *k)
{
    struct fast_place made = {
        .stride = MPM_PATCH_EDGE,
        .pitch = MPM_PATCH_EDGE * (int64_t)sizeof(mpm_vector),
        .arrays = {patches->values[FAST_SUM][0], patches->values[FAST_READ][0],
                   patches->values[FAST_GRADIENT][0]},
    };
    for (int a = 0; a < FAST_SINGLE_ARRAYS; a++)
        made.singles[a] = patches->singles[a];
    set_place(k, at_patches ? &made : &patches->grid);
}

/* The next block. */
MPM_INLINE void fast_patches_take(struct fast_patches *patches, size_t first, size_t count)
{
    patches->first = first;
    patches->count = count;
    patches->lanes = (count + MPM_VECTOR_SIZE - 1) / MPM_VECTOR_SIZE * MPM_VECTOR_SIZE;
}

/* ---------------------------------------------------------------- the nodes */

/* A block of edge by edge nodes from `first` on, at a place of a lane's patch: in the fields of the
 * particle. */
MPM_INLINE void find_nodes(const struct fast_patches *patches, const struct mpm_field_use *use,
                           int64_t first, int edge, uint32_t *nodes)
{
    for (int j = 0; j < edge; j++)
        for (int i = 0; i < edge; i++)
            nodes[MPM_PATCH_EDGE * j + i] = (uint32_t)(first + j * patches->grid.stride + i);
    for (int k = 0; use != NULL && k < use->detours; k++) {
        int64_t column = (int64_t)use->detour[k].node - first;
        for (int j = 0; j < edge; j++, column -= patches->grid.stride)
            if (column >= 0 && column < edge)
                nodes[MPM_PATCH_EDGE * j + column] = use->detour[k].field;
    }
}

/* A patch of edge by edge nodes, the first of which is *first. */
MPM_INLINE void make_patch(struct fast_patches *patches, struct mpm_field_use *use, size_t lane,
                           int edge, int64_t *first)
{
    uint32_t *const nodes = use != NULL ? use->block : patches->own[lane];
    if (use == NULL || use->first != *first)
        find_nodes(patches, use, *first, edge, nodes);
    if (use != NULL)
        use->first = *first;
    patches->edge[lane] = edge;
    patches->node[lane] = nodes;
    *first = (int64_t)(lane * MPM_PATCH_NODES);
}

/* Two nodes by two for each corner. */
MPM_INLINE void make_patch_of_corners(struct fast_patches *patches, const struct mpm_field_use *use,
                                      size_t lane, struct fast_corners *corners)
{
    for (int c = 0; c < MPM_CORNERS; c++) {
        const int place = 2 * (c % 2) + 2 * MPM_PATCH_EDGE * (c / 2);
        int64_t *const first = &corners->node[c][lane % MPM_VECTOR_SIZE];
        find_nodes(patches, use, *first, 2, patches->own[lane] + place);
        *first = (int64_t)(lane * MPM_PATCH_NODES) + place;
    }
    patches->edge[lane] = MPM_PATCH_EDGE;
    patches->node[lane] = patches->own[lane];
}

MPM_INLINE void make_patches(const struct fast_spec *spec, struct fast_patches *patches,
                             union fast_stencil *stencil)
{
    for (size_t v = 0; spec->scalars && v < patches->lanes / MPM_VECTOR_SIZE; v++)
        if (spec->shape != MPM_CPDI)
            stencil[v].lines.together = false;
        else if (!takes_corners(spec) && stencil[v].cpdi.near)
            stencil[v].cpdi.nodes.together = false;
    for (size_t lane = 0; lane < patches->lanes; lane++) {
        union fast_stencil *const own = &stencil[lane / MPM_VECTOR_SIZE];
        const size_t i = lane % MPM_VECTOR_SIZE;
        const size_t p = patches->first + (lane < patches->count ? lane : 0);
        struct mpm_field_use *const use = mpm_field_use_of(patches->state, p);
        if (spec->shape != MPM_CPDI)
            make_patch(patches, use, lane, line_nodes(spec), &own->lines.node[i]);
        else if (takes_corners(spec) || !own->cpdi.near)
            make_patch_of_corners(patches, use, lane, &own->cpdi.corners);
        else
            make_patch(patches, use, lane, MPM_BLOCK_EDGE, &own->cpdi.nodes.first[i]);
    }
}

/* --------------------------------------------------------------- the values */

/* One array at the nodes of a patch. Zeros to add to: */
MPM_INLINE void clear_nodes(const double *grid, const uint32_t *node, int edge,
                            double (*values)[MPM_VECTOR_SIZE])
{
    (void)grid;
    (void)node;
    for (int j = 0; j < edge; j++)
        for (int i = 0; i < edge; i++)
            mpm_store(values[MPM_PATCH_EDGE * j + i], mpm_splat(0.0));
}

MPM_INLINE void clear_singles(const double *grid, const uint32_t *node, int edge, double *values)
{
    (void)grid;
    (void)node;
    for (int j = 0; j < edge; j++)
        mpm_store(values + MPM_PATCH_EDGE * j, mpm_splat(0.0));
}

MPM_INLINE void read_nodes(const double *grid, const uint32_t *node, int edge,
                           double (*values)[MPM_VECTOR_SIZE])
{
    for (int j = 0; j < edge; j++)
        for (int i = 0; i < edge; i++) {
            const int n = MPM_PATCH_EDGE * j + i;
            mpm_store(values[n], mpm_load(grid + MPM_VECTOR_SIZE * (size_t)node[n]));
        }
}

/* To a fourth number of each row: kernels read three columns in halves of vectors. */
MPM_INLINE void read_singles(const double *grid, const uint32_t *node, int edge, double *values)
{
    clear_singles(grid, node, edge, values);
    for (int j = 0; j < edge; j++)
        for (int i = 0; i < edge; i++)
            values[MPM_PATCH_EDGE * j + i] = grid[node[MPM_PATCH_EDGE * j + i]];
}

MPM_INLINE void add_nodes(double *grid, const uint32_t *node, int edge,
                          const double (*values)[MPM_VECTOR_SIZE])
{
    for (int j = 0; j < edge; j++)
        for (int i = 0; i < edge; i++) {
            const int n = MPM_PATCH_EDGE * j + i;
            double *const sum = grid + MPM_VECTOR_SIZE * (size_t)node[n];
            mpm_store(sum, mpm_load(sum) + mpm_load(values[n]));
        }
}

MPM_INLINE void add_singles(double *grid, const uint32_t *node, int edge, const double *values)
{
    for (int j = 0; j < edge; j++)
        for (int i = 0; i < edge; i++)
            grid[node[MPM_PATCH_EDGE * j + i]] += values[MPM_PATCH_EDGE * j + i];
}

/* Of all patches, work(array, nodes, edge, values); most edges are 3. */
#define FOR_PATCHES(patches, work, array, values)                                                  \
    for (size_t lane = 0; lane < (patches)->lanes; lane++) {                                       \
        const int edge = (patches)->edge[lane];                                                    \
        if (edge == 3)                                                                             \
            work(array, (patches)->node[lane], 3, (values) + lane * MPM_PATCH_NODES);              \
        else                                                                                       \
            work(array, (patches)->node[lane], edge, (values) + lane * MPM_PATCH_NODES);           \
    }

/* Moves the stencils of a block to patches, with what the pass reads there. */
MPM_SEPARATE void fast_patches_begin(const struct fast_spec *spec, struct fast_patches *patches,
                                     union fast_stencil *stencil)
{
    make_patches(spec, patches, stencil);
    for (int a = 0; a < FAST_ARRAYS; a++) {
        if ((patches->traffic.reads >> a & 1u) != 0)
            FOR_PATCHES(patches, read_nodes, patches->grid.arrays[a], patches->values[a])
        if ((patches->traffic.adds >> a & 1u) != 0)
            FOR_PATCHES(patches, clear_nodes, patches->grid.arrays[a], patches->values[a])
    }
    for (int a = 0; a < FAST_SINGLE_ARRAYS; a++) {
        if ((patches->traffic.reads_single >> a & 1u) != 0)
            FOR_PATCHES(patches, read_singles, patches->grid.singles[a], patches->singles[a])
        if ((patches->traffic.adds_single >> a & 1u) != 0)
            FOR_PATCHES(patches, clear_singles, patches->grid.singles[a], patches->singles[a])
    }
    mpm_keep_in_memory(patches);
}

/* Adds what the pass has added to patches to the fields. */
MPM_SEPARATE void fast_patches_end(struct fast_patches *patches)
{
    mpm_keep_in_memory(patches);
    for (int a = 0; a < FAST_ARRAYS; a++)
        if ((patches->traffic.adds >> a & 1u) != 0)
            FOR_PATCHES(patches, add_nodes, patches->grid.arrays[a],
                        (const double(*)[MPM_VECTOR_SIZE])patches->values[a])
    for (int a = 0; a < FAST_SINGLE_ARRAYS; a++)
        if ((patches->traffic.adds_single >> a & 1u) != 0)
            FOR_PATCHES(patches, add_singles, patches->grid.singles[a], patches->singles[a])
}

#endif
