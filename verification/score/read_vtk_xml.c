/* Results as VTK's XML files, .vtu and .vtp.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/common/failure.h"
#include "verification/common/input.h"
#include "verification/common/rows.h"
#include "verification/score/readers.h"

#include <math.h>
#include <string.h>

/* What is open while the file is parsed. */
struct parsing {
    const char *path;
    const struct score_format *format;
    struct score_table *table;
    struct mpm_error *error;
    enum section { NO_SECTION, FIELD_DATA, POINT_DATA, POINTS, OTHER } section;
    unsigned pieces;
    bool header_64; /* bytes of an array are counted in 8 bytes, not 4 */
    bool in_array, binary;
    unsigned nested; /* elements that are open within the array: passed over */
    char *name, *type;
    size_t components;
    GString *text;
    double time;
};

static void fail(const struct parsing *parsing, GMarkupParseContext *context, GError **failure,
                 const char *format, ...) __attribute__((format(printf, 4, 5)));

static void fail(const struct parsing *parsing, GMarkupParseContext *context, GError **failure,
                 const char *format, ...)
{
    int line, column;
    va_list arguments;
    va_start(arguments, format);
    char *text = g_strdup_vprintf(format, arguments);
    va_end(arguments);
    g_markup_parse_context_get_position(context, &line, &column);
    failure_set(parsing->error, MPM_BAD_INPUT, "%s:%d: %s", parsing->path, line, text);
    g_set_error(failure, G_MARKUP_ERROR, G_MARKUP_ERROR_INVALID_CONTENT, "%s", text);
    g_free(text);
}

static const char *attribute(const char **names, const char **values, const char *name)
{
    for (size_t i = 0; names[i] != NULL; i++)
        if (strcmp(names[i], name) == 0)
            return values[i];
    return NULL;
}

/* ------------------------------------------------------------------ elements */

static void start_file(struct parsing *parsing, GMarkupParseContext *context, const char **names,
                       const char **values, GError **failure)
{
    const char *type = attribute(names, values, "type");
    const char *order = attribute(names, values, "byte_order");
    const char *header = attribute(names, values, "header_type");
    if (g_strcmp0(type, "UnstructuredGrid") != 0 && g_strcmp0(type, "PolyData") != 0)
        fail(parsing, context, failure, "type \"%s\": allowed are UnstructuredGrid and PolyData",
             type == NULL ? "" : type);
    else if (attribute(names, values, "compressor") != NULL)
        fail(parsing, context, failure,
             "compressed arrays are not read: allowed are ASCII and "
             "binary without a compressor");
    else if (order != NULL && strcmp(order, "LittleEndian") != 0)
        fail(parsing, context, failure, "byte_order \"%s\": allowed is LittleEndian", order);
    parsing->header_64 = g_strcmp0(header, "UInt64") == 0;
}

static void start_piece(struct parsing *parsing, GMarkupParseContext *context, const char **names,
                        const char **values, GError **failure)
{
    double count;
    const char *text = attribute(names, values, "NumberOfPoints");
    if (++parsing->pieces > 1)
        fail(parsing, context, failure, "a second Piece: allowed is one");
    else if (text == NULL || !row_number(text, &count) || !(count >= 1) || count > SCORE_ROWS_MAX ||
             floor(count) < count)
        fail(parsing, context, failure,
             "NumberOfPoints \"%s\": allowed are whole numbers from 1 to %d",
             text == NULL ? "" : text, SCORE_ROWS_MAX);
    else
        parsing->table->rows = (size_t)count;
}

static void start_array(struct parsing *parsing, GMarkupParseContext *context, const char **names,
                        const char **values, GError **failure)
{
    double components = 1;
    const char *format = attribute(names, values, "format");
    const char *count = attribute(names, values, "NumberOfComponents");
    const char *name = attribute(names, values, "Name");
    if (parsing->pieces == 0 && parsing->section != FIELD_DATA) {
        fail(parsing, context, failure, "an array of points before Piece: allowed is inside of it");
        return;
    }
    if (format == NULL || (strcmp(format, "ascii") != 0 && strcmp(format, "binary") != 0)) {
        fail(parsing, context, failure, "format \"%s\": allowed are ascii and binary",
             format == NULL ? "" : format);
        return;
    }
    if (count != NULL && (!row_number(count, &components) || !(components >= 1) || components > 99))
        components = 0; /* an array of no known layout is refused with that number */
    parsing->in_array = true;
    parsing->binary = strcmp(format, "binary") == 0;
    parsing->components = (size_t)components;
    parsing->name = g_strdup(parsing->section == POINTS ? "position" : name == NULL ? "" : name);
    parsing->type = g_strdup(attribute(names, values, "type"));
    g_string_truncate(parsing->text, 0);
}

