/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/segment.h"

#include "base/orientation.h"

#include <math.h>

void mpm_segment_find_way(const struct mpm_segment *segment, const double place[2], double way[2])
{
    const double along[2] = {segment->b[0] - segment->a[0], segment->b[1] - segment->a[1]};
    const double to[2] = {segment->a[0] - place[0], segment->a[1] - place[1]};
    const double part =
        -(to[0] * along[0] + to[1] * along[1]) / (along[0] * along[0] + along[1] * along[1]);
    const double bounded = fmin(fmax(part, 0.0), 1.0);
    way[0] = to[0] + bounded * along[0];
    way[1] = to[1] + bounded * along[1];
}

static bool is_near(const struct mpm_segment *segment, const double place[2], double near)
{
    double way[2];
    mpm_segment_find_way(segment, place, way);
    return way[0] * way[0] + way[1] * way[1] <= near * near;
}

static bool are_apart(const struct mpm_segment *one, const struct mpm_segment *other, double near)
{
    for (int i = 0; i < 2; i++)
        if (fmax(one->a[i], one->b[i]) + near < fmin(other->a[i], other->b[i]) ||
            fmax(other->a[i], other->b[i]) + near < fmin(one->a[i], one->b[i]))
            return true;
    return false;
}

static bool splits(const struct mpm_segment *one, const struct mpm_segment *other)
{
    return (mpm_orientation(one->a, one->b, other->a) > 0.0) !=
           (mpm_orientation(one->a, one->b, other->b) > 0.0);
}

bool mpm_segments_meet(const struct mpm_segment *one, const struct mpm_segment *other, double near)
{
    if (are_apart(one, other, near))
        return false;
    return (splits(one, other) && splits(other, one)) || is_near(one, other->a, near) ||
           is_near(one, other->b, near) || is_near(other, one->a, near) ||
           is_near(other, one->b, near);
}

bool mpm_segments_fold(const struct mpm_segment *one, const struct mpm_segment *next, double near)
{
    return is_near(one, next->b, near) || is_near(next, one->a, near);
}
