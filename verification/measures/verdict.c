/* Verdicts: bands, statuses, margins.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/measures/verdict.h"

#include <math.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

static const struct {
    const char *name;
    bool red;
} statuses[VERDICT_STATUS_COUNT] = {
    [VERDICT_PASS] = {"pass", false},
    [VERDICT_FAIL] = {"fail", true},
    [VERDICT_ERROR] = {"error", true},
    [VERDICT_TIMEOUT] = {"timeout", true},
    [VERDICT_SKIP] = {"skip", false},
    [VERDICT_EXPECTED_FAIL] = {"expected-fail", false},
    [VERDICT_UNEXPECTED_PASS] = {"unexpected-pass", true},
    [VERDICT_INCONCLUSIVE] = {"inconclusive", true},
};

const char *verdict_status_name(enum verdict_status status)
{
    return statuses[status].name;
}

enum verdict_status verdict_status_find(const char *name)
{
    for (int status = 0; status < VERDICT_STATUS_COUNT; status++)
        if (strcmp(statuses[status].name, name) == 0)
            return (enum verdict_status)status;
    return VERDICT_STATUS_COUNT;
}

bool verdict_is_red(enum verdict_status status)
{
    return statuses[status].red;
}

static bool inside(double low, double high, double value)
{
    return value >= low && value <= high;
}

const char *verdict_band_fault(const struct verdict_band *band)
{
    if (!isfinite(band->expected) || !isfinite(band->low) || !isfinite(band->high))
        return "expected, low and high must be finite";
    if (!(band->low < band->high))
        return "low must be less than high";
    if (!inside(band->low, band->high, band->expected))
        return "expected must lie in [low, high]";
    if (inside(band->low, band->high, 0))
        return "the band holds zero, so zero in place of a result would pass";
    if (band->has_initial && !isfinite(band->initial))
        return "initial must be finite";
    if (band->has_initial && inside(band->low, band->high, band->initial))
        return "the band holds the initial value, so a run that does nothing would pass";
    if (!band->weakness)
        return NULL;
    if (!isfinite(band->fails_low) || !isfinite(band->fails_high))
        return "fails_low and fails_high must be finite";
    if (!(band->fails_low < band->fails_high))
        return "fails_low must be less than fails_high";
    if (inside(band->fails_low, band->fails_high, 0))
        return "the band of the weakness holds zero, so zero in place of a result would be "
               "accepted";
    if (band->has_initial && inside(band->fails_low, band->fails_high, band->initial))
        return "the band of the weakness holds the initial value, so a run that does nothing would "
               "be accepted";
    if (band->fails_low <= band->high && band->low <= band->fails_high)
        return "the band of the weakness must not overlap [low, high]";
    return NULL;
}

bool verdict_spans_decades(double low, double high)
{
    return low * high > 0 && fmax(fabs(low), fabs(high)) >= 10 * fmin(fabs(low), fabs(high));
}

double verdict_margin(double low, double high, double value)
{
    const double sign = low > 0 ? 1 : -1;
    const double near = fmin(fabs(low), fabs(high)), far = fmax(fabs(low), fabs(high));
    if (verdict_spans_decades(low, high) && sign * value > 0) {
        const double position = log(fabs(value));
        return fmin(position - log(near), log(far) - position) / (0.5 * (log(far) - log(near)));
    }
    return fmin(value - low, high - value) / (0.5 * (high - low));
}

static void explain(struct verdict *verdict, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

static void explain(struct verdict *verdict, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(verdict->reason, sizeof verdict->reason, format, arguments);
    va_end(arguments);
}

struct verdict verdict_without_value(enum verdict_status status, const char *format, ...)
{
    struct verdict verdict = {.status = status};
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(verdict.reason, sizeof verdict.reason, format, arguments);
    va_end(arguments);
    return verdict;
}

/* Digits that tell the numbers of a band apart, and a value from its edges. */
static int digits_of(double low, double high)
{
    const double relative = (high - low) / fmax(fabs(low), fabs(high));
    return relative > 1e-3 ? 6 : 15;
}

static void judge_weakness(const struct verdict_band *band, double value, struct verdict *verdict)
{
    const int digits = digits_of(band->fails_low, band->fails_high);
    verdict->margin = verdict_margin(band->fails_low, band->fails_high, value);
    if (inside(band->low, band->high, value)) {
        verdict->status = VERDICT_UNEXPECTED_PASS;
        explain(verdict, "the known weakness does not show: %.*g lies in %.*g .. %.*g", digits,
                value, digits, band->low, digits, band->high);
    } else if (inside(band->fails_low, band->fails_high, value)) {
        verdict->status = VERDICT_EXPECTED_FAIL;
        explain(verdict, "known weakness: %.*g, as declared in %.*g .. %.*g", digits, value, digits,
                band->fails_low, digits, band->fails_high);
    } else {
        verdict->status = VERDICT_FAIL;
        explain(verdict, "fails in another way than declared: %.*g is outside %.*g .. %.*g", digits,
                value, digits, band->fails_low, digits, band->fails_high);
    }
}

struct verdict verdict_judge(const struct verdict_band *band, double value)
{
    if (!isfinite(value))
        return verdict_without_value(VERDICT_ERROR, "the value is %s",
                                     isnan(value) ? "not a number" : "infinite");
    struct verdict verdict = {.has_margin = true};
    if (band->weakness) {
        judge_weakness(band, value, &verdict);
        return verdict;
    }
    verdict.margin = verdict_margin(band->low, band->high, value);
    if (inside(band->low, band->high, value)) {
        verdict.status = VERDICT_PASS;
    } else {
        const int digits = digits_of(band->low, band->high);
        verdict.status = VERDICT_FAIL;
        explain(&verdict, "%.*g is %s the band %.*g .. %.*g", digits, value,
                value < band->low ? "below" : "above", digits, band->low, digits, band->high);
    }
    return verdict;
}

bool verdict_mutation_value(const struct verdict_band *band, enum verdict_mutation mutation,
                            double *value, const char **name)
{
    const double low = band->weakness ? band->fails_low : band->low;
    const double high = band->weakness ? band->fails_high : band->high;
    const struct {
        const char *name;
        double value;
        bool applies;
    } table[VERDICT_MUTATION_COUNT] = {
        [VERDICT_MUTATE_NAN] = {"not a number", (double)NAN, true},
        [VERDICT_MUTATE_INFINITY] = {"infinity", (double)INFINITY, true},
        [VERDICT_MUTATE_MINUS_INFINITY] = {"minus infinity", -(double)INFINITY, true},
        [VERDICT_MUTATE_ZERO] = {"zero", 0, true},
        [VERDICT_MUTATE_INITIAL] = {"the initial state", band->initial, band->has_initial},
        [VERDICT_MUTATE_CURED] = {"the weakness gone", band->expected, band->weakness},
        [VERDICT_MUTATE_ABOVE] = {"twice the band above", high + 0.5 * (high - low), true},
        [VERDICT_MUTATE_BELOW] = {"twice the band below", low - 0.5 * (high - low), true},
    };
    *value = table[mutation].value;
    *name = table[mutation].name;
    return table[mutation].applies;
}