/* The section that an element is; NO_SECTION if it is none. */
static enum section section_of(const char *element)
{
    static const struct {
        const char *name;
        enum section section;
    } sections[] = {{"FieldData", FIELD_DATA}, {"PointData", POINT_DATA}, {"Points", POINTS},
                    {"CellData", OTHER},       {"Cells", OTHER},          {"Verts", OTHER},
                    {"Lines", OTHER},          {"Strips", OTHER},         {"Polys", OTHER}};
    for (size_t i = 0; i < G_N_ELEMENTS(sections); i++)
        if (strcmp(element, sections[i].name) == 0)
            return sections[i].section;
    return NO_SECTION;
}

static void start_element(GMarkupParseContext *context, const char *element, const char **names,
                          const char **values, void *data, GError **failure)
{
    struct parsing *parsing = data;
    if (parsing->in_array) { /* InformationKey and its like */
        parsing->nested++;
        return;
    }
    if (section_of(element) != NO_SECTION)
        parsing->section = section_of(element);
    if (strcmp(element, "VTKFile") == 0)
        start_file(parsing, context, names, values, failure);
    else if (strcmp(element, "Piece") == 0)
        start_piece(parsing, context, names, values, failure);
    else if (strcmp(element, "AppendedData") == 0)
        fail(parsing, context, failure, "appended arrays are not read: write them in place");
    else if (strcmp(element, "DataArray") == 0 && parsing->section != OTHER)
        start_array(parsing, context, names, values, failure);
}

static void add_text(GMarkupParseContext *context, const char *text, size_t length, void *data,
                     GError **failure)
{
    (void)context;
    (void)failure;
    struct parsing *parsing = data;
    if (parsing->in_array && parsing->nested == 0)
        g_string_append_len(parsing->text, text, (gssize)length);
}

/* -------------------------------------------------------------------- values */

static bool parse_ascii(const char *text, GArray *values)
{
    char **words = g_strsplit_set(text, " \t\r\n", -1);
    bool good = true;
    for (char **word = words; good && *word != NULL; word++) {
        double value;
        if (**word == '\0')
            continue;
        good = row_number(*word, &value);
        g_array_append_val(values, value);
    }
    g_strfreev(words);
    return good;
}

/* One number of a type of VTK from bytes in this machine's order. */
#define CONVERT(type)                                                                              \
    static double convert_##type(const guchar *bytes)                                              \
    {                                                                                              \
        type value;                                                                                \
        memcpy(&value, bytes, sizeof value);                                                       \
        return (double)value;                                                                      \
    }
CONVERT(double)
CONVERT(float)
CONVERT(gint64)
CONVERT(gint32)
CONVERT(guint64)
CONVERT(guint32)
CONVERT(guint8)
CONVERT(gint8)

static const struct number {
    const char *name;
    size_t size;
    double (*convert)(const guchar *bytes);
} numbers[] = {
    {"Float64", 8, convert_double}, {"Float32", 4, convert_float},  {"Int64", 8, convert_gint64},
    {"Int32", 4, convert_gint32},   {"UInt64", 8, convert_guint64}, {"UInt32", 4, convert_guint32},
    {"UInt8", 1, convert_guint8},   {"Int8", 1, convert_gint8},
};

/* The count of bytes, then the bytes, in one run of base64 or in one each. */
static bool parse_binary(const struct parsing *parsing, GArray *values)
{
    const struct number *number = NULL;
    for (size_t i = 0; i < G_N_ELEMENTS(numbers); i++)
        if (g_strcmp0(parsing->type, numbers[i].name) == 0)
            number = &numbers[i];
    char *text = g_strstrip(g_strdup(parsing->text->str));
    const size_t header = parsing->header_64 ? 8 : 4, head_text = parsing->header_64 ? 12 : 8;
    const bool apart = strlen(text) > head_text && text[head_text - 1] == '=';
    size_t length = 0, head_length = 0;
    char *head_part = g_strndup(text, head_text);
    guchar *head = g_base64_decode(head_part, &head_length);
    guchar *body = g_base64_decode(apart ? text + head_text : text, &length);
    const size_t start = apart ? 0 : header;
    bool good = number != NULL && head_length >= header && length >= start;
    const double bytes = !good                ? 0
                         : parsing->header_64 ? convert_guint64(head)
                                              : convert_guint32(head);
    good = good && bytes <= (double)(length - start);
    for (size_t i = 0; good && (double)((i + 1) * number->size) <= bytes; i++) {
        const double value = number->convert(body + start + i * number->size);
        g_array_append_val(values, value);
    }
    g_free(body);
    g_free(head);
    g_free(head_part);
    g_free(text);
    return good;
}

