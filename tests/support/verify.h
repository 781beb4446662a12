/* Running the commands of mpm-verify in this process, with the programs of
 * support/catalogue.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TESTS_SUPPORT_VERIFY_H
#define TESTS_SUPPORT_VERIFY_H

#include "verification/measures/verdict.h"

struct test_said {
    int exit_status;
    char *out, *err;
};

/* Runs a command line; blanks part its arguments. */
struct test_said test_verify(const char *line);

/* The same with the first @ replaced by `one` and the second by `other`. */
struct test_said test_verify_with(const char *format, const char *one, const char *other);

void test_said_free(struct test_said *said);

/* The last line of a text; cuts blanks off its end. */
const char *test_last_line(char *text);

/* What each program of the tests comes to. */
struct test_behaviour {
    const char *program;
    enum verdict_status status;
    const char *reason; /* part of it */
};
enum { TEST_BEHAVIOURS = 11 };
extern const struct test_behaviour test_behaviours[TEST_BEHAVIOURS];

/* A new folder with a catalogue of one case for each of them. */
char *test_misbehaving_catalogue(void);

/* Fails the test if `text` is not well-formed XML. */
void test_assert_well_formed(const char *text, const char *what);

/* The text of a file in a folder; g_free. */
char *test_folder_read(const char *folder, const char *name);

#endif
