/* Places of a domain, for sums and integrals over it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VERIFICATION_EXACT_MANUFACTURED_SAMPLE_H
#define VERIFICATION_EXACT_MANUFACTURED_SAMPLE_H

#include "verification/exact/manufactured/manufactured_field.h"

/* The place at two parts of the domain from 0 to 1: along X and Y of a rectangle, along radius and
 * angle of an annulus. Returns the area per area of the parts; in axisymmetry per radian. */
double manufactured_place(const struct manufactured_problem *problem, const double part[2],
                          double place[2]);

/* The place at a part of an edge, with its outward normal. Returns the length (area per radian) per
 * part. Only the first two edges of an annulus are edges: 0 for the others. */
double manufactured_edge_place(const struct manufactured_problem *problem,
                               enum manufactured_edge edge, double part, double place[2],
                               double normal[2]);

#endif
