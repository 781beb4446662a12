/* Results as legacy VTK files, ASCII.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/common/failure.h"
#include "verification/common/input.h"
#include "verification/common/rows.h"
#include "verification/score/readers.h"

#include <math.h>
#include <string.h>

enum { WORD_SIZE = 256, TENSOR = 9, VECTOR = 3 };

/* The words of a file, one by one. */
struct words {
    const char *path, *at;
    const struct score_format *format;
    unsigned line;
    char word[WORD_SIZE];    /* the last one; "" at the end */
    bool points, point_data; /* that have begun */
    double time;
};

static bool next_word(struct words *words)
{
    while (g_ascii_isspace(*words->at)) {
        words->line += *words->at == '\n';
        words->at++;
    }
    size_t length = 0;
    while (*words->at != '\0' && !g_ascii_isspace(*words->at)) {
        if (length + 1 < WORD_SIZE)
            words->word[length++] = *words->at;
        words->at++;
    }
    words->word[length] = '\0';
    return length > 0;
}

/* Whether the line goes on with a word. */
static bool line_goes_on(const struct words *words)
{
    const char *at = words->at;
    while (*at == ' ' || *at == '\t' || *at == '\r')
        at++;
    return *at != '\n' && *at != '\0';
}

static void skip_line(struct words *words)
{
    while (*words->at != '\0' && *words->at != '\n')
        words->at++;
}

/* A block that ends with an empty line. */
static void skip_block(struct words *words)
{
    do {
        skip_line(words);
        words->line += *words->at == '\n';
        words->at += *words->at == '\n';
    } while (line_goes_on(words));
}

static enum mpm_status refuse(const struct words *words, struct mpm_error *error, const char *what)
{
    return failure_set(error, MPM_BAD_INPUT, "%s:%u: \"%s\": %s", words->path, words->line,
                       words->word, what);
}

static enum mpm_status next_count(struct words *words, size_t *count, struct mpm_error *error)
{
    double value = -1;
    if (!next_word(words) || !row_number(words->word, &value) || !(value >= 0) || value > 1e9 ||
        floor(value) < value)
        return refuse(words, error, "allowed is a number of things");
    *count = (size_t)value;
    return MPM_OK;
}

/* `count` numbers; NULL with *status set on failure. */
static GArray *next_numbers(struct words *words, size_t count, enum mpm_status *status,
                            struct mpm_error *error)
{
    if (count > (size_t)SCORE_ROWS_MAX * TENSOR) {
        *status = refuse(words, error, "more numbers than 1e8 points have");
        return NULL;
    }
    GArray *values = g_array_new(FALSE, FALSE, sizeof(double));
    for (size_t i = 0; i < count; i++) {
        double value;
        if (!next_word(words) || !row_number(words->word, &value)) {
            *status = refuse(words, error, "allowed is a number");
            g_array_unref(values);
            return NULL;
        }
        g_array_append_val(values, value);
    }
    *status = MPM_OK;
    return values;
}

/* An array of points; outside of POINT_DATA only the time is read. */
static enum mpm_status take(struct words *words, const char *name, size_t components, size_t count,
                            struct score_table *table, struct mpm_error *error)
{
    enum mpm_status status;
    GArray *values = next_numbers(words, components * count, &status, error);
    if (values == NULL)
        return status;
    if (words->point_data)
        status =
            score_take_array(words->path, words->format, name, components, values, table, error);
    else if (values->len == 1 &&
             (g_ascii_strcasecmp(name, "TimeValue") == 0 || g_ascii_strcasecmp(name, "TIME") == 0))
        words->time = g_array_index(values, double, 0);
    g_array_unref(values);
    return status;
}

/* ------------------------------------------------------------------ keywords */

