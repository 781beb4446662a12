/* What holds the surfaces of a crack together, and whether its opening is tracked.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/scene/scene_build.h"

static bool has_knee(const struct mpm_cohesive *cohesive)
{
    return cohesive->law->work_to_knee != NULL;
}

static enum mpm_status check_knee_keys(const struct mpm_reading *reading, const char *path,
                                       const struct mpm_raw_cohesive *raw,
                                       const struct mpm_cohesive *cohesive)
{
    const struct {
        const char *key, *given;
    } keys[] = {{"knee_opening", raw->knee_opening}, {"knee_traction", raw->knee_traction}};
    for (size_t k = 0; k < sizeof keys / sizeof *keys; k++) {
        if (has_knee(cohesive) && keys[k].given == NULL)
            return mpm_reading_fault(reading, path,
                                     "%s without %s; allowed: with knee_opening and "
                                     "knee_traction",
                                     cohesive->law->name, keys[k].key);
        if (!has_knee(cohesive) && keys[k].given != NULL)
            return mpm_reading_fault(reading, mpm_path_join(path, keys[k].key).text,
                                     "given with law: %s, got %s; allowed: with trilinear only",
                                     cohesive->law->name, keys[k].given);
    }
    return MPM_OK;
}

static enum mpm_status check_knee(const struct mpm_reading *reading, const char *path,
                                  const struct mpm_cohesive *cohesive)
{
    const double onset = cohesive->strength / cohesive->stiffness;
    if (!has_knee(cohesive))
        return MPM_OK;
    if (!(cohesive->knee_opening > onset))
        return mpm_reading_fault(reading, mpm_path_join(path, "knee_opening").text,
                                 "got %g; allowed: above %g, the opening strength/stiffness at "
                                 "which the traction begins to fall",
                                 cohesive->knee_opening, onset);
    if (!(cohesive->knee_traction <= cohesive->strength))
        return mpm_reading_fault(reading, mpm_path_join(path, "knee_traction").text,
                                 "got %g; allowed: up to the strength, %g", cohesive->knee_traction,
                                 cohesive->strength);
    return MPM_OK;
}

static enum mpm_status build_law(const struct mpm_reading *reading, const char *path,
                                 const struct mpm_raw_cohesive *raw, struct mpm_cohesive *cohesive)
{
    double least;
    cohesive->law = mpm_cohesive_law((enum mpm_cohesive_kind)raw->law);
    cohesive->strength = mpm_raw_double(raw->strength);
    cohesive->toughness = mpm_raw_double(raw->toughness);
    cohesive->stiffness = mpm_raw_double(raw->stiffness);
    cohesive->knee_opening = mpm_raw_double(raw->knee_opening);
    cohesive->knee_traction = mpm_raw_double(raw->knee_traction);
    MPM_TRY(check_knee_keys(reading, path, raw, cohesive));
    MPM_TRY(check_knee(reading, path, cohesive));
    if (!mpm_cohesive_settle(cohesive, &least))
        return mpm_reading_fault(reading, mpm_path_join(path, "toughness").text,
                                 "got %g; allowed: above %g, the work of what the other keys "
                                 "describe (%s)",
                                 cohesive->toughness, least,
                                 has_knee(cohesive) ? "up to the knee"
                                                    : "strength^2/(2 stiffness)");
    return MPM_OK;
}

enum mpm_status mpm_build_cohesive(const struct mpm_reading *reading, const char *path,
                                   const struct mpm_raw_crack *raw, struct mpm_crack_spec *crack)
{
    crack->opening = raw->opening;
    if (raw->cohesive != NULL)
        MPM_TRY(build_law(reading, mpm_path_join(path, "cohesive").text, raw->cohesive,
                          &crack->cohesive));
    const bool tracked = crack->opening || crack->cohesive.law != NULL;
    if (tracked && reading->scene->crack_method == MPM_CRACKS_VISIBILITY)
        return mpm_reading_fault(reading, "method.cracks",
                                 "visibility with %s: its nodes have no field of their own for "
                                 "each surface; allowed: fields",
                                 crack->cohesive.law != NULL ? "cracks.cohesive"
                                                             : "cracks.opening");
    return MPM_OK;
}
