/* Tests run in processes of their own: what they skip goes through a shared file.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "support/skip.h"

static FILE *skipped;

bool test_skip_open(void)
{
    skipped = tmpfile();
    return skipped != NULL;
}

void test_skip_record(const char *test, const char *reason)
{
    (void)fprintf(skipped, "skipped: %s: %s\n", test, reason);
    (void)fflush(skipped);
}

int test_skip_report(FILE *stream)
{
    int lines = 0;
    rewind(skipped);
    for (int c = getc(skipped); c != EOF; c = getc(skipped)) {
        (void)putc(c, stream);
        lines += c == '\n';
    }
    (void)fclose(skipped);
    return lines;
}