static enum mpm_status read_points(struct words *words, struct score_table *table,
                                   struct mpm_error *error)
{
    enum mpm_status status;
    if (words->points)
        return refuse(words, error, "a second time: allowed is once");
    words->points = true;
    TRY(next_count(words, &table->rows, error));
    if (table->rows > SCORE_ROWS_MAX)
        return refuse(words, error, "allowed are up to 1e8 points");
    next_word(words); /* the type */
    GArray *values = next_numbers(words, table->rows * VECTOR, &status, error);
    if (values == NULL)
        return status;
    status = score_take_array(words->path, words->format, "position", VECTOR, values, table, error);
    g_array_unref(values);
    return status;
}

static enum mpm_status skip_words(struct words *words, size_t count, struct mpm_error *error)
{
    for (size_t i = 0; i < count; i++)
        if (!next_word(words))
            return refuse(words, error, "the cells are cut short");
    return MPM_OK;
}

/* The cells of version 5: OFFSETS and CONNECTIVITY, each with its type. */
static enum mpm_status skip_offsets(struct words *words, size_t offsets, size_t connectivity,
                                    struct mpm_error *error)
{
    TRY(skip_words(words, offsets + 1, error));
    next_word(words);
    if (strcmp(words->word, "CONNECTIVITY") != 0)
        return refuse(words, error, "allowed is CONNECTIVITY after OFFSETS");
    return skip_words(words, connectivity + 1, error);
}

static enum mpm_status read_cells(struct words *words, struct score_table *table,
                                  struct mpm_error *error)
{
    size_t count = 0, size = 0;
    (void)table;
    const bool types = strcmp(words->word, "CELL_TYPES") == 0;
    TRY(next_count(words, &count, error));
    if (!types)
        TRY(next_count(words, &size, error));
    const struct words before = *words;
    if (!types && next_word(words) && strcmp(words->word, "OFFSETS") == 0)
        return skip_offsets(words, count, size, error);
    *words = before;
    return skip_words(words, types ? count : size, error);
}

static enum mpm_status read_metadata(struct words *words, struct score_table *table,
                                     struct mpm_error *error)
{
    (void)table;
    (void)error;
    skip_block(words);
    return MPM_OK;
}

static enum mpm_status read_point_data(struct words *words, struct score_table *table,
                                       struct mpm_error *error)
{
    size_t count = 0;
    if (!words->points)
        return refuse(words, error, "allowed is POINTS before it");
    TRY(next_count(words, &count, error));
    words->point_data = true;
    return count == table->rows
               ? MPM_OK
               : refuse(words, error, "POINT_DATA must have as many rows as POINTS");
}

static enum mpm_status read_cell_data(struct words *words, struct score_table *table,
                                      struct mpm_error *error)
{
    (void)table;
    return refuse(words, error, "CELL_DATA is not read: write particles' values as POINT_DATA");
}

static enum mpm_status read_scalars(struct words *words, struct score_table *table,
                                    struct mpm_error *error)
{
    size_t components = 1;
    next_word(words);
    char *name = g_strdup(words->word);
    next_word(words); /* the type */
    enum mpm_status status = line_goes_on(words) ? next_count(words, &components, error) : MPM_OK;
    if (status == MPM_OK && (!next_word(words) || strcmp(words->word, "LOOKUP_TABLE") != 0))
        status = refuse(words, error, "allowed is LOOKUP_TABLE after SCALARS");
    if (status == MPM_OK) {
        next_word(words);
        status = take(words, name, components, table->rows, table, error);
    }
    g_free(name);
    return status;
}

static enum mpm_status read_fixed(struct words *words, size_t components, struct score_table *table,
                                  struct mpm_error *error)
{
    next_word(words);
    char *name = g_strdup(words->word);
    next_word(words); /* the type */
    const enum mpm_status status = take(words, name, components, table->rows, table, error);
    g_free(name);
    return status;
}

static enum mpm_status read_vectors(struct words *words, struct score_table *table,
                                    struct mpm_error *error)
{
    return read_fixed(words, VECTOR, table, error);
}

