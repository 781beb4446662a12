/* Probes: arithmetic and memory.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "benchmarks/measuring/probes.h"

#include "benchmarks/measuring/timing.h"
#include "verification/common/failure.h"

#include <math.h>
#include <stdlib.h>

#if defined __x86_64__ && defined __GNUC__
#define HAS_WIDE 1
#include <immintrin.h>
#else
#define HAS_WIDE 0
#endif

/* Chains enough to hide the latency of four cycles at two operations a cycle, few enough for
 * sixteen registers. Factor and term keep every chain near 1: nothing overflows or vanishes. */
enum { CHAINS = 12, LANES = 4, REPEATS = 1 << 20 };
static const double FACTOR = 0.999999, TERM = 1e-6;

/* A probe goes on for so long. */
static const double DURATION = 0.1;

/* --------------------------------------------------------------- arithmetic */

/* The compiler's own instructions: fused where they are by default, as on AArch64. */
static double multiply_add(void)
{
    double value[CHAINS * LANES], sum = 0;
    for (int k = 0; k < CHAINS * LANES; k++)
        value[k] = k;
    for (int i = 0; i < REPEATS; i++)
        for (int k = 0; k < CHAINS * LANES; k++)
#ifdef __FP_FAST_FMA
            value[k] = fma(value[k], FACTOR, TERM);
#else
            value[k] = value[k] * FACTOR + TERM;
#endif
    for (int k = 0; k < CHAINS * LANES; k++)
        sum += value[k];
    return sum;
}

#if HAS_WIDE
/* The same numbers, four to a register and fused whatever the flags of this build. */
__attribute__((target("avx2,fma"))) static double multiply_add_wide(void)
{
    const __m256d factor = _mm256_set1_pd(FACTOR), term = _mm256_set1_pd(TERM);
    __m256d value[CHAINS], sum = _mm256_setzero_pd();
    for (int k = 0; k < CHAINS; k++)
        value[k] = _mm256_set1_pd(k);
    for (int i = 0; i < REPEATS; i++) {
#pragma GCC unroll 12
        for (int k = 0; k < CHAINS; k++)
            value[k] = _mm256_fmadd_pd(value[k], factor, term);
    }
    for (int k = 0; k < CHAINS; k++)
        sum = _mm256_add_pd(sum, value[k]);
    return sum[0] + sum[1] + sum[2] + sum[3];
}
#endif

static bool machine_is_wide(void)
{
#if HAS_WIDE
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
#else
    return false;
#endif
}

const char *bench_probe_instructions(void)
{
    if (machine_is_wide())
        return "AVX2 with FMA";
#ifdef __FP_FAST_FMA
    return "the compiler's own, fused";
#else
    return "the compiler's own, not fused";
#endif
}

static double run_chains(void)
{
#if HAS_WIDE
    if (machine_is_wide())
        return multiply_add_wide();
#endif
    return multiply_add();
}

enum mpm_status bench_probe_arithmetic(const void *context, struct bench_sample *sample,
                                       struct mpm_error *error)
{
    (void)context;
    double sum = run_chains(); /* not timed: the clock of the core rises to what it keeps */
    const double cpu = bench_clock_cpu(), wall = bench_clock_wall();
    *sample = (struct bench_sample){0, 0, 0};
    do {
        sum += run_chains();
        sample->work += 2e-9 * CHAINS * LANES * REPEATS;
    } while (bench_clock_wall() - wall < DURATION);
    sample->cpu = bench_clock_cpu() - cpu;
    sample->wall = bench_clock_wall() - wall;
    /* the sum is used so that the chains cannot be optimised away */
    return isfinite(sum) ? MPM_OK
                         : failure_set(error, MPM_RUN_FAILED, "the chains overflow: %g", sum);
}

/* ------------------------------------------------------------------ bandwidth */

static const size_t COUNT = BENCH_TRIAD_BYTES / sizeof(double);

static void triad(double *restrict a, const double *restrict b, const double *restrict c, double s)
{
    for (size_t i = 0; i < COUNT; i++)
        a[i] = b[i] + s * c[i];
}

static void time_triad(double *a, double *b, double *c, struct bench_sample *sample)
{
    for (size_t i = 0; i < COUNT; i++) {
        a[i] = 0;
        b[i] = 1;
        c[i] = 2;
    }
    triad(a, b, c, 1);
    const double cpu = bench_clock_cpu(), wall = bench_clock_wall();
    *sample = (struct bench_sample){0, 0, 0};
    do {
        triad(a, b, c, sample->work); /* a factor of its own each time: none can be left out */
        sample->work += 3e-9 * BENCH_TRIAD_BYTES;
    } while (bench_clock_wall() - wall < DURATION);
    sample->cpu = bench_clock_cpu() - cpu;
    sample->wall = bench_clock_wall() - wall;
}

enum mpm_status bench_probe_bandwidth(const void *context, struct bench_sample *sample,
                                      struct mpm_error *error)
{
    (void)context;
    double *a = malloc(BENCH_TRIAD_BYTES), *b = malloc(BENCH_TRIAD_BYTES);
    double *c = malloc(BENCH_TRIAD_BYTES);
    const bool have = a != NULL && b != NULL && c != NULL;
    bool right = false;
    if (have) {
        time_triad(a, b, c, sample);
        right = isfinite(a[0]) && isfinite(a[COUNT - 1]);
    }
    free(a);
    free(b);
    free(c);
    if (!have)
        return failure_set(error, MPM_ENVIRONMENT_FAILED, "no memory for three arrays of %d bytes",
                           BENCH_TRIAD_BYTES);
    return right ? MPM_OK : failure_set(error, MPM_RUN_FAILED, "the triad overflows");
}
