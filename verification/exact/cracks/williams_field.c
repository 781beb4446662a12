/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/cracks/williams_field.h"

#include <math.h>

static const double PI = 3.14159265358979323846;

/* u_i = sqrt(r) shape[i], and the slope of shape over theta. */
struct angular {
    double shape[2], slope[2];
};

static struct angular angular_at(const struct williams_field *field, double theta)
{
    const double factor = 1.0 / (2.0 * field->shear * sqrt(2.0 * PI));
    const double one = factor * field->mode_1, two = factor * field->mode_2, k = field->kappa;
    const double c = cos(0.5 * theta), s = sin(0.5 * theta);
    const double c3 = cos(1.5 * theta), s3 = sin(1.5 * theta);
    return (struct angular){
        .shape = {one * ((k - 0.5) * c - 0.5 * c3) + two * ((k + 1.5) * s + 0.5 * s3),
                  one * ((k + 0.5) * s - 0.5 * s3) - two * ((k - 1.5) * c + 0.5 * c3)},
        .slope = {0.5 * one * (-(k - 0.5) * s + 1.5 * s3) + 0.5 * two * ((k + 1.5) * c + 1.5 * c3),
                  0.5 * one * ((k + 0.5) * c - 1.5 * c3) + 0.5 * two * ((k - 1.5) * s + 1.5 * s3)},
    };
}

struct polar {
    double along[2]; /* place from the tip, in local axes */
    double r, theta;
};

static struct polar polar_of(const struct williams_field *field, const double place[2])
{
    const double *const d = field->direction;
    const double x = place[0] - field->tip[0], y = place[1] - field->tip[1];
    const double one = d[0] * x + d[1] * y, two = d[0] * y - d[1] * x;
    return (struct polar){{one, two}, hypot(one, two), atan2(two, one)};
}

void williams_field_displacement(const struct williams_field *field, const double place[2],
                                 double u[2])
{
    const double *const d = field->direction;
    const struct polar at = polar_of(field, place);
    const struct angular angular = angular_at(field, at.theta);
    const double t = field->parallel / (8.0 * field->shear);
    const double one = sqrt(at.r) * angular.shape[0] + t * (field->kappa + 1.0) * at.along[0];
    const double two = sqrt(at.r) * angular.shape[1] - t * (3.0 - field->kappa) * at.along[1];
    u[0] = d[0] * one - d[1] * two;
    u[1] = d[1] * one + d[0] * two;
}

void williams_field_gradient(const struct williams_field *field, const double place[2],
                             double gradient[4])
{
    const double *const d = field->direction;
    const struct polar at = polar_of(field, place);
    const struct angular angular = angular_at(field, at.theta);
    const double t = field->parallel / (8.0 * field->shear), root = sqrt(at.r);
    const double c = at.along[0] / at.r, s = at.along[1] / at.r;
    double local[2][2];
    for (int i = 0; i < 2; i++) {
        local[i][0] = (0.5 * angular.shape[i] * c - angular.slope[i] * s) / root;
        local[i][1] = (0.5 * angular.shape[i] * s + angular.slope[i] * c) / root;
    }
    local[0][0] += t * (field->kappa + 1.0);
    local[1][1] -= t * (3.0 - field->kappa);
    const double turn[2][2] = {{d[0], -d[1]}, {d[1], d[0]}}; /* local axes in columns */
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 2; k++) {
            double sum = 0.0;
            for (int m = 0; m < 2; m++)
                for (int n = 0; n < 2; n++)
                    sum += turn[i][m] * local[m][n] * turn[k][n];
            gradient[2 * i + k] = sum;
        }
}

double williams_field_modulus(const struct williams_field *field)
{
    return 8.0 * field->shear / (field->kappa + 1.0);
}
