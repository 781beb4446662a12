/* What is known of scalars that a scene conducts: temperature. Part of the public interface: mpm.h
 * includes it. Values of particles are MPM_FIELD_TEMPERATURE.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_TRANSPORT_H
#define MPM_TRANSPORT_H

#include "mpm_api.h"

#include <stdbool.h>
#include <stddef.h>

MPM_API_BEGIN

struct mpm_scene;
struct mpm_simulation;
struct mpm_quantity_info; /* mpm.h */

/* Does the scene conduct any? */
bool mpm_scene_has_transport(const struct mpm_scene *scene);

/* Have its materials no stress, law: none, so that nothing but conduction is computed? */
bool mpm_scene_is_at_rest(const struct mpm_scene *scene);

/* Do stresses and scalars depend on each other, by free expansion, the law or plastic work: has its
 * history the column expansion_work? Does deformation change temperatures, with deformation_heat
 * and thermoelastic_energy? And is plastic work a part of that, with plastic_heat? */
bool mpm_scene_couples(const struct mpm_scene *scene);
bool mpm_scene_heats(const struct mpm_scene *scene);
bool mpm_scene_has_plastic_heat(const struct mpm_scene *scene);

/* Values of the history, scalar by scalar: of temperature thermal_energy, boundary_heat
 * (at nodes with a prescribed one), source_heat, edge_heat (fluxes), temperature_min and
 * temperature_max. Per thickness or per radian, as all sums. The change of thermal_energy since t =
 * 0 is boundary_heat + source_heat + edge_heat, to round-off. */
size_t mpm_scene_transport_quantity_count(const struct mpm_scene *scene);
struct mpm_quantity_info mpm_scene_transport_quantity(const struct mpm_scene *scene, size_t index);
/* Cost: up to one pass over the particles. */
double mpm_simulation_transport_quantity(const struct mpm_simulation *simulation, size_t index);

MPM_API_END

#endif
