/* Probes: what one core of this machine can do at most.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef BENCHMARKS_MEASURING_PROBES_H
#define BENCHMARKS_MEASURING_PROBES_H

#include "benchmarks/measuring/points.h"

/* Double precision: independent chains of multiply-add in registers, fused and four wide
 * (AVX2) where the processor has it, as the fast kernels are at most. Work is counted in
 * GFLOP, two for each multiply-add of one number. */
enum mpm_status bench_probe_arithmetic(const void *context, struct bench_sample *sample,
                                       struct mpm_error *error);

/* Triad a = b + s c over three arrays of BENCH_TRIAD_BYTES each, far beyond the caches. Work
 * is counted in GB, 24 bytes a number: two read, one written. */
enum { BENCH_TRIAD_BYTES = 96 << 20 };
enum mpm_status bench_probe_bandwidth(const void *context, struct bench_sample *sample,
                                      struct mpm_error *error);

/* "AVX2 with FMA", ...: what bench_probe_arithmetic uses here. */
const char *bench_probe_instructions(void);

#endif
