/* A YAML file as JSON.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_SCORE_SCENE_JSON_H
#define VERIFICATION_SCORE_SCENE_JSON_H

#include "mpm.h"

#include <jansson.h>

/* The whole file: mappings as objects, lists as arrays, plain numbers and true and false as such,
 * all else as text. MPM_BAD_INPUT if it cannot be read. json_decref. */
enum mpm_status scene_json_read(const char *path, json_t **json, struct mpm_error *error);

#endif
