/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/spinning_disk.h"

#include <complex.h>
#include <math.h>

static double complex number(double real, double imaginary)
{
    return real + imaginary * (double complex)I;
}

static double complex series(double complex a, unsigned terms)
{
    double complex sum = 1.0, term = 1.0;
    for (unsigned k = 1; k <= terms; k++) {
        term *= a / k;
        sum += term;
    }
    return sum;
}

static double complex factor_of_f(const struct spinning_disk *disk, double complex start,
                                  double complex end)
{
    switch (disk->order) {
    case SPINNING_DISK_USF:
        return series(start, disk->terms);
    case SPINNING_DISK_USAVG:
        return series(0.5 * start, disk->terms) * series(0.5 * end, disk->terms);
    case SPINNING_DISK_USL:
    default:
        return series(end, disk->terms);
    }
}

static double complex factor_of_x(const struct spinning_disk *disk, double complex start,
                                  double complex end)
{
    return 1.0 + (disk->midpoint ? 0.5 * (start + end) : end);
}

/* Both conditions, zero at the solution: ln |F factor| and the angle of x less theta. */
static void residual(const struct spinning_disk *disk, double theta, const double alpha[2],
                     double rest[2])
{
    const double complex start = number(alpha[0], alpha[1]);
    const double complex end = number(cos(theta), sin(theta)) * start;
    rest[0] = log(cabs(factor_of_f(disk, start, end)));
    rest[1] = carg(factor_of_x(disk, start, end)) - theta;
}

double spinning_disk_growth(const struct spinning_disk *disk, double theta)
{
    enum { ROUNDS = 20 };
    static const double STEP = 1e-7;
    double alpha[2] = {0.0, theta};
    for (int round = 0; round < ROUNDS; round++) {
        double rest[2], moved[2][2];
        residual(disk, theta, alpha, rest);
        for (int k = 0; k < 2; k++) {
            double beside[2] = {alpha[0], alpha[1]};
            beside[k] += STEP;
            residual(disk, theta, beside, moved[k]);
        }
        const double a = (moved[0][0] - rest[0]) / STEP, b = (moved[1][0] - rest[0]) / STEP;
        const double c = (moved[0][1] - rest[1]) / STEP, d = (moved[1][1] - rest[1]) / STEP;
        const double determinant = a * d - b * c;
        alpha[0] -= (d * rest[0] - b * rest[1]) / determinant;
        alpha[1] -= (a * rest[1] - c * rest[0]) / determinant;
    }
    const double complex start = number(alpha[0], alpha[1]);
    const double complex end = number(cos(theta), sin(theta)) * start;
    return log(cabs(factor_of_x(disk, start, end)));
}
