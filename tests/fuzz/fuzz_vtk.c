/* VTK: legacy files, XML files, and collections. An input that begins with "=== " is several files,
 * one with '<' is XML.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "fuzz/fuzz.h"

#include "verification/score/results.h"

#include <glib.h>
#include <string.h>

static void read_results(const char *name)
{
    const struct score_format format = {MPM_PLANE_STRAIN, {"mm", "g", "ms", "K"}, 0};
    struct mpm_error error = {.status = MPM_OK};
    struct score_table table;
    char *const path = g_build_filename(fuzz_folder(), name, NULL);
    if (fuzz_judge(results_read(path, &format, &table, &error), &error))
        score_table_close(&table);
    g_free(path);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static const char *const names[] = {"results.pvd", "a.vtu", "b.vtp", "c.vtk", NULL};
    if (size >= 4 && memcmp(data, "=== ", 4) == 0) {
        fuzz_write_all(data, size, names);
        read_results("results.pvd");
    } else {
        const char *const name = size > 0 && data[0] == '<' ? "results.vtu" : "results.vtk";
        (void)fuzz_write(name, data, size);
        read_results(name);
    }
    return 0;
}
