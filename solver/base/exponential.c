/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/exponential.h"

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

/* ln 2 in two parts, so that its multiples keep their digits. */
static const double LN2_HIGH = 0x1.62e42feep-1, LN2_LOW = 0x1.a39ef35793c76p-33;

enum { FRACTION_BITS = 52, BIAS = 1023, EXP_TERMS = 15, LOG_TERMS = 13 };

/* 1/k! */
static const double inverse_factorial[EXP_TERMS] = {
    0x1.0000000000000p+0,  0x1.0000000000000p+0,  0x1.0000000000000p-1,  0x1.5555555555555p-3,
    0x1.5555555555555p-5,  0x1.1111111111111p-7,  0x1.6c16c16c16c17p-10, 0x1.a01a01a01a01ap-13,
    0x1.a01a01a01a01ap-16, 0x1.71de3a556c734p-19, 0x1.27e4fb7789f5cp-22, 0x1.ae64567f544e4p-26,
    0x1.1eed8eff8d898p-29, 0x1.6124613a86d09p-33, 0x1.93974a8c07c9dp-37};
/* 1/(2 k + 1) */
static const double inverse_odd[LOG_TERMS] = {
    0x1.0000000000000p+0, 0x1.5555555555555p-2, 0x1.999999999999ap-3, 0x1.2492492492492p-3,
    0x1.c71c71c71c71cp-4, 0x1.745d1745d1746p-4, 0x1.3b13b13b13b14p-4, 0x1.1111111111111p-4,
    0x1.e1e1e1e1e1e1ep-5, 0x1.af286bca1af28p-5, 0x1.8618618618618p-5, 0x1.642c8590b2164p-5,
    0x1.47ae147ae147bp-5};

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
    static const double PER_LN2 = 0x1.71547652b82fep0, WHOLE = 0x1.8p52;
    if (!(x <= 700.0))
        return x > 700.0 ? HUGE_VAL : x;
    if (x < -700.0)
        return 0.0;
    const double n = (x * PER_LN2 + WHOLE) - WHOLE; /* rounded to a whole number */
    const double y = (x - n * LN2_HIGH) - n * LN2_LOW;
    const double sum = 1.0 + (y + y * y * polynomial(inverse_factorial + 2, EXP_TERMS - 2, y));
    return sum * of_bits((uint64_t)((int)n + BIAS) << FRACTION_BITS);
}

/* x = 2^e y with y within sqrt(2)/2 and sqrt(2): ln y = 2 (s + s^3/3 + ...), s = (y - 1)/(y + 1),
 * at most 0.172. What is left out of the series is below 1e-20 of it. */
double mpm_logarithm(double x)
{
    static const double ROOT_HALF = 0x1.6a09e667f3bcdp-1;
    if (!(x >= DBL_MIN && x <= DBL_MAX))
        return (double)NAN;
    const uint64_t above = bits_of(x) - bits_of(ROOT_HALF) + ((uint64_t)BIAS << FRACTION_BITS);
    const int exponent = (int)(above >> FRACTION_BITS) - BIAS;
    const double y = of_bits(bits_of(x) - ((uint64_t)exponent << FRACTION_BITS));
    const double s = (y - 1.0) / (y + 1.0), square = s * s;
    const double sum = polynomial(inverse_odd + 1, LOG_TERMS - 1, square);
    return exponent * LN2_HIGH + (exponent * LN2_LOW + (2.0 * s + 2.0 * s * square * sum));
}
