/* case.yaml: the schema, and reading by it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/suite/case_file.h"

#include "verification/suite/rows.h"
#include "verification/suite/yaml_place.h"

#include <cyaml/cyaml.h>
#include <glib.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ------------------------------------------------------------------ schema */

/* Numbers are read as text and converted by us: the reader's own conversion accepts
 * trailing text ("2 mm"). */
#define TEXT(key, type, member)                                                                    \
    CYAML_FIELD_STRING_PTR(key, CYAML_FLAG_POINTER, struct type, member, 1, 4096)
#define OPTIONAL_TEXT(key, type, member)                                                           \
    CYAML_FIELD_STRING_PTR(key, CYAML_FLAG_POINTER | CYAML_FLAG_OPTIONAL, struct type, member, 1,  \
                           4096)
#define LIST(key, type, member, entry, least)                                                      \
    CYAML_FIELD_SEQUENCE(key, CYAML_FLAG_POINTER | ((least) > 0 ? 0 : CYAML_FLAG_OPTIONAL),        \
                         struct type, member, entry, least, 1000)

static const cyaml_schema_value_t text_schema = {
    CYAML_VALUE_STRING(CYAML_FLAG_POINTER, char *, 1, 4096)};

static const cyaml_schema_field_t parameter_fields[] = {
    TEXT("name", case_parameter, name), TEXT("value", case_parameter, value), CYAML_FIELD_END};
static const cyaml_schema_value_t parameter_schema = {
    CYAML_VALUE_MAPPING(CYAML_FLAG_DEFAULT, struct case_parameter, parameter_fields)};

static const cyaml_strval_t tier_values[] = {{"ci", TIER_CI}, {"full", TIER_FULL}};
static const cyaml_strval_t basis_values[] = {{"theory", BASIS_THEORY},
                                              {"round-off", BASIS_ROUND_OFF},
                                              {"literature", BASIS_LITERATURE},
                                              {"measured", BASIS_MEASURED}};
static const cyaml_strval_t outcome_values[] = {{"pass", OUTCOME_PASS}, {"fail", OUTCOME_FAIL}};

static const cyaml_schema_field_t variant_fields[] = {
    TEXT("name", case_variant, name),
    CYAML_FIELD_ENUM("tier", CYAML_FLAG_STRICT, struct case_variant, tier, tier_values,
                     CYAML_ARRAY_LEN(tier_values)),
    TEXT("timeout", case_variant, timeout_text),
    LIST("settings", case_variant, settings, &text_schema, 0),
    LIST("parameters", case_variant, parameters, &parameter_schema, 0),
    CYAML_FIELD_END};
static const cyaml_schema_value_t variant_schema = {
    CYAML_VALUE_MAPPING(CYAML_FLAG_DEFAULT, struct case_variant, variant_fields)};

static const cyaml_schema_field_t check_fields[] = {
    TEXT("check", case_check, name),
    TEXT("title", case_check, title),
    LIST("variants", case_check, variants, &text_schema, 1),
    TEXT("quantity", case_check, quantity),
    TEXT("unit", case_check, unit),
    TEXT("norm", case_check, norm),
    TEXT("expected", case_check, expected_text),
    TEXT("low", case_check, low_text),
    TEXT("high", case_check, high_text),
    OPTIONAL_TEXT("fails_low", case_check, fails_low_text),
    OPTIONAL_TEXT("fails_high", case_check, fails_high_text),
    OPTIONAL_TEXT("initial", case_check, initial_text),
    CYAML_FIELD_ENUM("basis", CYAML_FLAG_STRICT, struct case_check, basis, basis_values,
                     CYAML_ARRAY_LEN(basis_values)),
    TEXT("why", case_check, why),
    CYAML_FIELD_ENUM("outcome", CYAML_FLAG_STRICT | CYAML_FLAG_OPTIONAL, struct case_check, outcome,
                     outcome_values, CYAML_ARRAY_LEN(outcome_values)),
    CYAML_FIELD_END};
static const cyaml_schema_value_t check_schema = {
    CYAML_VALUE_MAPPING(CYAML_FLAG_DEFAULT, struct case_check, check_fields)};

static const cyaml_schema_field_t figure_fields[] = {
    TEXT("name", case_figure, name),
    TEXT("script", case_figure, script),
    TEXT("title", case_figure, title),
    TEXT("caption", case_figure, caption),
    TEXT("reference", case_figure, reference),
    LIST("needs", case_figure, needs, &text_schema, 0),
    CYAML_FIELD_END};
static const cyaml_schema_value_t figure_schema = {
    CYAML_VALUE_MAPPING(CYAML_FLAG_DEFAULT, struct case_figure, figure_fields)};

static const cyaml_schema_field_t file_fields[] = {
    CYAML_FIELD_INT("format", CYAML_FLAG_DEFAULT, struct case_file, format),
    TEXT("family", case_file, family),
    TEXT("case", case_file, name),
    TEXT("title", case_file, title),
    TEXT("summary", case_file, summary),
    LIST("tags", case_file, tags, &text_schema, 0),
    TEXT("program", case_file, program_name),
    OPTIONAL_TEXT("scene", case_file, scene),
    LIST("parameters", case_file, parameters, &parameter_schema, 0),
    LIST("variants", case_file, variants, &variant_schema, 1),
    LIST("checks", case_file, checks, &check_schema, 1),
    LIST("figures", case_file, figures, &figure_schema, 0),
    CYAML_FIELD_END};
static const cyaml_schema_value_t file_schema = {
    CYAML_VALUE_MAPPING(CYAML_FLAG_POINTER, struct case_file, file_fields)};

/* ----------------------------------------------------------------- reading */

