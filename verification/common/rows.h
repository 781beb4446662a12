/* Rows: the text by which a measuring program's process hands its results to the
 * suite, one JSON object a line. Values travel as text, since JSON has no NaN.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_COMMON_ROWS_H
#define VERIFICATION_COMMON_ROWS_H

#include <glib.h>
#include <stdbool.h>
#include <stdint.h>

enum row_kind {
    ROW_VALUE,        /* name: the quantity; text: the number */
    ROW_INCONCLUSIVE, /* name: the quantity; text: why */
    ROW_SKIP,         /* text: why */
    ROW_NOTE,         /* text */
    ROW_WORK,         /* text: particle-steps */
    ROW_PROCESSOR,    /* text: seconds of processor time */
    ROW_MEMORY,       /* text: the most memory that the process has had, bytes */
    ROW_SERIES,       /* name: the file's name */
    ROW_FAILURE,      /* text: the program's error message */
    ROW_END,          /* the program returned; without it the text is cut short */
    ROW_KIND_COUNT,
};

struct row {
    enum row_kind kind;
    char *name, *text; /* "" where the kind has none */
};

/* One row as a line with its newline; the caller frees it with g_free. */
char *row_line(enum row_kind kind, const char *name, const char *text);

/* The row of a value: 17 digits, or nan, inf, -inf. */
char *row_line_value(const char *quantity, double value);

/* The rows of a text (elements struct row, with a clear function); NULL if a line
 * is no row, with its number in *bad_line. */
GArray *rows_parse(const char *text, unsigned *bad_line);

/* The whole of `text` as a number (nan and inf included). */
bool row_number(const char *text, double *value);

#endif
