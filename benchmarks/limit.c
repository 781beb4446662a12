/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "benchmarks/bench.h"

enum mpm_status bench_limit(struct bench_context *context, struct mpm_error *error)
{
    (void)context;
    (void)error;
    return MPM_OK;
}
