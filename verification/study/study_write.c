/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/study/study_write.h"

#include "verification/common/output.h"
#include "verification/study/study_catalogue.h"

static enum mpm_status write_texts(const struct study_results *results, const char *folder,
                                   const json_t *run, struct mpm_error *error)
{
    char *markdown = study_markdown(results, true), *csv = study_csv(results);
    char *lines = study_jsonl(results, run);
    enum mpm_status status = output_write(folder, "study.md", markdown, error);
    if (status == MPM_OK)
        status = output_write(folder, "study.csv", csv, error);
    if (status == MPM_OK)
        status = output_write(folder, "study.jsonl", lines, error);
    g_free(lines);
    g_free(csv);
    g_free(markdown);
    return status;
}

static enum mpm_status write_results(const struct study_results *results, const char *output,
                                     const char *reports, const json_t *run, FILE *out,
                                     struct mpm_error *error)
{
    char *folder = study_folder(output), *shown = study_markdown(results, false);
    char *stamp = g_strdup_printf("Touchstone %s, %s", record_text(run, "version"),
                                  record_text(run, "revision"));
    enum mpm_status status = write_texts(results, folder, run, error);
    fprintf(out, "\n%s\n", shown);
    if (status == MPM_OK)
        status = study_pictures(results, folder, reports, stamp, error);
    if (status == MPM_OK)
        fprintf(out, "study: %s/study.md, study.csv, study.jsonl and pictures\n", folder);
    g_free(stamp);
    g_free(shown);
    g_free(folder);
    return status;
}

/* With the scene that the runs had: the user's may have changed since. */
static enum mpm_status read_own(const char *output, struct study **study, struct mpm_error *error)
{
    char *path = study_file_path(output);
    const enum mpm_status status = study_read(path, study, error);
    g_free(path);
    TRY(status);
    g_free((*study)->scene);
    (*study)->scene = study_scene_path(output);
    return study_complete(*study, error);
}

enum mpm_status study_write(const char *output, const char *reports, FILE *out, bool *holds,
                            struct mpm_error *error)
{
    struct study *study;
    struct records records;
    struct study_results results;
    enum mpm_status status = read_own(output, &study, error);
    if (status == MPM_OK)
        status = records_read(output, &records, error);
    if (status != MPM_OK) {
        study_free(study);
        return status;
    }
    status = study_results_make(study, &records, &results, error);
    if (status == MPM_OK) {
        *holds = results.failed + results.missing + results.out_of_order == 0;
        status = write_results(&results, output, reports, records.run, out, error);
        study_results_clear(&results);
    }
    records_clear(&records);
    study_free(study);
    return status;
}
