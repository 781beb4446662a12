/* A study from the command line.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/study/study.h"

#include "mpm_expression.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

/* What mpm_keys_free() frees is of malloc, which g_malloc is. */

struct study *study_of_scene(const char *scene)
{
    struct study *study = g_new0(struct study, 1);
    study->format = 1;
    study->scene = g_strdup(scene);
    return study;
}

/* Parts between commas that are in no bracket and no quotes. */
static GPtrArray *split(const char *text)
{
    GPtrArray *parts = g_ptr_array_new();
    const char *begin = text;
    int depth = 0;
    char quote = '\0';
    for (const char *c = text;; c++) {
        if (*c == '\0' || (*c == ',' && depth == 0 && quote == '\0')) {
            g_ptr_array_add(parts, g_strstrip(g_strndup(begin, (size_t)(c - begin))));
            begin = c + 1;
        }
        if (*c == '\0')
            return parts;
        if (quote != '\0')
            quote = *c == quote ? '\0' : quote;
        else if (*c == '"' || *c == '\'')
            quote = *c;
        else
            depth += strchr("([{", *c) != NULL ? 1 : strchr(")]}", *c) != NULL ? -1 : 0;
    }
}

static char **take_parts(GPtrArray *parts, unsigned *count)
{
    *count = parts->len;
    return (char **)g_ptr_array_free(parts, FALSE);
}

static void free_texts(char **texts, unsigned count)
{
    for (unsigned i = 0; i < count; i++)
        g_free(texts[i]);
    g_free(texts);
}

/* ----------------------------------------------------------------------- refine */

static enum mpm_status take_refine(struct study *study, const char *text, struct mpm_error *error)
{
    unsigned count;
    char **parts = take_parts(split(text), &count);
    enum mpm_status status = MPM_OK;
    free(study->refine);
    study->refine = g_new0(int64_t, count);
    study->refine_count = count;
    for (unsigned i = 0; status == MPM_OK && i < count; i++) {
        guint64 level;
        if (g_ascii_string_to_unsigned(parts[i], 10, 1, 1048576, &level, NULL))
            study->refine[i] = (int64_t)level;
        else
            status = failure_set(error, MPM_BAD_INPUT,
                                 "--refine \"%s\": \"%s\": allowed are whole numbers from 1 to "
                                 "1048576 that rise, with commas between",
                                 text, parts[i]);
    }
    free_texts(parts, count);
    return status;
}

/* ------------------------------------------------------------------------- vary */

static enum mpm_status take_one_vary(const char *text, struct study_vary *vary,
                                     struct mpm_error *error)
{
    const char *equals = strchr(text, '=');
    if (equals == NULL || equals == text || equals[1] == '\0')
        return failure_set(
            error, MPM_BAD_INPUT,
            "--vary \"%s\": allowed is PATH=VALUE,VALUE,... with a path of the scene", text);
    vary->path = g_strndup(text, (size_t)(equals - text));
    vary->values = take_parts(split(equals + 1), &vary->values_count);
    return MPM_OK;
}

static enum mpm_status take_vary(struct study *study, char **list, struct mpm_error *error)
{
    for (unsigned i = 0; i < study->vary_count; i++) {
        free_texts(study->vary[i].values, study->vary[i].values_count);
        free(study->vary[i].path);
    }
    free(study->vary);
    study->vary_count = g_strv_length(list);
    study->vary = g_new0(struct study_vary, study->vary_count);
    for (unsigned i = 0; i < study->vary_count; i++)
        TRY(take_one_vary(list[i], &study->vary[i], error));
    return MPM_OK;
}

/* --------------------------------------------------------------------- measures */

static const char form[] = "allowed is QUANTITY[:TAKE[@TIME or @X,Y]][=REFERENCE]";

/* "1.5" is a time, "3,4" a place. */
static enum mpm_status take_at(const char *text, const char *at, struct study_entry *entry,
                               struct mpm_error *error)
{
    unsigned count;
    double value;
    char **parts = take_parts(split(at), &count);
    bool sound = count >= 1 && count <= 2;
    for (unsigned i = 0; i < count; i++)
        sound = sound && mpm_number_parse(parts[i], &value);
    if (sound && count == 1)
        entry->instant_text = g_strdup(parts[0]);
    for (unsigned i = 0; sound && count == 2 && i < 2; i++)
        entry->at_text[i] = g_strdup(parts[i]);
    free_texts(parts, count);
    return sound ? MPM_OK
                 : failure_set(error, MPM_BAD_INPUT,
                               "--measure \"%s\": @%s: allowed are a time, or X,Y", text, at);
}

static enum mpm_status take_measure(const char *text, struct study_entry *entry,
                                    struct mpm_error *error)
{
    const char *equals = strchr(text, '=');
    char *head = equals == NULL ? g_strdup(text) : g_strndup(text, (size_t)(equals - text));
    char *take = strchr(head, ':'), *at = take == NULL ? NULL : strchr(take, '@');
    enum mpm_status status = MPM_OK;
    if (at != NULL)
        *at++ = '\0';
    if (take != NULL)
        *take++ = '\0';
    if (*g_strstrip(head) == '\0' || (take != NULL && *take == '\0') ||
        (equals != NULL && equals[1] == '\0'))
        status = failure_set(error, MPM_BAD_INPUT, "--measure \"%s\": %s", text, form);
    entry->quantity = g_strdup(head);
    entry->take_text = g_strdup(take);
    if (equals != NULL)
        entry->reference = g_strstrip(g_strdup(equals + 1));
    if (status == MPM_OK && at != NULL)
        status = take_at(text, at, entry, error);
    g_free(head);
    return status;
}

static void entry_clear(struct study_entry *entry)
{
    char *const owned[] = {entry->name,         entry->quantity,   entry->take_text,
                           entry->at_text[0],   entry->at_text[1], entry->instant_text,
                           entry->reference,    entry->unit,       entry->order_text[0],
                           entry->order_text[1]};
    for (size_t i = 0; i < G_N_ELEMENTS(owned); i++)
        free(owned[i]);
}

static enum mpm_status take_measures(struct study *study, char **list, struct mpm_error *error)
{
    for (unsigned i = 0; i < study->measures_count; i++)
        entry_clear(&study->measures[i]);
    free(study->measures);
    study->measures_count = g_strv_length(list);
    study->measures = g_new0(struct study_entry, study->measures_count);
    for (unsigned i = 0; i < study->measures_count; i++)
        TRY(take_measure(list[i], &study->measures[i], error));
    return MPM_OK;
}

/* -------------------------------------------------------------------------- all */

static void add_settings(struct study *study, char **list)
{
    const unsigned more = g_strv_length(list);
    study->settings = g_renew(char *, study->settings, study->settings_count + more);
    for (unsigned i = 0; i < more; i++)
        study->settings[study->settings_count++] = g_strdup(list[i]);
}

enum mpm_status study_take_arguments(struct study *study, const struct study_arguments *given,
                                     struct mpm_error *error)
{
    if (given->refine != NULL)
        TRY(take_refine(study, given->refine, error));
    if (given->vary != NULL)
        TRY(take_vary(study, given->vary, error));
    if (given->measures != NULL)
        TRY(take_measures(study, given->measures, error));
    if (given->settings != NULL)
        add_settings(study, given->settings);
    if (given->timeout != NULL) {
        free(study->timeout_text);
        study->timeout_text = g_strdup(given->timeout);
    }
    return MPM_OK;
}
