/* Reading scenes in tests.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TESTS_SUPPORT_SCENE_FILES_H
#define TESTS_SUPPORT_SCENE_FILES_H

#include "model/scene.h"

/* The file of the smallest good scene. */
#define TEST_MINIMAL_SCENE "tests/scenes/good/minimal.yaml"

/* The same as a text, to put more behind it. */
extern const char *const TEST_LEAST_SCENE;

/* A scene that must be good, with one setting or NULL; mpm_scene_free it. */
struct mpm_scene *test_scene_read(const char *path, const char *setting);
struct mpm_scene *test_scene_read_text(const char *text);

/* The message of a scene that must be refused as bad input; g_free it. */
char *test_scene_refusal(const char *path);
char *test_scene_refusal_of_text(const char *text);

/* Fails unless the message has the part in it. */
void test_contains(const char *message, const char *part);

#endif
