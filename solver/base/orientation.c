/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/orientation.h"

enum { PRODUCTS = 6, TERMS = 2 * PRODUCTS };

/* A sum of terms of rising size that do not overlap: the last one that is not zero has its sign. */
struct expansion {
    double term[TERMS];
    int count;
};

/* Each term gets the rounded sum so far, and keeps what was rounded off. */
static void add(struct expansion *sum, double value)
{
    for (int k = 0; k < sum->count; k++) {
        const double total = value + sum->term[k];
        const double of_term = total - value;
        sum->term[k] = (value - (total - of_term)) + (sum->term[k] - of_term);
        value = total;
    }
    sum->term[sum->count++] = value;
}

static void add_product(struct expansion *sum, double one, double other)
{
    const double product = one * other;
    add(sum, fma(one, other, -product));
    add(sum, product);
}

double mpm_orientation_exact(const double a[2], const double b[2], const double c[2])
{
    const double *const corner[3] = {a, b, c};
    struct expansion sum = {.count = 0};
    for (int k = 0; k < 3; k++) {
        const double *const next = corner[(k + 1) % 3];
        add_product(&sum, corner[k][0], next[1]);
        add_product(&sum, -corner[k][1], next[0]);
    }
    for (int k = TERMS - 1; k >= 0; k--)
        if (sum.term[k] != 0.0)
            return sum.term[k];
    return 0.0;
}
