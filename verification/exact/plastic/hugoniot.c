/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/plastic/hugoniot.h"

#include "verification/exact/root.h"

#include <math.h>

static double strain_of(const struct hugoniot *h, double u)
{
    return u / (h->sound_speed + h->slope * u);
}

/* exp(-gamma_0 eta) (de - P deta/rho_0)/du, with P/rho_0 = U_s u, de = u du, deta = c_0 du/U_s^2:
 * u - u c_0/U_s = s u^2/U_s, third order in a weak shock's strength once integrated. */
static double heating(const struct hugoniot *h, double u)
{
    const double speed = h->sound_speed + h->slope * u;
    return exp(-h->gruneisen * strain_of(h, u)) * h->slope * u * u / speed;
}

struct hugoniot_state hugoniot_behind(const struct hugoniot *h, double velocity)
{
    enum { PANELS = 256 };
    const double speed = h->sound_speed + h->slope * velocity;
    const double width = velocity / PANELS, strain = strain_of(h, velocity);
    double heat = 0.0;
    for (int k = 0; k < PANELS; k++) {
        const double u = k * width;
        heat += width / 6.0 *
                (heating(h, u) + 4.0 * heating(h, u + 0.5 * width) + heating(h, u + width));
    }
    return (struct hugoniot_state){
        .shock_speed = speed,
        .pressure = h->density * speed * velocity,
        .relative_volume = 1.0 - strain,
        .energy = 0.5 * velocity * velocity,
        .temperature =
            exp(h->gruneisen * strain) * (h->start_temperature + heat / h->specific_heat),
    };
}

struct meeting {
    const struct hugoniot *first, *second;
    double speed;
};

static double pressure_of(const struct hugoniot *h, double velocity)
{
    return h->density * (h->sound_speed + h->slope * velocity) * velocity;
}

static double excess(double velocity, void *context)
{
    const struct meeting *const m = context;
    return pressure_of(m->first, m->speed - velocity) - pressure_of(m->second, velocity);
}

double hugoniot_contact(const struct hugoniot *first, const struct hugoniot *second, double speed)
{
    struct meeting meeting = {first, second, speed};
    return root_between(excess, &meeting, 0.0, speed, 1e-14);
}
