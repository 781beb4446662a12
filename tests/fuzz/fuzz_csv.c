/* CSV: results that are scored, numbers that are scored, and tables of reference data.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "fuzz/fuzz.h"

#include "verification/programs/table_file.h"
#include "verification/score/numbers.h"
#include "verification/score/results.h"

#include <glib.h>

static void read_results(const char *path, enum mpm_geometry geometry)
{
    const struct score_format format = {geometry, {"mm", "g", "ms", "K"}, 0};
    struct mpm_error error = {.status = MPM_OK};
    struct score_table table;
    if (fuzz_judge(results_read(path, &format, &table, &error), &error))
        score_table_close(&table);
}

static void read_numbers(const char *path)
{
    static struct bundle_criterion criteria[] = {
        {.check = {.name = (char *)"j", .quantity = (char *)"j", .unit = (char *)"J m^-2"}},
        {.check = {.name = (char *)"k", .quantity = (char *)"k", .unit = (char *)"1"}},
    };
    const struct bundle bundle = {
        .numbers = true, .criteria = criteria, .criterion_count = G_N_ELEMENTS(criteria)};
    struct mpm_error error = {.status = MPM_OK};
    GString *const rows = g_string_new(NULL);
    (void)fuzz_judge(numbers_rows(&bundle, path, rows, &error), &error);
    g_string_free(rows, TRUE);
}

/* The reader takes names in the folder of reference data: this one leads out of it, to the root. */
static void read_reference(const char *path)
{
    struct mpm_error error = {.status = MPM_OK};
    struct table_file table;
    size_t column;
    char *const name = g_strconcat("../../../../../../../../../../../../../../../..", path, NULL);
    if (fuzz_judge(table_file_read(name, &table, &error), &error))
        (void)fuzz_judge(table_file_column(&table, "x", &column, &error), &error);
    table_file_free(&table);
    g_free(name);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    const char *const path = fuzz_write("results.csv", data, size);
    read_results(path, MPM_PLANE_STRAIN);
    read_results(path, MPM_AXISYMMETRIC);
    read_numbers(path);
    read_reference(path);
    return 0;
}
