/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/suite/run_state.h"

#include "verification/common/folders.h"
#include "verification/common/input.h"
#include "verification/common/output.h"

#include <stddef.h>
#include <stdlib.h>
#include <string.h>

enum { STATE_FORMAT = 1 };

static const char file_name[] = "run.json";

static const struct {
    const char *key, *option;
    size_t place;
    bool path;             /* kept whole: a run may go on from another folder */
    const char *otherwise; /* what not giving it means; NULL: nothing */
} texts_table[] = {
    {"tier", "--tier", offsetof(struct run_texts, tier), false, "ci"},
    {"case", "--case", offsetof(struct run_texts, case_globs), false, NULL},
    {"variant", "--variant", offsetof(struct run_texts, variant_globs), false, NULL},
    {"only", "--only", offsetof(struct run_texts, only), true, NULL},
    {"kernels", "--kernels", offsetof(struct run_texts, kernels), false, "auto"},
    {"baseline", "--baseline", offsetof(struct run_texts, baseline), true, NULL},
    {"api", "--api", offsetof(struct run_texts, api), true, NULL},
    {"catalogue", "--catalogue", offsetof(struct run_texts, catalogue), true, NULL},
};

static char **text_of(struct run_texts *texts, size_t row)
{
    return (char **)(void *)((char *)texts + texts_table[row].place);
}

/* As it is kept; NULL: nothing. g_free. */
static char *kept_form(const char *given, size_t row)
{
    if (given == NULL)
        return g_strdup(texts_table[row].otherwise);
    return texts_table[row].path ? g_canonicalize_filename(given, NULL) : g_strdup(given);
}

void run_texts_complete(struct run_texts *texts)
{
    for (size_t i = 0; i < G_N_ELEMENTS(texts_table); i++) {
        char **text = text_of(texts, i), *kept = kept_form(*text, i);
        g_free(*text);
        *text = kept;
    }
}

void run_texts_clear(struct run_texts *texts)
{
    for (size_t i = 0; i < G_N_ELEMENTS(texts_table); i++)
        g_free(*text_of(texts, i));
}

/* ---------------------------------------------------------------------- files */

static enum mpm_status write_state(const struct output_folder *output, json_t *state,
                                   struct mpm_error *error)
{
    char *text = json_dumps(state, JSON_INDENT(1) | JSON_PRESERVE_ORDER);
    const enum mpm_status status = output_write(output->state, file_name, text, error);
    free(text);
    return status;
}

static enum mpm_status read_state(const char *folder, json_t **state, struct mpm_error *error)
{
    struct output_folder output = output_names(folder);
    char *path = g_build_filename(output.state, file_name, NULL);
    enum mpm_path kind;
    enum mpm_status status = input_kind(path, &kind, error);
    *state = NULL;
    if (status == MPM_OK && kind == MPM_PATH_NONE)
        status = failure_set(error, MPM_BAD_INPUT,
                             "%s: no run was begun here that could go on (%s is missing); allowed "
                             "is the --output of an earlier run",
                             folder, path);
    else if (status == MPM_OK)
        status = input_json(path, JSON_REJECT_DUPLICATES, state, error);
    if (status == MPM_OK && json_integer_value(json_object_get(*state, "format")) != STATE_FORMAT)
        status = failure_set(error, MPM_BAD_INPUT, "%s: format: allowed is %d", path, STATE_FORMAT);
    if (status != MPM_OK) {
        json_decref(*state);
        *state = NULL;
    }
    g_free(path);
    output_close(&output);
    return status;
}

/* --------------------------------------------------------------------- begin */

static char *now(void)
{
    GDateTime *time = g_date_time_new_now_utc();
    char *text = g_date_time_format(time, "%Y-%m-%dT%H:%M:%SZ");
    g_date_time_unref(time);
    return text;
}

enum mpm_status run_state_begin(const struct output_folder *output, const struct run_texts *texts,
                                const char *command, struct mpm_error *error)
{
    struct run_texts copy = *texts;
    json_t *state = json_object();
    char *started = now();
    json_object_set_new(state, "format", json_integer(STATE_FORMAT));
    for (size_t i = 0; i < G_N_ELEMENTS(texts_table); i++) {
        const char *text = *text_of(&copy, i);
        json_object_set_new(state, texts_table[i].key,
                            text == NULL ? json_null() : record_text_of(text));
    }
    json_object_set_new(state, "command", record_text_of(command));
    json_object_set_new(state, "started", record_text_of(started));
    json_object_set_new(state, "seconds", json_real(0));
    /* all of an earlier run goes, tasks of a campaign too */
    enum mpm_status status = folder_remove(output->state, error);
    if (status == MPM_OK)
        status = folder_make(output->results, error);
    if (status == MPM_OK)
        status = write_state(output, state, error);
    json_decref(state);
    g_free(started);
    return status;
}

/* --------------------------------------------------------------------- go on */

static enum mpm_status adopt_text(const char *folder, const json_t *state, size_t row, char **given,
                                  struct mpm_error *error)
{
    const char *kept = json_string_value(json_object_get(state, texts_table[row].key));
    if (*given == NULL) {
        *given = g_strdup(kept);
        return MPM_OK;
    }
    enum mpm_status status = MPM_OK;
    char *own = kept_form(*given, row);
    if (g_strcmp0(own, kept) != 0)
        status = failure_set(error, MPM_BAD_INPUT,
                             "%s \"%s\": the run in %s was begun %s%s%s; leave it out to go on, or "
                             "begin a run without --resume",
                             texts_table[row].option, *given, folder,
                             kept == NULL ? "without it" : "with \"", kept == NULL ? "" : kept,
                             kept == NULL ? "" : "\"");
    g_free(own);
    return status;
}

enum mpm_status run_state_adopt(const char *folder, struct run_texts *texts, json_t **state,
                                struct mpm_error *error)
{
    TRY(read_state(folder, state, error));
    enum mpm_status status = MPM_OK;
    for (size_t i = 0; status == MPM_OK && i < G_N_ELEMENTS(texts_table); i++)
        status = adopt_text(folder, *state, i, text_of(texts, i), error);
    if (status != MPM_OK) {
        json_decref(*state);
        *state = NULL;
    }
    return status;
}

enum mpm_status run_state_add_seconds(const struct output_folder *output, double seconds,
                                      struct mpm_error *error)
{
    json_t *state;
    TRY(read_state(output->folder, &state, error));
    json_object_set_new(state, "seconds", json_real(record_number(state, "seconds") + seconds));
    const enum mpm_status status = write_state(output, state, error);
    json_decref(state);
    return status;
}
