/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/exponential.h"

#include <math.h>

/* exp(x) = 2^n exp(y), y = x - n ln 2 within +-ln 2/2, ln 2 in two parts so that y keeps its digits.
 * Of Taylor's series of exp(y) what is left out is below 1e-17. */
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
