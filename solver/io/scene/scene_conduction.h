/* Materials' part of scalars that are conducted.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_IO_SCENE_CONDUCTION_H
#define MPM_IO_SCENE_CONDUCTION_H

#include "io/scene/scene_build.h"

/* Capacity, conductivity and expansion of one material; all but expansion are required. */
enum mpm_status mpm_build_conduction(const struct mpm_reading *reading, enum mpm_scalar which,
                                     size_t material);

/* No material has keys of a scalar that is not conducted. */
enum mpm_status mpm_refuse_conduction(const struct mpm_reading *reading, enum mpm_scalar which);

/* No material has heat that a scene with temperatures would not know: an equation of state has a
 * temperature of its own, and work of viscosity would be heat that heating does not have; plastic
 * work heats with heating alone. */
enum mpm_status mpm_check_own_heat(const struct mpm_reading *reading);

/* No material has parameters that only a conducted temperature has a use for. */
enum mpm_status mpm_refuse_heated_laws(const struct mpm_reading *reading);

#endif
