/* Commands and numbers in the text of a document.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TESTS_SUPPORT_DOCUMENT_H
#define TESTS_SUPPORT_DOCUMENT_H

#include "support/command.h"

#include <stdbool.h>

/* The same with every `from` replaced; frees the text. */
char *test_text_replaced(char *text, const char *from, const char *to);

/* The words with one blank between them; g_free it. */
char *test_text_squeezed(const char *text);

/* An indented line that a reader types. */
bool test_document_command(const char *line);

/* Runs it with the build under test, `folder` in the place of build/; `more` goes to its end. */
struct test_command test_document_run(const char *line, const char *folder, const char *more);

/* The same words, numbers of them within `tolerance` of each other, relatively. */
bool test_words_agree(const char *one, const char *other, double tolerance);

/* Pictures of one gnuplot: the same elements and words, coordinates and colours within `pixels`.
 * True too where another version of gnuplot has drawn one of them. */
bool test_pictures_agree(const char *one, const char *other, double pixels);

#endif
