/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/strips.h"

#include "base/workers.h"

struct strips {
    void (*work)(void *context, int64_t strip, int worker);
    void *context;
    int64_t colour;
};

static void run_strip(void *context, int64_t item, int worker)
{
    const struct strips *const strips = context;
    strips->work(strips->context, strips->colour + 2 * item, worker);
}

void mpm_strips_run(int64_t strip_count, int workers,
                    void (*work)(void *context, int64_t strip, int worker), void *context)
{
    struct strips strips = {.work = work, .context = context};
    for (; strips.colour < 2; strips.colour++)
        mpm_workers_run((strip_count - strips.colour + 1) / 2, workers, run_strip, &strips);
}

/* Rows are short: workers take several at a time, but few enough that the last ones to work are
 * not long alone. */
enum { BLOCKS_PER_WORKER = 4 };

struct rows {
    void (*work)(void *context, int64_t row, int worker);
    void *context;
    int64_t first, count, blocks;
};

static void run_block(void *context, int64_t block, int worker)
{
    const struct rows *const rows = context;
    const int64_t end = rows->count * (block + 1) / rows->blocks;
    for (int64_t row = rows->count * block / rows->blocks; row < end; row++)
        rows->work(rows->context, rows->first + row, worker);
}

void mpm_rows_run(int64_t first, int64_t last, int workers,
                  void (*work)(void *context, int64_t row, int worker), void *context)
{
    struct rows rows = {.work = work, .context = context, .first = first};
    rows.count = last < first ? 0 : last - first + 1;
    rows.blocks = workers > 1 ? (int64_t)BLOCKS_PER_WORKER * workers : 1;
    if (rows.blocks > rows.count)
        rows.blocks = rows.count;
    mpm_workers_run(rows.blocks, workers, run_block, &rows);
}
