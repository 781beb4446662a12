/* The variants of the solver that tables and pictures of benchmarks go through: every family of
 * shape functions with every stress-update order, then other transfers and forms.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef BENCHMARKS_GROUPS_VARIANTS_H
#define BENCHMARKS_GROUPS_VARIANTS_H

#include <stddef.h>

struct bench_variant {
    const char *shape, *stress_update; /* as scenes name them */
    const char *change;  /* a word for what else differs; "" in the product of the two */
    const char *setting; /* of a scene, PATH=VALUE; NULL without a change */
    /* Places of shape and of order, then of change, in the scripts of pictures. */
    size_t colour, marker;
};

/* Of shapes and orders alone: the first ones. */
size_t bench_variants_plain(void);
size_t bench_variants_count(void);
struct bench_variant bench_variant(size_t index);

#endif
