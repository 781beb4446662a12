/* Lines of progress on a terminal.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "mpm_words.h"

#include <glib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <unistd.h>

enum { BAR_WIDTH = 30, BAR_LEAST = 5 };

/* Characters that fit into a line without a break; many where that is not known. */
static size_t columns_of(FILE *out)
{
    struct winsize size = {.ws_col = 0};
    const int file = fileno(out);
    const bool known = file >= 0 && ioctl(file, TIOCGWINSZ, &size) == 0 && size.ws_col > 1;
    return known ? size.ws_col - 1U : 4096;
}

/* Can it do no more than print characters? */
static bool is_dumb(void)
{
    return g_strcmp0(g_getenv("TERM"), "dumb") == 0;
}

bool mpm_terminal_has_colours(void)
{
    const char *const no_color = g_getenv("NO_COLOR");
    return !is_dumb() && (no_color == NULL || no_color[0] == '\0');
}

void mpm_progress_clear(FILE *out)
{
    if (!is_dumb()) {
        (void)fputs("\r\033[K", out);
        return;
    }
    const size_t columns = MIN(columns_of(out), 79);
    (void)fprintf(out, "\r%*s\r", (int)columns, "");
}

static void print_bar(FILE *out, double fraction, size_t width)
{
    const size_t filled = (size_t)(CLAMP(fraction, 0.0, 1.0) * (double)width);
    (void)fputc('[', out);
    for (size_t i = 0; i < width; i++)
        (void)fputc(i < filled ? '#' : '.', out);
    (void)fputs("] ", out);
}

void mpm_progress_draw(FILE *out, double fraction, const char *text)
{
    size_t columns = columns_of(out);
    const size_t length = (size_t)g_utf8_strlen(text, -1), frame = strlen("[] ");
    mpm_progress_clear(out);
    if (fraction >= 0.0 && columns >= length + frame + BAR_LEAST) {
        const size_t width = MIN(BAR_WIDTH, columns - length - frame);
        print_bar(out, fraction, width);
        columns -= width + frame;
    }
    char *const part = g_utf8_substring(text, 0, (glong)MIN(length, columns));
    (void)fputs(part, out);
    (void)fflush(out);
    g_free(part);
}
