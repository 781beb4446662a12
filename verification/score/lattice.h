/* The points at which a bundle states its reference, and what is between them.
 *
 * A lattice of count[0] x count[1] initial positions, the first axis running fastest, over a
 * rectangle, or over a sector of a ring: radius and angle. A count of 1 means that the reference
 * does not depend on that axis. Between points the reference is the product of cubic polynomials
 * through the four nearest (error about (3/128) h^4 times the fourth derivative), or linear where
 * it jumps.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_SCORE_LATTICE_H
#define VERIFICATION_SCORE_LATTICE_H

#include <stdbool.h>
#include <stddef.h>

struct lattice {
    double from[2], to[2]; /* x and y, or radius and angle */
    size_t count[2];
    bool polar, linear;
};

/* The initial position of a point. */
void lattice_point(const struct lattice *lattice, size_t index, double place[2]);

enum { LATTICE_REACH = 4 };

/* The points around a place and their weights. */
struct lattice_weights {
    size_t first[2], number[2];
    double weight[2][LATTICE_REACH];
};

/* False if the place is outside, by more than 1e-6 of the lattice's extent. */
bool lattice_locate(const struct lattice *lattice, const double place[2],
                    struct lattice_weights *weights);

/* A column of count[0] * count[1] values there. */
double lattice_value(const struct lattice *lattice, const struct lattice_weights *weights,
                     const double *values);

#endif
