/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/exponential.h"

#include "base/exponential_terms.h"

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

static double of_bits(uint64_t bits)
{
    double x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

static uint64_t bits_of(double x)
{
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

/* Sum of c[k] x^k, even and odd powers side by side. */
static double polynomial(const double *c, int terms, double x)
{
    const double square = x * x;
    const int top = (terms - 1) / 2 * 2; /* even */
    double even = c[top], odd = top + 1 < terms ? c[top + 1] : 0.0;
    for (int k = top - 2; k >= 0; k -= 2) {
        even = even * square + c[k];
        odd = odd * square + c[k + 1];
    }
    return even + odd * x;
}

/* exp(x) = 2^n exp(y), y = x - n ln 2 within +-ln 2/2. Of Taylor's series of exp(y) what is left
 * out is below 2e-19. */
double mpm_exponential(double x)
{
    static const double WHOLE = 0x1.8p52;
    if (!(x <= MPM_EXP_LARGEST))
        return x > MPM_EXP_LARGEST ? HUGE_VAL : x;
    if (x < -MPM_EXP_LARGEST)
        return 0.0;
    const double n = (x * MPM_PER_LN2 + WHOLE) - WHOLE; /* rounded to a whole number */
    const double y = (x - n * MPM_LN2_HIGH) - n * MPM_LN2_LOW;
    const double sum =
        1.0 + (y + y * y * polynomial(mpm_inverse_factorial + 2, MPM_EXP_TERMS - 2, y));
    return sum * of_bits((uint64_t)((int)n + MPM_BIAS) << MPM_FRACTION_BITS);
}

/* x = 2^e y with y within sqrt(2)/2 and sqrt(2): ln y = 2 (s + s^3/3 + ...), s = (y - 1)/(y + 1),
 * at most 0.172. What is left out of the series is below 1e-20 of it. */
double mpm_logarithm(double x)
{
    if (!(x >= DBL_MIN && x <= DBL_MAX))
        return (double)NAN;
    const uint64_t above =
        bits_of(x) - bits_of(MPM_ROOT_HALF) + ((uint64_t)MPM_BIAS << MPM_FRACTION_BITS);
    const int exponent = (int)(above >> MPM_FRACTION_BITS) - MPM_BIAS;
    const double y = of_bits(bits_of(x) - ((uint64_t)exponent << MPM_FRACTION_BITS));
    const double s = (y - 1.0) / (y + 1.0), square = s * s;
    const double sum = polynomial(mpm_inverse_odd + 1, MPM_LOG_TERMS - 1, square);
    return exponent * MPM_LN2_HIGH + (exponent * MPM_LN2_LOW + (2.0 * s + 2.0 * s * square * sum));
}