static enum mpm_status take_values(struct parsing *parsing, const GArray *values,
                                   struct mpm_error *error)
{
    if (parsing->section == FIELD_DATA) {
        if (values->len == 1 && (g_ascii_strcasecmp(parsing->name, "TimeValue") == 0 ||
                                 g_ascii_strcasecmp(parsing->name, "TIME") == 0))
            parsing->time = g_array_index(values, double, 0);
        return MPM_OK;
    }
    return score_take_array(parsing->path, parsing->format, parsing->name, parsing->components,
                            values, parsing->table, error);
}

static void end_array(struct parsing *parsing, GMarkupParseContext *context, GError **failure)
{
    GArray *values = g_array_new(FALSE, FALSE, sizeof(double));
    struct mpm_error error = {.status = MPM_OK};
    if (!(parsing->binary ? parse_binary(parsing, values)
                          : parse_ascii(parsing->text->str, values)))
        fail(parsing, context, failure, "array \"%s\" of type %s cannot be read as %s",
             parsing->name, parsing->type == NULL ? "(none)" : parsing->type,
             parsing->binary ? "base64" : "numbers");
    else if (take_values(parsing, values, &error) != MPM_OK) {
        *parsing->error = error;
        g_set_error(failure, G_MARKUP_ERROR, G_MARKUP_ERROR_INVALID_CONTENT, "%s", error.message);
    }
    g_array_unref(values);
    g_free(parsing->name);
    g_free(parsing->type);
    parsing->name = parsing->type = NULL;
    parsing->in_array = false;
}

static void end_element(GMarkupParseContext *context, const char *element, void *data,
                        GError **failure)
{
    struct parsing *parsing = data;
    if (parsing->nested > 0)
        parsing->nested--;
    else if (parsing->in_array)
        end_array(parsing, context, failure);
    else if (section_of(element) != NO_SECTION)
        parsing->section = NO_SECTION;
}

enum mpm_status score_read_vtk_xml(const char *path, const struct score_format *format,
                                   struct score_table *table, struct mpm_error *error)
{
    static const GMarkupParser parser = {start_element, end_element, add_text, NULL, NULL};
    char *text;
    size_t length;
    TRY(input_text(path, NULL, &text, &length, error));
    struct mpm_error own = {.status = MPM_OK};
    struct parsing parsing = {.path = path,
                              .format = format,
                              .table = table,
                              .error = &own,
                              .text = g_string_new(NULL),
                              .time = (double)NAN};
    GError *failure = NULL;
    GMarkupParseContext *context = g_markup_parse_context_new(&parser, 0, &parsing, NULL);
    enum mpm_status status = MPM_OK;
    if (!g_markup_parse_context_parse(context, text, (gssize)length, &failure) ||
        !g_markup_parse_context_end_parse(context, &failure)) {
        /* ours has file and line; the parser's own has the line itself */
        status = own.status != MPM_OK
                     ? failure_set(error, MPM_BAD_INPUT, "%s", own.message)
                     : failure_set(error, MPM_BAD_INPUT, "%s: %s", path, failure->message);
        g_error_free(failure);
    } else if (parsing.pieces == 0) {
        status = failure_set(error, MPM_BAD_INPUT, "%s: holds no Piece of points", path);
    } else if (!score_table_has(table, SCORE_X)) {
        status = failure_set(error, MPM_BAD_INPUT, "%s: the Piece has no array of Points", path);
    } else if (isfinite(parsing.time)) {
        status = score_take_time(path, parsing.time, table, error);
    }
    g_markup_parse_context_free(context);
    g_string_free(parsing.text, TRUE);
    g_free(parsing.name);
    g_free(parsing.type);
    g_free(text);
    return status;
}
