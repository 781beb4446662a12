/* Constants of exponential.c and exponential_vector.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_BASE_EXPONENTIAL_TERMS_H
#define MPM_BASE_EXPONENTIAL_TERMS_H

/* ln 2 in two parts, so that its multiples keep their digits. */
static const double MPM_LN2_HIGH = 0x1.62e42feep-1, MPM_LN2_LOW = 0x1.a39ef35793c76p-33;

enum { MPM_FRACTION_BITS = 52, MPM_BIAS = 1023, MPM_EXP_TERMS = 15, MPM_LOG_TERMS = 13 };

/* 1/k! */
static const double mpm_inverse_factorial[MPM_EXP_TERMS] = {
    0x1.0000000000000p+0,  0x1.0000000000000p+0,  0x1.0000000000000p-1,  0x1.5555555555555p-3,
    0x1.5555555555555p-5,  0x1.1111111111111p-7,  0x1.6c16c16c16c17p-10, 0x1.a01a01a01a01ap-13,
    0x1.a01a01a01a01ap-16, 0x1.71de3a556c734p-19, 0x1.27e4fb7789f5cp-22, 0x1.ae64567f544e4p-26,
    0x1.1eed8eff8d898p-29, 0x1.6124613a86d09p-33, 0x1.93974a8c07c9dp-37};
/* 1/(2 k + 1) */
static const double mpm_inverse_odd[MPM_LOG_TERMS] = {
    0x1.0000000000000p+0, 0x1.5555555555555p-2, 0x1.999999999999ap-3, 0x1.2492492492492p-3,
    0x1.c71c71c71c71cp-4, 0x1.745d1745d1746p-4, 0x1.3b13b13b13b14p-4, 0x1.1111111111111p-4,
    0x1.e1e1e1e1e1e1ep-5, 0x1.af286bca1af28p-5, 0x1.8618618618618p-5, 0x1.642c8590b2164p-5,
    0x1.47ae147ae147bp-5};

static const double MPM_PER_LN2 = 0x1.71547652b82fep0;
/* sqrt(2)/2: a logarithm's series is one of numbers from there to sqrt(2) */
static const double MPM_ROOT_HALF = 0x1.6a09e667f3bcdp-1;
static const double MPM_EXP_LARGEST = 700.0;

#endif
