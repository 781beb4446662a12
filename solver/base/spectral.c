/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/spectral.h"

#include "base/exponential.h"

#include <math.h>

/* The plane part. */
struct plane {
    double mean, half; /* of the eigenvalues: half their difference */
};

static struct plane plane_of(const double a[MPM_SYMMETRIC_SIZE])
{
    double value[2];
    mpm_plane_eigenvalues(a, value);
    return (struct plane){0.5 * (a[MPM_SYM_XX] + a[MPM_SYM_YY]), 0.5 * (value[1] - value[0])};
}

/* mean I + factor (A - a I) */
static void compose(const double a[MPM_SYMMETRIC_SIZE], double mean, double factor,
                    double out[MPM_SYMMETRIC_SIZE])
{
    const double half = 0.5 * (a[MPM_SYM_XX] - a[MPM_SYM_YY]), shear = a[MPM_SYM_XY];
    out[MPM_SYM_XX] = mean + factor * half;
    out[MPM_SYM_YY] = mean - factor * half;
    out[MPM_SYM_XY] = factor * shear;
}

/* (ln(a + d) - ln(a - d))/(2 d) = atanh(d/a)/d */
void mpm_symmetric_logarithm(const double a[MPM_SYMMETRIC_SIZE], double out[MPM_SYMMETRIC_SIZE])
{
    const struct plane plane = plane_of(a);
    const double ratio = plane.half / plane.mean;
    const double determinant =
        a[MPM_SYM_XX] * a[MPM_SYM_YY] - a[MPM_SYM_XY] * a[MPM_SYM_XY]; /* (a + d)(a - d) */
    const double high = plane.mean + plane.half;
    const double factor = ratio < MPM_SPECTRAL_SERIES
                              ? (1.0 + ratio * ratio * (1.0 / 3.0)) / plane.mean
                              : 0.5 * mpm_logarithm(high / (determinant / high)) / plane.half;
    const double zz = mpm_logarithm(a[MPM_SYM_ZZ]);
    compose(a, 0.5 * mpm_logarithm(determinant), factor, out);
    out[MPM_SYM_ZZ] = zz;
}

/* exp(a) (cosh d, sinh(d)/d) */
void mpm_symmetric_exponential(const double a[MPM_SYMMETRIC_SIZE], double out[MPM_SYMMETRIC_SIZE])
{
    const struct plane plane = plane_of(a);
    const double d = plane.half, scale = mpm_exponential(plane.mean);
    const double up = mpm_exponential(d), down = 1.0 / up;
    const double factor =
        d < MPM_SPECTRAL_SERIES ? 1.0 + d * d * (1.0 / 6.0) : 0.5 * (up - down) / d;
    const double zz = mpm_exponential(a[MPM_SYM_ZZ]);
    compose(a, scale * (0.5 * (up + down)), scale * factor, out);
    out[MPM_SYM_ZZ] = zz;
}

/* Cayley-Hamilton: V = (V^2 + det V I)/tr V with (tr V)^2 = tr V^2 + 2 det V. */
void mpm_symmetric_root(const double a[MPM_SYMMETRIC_SIZE], double out[MPM_SYMMETRIC_SIZE])
{
    const double determinant = sqrt(a[MPM_SYM_XX] * a[MPM_SYM_YY] - a[MPM_SYM_XY] * a[MPM_SYM_XY]);
    const double trace = sqrt(a[MPM_SYM_XX] + a[MPM_SYM_YY] + 2.0 * determinant);
    out[MPM_SYM_XX] = (a[MPM_SYM_XX] + determinant) / trace;
    out[MPM_SYM_YY] = (a[MPM_SYM_YY] + determinant) / trace;
    out[MPM_SYM_XY] = a[MPM_SYM_XY] / trace;
    out[MPM_SYM_ZZ] = sqrt(a[MPM_SYM_ZZ]);
}

