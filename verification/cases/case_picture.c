/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/cases/case_picture.h"

#include "verification/cases/yaml_place.h"

#include <math.h>
#include <string.h>

static bool has_scene(const struct case_file *file)
{
    return file->scene != NULL;
}

const struct case_variant *case_picture_variant(const struct case_file *file)
{
    const char *const name = file->picture == NULL ? NULL : file->picture->variant;
    if (!has_scene(file) || file->no_picture != NULL)
        return NULL;
    for (unsigned i = 0; i < file->variants_count; i++)
        if (name == NULL ? file->variants[i].tier == TIER_CI
                         : strcmp(name, file->variants[i].name) == 0)
            return &file->variants[i];
    return name == NULL && file->variants_count > 0 ? &file->variants[0] : NULL;
}

struct case_picture case_picture_of(const struct case_file *file)
{
    static const struct case_picture none = {.time = (double)NAN, .magnify = (double)NAN};
    struct case_picture picture = file->picture == NULL ? none : *file->picture;
    if (picture.simulation == 0)
        picture.simulation = 1;
    return picture;
}

enum mpm_status case_picture_check(const char *path, const struct case_file *file,
                                   struct mpm_error *error)
{
    const struct case_picture *const picture = file->picture;
    if (file->no_picture != NULL && picture != NULL)
        return yaml_refuse(path, error, "no_picture", "there is a picture");
    if (picture == NULL)
        return MPM_OK;
    if (!has_scene(file))
        return yaml_refuse(path, error, "picture", "shows the case's scene, and it has none");
    if (case_picture_variant(file) == NULL)
        return yaml_refuse(path, error, "picture", "variant \"%s\" is none of the case",
                           picture->variant);
    if (picture->time_text != NULL && !(picture->time > 0))
        return yaml_refuse(path, error, "picture", "time %s: allowed are times > 0",
                           picture->time_text);
    if (picture->magnify_text != NULL && !(picture->magnify >= 1))
        return yaml_refuse(path, error, "picture", "magnify %s: allowed are numbers >= 1",
                           picture->magnify_text);
    return MPM_OK;
}
