/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/suite/task_key.h"

#include "verification/common/folders.h"
#include "verification/common/input.h"
#include "verification/common/machine.h"
#include "verification/common/names.h"
#include "verification/common/resources.h"

#include <string.h>

/* To be changed when a program's result would mean something else: old ones are run again. */
static const char format[] = "result 1";

/* With its end, so that no two lists of texts are one. */
static void add_text(GChecksum *sum, const char *text)
{
    g_checksum_update(sum, (const unsigned char *)text, (gssize)strlen(text) + 1);
}

static enum mpm_status add_file(GChecksum *sum, const char *path, struct mpm_error *error)
{
    char *content = NULL;
    size_t length = 0;
    TRY(input_text(path, NULL, &content, &length, error));
    char *size = g_strdup_printf("%zu", length);
    add_text(sum, size);
    g_checksum_update(sum, (const unsigned char *)content, (gssize)length);
    g_free(size);
    g_free(content);
    return MPM_OK;
}

/* What only reports read of a case's folder. */
static bool is_for_reports(const char *name)
{
    return strcmp(name, "README.md") == 0 || glob_matches("*.gp", name);
}

/* All files of a folder and of those in it, with their names. */
static enum mpm_status add_folder(GChecksum *sum, const char *folder, struct mpm_error *error)
{
    enum mpm_status status = MPM_OK;
    GPtrArray *names;
    TRY(folder_names(folder, &names, error));
    for (unsigned i = 0; status == MPM_OK && i < names->len; i++) {
        const char *name = names->pdata[i];
        char *path = g_build_filename(folder, name, NULL);
        if (is_for_reports(name) || *name == '.') {
            g_free(path);
            continue;
        }
        enum mpm_path kind;
        add_text(sum, name);
        status = input_kind(path, &kind, error);
        if (status == MPM_OK && kind == MPM_PATH_FOLDER)
            status = add_folder(sum, path, error);
        else if (status == MPM_OK)
            status = add_file(sum, path, error);
        g_free(path);
    }
    g_ptr_array_unref(names);
    return status;
}

/* Where the system does not name the file of the running program, its version has to do. */
static enum mpm_status add_program(GChecksum *sum, struct mpm_error *error)
{
    const struct mpm_build_info *build = mpm_build_info();
    char *path = g_file_read_link("/proc/self/exe", NULL);
    char *libraries = machine_libraries();
    const char *const texts[] = {format, build->version, build->revision, build->flags, libraries};
    for (size_t i = 0; i < G_N_ELEMENTS(texts); i++)
        add_text(sum, texts[i]);
    /* by this name it is there even if the file has been replaced since */
    const enum mpm_status status = path == NULL ? MPM_OK : add_file(sum, "/proc/self/exe", error);
    g_free(libraries);
    g_free(path);
    return status;
}

static enum mpm_status add_common(GChecksum *sum, enum mpm_kernels kernels, struct mpm_error *error)
{
    char *data = resources_reference_data("mpm-verify");
    enum mpm_status status = add_program(sum, error);
    if (status == MPM_OK && data != NULL)
        status = add_folder(sum, data, error);
    add_text(sum, mpm_kernels_name(kernels));
    g_free(data);
    return status;
}

static enum mpm_status add_case(GChecksum *sum, const struct catalogue *catalogue,
                                const struct planned_job *job, struct mpm_error *error)
{
    add_text(sum, job->entry->file->name);
    add_text(sum, job->variant->name);
    if (job->variant->method != NULL) {
        char *methods = g_build_filename(catalogue->folder, "methods.yaml", NULL);
        const enum mpm_status status = add_file(sum, methods, error);
        g_free(methods);
        TRY(status);
    }
    return add_folder(sum, job->entry->folder, error);
}

enum mpm_status task_keys(const struct catalogue *catalogue, const struct plan *plan,
                          enum mpm_kernels kernels, char ***keys, struct mpm_error *error)
{
    GChecksum *common = g_checksum_new(G_CHECKSUM_SHA256);
    enum mpm_status status = add_common(common, kernels, error);
    *keys = g_new0(char *, plan->job_count + 1);
    for (size_t i = 0; status == MPM_OK && i < plan->job_count; i++) {
        GChecksum *sum = g_checksum_copy(common);
        status = add_case(sum, catalogue, &plan->jobs[i], error);
        (*keys)[i] = g_strdup(g_checksum_get_string(sum));
        g_checksum_free(sum);
    }
    g_checksum_free(common);
    if (status != MPM_OK) {
        for (size_t i = 0; i < plan->job_count; i++)
            g_free((*keys)[i]);
        g_free(*keys);
        *keys = NULL;
    }
    return status;
}