void mpm_symmetric_sandwich(const double a[MPM_SYMMETRIC_SIZE], const double x[MPM_SYMMETRIC_SIZE],
                            double out[MPM_SYMMETRIC_SIZE])
{
    /* rows of A X */
    const double xx = a[MPM_SYM_XX] * x[MPM_SYM_XX] + a[MPM_SYM_XY] * x[MPM_SYM_XY];
    const double xy = a[MPM_SYM_XX] * x[MPM_SYM_XY] + a[MPM_SYM_XY] * x[MPM_SYM_YY];
    const double yx = a[MPM_SYM_XY] * x[MPM_SYM_XX] + a[MPM_SYM_YY] * x[MPM_SYM_XY];
    const double yy = a[MPM_SYM_XY] * x[MPM_SYM_XY] + a[MPM_SYM_YY] * x[MPM_SYM_YY];
    const double zz = a[MPM_SYM_ZZ] * x[MPM_SYM_ZZ] * a[MPM_SYM_ZZ];
    const double axx = a[MPM_SYM_XX], axy = a[MPM_SYM_XY], ayy = a[MPM_SYM_YY];
    out[MPM_SYM_XX] = xx * axx + xy * axy;
    out[MPM_SYM_XY] = xx * axy + xy * ayy;
    out[MPM_SYM_YY] = yx * axy + yy * ayy;
    out[MPM_SYM_ZZ] = zz;
}

void mpm_symmetric_product(const double a[MPM_SYMMETRIC_SIZE], const double x[MPM_SYMMETRIC_SIZE],
                           double out[MPM_SYMMETRIC_SIZE])
{
    const double xx = a[MPM_SYM_XX] * x[MPM_SYM_XX] + a[MPM_SYM_XY] * x[MPM_SYM_XY];
    const double yy = a[MPM_SYM_XY] * x[MPM_SYM_XY] + a[MPM_SYM_YY] * x[MPM_SYM_YY];
    const double xy = a[MPM_SYM_XX] * x[MPM_SYM_XY] + a[MPM_SYM_XY] * x[MPM_SYM_YY];
    out[MPM_SYM_XX] = xx;
    out[MPM_SYM_YY] = yy;
    out[MPM_SYM_XY] = xy;
    out[MPM_SYM_ZZ] = a[MPM_SYM_ZZ] * x[MPM_SYM_ZZ];
}

void mpm_symmetric_inverse(const double a[MPM_SYMMETRIC_SIZE], double out[MPM_SYMMETRIC_SIZE])
{
    const double determinant = a[MPM_SYM_XX] * a[MPM_SYM_YY] - a[MPM_SYM_XY] * a[MPM_SYM_XY];
    const double xx = a[MPM_SYM_XX];
    out[MPM_SYM_XX] = a[MPM_SYM_YY] / determinant;
    out[MPM_SYM_YY] = xx / determinant;
    out[MPM_SYM_XY] = -a[MPM_SYM_XY] / determinant;
    out[MPM_SYM_ZZ] = 1.0 / a[MPM_SYM_ZZ];
}

void mpm_symmetric_deviate(double a[MPM_SYMMETRIC_SIZE])
{
    const double mean = (a[MPM_SYM_XX] + a[MPM_SYM_YY] + a[MPM_SYM_ZZ]) * (1.0 / 3.0);
    a[MPM_SYM_XX] -= mean;
    a[MPM_SYM_YY] -= mean;
    a[MPM_SYM_ZZ] -= mean;
}

double mpm_symmetric_norm(const double a[MPM_SYMMETRIC_SIZE])
{
    return sqrt(a[MPM_SYM_XX] * a[MPM_SYM_XX] + a[MPM_SYM_YY] * a[MPM_SYM_YY] +
                a[MPM_SYM_ZZ] * a[MPM_SYM_ZZ] + 2.0 * (a[MPM_SYM_XY] * a[MPM_SYM_XY]));
}
