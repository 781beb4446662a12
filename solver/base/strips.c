/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/strips.h"

/* The worker's number is the loop's own variable, so that no run-time call to the
 * threading library is needed. */

void mpm_strips_run(int64_t strip_count, int workers,
                    void (*work)(void *context, int64_t strip, int worker), void *context)
{
    for (int64_t colour = 0; colour < 2; colour++) {
#pragma omp parallel for schedule(static, 1) num_threads(workers) if (workers > 1)
        for (int worker = 0; worker < workers; worker++)
            for (int64_t strip = colour + 2 * worker; strip < strip_count; strip += 2 * workers)
                work(context, strip, worker);
    }
}

void mpm_rows_run(int64_t first, int64_t last, int workers,
                  void (*work)(void *context, int64_t row, int worker), void *context)
{
#pragma omp parallel for schedule(static, 1) num_threads(workers) if (workers > 1)
    for (int worker = 0; worker < workers; worker++)
        for (int64_t row = first + worker; row <= last; row += workers)
            work(context, row, worker);
}
