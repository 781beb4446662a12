/* Reading what valgrind's callgrind writes.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef BENCHMARKS_MEASURING_CALLGRIND_FILE_H
#define BENCHMARKS_MEASURING_CALLGRIND_FILE_H

#include "mpm.h"

enum { CALLGRIND_TOP = 8, CALLGRIND_NAME = 64 };

/* What a function executed itself, without those that it calls. */
struct callgrind_function {
    char name[CALLGRIND_NAME];
    uint64_t instructions, branches;
};

struct callgrind_counts {
    uint64_t instructions; /* executed: the program's and its libraries' */
    uint64_t branches;     /* conditional ones, of the program itself: a library's loop over
                              bytes says nothing about it */
    struct callgrind_function top[CALLGRIND_TOP]; /* by instructions, most first; "": none */
};

/* Reads the text of a file written with --branch-sim=yes --compress-strings=no and
 * --compress-pos=no. MPM_ENVIRONMENT_FAILED: it has no totals of the events Ir and Bc, counted
 * nothing, or its functions do not add up to the totals. */
enum mpm_status callgrind_file_parse(const char *text, struct callgrind_counts *counts,
                                     struct mpm_error *error);

#endif
