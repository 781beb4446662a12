/* SPDX-License-Identifier: GPL-3.0-or-later */
/* for madvise, which POSIX does not have */
#define _DEFAULT_SOURCE /* NOLINT */
#include "base/arena.h"

#include <stdlib.h>
#include <sys/mman.h>
#include <unistd.h>

enum { CACHE_LINE = 64 };

/* A step reads a dozen arrays at once: with pages of the usual size, the processor would
 * look up a new one every 512 numbers. The parts that are never touched still cost nothing
 * but their share of a page. */
static void ask_for_large_pages(const struct mpm_arena *arena)
{
#ifdef MADV_HUGEPAGE
    enum { LARGE_PAGE = 1 << 21 };
    const uintptr_t start = (uintptr_t)arena->base;
    const uintptr_t first = (start + LARGE_PAGE - 1) / LARGE_PAGE * LARGE_PAGE;
    const uintptr_t last = (start + arena->capacity) / LARGE_PAGE * LARGE_PAGE;
    if (first < last)
        (void)madvise((void *)first, last - first, MADV_HUGEPAGE); /* a wish only */
#else
    (void)arena;
#endif
}

void *mpm_arena_take(struct mpm_arena *arena, size_t count, size_t size)
{
    const size_t room = SIZE_MAX - arena->used;
    if (count > (room - CACHE_LINE) / size) {
        arena->used = SIZE_MAX - CACHE_LINE;
        return NULL;
    }
    const size_t bytes = (count * size + CACHE_LINE - 1) / CACHE_LINE * CACHE_LINE;
    unsigned char *const start = arena->base == NULL ? NULL : arena->base + arena->used;
    arena->used += bytes;
    return start;
}

enum mpm_status mpm_memory_check(size_t bytes, struct mpm_error *error)
{
    const double machine = (double)sysconf(_SC_PHYS_PAGES) * (double)sysconf(_SC_PAGESIZE);
    if ((double)bytes > machine)
        return mpm_error_set(error, MPM_ENVIRONMENT_FAILED,
                             "memory: the scene needs %.3g GB, the machine has %.3g GB",
                             (double)bytes * 1e-9, machine * 1e-9);
    return MPM_OK;
}

enum mpm_status mpm_arena_allocate(struct mpm_arena *arena, struct mpm_error *error)
{
    MPM_TRY(mpm_memory_check(arena->used, error));
    /* calloc of a large block hands out untouched pages: a part of the grid that no
     * particle reaches costs address space only. The slack aligns the first array. */
    arena->capacity = arena->used + CACHE_LINE;
    arena->base = calloc(arena->capacity, 1);
    if (arena->base == NULL)
        return mpm_error_memory(error, arena->capacity, "the simulation");
    ask_for_large_pages(arena);
    arena->used = (CACHE_LINE - (size_t)((uintptr_t)arena->base % CACHE_LINE)) % CACHE_LINE;
    return MPM_OK;
}

void mpm_arena_free(struct mpm_arena *arena)
{
    free(arena->base);
    *arena = (struct mpm_arena){0};
}
