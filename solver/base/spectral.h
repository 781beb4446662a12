/* Functions of symmetric tensors, by their eigenvalues: f(A) has the eigenvectors of A, and the
 * eigenvalues f of its eigenvalues. In the plane, with the mean a and the half difference d of the
 * eigenvalues, f(A) = (f(a + d) + f(a - d))/2 I + (f(a + d) - f(a - d))/(2 d) (A - a I). The same
 * bits on every machine.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_BASE_SPECTRAL_H
#define MPM_BASE_SPECTRAL_H

#include "base/tensor.h"

/* Below this ratio d/a the series of the second term has two terms: the third is round-off. */
static const double MPM_SPECTRAL_SERIES = 1e-4;

/* ln A of a positive definite A; of any other one components that are not a number. The error is a
 * few units of round-off times the ratio of the eigenvalues. */
void mpm_symmetric_logarithm(const double a[MPM_SYMMETRIC_SIZE], double out[MPM_SYMMETRIC_SIZE]);

/* exp(A); eigenvalues up to 700. */
void mpm_symmetric_exponential(const double a[MPM_SYMMETRIC_SIZE], double out[MPM_SYMMETRIC_SIZE]);

/* The positive definite root of a positive definite A. */
void mpm_symmetric_root(const double a[MPM_SYMMETRIC_SIZE], double out[MPM_SYMMETRIC_SIZE]);

/* A X A, of symmetric A and X. */
void mpm_symmetric_sandwich(const double a[MPM_SYMMETRIC_SIZE], const double x[MPM_SYMMETRIC_SIZE],
                            double out[MPM_SYMMETRIC_SIZE]);

/* A X of A and X with the same eigenvectors, which is symmetric. */
void mpm_symmetric_product(const double a[MPM_SYMMETRIC_SIZE], const double x[MPM_SYMMETRIC_SIZE],
                           double out[MPM_SYMMETRIC_SIZE]);

/* A^-1 of a regular A. */
void mpm_symmetric_inverse(const double a[MPM_SYMMETRIC_SIZE], double out[MPM_SYMMETRIC_SIZE]);

/* Takes the mean of the three diagonal components off them. */
void mpm_symmetric_deviate(double a[MPM_SYMMETRIC_SIZE]);

/* sqrt(A : A) */
double mpm_symmetric_norm(const double a[MPM_SYMMETRIC_SIZE]);

#endif
