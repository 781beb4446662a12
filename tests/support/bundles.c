/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "support/bundles.h"

#include "support/command.h"
#include "support/folder.h"
#include "support/marks.h"

#include <glib.h>
#include <string.h>

char *test_bundles;

void test_bundles_export(void)
{
    test_bundles = test_folder_create();
    struct test_command command =
        test_command_run("mpm-verify", "export", "--output", test_bundles, NULL);
    ck_assert_msg(command.exit_status == 0, "%s", command.errors);
    ck_assert_ptr_nonnull(strstr(command.output, "38 exported, 61 not exportable"));
    ck_assert_ptr_nonnull(strstr(command.output, "S1       not exportable: it integrates"));
    test_command_free(&command);
}

void test_bundles_remove(void)
{
    test_folder_remove(test_bundles);
}

void test_bundle_open(const char *name, struct bundle *bundle)
{
    char *path = test_folder_path(test_bundles, name);
    struct mpm_error error = {.message = ""};
    ck_assert_msg(bundle_read(path, bundle, &error) == MPM_OK, "%s", error.message);
    g_free(path);
}
