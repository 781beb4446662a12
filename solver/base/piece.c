/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/piece.h"

#include <stdio.h>

void mpm_piece_visit(struct mpm_piece_visitor *visitor, enum mpm_piece_type type, void *data,
                     size_t count, const char *name, int index)
{
    struct mpm_piece piece = {.type = type, .count = count, .data = data};
    if (visitor->status != MPM_OK || count == 0)
        return;
    if (index < 0)
        (void)snprintf(piece.name, sizeof piece.name, "%s", name);
    else
        (void)snprintf(piece.name, sizeof piece.name, "%s.%d", name, index);
    visitor->status = visitor->take(visitor->context, &piece, visitor->error);
}

void mpm_piece_refuse(struct mpm_piece_visitor *visitor, const char *name)
{
    if (visitor->status == MPM_OK)
        visitor->status = mpm_error_set(visitor->error, MPM_BAD_INPUT,
                                        "'%s' has a value that no run leaves there", name);
}

size_t mpm_piece_bytes(const struct mpm_piece *piece)
{
    static const size_t sizes[MPM_PIECE_TYPE_COUNT] = {
        [MPM_PIECE_DOUBLE] = sizeof(double), [MPM_PIECE_UINT64] = sizeof(uint64_t),
        [MPM_PIECE_INT64] = sizeof(int64_t), [MPM_PIECE_UINT32] = sizeof(uint32_t),
        [MPM_PIECE_INT32] = sizeof(int32_t), [MPM_PIECE_UINT8] = sizeof(uint8_t),
        [MPM_PIECE_BOOL] = sizeof(bool),
    };
    return piece->count * sizes[piece->type];
}
