/* Running a program, on GLib.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "support/command.h"
#include "support/marks.h"

#include <glib.h>
#include <stdarg.h>
#include <string.h>
#include <sys/wait.h>

/* MPM_BIN: the folder of the programs under test, set by `make test`. */
static char *program_path(const char *program)
{
    const char *folder = g_getenv("MPM_BIN");
    if (strchr(program, '/') != NULL)
        return g_strdup(program);
    return g_build_filename(folder != NULL ? folder : "build/release/bin", program, NULL);
}

static int exit_status(int wait_status)
{
    return WIFEXITED(wait_status) ? WEXITSTATUS(wait_status) : 128 + WTERMSIG(wait_status);
}

struct test_command test_command_run(const char *program, ...)
{
    GPtrArray *arguments = g_ptr_array_new_with_free_func(g_free);
    g_ptr_array_add(arguments, program_path(program));
    va_list list;
    va_start(list, program);
    for (const char *next = va_arg(list, const char *); next != NULL;
         next = va_arg(list, const char *))
        g_ptr_array_add(arguments, g_strdup(next));
    va_end(list);
    g_ptr_array_add(arguments, NULL);

    struct test_command command = {0};
    GError *error = NULL;
    int wait_status = 0;
    const gboolean started =
        g_spawn_sync(NULL, (char **)arguments->pdata, NULL, G_SPAWN_DEFAULT, NULL, NULL,
                     &command.output, &command.errors, &wait_status, &error);
    ck_assert_msg(started, "%s", error == NULL ? "" : error->message);
    command.exit_status = exit_status(wait_status);
    g_ptr_array_free(arguments, TRUE);
    return command;
}

void test_command_free(struct test_command *command)
{
    g_free(command->output);
    g_free(command->errors);
    *command = (struct test_command){0};
}
