/* The catalogue's files: case.yaml and methods.yaml.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "fuzz/fuzz.h"

#include "verification/cases/case_file.h"
#include "verification/cases/methods.h"

#include <glib.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static const char *const names[] = {"case.yaml", "methods.yaml", NULL};
    struct mpm_error error = {.status = MPM_OK};
    struct method_table *table = NULL;
    struct case_file *file = NULL;
    fuzz_write_all(data, size, names);
    char *const path = g_build_filename(fuzz_folder(), names[0], NULL);
    if (fuzz_judge(methods_load(fuzz_folder(), &table, &error), &error) &&
        fuzz_judge(case_file_load(path, &file, &error), &error) &&
        fuzz_judge(methods_add_variants(path, table, file, &error), &error))
        (void)fuzz_judge(case_file_check(path, file, &error), &error);
    case_file_free(file);
    methods_free(table);
    g_free(path);
    return 0;
}
