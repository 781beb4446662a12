/* The variants of the solver.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "benchmarks/groups/variants.h"

#include <assert.h>
#include <glib.h>

/* The order of both is that of the names in reports/bench_accuracy.gp and bench_throughput.gp. */
static const char *const shapes[] = {"classic", "ugimp", "cpdi", "bspline2", "bspline3"};
static const char *const orders[] = {"usl", "musl", "usf", "usavg"};

/* With uGIMP and MUSL. Methods that damp as they go are here for what they cost and lose. */
static const struct {
    const char *change, *setting;
} changes[] = {
    {"apic", "method.transfer={kind: apic}"},
    {"xpic2", "method.transfer={kind: xpic, order: 2}"},
    {"fmpm2", "method.transfer={kind: fmpm, order: 2}"},
    {"flip99", "method.transfer={kind: flip, fraction: 0.99}"},
    {"momentum", "method.form=momentum"},
};
enum { UGIMP = 1, MUSL = 1 };

size_t bench_variants_plain(void)
{
    return G_N_ELEMENTS(shapes) * G_N_ELEMENTS(orders);
}

size_t bench_variants_count(void)
{
    return bench_variants_plain() + G_N_ELEMENTS(changes);
}

struct bench_variant bench_variant(size_t index)
{
    const size_t plain = bench_variants_plain();
    assert(index < bench_variants_count());
    if (index < plain) {
        const size_t shape = index / G_N_ELEMENTS(orders), order = index % G_N_ELEMENTS(orders);
        return (struct bench_variant){shapes[shape], orders[order], "", NULL, shape, order};
    }
    const size_t change = index - plain;
    return (struct bench_variant){
        shapes[UGIMP],           orders[MUSL], changes[change].change,
        changes[change].setting, UGIMP,        G_N_ELEMENTS(orders) + change};
}