static enum mpm_status read_tensors(struct words *words, struct score_table *table,
                                    struct mpm_error *error)
{
    return read_fixed(words, TENSOR, table, error);
}

static enum mpm_status read_field(struct words *words, struct score_table *table,
                                  struct mpm_error *error)
{
    size_t arrays = 0;
    next_word(words); /* its name */
    TRY(next_count(words, &arrays, error));
    for (size_t i = 0; i < arrays; i++) {
        size_t components = 0, count = 0;
        next_word(words);
        while (strcmp(words->word, "METADATA") == 0) { /* of the array before */
            skip_block(words);
            next_word(words);
        }
        char *name = g_strdup(words->word);
        enum mpm_status status = next_count(words, &components, error);
        if (status == MPM_OK)
            status = next_count(words, &count, error);
        next_word(words); /* the type */
        if (status == MPM_OK)
            status = take(words, name, components, count, table, error);
        g_free(name);
        TRY(status);
    }
    return MPM_OK;
}

static const struct keyword {
    const char *name;
    enum mpm_status (*read)(struct words *words, struct score_table *table,
                            struct mpm_error *error);
} keywords[] = {
    {"POINTS", read_points},         {"VERTICES", read_cells},      {"LINES", read_cells},
    {"POLYGONS", read_cells},        {"CELLS", read_cells},         {"CELL_TYPES", read_cells},
    {"POINT_DATA", read_point_data}, {"CELL_DATA", read_cell_data}, {"SCALARS", read_scalars},
    {"VECTORS", read_vectors},       {"TENSORS", read_tensors},     {"FIELD", read_field},
    {"METADATA", read_metadata},
};

static enum mpm_status read_keyword(struct words *words, struct score_table *table,
                                    struct mpm_error *error)
{
    for (size_t i = 0; i < G_N_ELEMENTS(keywords); i++)
        if (strcmp(words->word, keywords[i].name) == 0)
            return keywords[i].read(words, table, error);
    return refuse(words, error,
                  "allowed are POINTS, cells, POINT_DATA, SCALARS, VECTORS, TENSORS and FIELD");
}

/* The three lines before the data, and DATASET. */
static enum mpm_status read_head(struct words *words, struct mpm_error *error)
{
    if (!g_str_has_prefix(words->at, "# vtk DataFile"))
        return failure_set(error, MPM_BAD_INPUT,
                           "%s:1: no legacy VTK file: its first line begins "
                           "with \"# vtk DataFile\"",
                           words->path);
    skip_line(words);
    if (*words->at == '\n') {
        words->at++;
        words->line++;
    }
    skip_line(words); /* the title */
    next_word(words);
    if (strcmp(words->word, "ASCII") != 0)
        return refuse(words, error, "allowed is ASCII");
    next_word(words);
    if (strcmp(words->word, "DATASET") != 0)
        return refuse(words, error, "allowed is DATASET");
    next_word(words);
    if (strcmp(words->word, "POLYDATA") != 0 && strcmp(words->word, "UNSTRUCTURED_GRID") != 0)
        return refuse(words, error, "allowed are POLYDATA and UNSTRUCTURED_GRID");
    return MPM_OK;
}

enum mpm_status score_read_vtk(const char *path, const struct score_format *format,
                               struct score_table *table, struct mpm_error *error)
{
    char *text;
    TRY(input_text(path, NULL, &text, NULL, error));
    struct words words = {
        .path = path, .at = text, .format = format, .line = 1, .time = (double)NAN};
    enum mpm_status status = read_head(&words, error);
    while (status == MPM_OK && next_word(&words))
        status = read_keyword(&words, table, error);
    if (status == MPM_OK && table->rows == 0)
        status = failure_set(error, MPM_BAD_INPUT, "%s: holds no POINTS", path);
    /* a .pvd may know the time better */
    if (status == MPM_OK && isfinite(words.time))
        status = score_take_time(path, words.time, table, error);
    g_free(text);
    return status;
}
