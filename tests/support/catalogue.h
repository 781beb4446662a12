/* A small catalogue in a temporary folder, and measuring programs that behave and
 * misbehave.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TESTS_SUPPORT_CATALOGUE_H
#define TESTS_SUPPORT_CATALOGUE_H

#include "verification/programs/programs.h"

/* The programs quadrature, pass, fail, weak, crash, hang, omit, leave, refuse, spoil,
 * skip, talk, scene and undecided. */
struct program_table test_programs(void);

/* case.yaml of case `name` in family T, with one variant `only` and one check `value` of
 * 1 in 0.5 .. 2 on that program. g_free. */
char *test_case_text(const char *name, const char *program);

/* Writes <folder>/T/<name>/case.yaml and README.md. */
void test_case_write(const char *folder, const char *name, const char *text);

/* Adds case Q with program quadrature: two variants of tier ci and one of tier full, two
 * checks, a figure; gnuplot is needed for its report. */
void test_case_write_quadrature(const char *folder);

#endif
