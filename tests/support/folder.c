/* Temporary folders, on GLib.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "support/folder.h"
#include "support/marks.h"

#include <glib.h>
#include <glib/gstdio.h>

char *test_folder_create(void)
{
    GError *error = NULL;
    char *folder = g_dir_make_tmp("mpm-test-XXXXXX", &error);
    ck_assert_msg(folder != NULL, "%s", error == NULL ? "" : error->message);
    return folder;
}

static void remove_tree(const char *path)
{
    const bool is_folder =
        g_file_test(path, G_FILE_TEST_IS_DIR) && !g_file_test(path, G_FILE_TEST_IS_SYMLINK);
    GDir *entries = is_folder ? g_dir_open(path, 0, NULL) : NULL;
    if (entries != NULL) {
        for (const char *name = g_dir_read_name(entries); name != NULL;
             name = g_dir_read_name(entries)) {
            char *entry = g_build_filename(path, name, NULL);
            remove_tree(entry);
            g_free(entry);
        }
        g_dir_close(entries);
    }
    (void)g_remove(path);
}

void test_folder_remove(char *folder)
{
    remove_tree(folder);
    g_free(folder);
}

char *test_folder_path(const char *folder, const char *name)
{
    return g_build_filename(folder, name, NULL);
}

char *test_folder_write(const char *folder, const char *name, const char *text)
{
    GError *error = NULL;
    char *path = test_folder_path(folder, name);
    ck_assert_msg(g_file_set_contents(path, text, -1, &error), "%s",
                  error == NULL ? "" : error->message);
    return path;
}

char *test_file_read(const char *path)
{
    GError *error = NULL;
    char *text = NULL;
    ck_assert_msg(g_file_get_contents(path, &text, NULL, &error), "%s",
                  error == NULL ? "" : error->message);
    return text;
}

bool test_file_exists(const char *path)
{
    return g_file_test(path, G_FILE_TEST_EXISTS);
}
