/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/plastic/plastic_wave.h"

#include <math.h>

struct plastic_wave_fronts plastic_wave_fronts(const struct plastic_wave *w)
{
    const double slope = 3.0 * w->shear + w->hardening;
    const double elastic = w->bulk + 4.0 / 3.0 * w->shear;
    const double beyond = w->bulk + 4.0 / 3.0 * w->shear * w->hardening / slope;
    const double strain = w->yield / (2.0 * w->shear), pressure = elastic * strain;
    struct plastic_wave_fronts fronts = {
        .precursor = {.celerity = sqrt(elastic / w->density),
                      .pressure = pressure,
                      .lateral = pressure - w->yield,
                      .strain = strain},
        .plastic = {.celerity = sqrt(beyond / w->density)},
    };
    struct plastic_wave_state *const first = &fronts.precursor, *const last = &fronts.plastic;
    first->remaining = w->speed - pressure / (w->density * first->celerity);
    last->pressure = pressure + w->density * last->celerity * first->remaining;
    last->strain = strain + first->remaining / last->celerity;
    last->plastic = 2.0 * w->shear * (last->strain - strain) / slope;
    last->lateral = last->pressure - w->yield - w->hardening * last->plastic;
    return fronts;
}
