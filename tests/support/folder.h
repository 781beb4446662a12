/* Temporary folders and the files in them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TESTS_SUPPORT_FOLDER_H
#define TESTS_SUPPORT_FOLDER_H

#include <stdbool.h>

/* A new empty folder; the test fails if there can be none. g_free the path. */
char *test_folder_create(void);

/* Removes the folder with all that it holds, and frees the path. */
void test_folder_remove(char *folder);

/* The path of `name` in `folder`; g_free it. */
char *test_folder_path(const char *folder, const char *name);

/* Writes a text file into the folder; returns its path, g_free it. */
char *test_folder_write(const char *folder, const char *name, const char *text);

/* The whole of a file as text, the test fails if it cannot be read; g_free it. */
char *test_file_read(const char *path);
bool test_file_exists(const char *path);

#endif
