/* What a run has left of its scene for pictures: picture-<variant>.json, read and checked, since a
 * folder of results may come from anywhere.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_REPORT_PICTURE_FILE_H
#define VERIFICATION_REPORT_PICTURE_FILE_H

#include "verification/common/failure.h"

#include <jansson.h>
#include <stdbool.h>
#include <stddef.h>

struct picture_frame {
    double time;
    double *u, *g, *value; /* 2, 4 and 1 of each particle: displacement, F - 1, a value or NAN */
    const json_t *cracks;  /* lists of coordinates; may be NULL */
};

/* States of the particles that are drawn. */
struct picture_states {
    size_t stride; /* one of stride by stride neighbours is there */
    size_t count, frame_count;
    double *start, *half; /* 2 of each particle; 2 of each body */
    size_t *body;
    struct picture_frame *frames;
};

struct picture_file {
    json_t *object;
    const json_t *scene;
    const char *variant, *title, *unit; /* of the field; unit "1": none */
    bool is_signed;
    double magnify;
    size_t particles, body_count;
    struct picture_states still, motion; /* motion.frame_count 0: there is none */
};

/* MPM_BAD_INPUT: there is no such file, or it is not what a run writes. */
enum mpm_status picture_file_read(const char *path, struct picture_file *file,
                                  struct mpm_error *error);
void picture_file_clear(struct picture_file *file);

/* A number or two numbers of a scene, small enough to be drawn, in a list or at the key of an
 * object; false: there are none. */
bool picture_point(const json_t *list, double point[2]);
bool picture_pair(const json_t *object, const char *key, double pair[2]);
bool picture_number(const json_t *object, const char *key, double *number);

#endif
