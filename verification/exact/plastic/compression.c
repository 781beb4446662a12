/* Uniform radial compression of a neo-Hookean disk; see compression.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/exact/plastic/compression.h"

#include <math.h>

double compression_relative_volume(double radial_strain)
{
    return (1 + radial_strain) * (1 + radial_strain);
}

double compression_radial_strain(double relative_volume)
{
    return sqrt(relative_volume) - 1;
}

double compression_energy(const struct compression_material *material, const double stretch[3])
{
    const double j = stretch[0] * stretch[1] * stretch[2];
    const double trace =
        stretch[0] * stretch[0] + stretch[1] * stretch[1] + stretch[2] * stretch[2];
    const double invariant = trace / cbrt(j * j); /* (65) */
    return material->bulk / 2 * ((j * j - 1) / 2 - log(j)) + material->shear / 2 * (invariant - 3);
}

struct compression_stress compression_stress(const struct compression_material *material,
                                             double relative_volume)
{
    const double j = relative_volume;
    const double factor = (j - 1) / j;
    const double volumetric = material->bulk / 2 * (j + 1);
    const double deviatoric = material->shear / (3 * cbrt(j * j));
    const double radial = factor * (volumetric + deviatoric);    /* (66) */
    const double axial = factor * (volumetric - 2 * deviatoric); /* (67) */
    return (struct compression_stress){.rr = radial, .zz = axial, .tt = radial};
}
