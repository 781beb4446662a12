/* The table of measuring programs: one line each.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "verification/programs/programs.h"

#include <string.h>

/* PROGRAM(name): `const struct measure_program program_<name>` in program_<name>.c */
#define PROGRAMS                                                                                   \
    PROGRAM(shape_quadrature)                                                                      \
    PROGRAM(shape_identities)                                                                      \
    PROGRAM(shape_curves)                                                                          \
    PROGRAM(compression)                                                                           \
    PROGRAM(energy)                                                                                \
    PROGRAM(vibration)                                                                             \
    PROGRAM(heat)                                                                                  \
    PROGRAM(heat_contact)                                                                          \
    PROGRAM(heat_stability)                                                                        \
    PROGRAM(solvent)                                                                               \
    PROGRAM(thermodynamics)                                                                        \
    PROGRAM(plastic_heat)                                                                          \
    PROGRAM(shock)                                                                                 \
    PROGRAM(plastic_path)                                                                          \
    PROGRAM(pressed_shell)                                                                         \
    PROGRAM(plastic_wave)                                                                          \
    PROGRAM(taylor_bar)                                                                            \
    PROGRAM(first_contact)                                                                         \
    PROGRAM(adiabat)                                                                               \
    PROGRAM(penetration)                                                                           \
    PROGRAM(damped_flight)                                                                         \
    PROGRAM(damped_bar)                                                                            \
    PROGRAM(step_wave)                                                                             \
    PROGRAM(spin)                                                                                  \
    PROGRAM(normals)                                                                               \
    PROGRAM(hertz)                                                                                 \
    PROGRAM(incline)                                                                               \
    PROGRAM(collision)                                                                             \
    PROGRAM(disk_chain)                                                                            \
    PROGRAM(cracked_disks)                                                                         \
    PROGRAM(overhead)                                                                              \
    PROGRAM(crack_patch)                                                                           \
    PROGRAM(crack_growth)                                                                          \
    PROGRAM(sliding)                                                                               \
    PROGRAM(pressed_crack)                                                                         \
    PROGRAM(cohesive)                                                                              \
    PROGRAM(crack_wave)                                                                            \
    PROGRAM(fracture)                                                                              \
    PROGRAM(slip_threshold)                                                                        \
    PROGRAM(crack_release)                                                                         \
    PROGRAM(slanted_crack)                                                                         \
    PROGRAM(cantilever)                                                                            \
    PROGRAM(contact_twins)                                                                         \
    PROGRAM(two_bars)                                                                              \
    PROGRAM(laminate)                                                                              \
    PROGRAM(contact_energy)                                                                        \
    PROGRAM(adhesion)                                                                              \
    PROGRAM(inclusion)                                                                             \
    PROGRAM(carried)                                                                               \
    PROGRAM(manufactured)                                                                          \
    PROGRAM(stretch)                                                                               \
    PROGRAM(stability)                                                                             \
    PROGRAM(extremes)                                                                              \
    PROGRAM(statics)                                                                               \
    PROGRAM(traction_sum)                                                                          \
    PROGRAM(turning_load)                                                                          \
    PROGRAM(study)

#define PROGRAM(name) extern const struct measure_program program_##name;
PROGRAMS
#undef PROGRAM

static const struct measure_program *const programs[] = {
#define PROGRAM(name) &program_##name,
    PROGRAMS
#undef PROGRAM
        NULL};

struct program_table programs_all(void)
{
    return (struct program_table){programs, sizeof programs / sizeof programs[0] - 1};
}

const struct measure_program *programs_find(struct program_table table, const char *name)
{
    for (size_t i = 0; i < table.count; i++)
        if (strcmp(table.programs[i]->name, name) == 0)
            return table.programs[i];
    return NULL;
}
