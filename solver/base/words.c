/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "mpm_words.h"

#include <stdbool.h>
#include <stdint.h>
#include <string.h>

enum { WORD_LENGTH_MAX = 64 };

/* ASCII, whatever the locale. */
static int lower(char c)
{
    return c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c;
}

static bool same(char a, char b)
{
    return lower(a) == lower(b);
}

static size_t least(size_t a, size_t b)
{
    return a < b ? a : b;
}

/* Optimal string alignment: rows of the table of distances of all beginnings. */
size_t mpm_words_distance(const char *one, const char *other)
{
    size_t rows[3][WORD_LENGTH_MAX + 1];
    const size_t n = strlen(one), m = strlen(other);
    if (n > WORD_LENGTH_MAX || m > WORD_LENGTH_MAX)
        return SIZE_MAX;
    for (size_t j = 0; j <= m; j++)
        rows[0][j] = j;
    for (size_t i = 1; i <= n; i++) {
        size_t *const row = rows[i % 3];
        const size_t *const above = rows[(i + 2) % 3], *const second = rows[(i + 1) % 3];
        row[0] = i;
        for (size_t j = 1; j <= m; j++) {
            const size_t replaced = above[j - 1] + !same(one[i - 1], other[j - 1]);
            row[j] = least(replaced, least(above[j], row[j - 1]) + 1);
            if (i > 1 && j > 1 && same(one[i - 1], other[j - 2]) && same(one[i - 2], other[j - 1]))
                row[j] = least(row[j], second[j - 2] + 1);
        }
    }
    return rows[n % 3][m];
}

/* One letter in three, but one at least; a word of one letter is near to nothing else. */
static bool is_near(size_t distance, const char *word)
{
    const size_t length = strlen(word);
    const size_t wrong = length / 3 > 1 ? length / 3 : 1;
    return distance <= wrong && distance < length;
}

void mpm_nearest_offer(struct mpm_nearest *nearest, const char *name)
{
    const size_t distance = mpm_words_distance(nearest->word, name);
    if (!is_near(distance, nearest->word) ||
        (nearest->best != NULL && distance >= nearest->distance))
        return;
    nearest->best = name;
    nearest->distance = distance;
}

const char *mpm_nearest_hint(const struct mpm_nearest *nearest, char hint[MPM_HINT_SIZE])
{
    hint[0] = '\0';
    if (nearest->best != NULL)
        (void)snprintf(hint, MPM_HINT_SIZE, "; did you mean %s?", nearest->best);
    return hint;
}

/* -------------------------------------------------------------------- lines */

/* Of UTF-8: bytes that begin a character. */
static size_t characters(const char *text, size_t length)
{
    size_t count = 0;
    for (size_t i = 0; i < length; i++)
        count += ((unsigned char)text[i] & 0xc0) != 0x80;
    return count;
}

void mpm_words_wrap(FILE *out, const char *text, size_t column, size_t indent, size_t width)
{
    size_t pad = 0; /* blanks before the next word, if it is the first of its line */
    bool first = true;
    while (*text != '\0') {
        const size_t length = strcspn(text, " \n"), wide = characters(text, length);
        const bool breaks = !first && column + 1 + wide > width;
        if (length > 0) {
            pad = breaks ? indent : pad;
            column = breaks ? indent : column + !first;
            (void)fprintf(out, "%s%*s%.*s",
                          breaks  ? "\n"
                          : first ? ""
                                  : " ",
                          (int)pad, "", (int)length, text);
            column += wide;
            first = false;
            pad = 0;
        }
        text += length;
        if (*text == '\n') {
            (void)fputc('\n', out);
            column = pad = indent;
            first = true;
        }
        text += *text != '\0';
    }
    (void)fputc('\n', out);
}
