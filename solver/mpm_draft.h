/* Scenes made by calls: a draft is set value by value, by the paths and with the checks of `mpm run
 * --set`, and becomes a scene. Part of the public interface: mpm.h includes it.
 *
 *     struct mpm_draft *draft = NULL;
 *     status = mpm_draft_create("bar", NULL, 0, &draft, &error);
 *     mpm_draft_set_text(draft, "geometry", "plane_strain", NULL);
 *     mpm_draft_set_pair(draft, "grid.cell", 0.5, 0.5, NULL);
 *     mpm_draft_set(draft, "bodies.+", "{name: bar, material: steel, ...}", NULL);
 *     mpm_draft_set_number(draft, "materials.steel.density", 7.8e-3, NULL);
 *     status = mpm_draft_build(draft, &scene, &error);
 *
 * A setter that fails leaves the draft without that value. One that had NULL for *error makes
 * mpm_draft_build fail with its message: such a caller may look at the status of the build alone.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_DRAFT_H
#define MPM_DRAFT_H

#include "mpm_error.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

MPM_API_BEGIN

struct mpm_scene;
struct mpm_draft;

/* Starts from a YAML text of `length` bytes, a whole scene or parts of one, or from nothing
 * (`text` NULL). `name` is what messages and the records of runs call the scene by. MPM_BAD_INPUT:
 * no YAML. On failure *draft is NULL. */
enum mpm_status mpm_draft_create(const char *name, const char *text, size_t length,
                                 struct mpm_draft **draft, struct mpm_error *error);
void mpm_draft_free(struct mpm_draft *draft);

/* Sets the value at a path: keys joined by points, entries of lists by position, by their `name`,
 * or + for a new one at the end: "bodies.+", "bodies.disk.velocity". `value` is YAML; an empty one
 * takes the key or entry out. The last value of a path wins. MPM_BAD_INPUT: no such key or entry,
 * no YAML, and, for a key that is no group of others, a value of another kind or out of range; the
 * message has path, value and what is allowed. */
enum mpm_status mpm_draft_set(struct mpm_draft *draft, const char *path, const char *value,
                              struct mpm_error *error);

/* The same with values of C. Numbers keep all bits; a text is taken as it is, never as YAML. */
enum mpm_status mpm_draft_set_number(struct mpm_draft *draft, const char *path, double value,
                                     struct mpm_error *error);
enum mpm_status mpm_draft_set_integer(struct mpm_draft *draft, const char *path, int64_t value,
                                      struct mpm_error *error);
enum mpm_status mpm_draft_set_boolean(struct mpm_draft *draft, const char *path, bool value,
                                      struct mpm_error *error);
enum mpm_status mpm_draft_set_text(struct mpm_draft *draft, const char *path, const char *value,
                                   struct mpm_error *error);
enum mpm_status mpm_draft_set_pair(struct mpm_draft *draft, const char *path, double first,
                                   double second, struct mpm_error *error);
/* A list of points: x and y of the first, of the second, ... */
enum mpm_status mpm_draft_set_points(struct mpm_draft *draft, const char *path,
                                     const double *values, size_t point_count,
                                     struct mpm_error *error);

/* Checks all of the draft as mpm_scene_read checks a file, and makes the scene. The draft can be
 * changed and built again; scenes do not depend on it. */
enum mpm_status mpm_draft_build(const struct mpm_draft *draft, struct mpm_scene **scene,
                                struct mpm_error *error);

MPM_API_END

#endif
