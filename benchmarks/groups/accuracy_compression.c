/* R1: radial compression of a disk by a rigid ring (the scene of the suite's case), judged
 * at a radial strain of -0.6 against N&G (63), (66), (67).
 *
 * The problem is homogeneous in z, where every node is held: one row of cells gives what the
 * case's four rows give, at a quarter of the cost, and the ladder refines r alone.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "benchmarks/groups/accuracy.h"

#include "verification/exact/plastic/compression.h"

#include <math.h>

/* As in the scene. */
#define RADIUS 50.0
#define SPEED  8.31
#define STRAIN 0.6

static const double GRID = 60.0, RING = 55.0, INNER = 0.8;
static const struct compression_material POLYMER = {.bulk = 2254.9, .shear = 864.662};

enum { STRESS_INNER, VOLUME_INNER, STRESS_ALL, VOLUME_ALL };
enum { RR, ZZ, TT, RZ, STRESS };

static char *scene(const struct bench_context *context)
{
    return bench_case_scene(context, "R/R1");
}

static void set(GPtrArray *settings, unsigned cells)
{
    const double cell = GRID / cells;
    accuracy_set(settings, "grid.cell=[%.17g,%.17g]", cell, cell);
    accuracy_set(settings, "grid.cells=[%u,1]", cells);
    accuracy_set(settings, "bodies.disk.region.rectangle.to=[%.17g,%.17g]", RADIUS, cell);
    accuracy_set(settings, "bodies.ring.region.rectangle.to=[%.17g,%.17g]", RING, cell);
}

/* |sigma - exact|^2 / |exact|^2, the squares over all components of the tensor. */
static double stress_error(const double *stress, const struct compression_stress *exact)
{
    const double rr = stress[RR] - exact->rr, zz = stress[ZZ] - exact->zz;
    const double tt = stress[TT] - exact->tt, rz = stress[RZ];
    return (rr * rr + zz * zz + tt * tt + 2 * rz * rz) /
           (exact->rr * exact->rr + exact->zz * exact->zz + exact->tt * exact->tt);
}

static void add(struct accuracy_sum *sum, double square)
{
    sum->squares += square;
    sum->count++;
}

static void look(const struct particle_set *particles, double time, struct accuracy_sum *sums)
{
    const double volume = compression_relative_volume(-SPEED * time / RADIUS);
    const struct compression_stress exact = compression_stress(&POLYMER, volume);
    for (size_t k = 0; k < particles->count; k++) {
        const double stress = stress_error(&particles->stress[STRESS * k], &exact);
        const double off = particles->relative_volume[k] / volume - 1;
        add(&sums[STRESS_ALL], stress);
        add(&sums[VOLUME_ALL], off * off);
        if (particles->start[2 * k] < INNER * RADIUS) {
            add(&sums[STRESS_INNER], stress);
            add(&sums[VOLUME_INNER], off * off);
        }
    }
}

const struct accuracy_problem accuracy_compression = {
    .name = "R1",
    .title = "R1: radial compression of a disk",
    .description = "A neo-Hookean disk compressed by a rigid ring to a radial strain of -0.6, "
                   "axisymmetric, against the exact homogeneous solution. The error is that of "
                   "the stress tensor, relative, root mean square over the particles inside "
                   "80 % of the radius. The ring's own error, at the rim, falls with the cell "
                   "size alone",
    .headline = "error_stress_interior",
    .headline_words = "error of stress inside, relative",
    .errors = {"error_stress_interior", "error_volume_interior", "error_stress_all",
               "error_volume_all"},
    .cells = {12, 24, 48, 72},
    .end = STRAIN * RADIUS / SPEED,
    .interval = (double)INFINITY,
    .scene = scene,
    .set = set,
    .look = look,
};
