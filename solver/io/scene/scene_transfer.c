/* How a scene's particles and nodes exchange velocities: which keys and choices go together.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/scene/scene_build.h"
#include "method/transfer/transfers.h"

static enum mpm_status check_keys(const struct mpm_reading *reading,
                                  const struct mpm_transfer *transfer)
{
    const bool fraction = mpm_reading_given(reading, "method.transfer.fraction");
    const bool order = mpm_reading_given(reading, "method.transfer.order");
    if (fraction && !transfer->fraction)
        return mpm_reading_fault(reading, "method.transfer.fraction",
                                 "kind %s has no fraction: all of a particle's velocity comes "
                                 "from the grid; allowed: fraction with flip",
                                 transfer->name);
    if (order && !transfer->order)
        return mpm_reading_fault(reading, "method.transfer.order",
                                 "kind %s has no order; allowed: order with xpic and fmpm",
                                 transfer->name);
    if (transfer->order && !order)
        return mpm_reading_fault(reading, "method.transfer.kind",
                                 "%s without an order; allowed: {kind: %s, order: 2}, or another "
                                 "order from 1",
                                 transfer->name, transfer->name);
    return MPM_OK;
}

static enum mpm_status build_transfer(const struct mpm_reading *reading)
{
    struct mpm_scene *const scene = reading->scene;
    const struct mpm_raw_transfer *const raw = reading->raw->method->transfer;
    const struct mpm_transfer *const transfer = mpm_transfer_of((enum mpm_transfer_kind)raw->kind);
    MPM_TRY(check_keys(reading, transfer));
    scene->transfer = (enum mpm_transfer_kind)raw->kind;
    scene->flip_fraction = transfer->fraction ? mpm_raw_double(raw->fraction) : 0.0;
    scene->transfer_order = transfer->order ? (int)raw->order : 1;
    if (scene->form == MPM_FORM_MOMENTUM && transfer->no_momentum != NULL)
        return mpm_reading_fault(reading, "method.form",
                                 "momentum is not defined with transfer %s, which %s; allowed: "
                                 "momentum with flip and pic, or velocity",
                                 transfer->name, transfer->no_momentum);
    return MPM_OK;
}

struct order {
    const char *name;
    bool with, without; /* re-extrapolation is defined, the step without it is */
    const char *hint;   /* what to use instead */
};

static const struct order orders[] = {
    [MPM_USL] = {.name = "usl", .without = true, .hint = "musl, which is usl with it"},
    [MPM_MUSL] = {.name = "musl", .with = true, .hint = "usl, which is musl without it"},
    [MPM_USF] = {.name = "usf",
                 .without = true,
                 .hint = "no extrapolate: no stress update follows it"},
    [MPM_USAVG] = {.name = "usavg", .with = true, .without = true},
};

static enum mpm_status build_stress_update(const struct mpm_reading *reading)
{
    struct mpm_scene *const scene = reading->scene;
    const struct mpm_raw_method *const raw = reading->raw->method;
    const struct order *const order = &orders[raw->stress_update];
    scene->stress_update = (enum mpm_stress_update)raw->stress_update;
    if (!mpm_reading_given(reading, "method.extrapolate"))
        return MPM_OK;
    if (raw->extrapolate ? !order->with : !order->without)
        return mpm_reading_fault(reading, "method.extrapolate",
                                 "got %s, but stress_update %s is defined %s it; allowed: %s",
                                 raw->extrapolate ? "true" : "false", order->name,
                                 raw->extrapolate ? "without" : "with", order->hint);
    if (!raw->extrapolate && scene->stress_update == MPM_USAVG)
        scene->stress_update = MPM_USAVG_ONCE;
    return MPM_OK;
}

enum mpm_status mpm_build_transfer(const struct mpm_reading *reading)
{
    reading->scene->form = (enum mpm_form)reading->raw->method->form;
    MPM_TRY(build_stress_update(reading));
    return build_transfer(reading);
}
