/* Stress intensity of a crack of length 2 a in the middle of a long plate of width 2 W, under
 * tension across it.
 *
 *     Feddersen 1966:  K_I = sigma sqrt(pi a) sqrt(sec(pi a/(2 W))), 0.3 % for a/W <= 0.7
 *     Tada 1973:       the same times 1 - 0.025 (a/W)^2 + 0.06 (a/W)^4, 0.1 % for every a/W
 * Formulas and errors: H. Tada, P. C. Paris, G. R. Irwin, The Stress Analysis of Cracks Handbook,
 * 3rd ed., ASME 2000, sec. 2.1, where they are held against Isida's series.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_EXACT_CENTRE_CRACK_H
#define VERIFICATION_EXACT_CENTRE_CRACK_H

struct centre_crack {
    double half_length, half_width; /* a, W */
    double stress;                  /* sigma */
};

double centre_crack_feddersen(const struct centre_crack *crack);
double centre_crack_tada(const struct centre_crack *crack);

#endif
