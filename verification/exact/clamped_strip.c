/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/clamped_strip.h"

#include <math.h>

double clamped_strip_release(const struct clamped_strip *strip, double place, double time)
{
    const double delta = strip->rate * time * (1.0 - strip->gradient * (place - strip->tip));
    return strip->modulus * delta * delta / strip->height;
}

double clamped_strip_growth(const struct clamped_strip *strip, double time)
{
    const double first = sqrt(strip->toughness * strip->height / strip->modulus);
    const double over = 1.0 - first / (strip->rate * time);
    return over <= 0.0 ? 0.0 : over / strip->gradient;
}
