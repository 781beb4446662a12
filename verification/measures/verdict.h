/* Verdicts: a value and its declared band become a status, a margin and a reason.
 * Pure functions.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_MEASURES_VERDICT_H
#define VERIFICATION_MEASURES_VERDICT_H

#include <stdbool.h>

enum verdict_status {
    VERDICT_PASS,
    VERDICT_FAIL,
    VERDICT_ERROR, /* no value: missing, not finite, crashed, could not measure */
    VERDICT_TIMEOUT,
    VERDICT_SKIP,
    VERDICT_EXPECTED_FAIL,   /* a known weakness shows itself as declared */
    VERDICT_UNEXPECTED_PASS, /* a known weakness is gone: the declaration must change */
    VERDICT_INCONCLUSIVE,    /* measured, but the quantity could not be determined */
    VERDICT_STATUS_COUNT,
};

/* "pass", "expected-fail", ... as in result lines. */
const char *verdict_status_name(enum verdict_status status);

/* The status of that name; VERDICT_STATUS_COUNT if there is none. */
enum verdict_status verdict_status_find(const char *name);

/* Whether the status fails a run: all but pass, skip and expected-fail. */
bool verdict_is_red(enum verdict_status status);

/* What a check declares. For a known weakness (`weakness`), [low, high] is what a
 * good method reaches and [fails_low, fails_high] is where the weakness shows. */
struct verdict_band {
    double expected, low, high;
    bool weakness;
    double fails_low, fails_high;
    bool has_initial;
    double initial; /* value of the quantity in the undisturbed initial state */
};

/* NULL if the band can be judged by, else why not: bounds must be finite and
 * ordered, `expected` inside, zero and the initial value in no band (either in place
 * of a result must turn the check red), the two bands of a weakness apart. */
const char *verdict_band_fault(const struct verdict_band *band);

/* Distance of `value` from the nearest edge of [low, high] over half the band's width:
 * 1 in the middle, 0 on an edge, negative outside. A band that spans a decade or more
 * on one side of zero is measured in logarithms: there the linear distance would call
 * every small error marginal. Not finite if `value` is not. */
double verdict_margin(double low, double high, double value);

enum { VERDICT_REASON_SIZE = 320 };

struct verdict {
    enum verdict_status status;
    bool has_margin; /* false where there is no finite value */
    double margin;   /* to the band that the check is declared to be in */
    char reason[VERDICT_REASON_SIZE];
};

/* Whether the band spans a decade or more on one side of zero. */
bool verdict_spans_decades(double low, double high);

/* Judges a value that was reported; band edges count as inside. */
struct verdict verdict_judge(const struct verdict_band *band, double value);

/* A verdict without a value. */
struct verdict verdict_without_value(enum verdict_status status, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* ------------------------------------------------------- proof that it can fail */

/* Values that no check may accept; the last two lie an error of twice the band's half
 * width off its middle, on either side. */
enum verdict_mutation {
    VERDICT_MUTATE_NAN,
    VERDICT_MUTATE_INFINITY,
    VERDICT_MUTATE_MINUS_INFINITY,
    VERDICT_MUTATE_ZERO,
    VERDICT_MUTATE_INITIAL, /* only if declared */
    VERDICT_MUTATE_CURED,   /* only for a weakness: the value of a good method */
    VERDICT_MUTATE_ABOVE,
    VERDICT_MUTATE_BELOW,
    VERDICT_MUTATION_COUNT,
};

/* Whether the mutation applies to the band; its value and its name if so. */
bool verdict_mutation_value(const struct verdict_band *band, enum verdict_mutation mutation,
                            double *value, const char **name);

#endif
