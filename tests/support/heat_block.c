/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "support/heat_block.h"

#include "method/transport/transport.h"
#include "support/near.h"

const char HEAT_BLOCK[] = TEST_BLOCK_SCENE(
    "{end: 1000, courant: 0.3}",
    "{name: soft, law: neo_hookean, density: 2, bulk: 1.25, shear: 0.75, heat_capacity: 0.5, "
    "conductivity: 0.25}",
    "  - {name: block, material: soft, region: {rectangle: {from: [3, 3.2],\n"
    "     to: [9, 8]}}, particles_per_cell: [3, 1]}\n"
    "transport: {temperature: {}}\n");

const char HEAT_BLOCK_HOT_SIDE[] =
    "transport.temperature.conditions=[{region: {line: {from: [0, 3.2], to: [14, 3.2]}}, "
    "value: '1+0.1*t'}]";

const char HEAT_BLOCK_AT_REST[] =
    "materials=[{name: soft, law: none, density: 2, heat_capacity: 0.5, conductivity: 0.25}]";

void heat_block_add_transfer(struct settings *settings, int transfer)
{
    static const char *const transfers[HEAT_BLOCK_TRANSFERS][2] = {
        {"flip", NULL},
        {"pic", NULL},
        {"xpic", "transport.temperature.order=3"},
        {"fmpm", "transport.temperature.order=2"},
    };
    settings_add_formatted(settings, "transport.temperature.transfer=%s", transfers[transfer][0]);
    if (transfers[transfer][1] != NULL)
        settings_add(settings, transfers[transfer][1]);
}

void heat_block_add_wild_heat(struct settings *settings, bool axisymmetric)
{
    settings_add(settings, axisymmetric ? "transport.temperature.start='sin(3*r)*cos(2*z)'"
                                        : "transport.temperature.start='sin(3*x)*cos(2*y)'");
    settings_add(settings, axisymmetric ? "transport.temperature.source='cos(r+2*z+t)'"
                                        : "transport.temperature.source='cos(x+2*y+t)'");
}

struct test_run heat_block_open(const struct settings *settings, enum mpm_kernels kernels)
{
    struct mpm_error error = {.message = ""};
    const struct mpm_simulation_options options = {.kernels = kernels, .threads = 1};
    struct test_run run = test_run_open(HEAT_BLOCK, settings->texts, 1);
    mpm_simulation_free(run.simulation);
    ck_assert_msg(mpm_simulation_create(run.scene, &options, &run.simulation, &error) == MPM_OK,
                  "%s", error.message);
    return run;
}

enum mpm_kernels heat_block_kernels(int set)
{
    return set == 0 ? MPM_KERNELS_REFERENCE : MPM_KERNELS_AUTO;
}

struct mpm_nodal_scalar *heat_block_scalar(const struct test_run *run)
{
    return &run->simulation->state.transport.list[0];
}

double heat_block_heat(const struct test_run *run)
{
    return mpm_transport_content(&run->simulation->state, heat_block_scalar(run), NULL);
}

struct settings heat_block_rest_settings(int index)
{
    const struct test_combination c = test_combination(index);
    struct settings settings = {.count = 0};
    settings_add_formatted(&settings, "method.shape=%s", c.shape);
    settings_add_formatted(&settings, "geometry=%s", c.geometry);
    settings_add(&settings, "time={end: 1000, step: 0.05}");
    heat_block_add_wild_heat(&settings, c.axisymmetric);
    settings_add(&settings, HEAT_BLOCK_HOT_SIDE);
    return settings;
}
