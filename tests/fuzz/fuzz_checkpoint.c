/* The file of a checkpoint, as `mpm run --resume` reads it: bytes of one that a run has left are
 * changed, and the length and the sum in its head made right, so that what is behind them is
 * reached.
 *
 * An input is a byte for the run, one that says what is right about the head, then edits of SIZE
 * bytes, as `enum part` has them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "fuzz/fuzz.h"
#include "fuzz/fuzz_runs.h"

#include "io/checkpoint/checkpoint.h"

#include <glib.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>

enum part { PLACE, PLACE_MIDDLE, PLACE_HIGH, ACTION, BYTE, SIZE };
enum { HEAD_SIZE = 512, NEAR = 4096, FILES_MAX = 16 };

/* A folder that a run has left, file by file. */
struct left {
    char *names[FILES_MAX], *texts[FILES_MAX];
    gsize sizes[FILES_MAX], count;
};
static struct left left[FUZZ_RUNS];

static int steps_left;

static int end_soon(void)
{
    return steps_left-- > 0 ? 0 : SIGTERM;
}

static enum mpm_status run_scene(size_t run, const char *folder, bool resume, int steps,
                                 struct mpm_error *error)
{
    const struct mpm_run_options options = {.output = folder,
                                            .simulation = fuzz_run_options,
                                            .overwrite = true,
                                            .resume = resume,
                                            .interrupted = end_soon};
    steps_left = steps;
    return mpm_scene_run(fuzz_run_scene(run), &options, error);
}

static void remember(const char *folder, struct left *files)
{
    GDir *const entries = g_dir_open(folder, 0, NULL);
    for (const char *name; (name = g_dir_read_name(entries)) != NULL && files->count < FILES_MAX;) {
        char *const path = g_build_filename(folder, name, NULL);
        if (!g_file_get_contents(path, &files->texts[files->count], &files->sizes[files->count],
                                 NULL))
            g_error("fuzz: %s cannot be read", path);
        files->names[files->count++] = g_strdup(name);
        g_free(path);
    }
    g_dir_close(entries);
}

static void forget(void)
{
    for (size_t k = 0; k < FUZZ_RUNS; k++)
        for (size_t f = 0; f < left[k].count; f++) {
            g_free(left[k].names[f]);
            g_free(left[k].texts[f]);
        }
}

/* ------------------------------------------------------------------- edits */

static void make_head_right(char *file, gsize size)
{
    char *const sum = g_compute_checksum_for_data(G_CHECKSUM_MD5, (const guchar *)file + HEAD_SIZE,
                                                  size - HEAD_SIZE);
    memset(file, 0, HEAD_SIZE);
    (void)g_snprintf(file, HEAD_SIZE, "touchstone checkpoint\nformat %d\nbytes %lld\nmd5 %s\n",
                     MPM_CHECKPOINT_FORMAT, (long long)size, sum);
    g_free(sum);
}

/* One byte, in the whole of the file or near its beginning; or all that follows goes. */
static gsize edit(char *file, gsize size, const uint8_t *part)
{
    const gsize place =
        (part[PLACE] + ((gsize)part[PLACE_MIDDLE] << 8) + ((gsize)part[PLACE_HIGH] << 16));
    const gsize body = size - HEAD_SIZE;
    char *const at =
        file + HEAD_SIZE + place % (part[ACTION] & 1 && body > NEAR ? (gsize)NEAR : body);
    if (part[ACTION] == 0xfe)
        return MAX((gsize)(at - file), HEAD_SIZE + 1);
    if (part[ACTION] & 2)
        *at = (char)((unsigned char)*at ^ (1u << part[BYTE] % 8));
    else
        *at = (char)part[BYTE];
    return size;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct mpm_error error = {.status = MPM_OK};
    if (size < 2)
        return 0;
    fuzz_clear();
    const struct left *const files = &left[data[0] % FUZZ_RUNS];
    for (gsize f = 0; f < files->count; f++) {
        gsize length = files->sizes[f];
        char *const file = g_memdup2(files->texts[f], length);
        const bool checkpoint = strcmp(files->names[f], MPM_CHECKPOINT_NAME) == 0;
        for (size_t at = 2; checkpoint && at + SIZE <= size; at += SIZE)
            length = edit(file, length, data + at);
        if (checkpoint && data[1] % 8 != 7)
            make_head_right(file, length);
        (void)fuzz_write(files->names[f], file, length);
        g_free(file);
    }
    (void)fuzz_judge(run_scene(data[0] % FUZZ_RUNS, fuzz_folder(), true, data[1] / 32, &error),
                     &error);
    return 0;
}

int LLVMFuzzerInitialize(int *argument_count, char ***arguments)
{
    struct mpm_error error = {.status = MPM_OK};
    (void)argument_count;
    (void)arguments;
    for (size_t k = 0; k < FUZZ_RUNS; k++) {
        char *const folder = g_strdup_printf("%s/run-%zu", fuzz_folder(), k);
        if (run_scene(k, folder, false, FUZZ_STEPS, &error) != MPM_INTERRUPTED)
            g_error("fuzz: %s", error.message);
        remember(folder, &left[k]);
        g_free(folder);
    }
    return atexit(forget);
}
