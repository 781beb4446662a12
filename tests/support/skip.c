/* Tests run in processes of their own: what they skip goes through a shared file.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "support/skip.h"

#include <stdlib.h>

static FILE *skipped;
static int run;
static bool ignored[1024];

bool test_skip_open(void)
{
    skipped = tmpfile();
    return skipped != NULL;
}

void test_skip_record(const char *test, const char *reason)
{
    (void)fprintf(skipped, "%d skipped: %s: %s\n", run, test, reason);
    (void)fflush(skipped);
}

void test_skip_run(int number)
{
    run = number;
}

void test_skip_ignore(int number)
{
    ignored[number] = true;
}

int test_skip_report(FILE *stream)
{
    int lines = 0;
    char line[512];
    rewind(skipped);
    while (fgets(line, sizeof line, skipped) != NULL) {
        char *text = NULL;
        if (ignored[strtol(line, &text, 10)])
            continue;
        (void)fputs(text + 1, stream);
        lines++;
    }
    (void)fclose(skipped);
    return lines;
}
