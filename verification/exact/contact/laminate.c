/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/contact/laminate.h"

double laminate_displacement(const struct laminate *laminate, double traction, double place)
{
    const double first = laminate->length[0];
    if (place <= first)
        return traction * place / laminate->modulus[0];
    return traction * (first / laminate->modulus[0] + 1.0 / laminate->interface +
                       (place - first) / laminate->modulus[1]);
}

double laminate_modulus(const struct laminate *laminate)
{
    const double length = laminate->length[0] + laminate->length[1];
    return length / laminate_displacement(laminate, 1.0, length);
}

double laminate_stored(const struct laminate *laminate, double traction)
{
    return 0.5 * traction * traction / laminate->interface;
}
