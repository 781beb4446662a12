/* One block of memory for a simulation. A layout function takes all its arrays
 * from an arena twice: first from a measuring one, which only counts, then from
 * the real one. Nothing is allocated after that.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_BASE_ARENA_H
#define MPM_BASE_ARENA_H

#include "base/status.h"

struct mpm_arena {
    unsigned char *base; /* NULL while measuring */
    size_t capacity;     /* bytes */
    size_t used;         /* bytes */
};

/* Takes count * size bytes, zeroed, aligned to a cache line. Returns NULL while
 * measuring. A total beyond the address space leaves `used` at SIZE_MAX. */
void *mpm_arena_take(struct mpm_arena *arena, size_t count, size_t size);

/* Has the machine so many bytes, used or not? MPM_ENVIRONMENT_FAILED: no; the message has both
 * numbers. */
enum mpm_status mpm_memory_check(size_t bytes, struct mpm_error *error);

/* Turns a measuring arena into a real one of the size measured, and empties it.
 * More than the machine's memory: MPM_ENVIRONMENT_FAILED, nothing allocated. */
enum mpm_status mpm_arena_allocate(struct mpm_arena *arena, struct mpm_error *error);
void mpm_arena_free(struct mpm_arena *arena);

#define MPM_TAKE(arena, type, count) ((type *)mpm_arena_take((arena), (count), sizeof(type)))

#endif
