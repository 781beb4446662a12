/* A study as a catalogue of the suite: <folder>/study/ holds
 *
 *     study.yaml                   the study, complete
 *     scene.yaml                   its scene as the runs have it
 *     catalogue/study/<run>/       case.yaml, scene.yaml, README.md, reference-<k>.csv
 *     study.csv  study.jsonl  study.md  *.svg      (study_write.h)
 *
 * Each run is a case of its own, so that a run whose inputs stay keeps its result.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_STUDY_STUDY_CATALOGUE_H
#define VERIFICATION_STUDY_STUDY_CATALOGUE_H

#include "verification/study/study.h"

char *study_folder(const char *output);     /* <output>/study; g_free */
char *study_file_path(const char *output);  /* its study.yaml; g_free */
char *study_scene_path(const char *output); /* its scene.yaml; g_free */
char *study_catalogue(const char *output);  /* its catalogue; g_free */

/* Replaces what is there, for a checked study; takes the folder for this time as a run does. */
enum mpm_status study_catalogue_write(const struct study *study, const char *output,
                                      struct mpm_error *error);

#endif
