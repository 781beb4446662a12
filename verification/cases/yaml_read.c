/* YAML files read by a schema.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/cases/yaml_read.h"

#include "verification/cases/yaml_place.h"
#include "verification/common/failure.h"

#include <glib.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const cyaml_schema_value_t yaml_text_schema = {
    CYAML_VALUE_STRING(CYAML_FLAG_POINTER, char *, 1, YAML_TEXT_MAX)};

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

enum mpm_status yaml_read(const char *path, const cyaml_schema_value_t *schema, void **data,
                          struct mpm_error *error)
{
    struct reader_log log = {.line = 0};
    const cyaml_config_t config = reader_config(&log);
    *data = NULL;
    const cyaml_err_t code = cyaml_load_file(path, &config, schema, data, NULL);
    if (code == CYAML_ERR_FILE_OPEN)
        return failure_set(error, MPM_BAD_INPUT, "%s: cannot be read", path);
    if (code != CYAML_OK)
        return refuse_unreadable(path, &log, code, error);
    if (*data == NULL)
        return failure_set(error, MPM_BAD_INPUT, "%s: is empty", path);
    return MPM_OK;
}

void yaml_read_free(const cyaml_schema_value_t *schema, void *data)
{
    struct reader_log log = {.line = 0};
    const cyaml_config_t config = reader_config(&log);
    if (data != NULL)
        cyaml_free(&config, schema, data, 0);
}
