/* The pieces that a state is made of: named arrays of numbers, which a checkpoint has one by one.
 *
 * What has such a state lists its pieces to a visitor, in a fixed order. One list serves writing,
 * reading and counting: a reader fills the arrays, a writer leaves them alone.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_BASE_PIECE_H
#define MPM_BASE_PIECE_H

#include "base/status.h"

#include <stdbool.h>
#include <stdint.h>

enum mpm_piece_type {
    MPM_PIECE_DOUBLE,
    MPM_PIECE_UINT64,
    MPM_PIECE_INT64,
    MPM_PIECE_UINT32,
    MPM_PIECE_INT32,
    MPM_PIECE_UINT8,
    MPM_PIECE_BOOL, /* read as bytes: 0 or 1 */
    MPM_PIECE_TYPE_COUNT,
};

enum { MPM_PIECE_NAME_SIZE = 64 };

struct mpm_piece {
    char name[MPM_PIECE_NAME_SIZE];
    enum mpm_piece_type type;
    size_t count;
    void *data;
};

/* The first failure stays: the pieces after it are not taken. */
struct mpm_piece_visitor {
    enum mpm_status (*take)(void *context, const struct mpm_piece *piece, struct mpm_error *error);
    void *context;
    struct mpm_error *error;
    enum mpm_status status;
};

/* Lists one, of which nothing is done if it has no numbers. The name is "name", or "name.index"
 * with an index that is not negative. */
void mpm_piece_visit(struct mpm_piece_visitor *visitor, enum mpm_piece_type type, void *data,
                     size_t count, const char *name, int index);

/* A number that was read and cannot be right: MPM_BAD_INPUT, with the piece's name. */
void mpm_piece_refuse(struct mpm_piece_visitor *visitor, const char *name);

size_t mpm_piece_bytes(const struct mpm_piece *piece);

#endif
