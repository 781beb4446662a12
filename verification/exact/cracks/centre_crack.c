/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/cracks/centre_crack.h"

#include <math.h>

double centre_crack_feddersen(const struct centre_crack *crack)
{
    const double pi = acos(-1.0);
    const double part = crack->half_length / crack->half_width;
    return crack->stress * sqrt(pi * crack->half_length / cos(0.5 * pi * part));
}

double centre_crack_tada(const struct centre_crack *crack)
{
    const double part = crack->half_length / crack->half_width, square = part * part;
    return centre_crack_feddersen(crack) * (1.0 - 0.025 * square + 0.06 * square * square);
}
