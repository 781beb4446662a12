/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fuzz/fuzz.h"

#include <glib.h>
#include <glib/gstdio.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The names are those of the sanitizers. */
/* NOLINTBEGIN(readability-identifier-naming,bugprone-reserved-identifier) */
/* A single allocation of more than 64 MB fails, so that what takes much memory has to be refused
 * before, or to end with a message. */
const char *__asan_default_options(void);
const char *__asan_default_options(void)
{
    return "max_allocation_size_mb=64:allocator_may_return_null=1:detect_leaks=1:handle_abort=1:"
           "detect_stack_use_after_return=0:quarantine_size_mb=32";
}

const char *__ubsan_default_options(void);
const char *__ubsan_default_options(void)
{
    return "print_stacktrace=1";
}

/* HDF5 has memory of its own until the program ends, some of it hidden from the search for leaks,
 * which goes on after each input here; the unit tests' search at the end finds none. */
const char *__lsan_default_suppressions(void);
const char *__lsan_default_suppressions(void)
{
    return "leak:libhdf5\n";
}
/* NOLINTEND(readability-identifier-naming,bugprone-reserved-identifier) */

/* -------------------------------------------------------------------- files */

static char *folder;

static void empty_tree(const char *path)
{
    GDir *const entries = g_dir_open(path, 0, NULL);
    for (const char *name; entries != NULL && (name = g_dir_read_name(entries)) != NULL;) {
        char *const entry = g_build_filename(path, name, NULL);
        if (g_unlink(entry) != 0) {
            empty_tree(entry);
            (void)g_rmdir(entry);
        }
        g_free(entry);
    }
    if (entries != NULL)
        g_dir_close(entries);
}

static void remove_folder(void)
{
    empty_tree(folder);
    (void)g_rmdir(folder);
    g_free(folder);
    folder = NULL;
}

const char *fuzz_folder(void)
{
    if (folder != NULL)
        return folder;
    folder = g_dir_make_tmp("touchstone-fuzz-XXXXXX", NULL);
    if (folder == NULL) {
        (void)fprintf(stderr, "fuzz: no folder can be made in %s\n", g_get_tmp_dir());
        exit(2);
    }
    (void)atexit(remove_folder);
    return folder;
}

void fuzz_clear(void)
{
    empty_tree(fuzz_folder());
}

const char *fuzz_write(const char *name, const void *data, size_t size)
{
    static char path[4096];
    (void)g_snprintf(path, sizeof path, "%s/%s", fuzz_folder(), name);
    FILE *const file = fopen(path, "wb");
    if (file == NULL || fwrite(data, 1, size, file) != size || fclose(file) != 0) {
        (void)fprintf(stderr, "fuzz: %s cannot be written\n", path);
        exit(2);
    }
    return path;
}

static bool is_one_of(const char *name, const char *const *names)
{
    while (*names != NULL && strcmp(*names, name) != 0)
        names++;
    return *names != NULL;
}

void fuzz_write_all(const uint8_t *data, size_t size, const char *const *names)
{
    static const char mark[] = "=== ";
    const char *const text = (const char *)data, *const end = text + size;
    fuzz_clear();
    const char *start = g_strstr_len(text, (gssize)size, mark);
    while (start != NULL) {
        const char *const name = start + strlen(mark);
        const char *const line = memchr(name, '\n', (size_t)(end - name));
        if (line == NULL)
            return;
        char *const own = g_strndup(name, (gsize)(line - name));
        start = g_strstr_len(line, end - line, "\n=== ");
        if (is_one_of(own, names))
            (void)fuzz_write(own, line + 1, (size_t)((start == NULL ? end : start + 1) - line) - 1);
        g_free(own);
        start = start == NULL ? NULL : start + 1;
    }
}

/* ------------------------------------------------------------------ judging */

bool fuzz_judge(enum mpm_status status, const struct mpm_error *error)
{
    if (status == MPM_OK)
        return true;
    const bool known = status == MPM_BAD_INPUT || status == MPM_RUN_FAILED ||
                       status == MPM_ENVIRONMENT_FAILED || status == MPM_INTERRUPTED;
    if (!known || error->status != status || error->message[0] == '\0' ||
        strchr(error->message, '\n') != NULL) {
        (void)fprintf(stderr, "fuzz: status %d with the message \"%s\" of status %d\n", (int)status,
                      error->message, (int)error->status);
        abort();
    }
    return false;
}
