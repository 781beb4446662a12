/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "model/transport.h"

#include "model/particles.h"

const struct mpm_scalar_row mpm_scalar_rows[MPM_SCALAR_COUNT] = {
    [MPM_TEMPERATURE] = {.name = "temperature",
                         .use = MPM_USE_TEMPERATURE,
                         .field = MPM_PARTICLE_TEMPERATURE,
                         .content = MPM_DIMENSION_ENERGY,
                         .content_name = "thermal_energy",
                         .flow_name = "heat"},
};
