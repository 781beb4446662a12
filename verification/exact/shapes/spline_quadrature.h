/* B-splines by adaptive quadrature of the averages that define them.
 *
 * Along one axis, lengths in cells: the hat N averaged over a top hat as wide as a cell is the
 * centred quadratic B-spline; that averaged once more is the cubic, which is N averaged over N,
 * since a top hat averaged over a top hat is a hat. Slopes are the averages of N'. Each average
 * is one integral, done by QAGP with break points where its integrand has kinks.
 *
 * At an edge the function of the node beyond is folded onto the two nodes inside by linear
 * extrapolation (Steffen, Kirby, Berzins 2008): that at the edge gets twice of it, the next one
 * loses it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_EXACT_SPLINE_QUADRATURE_H
#define VERIFICATION_EXACT_SPLINE_QUADRATURE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct spline_quadrature; /* work space */

/* NULL when out of memory. */
struct spline_quadrature *spline_quadrature_create(void);
void spline_quadrature_free(struct spline_quadrature *quadrature);

/* A point between the nodes of a line. */
struct spline_line {
    int degree;        /* 2 or 3 */
    long double place; /* of the point, from node 0 */
    bool has_edge[2];  /* is there a first, a last node? */
    int64_t edge[2];   /* which; at least a cell apart */
};

enum spline_value { SPLINE_VALUE, SPLINE_SLOPE, SPLINE_VALUES };

struct spline_node {
    double value[SPLINE_VALUES];
    double estimate[SPLINE_VALUES]; /* the quadrature's bound on its error */
    double depth; /* of the point in the node's support; -1 for nodes beyond an edge */
};

/* Half the width of a function's support. */
double spline_reach(int degree);

/* The nodes first to first + count - 1, all of those in reach among them. Returns false if a
 * quadrature did not reach its tolerance. Cost: 10 us. */
bool spline_quadrature_line(struct spline_quadrature *quadrature, const struct spline_line *line,
                            int64_t first, size_t count, struct spline_node nodes[]);

#endif