/* What the reader said: its first message, and the first place of its backtrace. */
struct reader_log {
    char message[400];
    unsigned line, column;
};

static void reader_logged(cyaml_log_t level, void *context, const char *format, va_list arguments)
{
    (void)level;
    static const char line_key[] = "(line: ", column_key[] = "column: ";
    struct reader_log *log = context;
    char text[400];
    vsnprintf(text, sizeof text, format, arguments);
    g_strchomp(text);
    const char *line = strstr(text, line_key), *column = strstr(text, column_key);
    if (log->line == 0 && line != NULL && column != NULL) {
        log->line = (unsigned)strtoul(line + strlen(line_key), NULL, 10);
        log->column = (unsigned)strtoul(column + strlen(column_key), NULL, 10);
    } else if (log->message[0] == '\0') {
        const char *said = g_str_has_prefix(text, "Load: ") ? text + strlen("Load: ") : text;
        g_strlcpy(log->message, said, sizeof log->message);
    }
}

static cyaml_config_t reader_config(struct reader_log *log)
{
    return (cyaml_config_t){.log_fn = reader_logged,
                            .log_ctx = log,
                            .mem_fn = cyaml_mem,
                            .log_level = CYAML_LOG_ERROR,
                            .flags = CYAML_CFG_NO_ALIAS};
}

/* The token that a message ends in: "Unexpected key: foo", "Invalid INT value: 'x'". */
static char *offending_token(const char *message)
{
    const char *colon = strrchr(message, ':');
    char *token = g_strdup(colon == NULL ? "" : colon + 1);
    g_strstrip(token);
    const size_t length = strlen(token);
    if (length >= 2 && token[0] == '\'' && token[length - 1] == '\'') {
        token[length - 1] = '\0';
        memmove(token, token + 1, length - 1);
    }
    return token;
}

static enum mpm_status refuse_unreadable(const char *path, const struct reader_log *log,
                                         cyaml_err_t code, struct mpm_error *error)
{
    char *token = offending_token(log->message);
    unsigned line = *token == '\0' ? 0 : yaml_place_scalar(path, token, log->line, log->column);
    if (line == 0)
        line = log->line;
    g_free(token);
    char place[32] = "";
    if (line > 0)
        g_snprintf(place, sizeof place, ":%u", line);
    return failure_set(error, MPM_BAD_INPUT, "%s%s: %s", path, place,
                       log->message[0] == '\0' ? cyaml_strerror(code) : log->message);
}

/* ----------------------------------------------------------------- numbers */

static enum mpm_status convert(const char *path, const char *place, const char *key,
                               const char *text, double *value, struct mpm_error *error)
{
    if (strspn(text, "0123456789+-.eE") == strlen(text) && row_number(text, value) &&
        isfinite(*value))
        return MPM_OK;
    char *full = g_strconcat(place, ".", key, NULL);
    const unsigned line = yaml_place_line(path, full);
    g_free(full);
    return failure_set(error, MPM_BAD_INPUT, "%s:%u: %s: %s: \"%s\" is not a finite number", path,
                       line, place, key, text);
}

static enum mpm_status convert_check(const char *path, unsigned index, struct case_check *check,
                                     struct mpm_error *error)
{
    struct verdict_band *band = &check->band;
    const struct {
        const char *key, *text;
        double *value;
    } numbers[] = {
        {"expected", check->expected_text, &band->expected},
        {"low", check->low_text, &band->low},
        {"high", check->high_text, &band->high},
        {"fails_low", check->fails_low_text, &band->fails_low},
        {"fails_high", check->fails_high_text, &band->fails_high},
        {"initial", check->initial_text, &band->initial},
    };
    char place[32];
    g_snprintf(place, sizeof place, "checks.%u", index);
    for (size_t i = 0; i < G_N_ELEMENTS(numbers); i++)
        if (numbers[i].text != NULL)
            TRY(convert(path, place, numbers[i].key, numbers[i].text, numbers[i].value, error));
    band->weakness = check->outcome == OUTCOME_FAIL;
    band->has_initial = check->initial_text != NULL;
    return MPM_OK;
}

static enum mpm_status convert_numbers(const char *path, struct case_file *file,
                                       struct mpm_error *error)
{
    for (unsigned i = 0; i < file->variants_count; i++) {
        char place[32];
        g_snprintf(place, sizeof place, "variants.%u", i);
        TRY(convert(path, place, "timeout", file->variants[i].timeout_text,
                    &file->variants[i].timeout, error));
    }
    for (unsigned i = 0; i < file->checks_count; i++)
        TRY(convert_check(path, i, &file->checks[i], error));
    return MPM_OK;
}

enum mpm_status case_file_load(const char *path, struct case_file **file, struct mpm_error *error)
{
    struct reader_log log = {.line = 0};
    const cyaml_config_t config = reader_config(&log);
    *file = NULL;
    const cyaml_err_t code =
        cyaml_load_file(path, &config, &file_schema, (cyaml_data_t **)file, NULL);
    if (code == CYAML_ERR_FILE_OPEN)
        return failure_set(error, MPM_BAD_INPUT, "%s: cannot be read", path);
    if (code != CYAML_OK)
        return refuse_unreadable(path, &log, code, error);
    if (*file == NULL)
        return failure_set(error, MPM_BAD_INPUT, "%s: is empty", path);
    const enum mpm_status status = convert_numbers(path, *file, error);
    if (status != MPM_OK) {
        case_file_free(*file);
        *file = NULL;
    }
    return status;
}

void case_file_free(struct case_file *file)
{
    struct reader_log log = {.line = 0};
    const cyaml_config_t config = reader_config(&log);
    if (file != NULL)
        cyaml_free(&config, &file_schema, file, 0);
}
