/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/exponential.h"

#include <math.h>

/* exp(x) = 2^n exp(y), y = x - n ln 2 within +-ln 2/2, ln 2 in two parts so that y keeps its
 * digits. Of Taylor's series of exp(y) what is left out is below 1e-17. */
double mpm_exponential(double x)
{
    static const double LN2_HIGH = 0x1.62e42feep-1, LN2_LOW = 0x1.a39ef35793c76p-33;
    static const int TERMS = 14;
    if (x < -700.0)
        return 0.0;
    const double n = rint(x / (LN2_HIGH + LN2_LOW));
    const double y = (x - n * LN2_HIGH) - n * LN2_LOW;
    double sum = 1.0;
    for (int k = TERMS; k > 0; k--)
        sum = 1.0 + sum * y / (double)k;
    return ldexp(sum, (int)n);
}

/* x = 2^e y with y within sqrt(2)/2 and sqrt(2): ln y = 2 (s + s^3/3 + ...), s = (y - 1)/(y + 1),
 * at most 0.172. What is left out of the series is below 1e-19 of it. */
double mpm_logarithm(double x)
{
    static const double LN2_HIGH = 0x1.62e42feep-1, LN2_LOW = 0x1.a39ef35793c76p-33;
    static const double ROOT_HALF = 0x1.6a09e667f3bcdp-1;
    static const int TERMS = 12;
    int exponent;
    if (!(x > 0.0) || !isfinite(x))
        return (double)NAN;
    double y = frexp(x, &exponent);
    if (y < ROOT_HALF) {
        y *= 2.0;
        exponent--;
    }
    const double s = (y - 1.0) / (y + 1.0), square = s * s;
    double sum = 1.0 / (2.0 * TERMS + 1.0);
    for (int k = TERMS - 1; k > 0; k--)
        sum = 1.0 / (2.0 * k + 1.0) + square * sum;
    return exponent * LN2_HIGH + (exponent * LN2_LOW + (2.0 * s + 2.0 * s * square * sum));
}
