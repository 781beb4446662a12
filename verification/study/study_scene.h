/* What a study needs to know of its scene, and changes in it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_STUDY_STUDY_SCENE_H
#define VERIFICATION_STUDY_STUDY_SCENE_H

#include "verification/study/study.h"

/* Fills in title, text, geometry and unit of length. MPM_BAD_INPUT: no scene, or no YAML. */
enum mpm_status study_scene_open(struct study *study, struct mpm_error *error);

/* Adds the settings of a level to those of a run: each cell is divided into `level` along each axis
 * (grid.refine is multiplied), a fixed time.step is divided by it; history and snapshots as the
 * measures need them. *cell: size of a cell along the first axis. */
enum mpm_status study_scene_refine(const struct study *study, int64_t level, GPtrArray *settings,
                                   double *cell, struct mpm_error *error);

/* Tries a run's first step, in a temporary folder: MPM_BAD_INPUT where the scene cannot be run, or
 * a measure is no quantity of it; fills in the units of measures that have none yet. */
enum mpm_status study_scene_try(struct study *study, const struct study_run *run,
                                struct mpm_error *error);

#endif
