/* SPDX-License-Identifier: GPL-3.0-or-later */
#define _DEFAULT_SOURCE /* NOLINT */
#include "support/call_order.h"

#include <glib.h>
#include <stddef.h>

static GString *record;

#ifdef __linux__

#include <fcntl.h>
#include <stdio.h>
#include <sys/syscall.h>
#include <unistd.h>

static void add(const char *call, const char *path)
{
    char *const name = g_path_get_basename(path);
    if (record != NULL)
        g_string_append_printf(record, "%s %s\n", call, name);
    g_free(name);
}

/* The linker takes these for those of the C library. */
int fsync(int file)
{
    char *const link = g_strdup_printf("/proc/self/fd/%d", file);
    char *const path = g_file_read_link(link, NULL);
    add("fsync", path != NULL ? path : "?");
    g_free(path);
    g_free(link);
    return (int)syscall(SYS_fsync, file);
}

int rename(const char *from, const char *to)
{
    add("rename", from);
    return renameat(AT_FDCWD, from, AT_FDCWD, to);
}

bool test_call_order_start(void)
{
    record = g_string_new(NULL);
    return true;
}

#else

bool test_call_order_start(void)
{
    return false;
}

#endif

char *test_call_order_end(void)
{
    GString *const all = record;
    record = NULL;
    return g_string_free(all, FALSE);
}
