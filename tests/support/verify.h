/* Running the commands of mpm-verify in this process, with the programs of
 * support/catalogue.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TESTS_SUPPORT_VERIFY_H
#define TESTS_SUPPORT_VERIFY_H

#include "verification/measures/verdict.h"

#include <sys/types.h>

struct test_said {
    int exit_status;
    char *out, *err;
};

/* Runs a command line; blanks part its arguments. */
struct test_said test_verify(const char *line);

/* The same with the first @ replaced by `one` and the second by `other`. */
struct test_said test_verify_with(const char *format, const char *one, const char *other);

void test_said_free(struct test_said *said);

/* A process that runs `act` and exits with what it returns; that exit status, 128 + n after signal
 * n. */
pid_t test_in_process(int (*act)(const char *one, const char *other), const char *one,
                      const char *other);
int test_exit_status(pid_t process);

/* mpm-verify run of a whole catalogue: the exit status. */
int test_run_all(const char *catalogue, const char *output);

/* Waits until a file is there; the test fails if none comes within ten seconds. */
void test_wait_for(const char *folder, const char *name);

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
