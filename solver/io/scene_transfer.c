/* The transfers of a scene: which keys go with which kind.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/scene_build.h"

struct transfer_keys {
    const char *name;
    bool fraction, order; /* takes this key */
};

static const struct transfer_keys transfers[] = {
    [MPM_TRANSFER_FLIP] = {"flip", .fraction = true},
    [MPM_TRANSFER_PIC] = {"pic"},
    [MPM_TRANSFER_XPIC] = {"xpic", .order = true},
    [MPM_TRANSFER_FMPM] = {"fmpm", .order = true},
};

static enum mpm_status check_keys(const struct mpm_reading *reading,
                                  const struct transfer_keys *transfer)
{
    const bool fraction = mpm_reading_given(reading, "method.transfer.fraction");
    const bool order = mpm_reading_given(reading, "method.transfer.order");
    if (fraction && !transfer->fraction)
        return mpm_reading_fault(reading, "method.transfer.fraction",
                                 "kind %s has no fraction: all of the velocity comes from the "
                                 "grid; allowed: fraction with flip",
                                 transfer->name);
    if (order && !transfer->order)
        return mpm_reading_fault(reading, "method.transfer.order",
                                 "kind %s has no order; allowed: order with xpic and fmpm",
                                 transfer->name);
    if (transfer->order && !order)
        return mpm_reading_fault(reading, "method.transfer.kind",
                                 "%s without an order; allowed: {kind: %s, order: 2}, or another "
                                 "from 1",
                                 transfer->name, transfer->name);
    return MPM_OK;
}

enum mpm_status mpm_build_transfer(const struct mpm_reading *reading)
{
    struct mpm_scene *const scene = reading->scene;
    const struct mpm_raw_transfer *const raw = reading->raw->method->transfer;
    const struct transfer_keys *const transfer = &transfers[raw->kind];
    MPM_TRY(check_keys(reading, transfer));
    scene->transfer = (enum mpm_transfer_kind)raw->kind;
    scene->flip_fraction = transfer->fraction ? mpm_raw_double(raw->fraction) : 0.0;
    scene->transfer_order = transfer->order ? (int)raw->order : 1;
    return MPM_OK;
}
