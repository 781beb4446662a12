/* A bar in its first axial mode.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/waves/vibrating_bar.h"

#include <math.h>

static const double PI = 3.14159265358979323846;

double vibrating_bar_wave_number(const struct vibrating_bar *bar)
{
    return (bar->end == VIBRATING_BAR_HELD ? PI : 0.5 * PI) / bar->length;
}

static double frequency(const struct vibrating_bar *bar)
{
    return sqrt(bar->modulus / bar->density) * vibrating_bar_wave_number(bar);
}

double vibrating_bar_period(const struct vibrating_bar *bar)
{
    return 2.0 * PI / frequency(bar);
}

double vibrating_bar_displacement(const struct vibrating_bar *bar, double start, double time)
{
    return bar->amplitude * sin(vibrating_bar_wave_number(bar) * start) *
           sin(frequency(bar) * time);
}

double vibrating_bar_velocity(const struct vibrating_bar *bar, double start, double time)
{
    const double omega = frequency(bar);
    return bar->amplitude * omega * sin(vibrating_bar_wave_number(bar) * start) * cos(omega * time);
}

double vibrating_bar_strain(const struct vibrating_bar *bar, double start, double time)
{
    const double k = vibrating_bar_wave_number(bar);
    return bar->amplitude * k * cos(k * start) * sin(frequency(bar) * time);
}

double vibrating_bar_energy(const struct vibrating_bar *bar)
{
    const double peak_velocity = bar->amplitude * frequency(bar);
    return 0.25 * bar->density * bar->length * peak_velocity * peak_velocity;
}
