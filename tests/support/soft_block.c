/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "support/soft_block.h"

/* Work is a sum of force times velocity times time: velocities agree to the bound times
 * the wave speed, forces to the bound times the stiffness times the length of 5 that is held. */
void test_soft_block_assert_alike(struct kernel_pair *pair, int steps)
{
    static const double WAVE_SPEED = 1.5, STIFFNESS = 2.25, LENGTH = 5.0, ACCELERATION = 0.085;
    struct mpm_ledger ledger;
    kernel_pair_assert_alike(pair, steps);
    mpm_simulation_ledger(pair->simulation[0], &ledger);
    kernel_pair_assert_same_work(pair, ACCELERATION * ledger.mass + STIFFNESS * LENGTH, WAVE_SPEED);
    kernel_pair_close(pair);
}
