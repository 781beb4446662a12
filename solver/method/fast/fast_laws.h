/* Fast kernels: the stress update of a block of particles, by law. A function each, which the
 * kernels of all families call: a law costs little to compile, and nothing where a scene does not
 * have it. Laws without equations on vectors have one function together.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_METHOD_FAST_LAWS_H
#define MPM_METHOD_FAST_LAWS_H

#include "method/fast/fast_constants.h"

/* One for each geometry of a scene, and that without gradients. */
enum { MPM_FAST_RECOMPUTE = MPM_AXISYMMETRIC + 1, MPM_FAST_UPDATES };

/* The name of a table of this level: mpm_fast_<what>_<level>. */
#define FAST_NAME_OF(what, level) mpm_fast_##what##_##level
#define FAST_NAME_AT(what, level) FAST_NAME_OF(what, level)
#define FAST_NAME(what)           FAST_NAME_AT(what, FAST_LEVEL)

/* Has a body's law equations on vectors, and its stress nothing that they lack: of elastic
 * laws viscosity; of metals back stress, a table of hardening, softening by a conducted
 * temperature? */
bool mpm_fast_body_has_vectors(const struct mpm_material_spec *body);

struct mpm_fast_law {
    const struct mpm_material_law *law;
    bool metal; /* with state variables and viscosity; in plane stress particle by particle */
    mpm_fast_update *update[MPM_FAST_UPDATES];
};

/* The laws that have equations on vectors. The last entry has no law: its updates take F from
 * vectors, and the stress particle by particle, as the reference kernels do. One table for each
 * level of SIMD. */
extern const struct mpm_fast_law mpm_fast_laws_baseline[];
#ifdef __x86_64__
extern const struct mpm_fast_law mpm_fast_laws_v3[];
#endif

#endif
