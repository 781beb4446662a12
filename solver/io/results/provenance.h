/* Where results come from: facts that every result file carries.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_IO_PROVENANCE_H
#define MPM_IO_PROVENANCE_H

#include "model/scene.h"

enum { MPM_FACT_COUNT = 6, MPM_SHA256_TEXT_SIZE = 65 };

struct mpm_fact {
    const char *name, *text;
};

struct mpm_provenance {
    struct mpm_fact facts[MPM_FACT_COUNT];
    char scene_sha256[MPM_SHA256_TEXT_SIZE];
};

/* Fills in what the scene and the binary decide: scene_sha256, version, revision,
 * compiler, flags, libraries. None of it depends on the machine, the date, the number of
 * threads or the kernels, so files that hold it stay the same byte by byte. The
 * texts live as long as *provenance. */
void mpm_provenance_fill(const struct mpm_scene *scene, struct mpm_provenance *provenance);

#endif
