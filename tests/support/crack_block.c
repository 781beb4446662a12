/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "support/crack_block.h"

#include <stdlib.h>

const char CRACK_BLOCK[] =
    TEST_BLOCK_SCENE("{end: 1000, courant: 0.3}",
                     "{name: rubber, law: neo_hookean, density: 1, bulk: 80, shear: 48}",
                     "  - {name: block, material: rubber, region: {rectangle: {from: [3, 3.2],\n"
                     "     to: [9, 8]}}, particles_per_cell: [2, 2]}\n");

struct settings crack_block_method(int index)
{
    static const char *const shapes[CRACK_BLOCK_FAMILIES] = {"classic", "ugimp", "cpdi",
                                                             "bspline2"};
    struct settings settings = {.count = 0};
    settings_add_formatted(&settings, "method={shape: %s, stress_update: %s}",
                           shapes[index % CRACK_BLOCK_FAMILIES],
                           test_orders[index / CRACK_BLOCK_FAMILIES % TEST_ORDERS]);
    return settings;
}

int crack_block_add_exchange(struct settings *settings, int index)
{
    static const char *const transfers[CRACK_BLOCK_TRANSFERS] = {
        "transfer={kind: flip}",
        "transfer={kind: flip, fraction: 0.95}",
        "transfer={kind: flip, fraction: 0.5}",
        "transfer={kind: pic}",
        "transfer={kind: xpic, order: 2}",
        "transfer={kind: xpic, order: 5}",
        "transfer={kind: fmpm, order: 3}",
        [CRACK_BLOCK_APIC] = "transfer={kind: apic}",
        [CRACK_BLOCK_FORM] = "form=momentum",
    };
    settings_add_formatted(settings, "method.%s", transfers[index / CRACK_BLOCK_WAYS]);
    settings_add_formatted(settings, "method.position_update=%s",
                           index % CRACK_BLOCK_WAYS == 0 ? "grid_velocity" : "midpoint");
    return index / CRACK_BLOCK_WAYS;
}

bool crack_block_amplifies(int index)
{
    return index % CRACK_BLOCK_METHODS == 0;
}

struct test_run crack_block_open(struct settings *settings)
{
    const struct test_run run = test_run_open(CRACK_BLOCK, settings->texts, 1);
    settings_clear(settings);
    return run;
}

const struct mpm_state *crack_block_state(const struct test_run *run)
{
    return &run->simulation->state;
}

struct crack_block_start crack_block_start(const struct test_run *run)
{
    struct crack_block_start start;
    start.place = test_run_field(run, MPM_FIELD_POSITION, &start.count);
    start.mass = test_run_field(run, MPM_FIELD_MASS, NULL);
    start.velocity = test_run_field(run, MPM_FIELD_VELOCITY, NULL);
    return start;
}

void crack_block_start_free(struct crack_block_start *start)
{
    free(start->place);
    free(start->mass);
    free(start->velocity);
}

void crack_block_momentum(const struct test_run *run, const struct crack_block_start *start,
                          bool above, double momentum[2])
{
    static const double MIDDLE = 5.6;
    double *const velocity = test_run_field(run, MPM_FIELD_VELOCITY, NULL);
    momentum[0] = momentum[1] = 0.0;
    for (size_t k = 0; k < start->count; k++)
        for (size_t axis = 0; axis < 2 && (start->place[2 * k + 1] > MIDDLE) == above; axis++)
            momentum[axis] += start->mass[k] * velocity[2 * k + axis];
    free(velocity);
}
