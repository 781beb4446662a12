/* Expressions of a scene: a number, or a formula in the coordinates and time. Part of the public
 * interface, for references in the same notation; mpm.h does not need it.
 *
 * muParser does the parsing; its header stays out of this one. One expression
 * holds one parser per worker, so that workers evaluate it at the same time.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_EXPRESSION_H
#define MPM_EXPRESSION_H

#include "mpm.h"

#include <stdbool.h>

struct mpm_expression;

/* Parses `text`. `names` are the two coordinates ("x","y" or "r","z"); `t` is
 * allowed when `has_time`. `workers` >= 1 parsers are made. Constants pi, e;
 * muParser's functions with log = ln natural; ^; no assignment, no comma list.
 * A mistake is MPM_BAD_INPUT with its position (1-based column) in the message;
 * the message does not name file or key: the caller adds them. A text that is a plain number
 * (1e-2, 1., .5) becomes a constant and costs no parser. */
enum mpm_status mpm_expression_create(const char *text, const char *const names[2], bool has_time,
                                      int workers, struct mpm_expression **expression,
                                      struct mpm_error *error);
void mpm_expression_free(struct mpm_expression *expression);

/* Value at a place and time; `worker` in [0, workers). May be not finite: the
 * caller decides what that means. Costs about 30 ns, 1 ns for a constant. */
double mpm_expression_value(const struct mpm_expression *expression, int worker,
                            const double position[2], double time);

/* No coordinate is in the text: one value for all places at a time. 0*x has one. */
bool mpm_expression_is_uniform(const struct mpm_expression *expression);
const char *mpm_expression_text(const struct mpm_expression *expression);

/* Strict number: decimal digits, at most one point, optional exponent, the whole
 * text; "1e-2", "1.", ".5", "1.0e6" are numbers; "nan", "inf", "0x1" and overflow
 * are not. Locale independent. */
bool mpm_number_parse(const char *text, double *value);

#endif
