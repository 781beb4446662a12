/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/results/provenance.h"

#include <glib.h>
#include <string.h>

void mpm_provenance_fill(const struct mpm_scene *scene, struct mpm_provenance *provenance)
{
    const struct mpm_build_info *build = mpm_build_info();
    for (size_t i = 0; i < sizeof scene->sha256; i++)
        g_snprintf(provenance->scene_sha256 + 2 * i, 3, "%02x", scene->sha256[i]);
    const struct mpm_fact facts[MPM_FACT_COUNT] = {
        {"scene_sha256", provenance->scene_sha256},
        {"version", build->version},
        {"revision", build->revision},
        {"compiler", build->compiler},
        {"flags", build->flags},
        {"libraries", build->libraries},
    };
    memcpy(provenance->facts, facts, sizeof facts);
}
