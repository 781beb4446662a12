/* A crowd of bodies for comparisons of kernels, the laws that they may have and ways from the grid
 * to the particles: part of a test, included once.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TESTS_SUPPORT_CROWD_H
#define TESTS_SUPPORT_CROWD_H

#include "support/settings.h"

/* Cells are not square. A block at the axis (or a wall), beside it in the same cells a body
 * with another number of particles a cell; apart from them bodies of 1, 3, 5 and 6 particles,
 * two of them in one cell; a rigid body and moving boundaries. Velocities vary from particle
 * to particle. Waves cross a cell in 0.5. */
static const char CROWD[] =
    "format: 1\n"
    "title: A crowd\n"
    "geometry: plane_strain\n"
    "grid: {origin: [-2, 0], cell: [1, 0.8], cells: [16, 15]}\n"
    "time: {end: 1000, courant: 0.3}\n"
    "materials:\n"
    "  - {name: soft, law: neo_hookean, density: 1, bulk: 1.2, shear: 0.9}\n"
    "  - {name: heavy, law: neo_hookean, density: 3, bulk: 2, shear: 0.7}\n"
    "bodies:\n"
    "  - {name: block, material: soft, region: {rectangle: {from: [0, 1.6], to: [3.5, 4.8]}},\n"
    "     particles_per_cell: [2, 2]}\n"
    "  - {name: side, material: heavy, region: {rectangle: {from: [3.6, 1.6], to: [5, 4]}},\n"
    "     particles_per_cell: [3, 1]}\n"
    "  - {name: one, material: heavy, region: {rectangle: {from: [7, 8], to: [7.5, 8.8]}},\n"
    "     particles_per_cell: [2, 1]}\n"
    "  - {name: three, material: soft, region: {rectangle: {from: [6, 8.8], to: [7, 9.6]}},\n"
    "     particles_per_cell: [3, 1]}\n"
    "  - {name: five, material: soft, region: {rectangle: {from: [7, 8.8], to: [8, 9.6]}},\n"
    "     particles_per_cell: [5, 1]}\n"
    "  - {name: six, material: soft, region: {rectangle: {from: [7.55, 8], to: [8, 8.8]}},\n"
    "     particles_per_cell: [4, 3]}\n"
    "  - {name: wall, rigid: {velocity: [free, '0.05*cos(2*t)']},\n"
    "     region: {rectangle: {from: [0, 0.8], to: [3, 1.6]}}}\n"
    "boundary:\n"
    "  - {region: {line: {from: [4, 1.6], to: [6, 1.6]}}, velocity: ['0.02*sin(3*t)', -0.03]}\n";

static const char *const crowd_velocities[] = {
    ("bodies.block.velocity=['0.08*sin(3*X+Y)*X/(X+1)+0.03*sin(37*X+91*Y)*X/(X+1)', "
     "'0.06*cos(2*Y-X)+0.03*cos(53*Y-71*X)']"),
    "bodies.side.velocity=['-0.05+0.04*cos(41*X*Y)', '0.05*sin(29*X-3*Y)']",
    "bodies.five.velocity=['0.1*sin(60*X)', '-0.1']",
};

/* of the two materials; and more parameters of the first, or NULL */
static const struct law {
    const char *names[2];
    const char *first;
    bool no_plane_stress;
} laws[] = {
    {.names = {"neo_hookean", "neo_hookean"}},
    {.names = {"linear_elastic", "linear_elastic"}},
    {.names = {"linear_elastic", "neo_hookean"}},
    {.names = {"von_mises", "neo_hookean"},
     .first = "materials.soft={name: soft, law: von_mises, density: 1, bulk: 1.2, shear: 0.9, "
              "yield_stress: 0.02, hardening_modulus: 0.3}"},
    {.names = {"von_mises_gruneisen", "linear_elastic"},
     .first = "materials.soft={name: soft, law: von_mises_gruneisen, density: 1, shear: 0.5, "
              "yield_stress: 0.02, hardening_modulus: 0.3, sound_speed: 1, hugoniot_slope: 1.2, "
              "gruneisen: 1.5, viscosity: {linear: 0.3, quadratic: 1}}",
     .no_plane_stress = true},
};
/* Ways from the grid to the particles that fast kernels have; NULL: as it is. */
static const char *const exchanges[] = {
    "method.transfer={kind: flip, fraction: 0.95}",
    "method.transfer={kind: pic}",
    "method.transfer={kind: xpic, order: 3}",
    "method.transfer={kind: fmpm, order: 2}",
    "method.transfer={kind: apic}",
};
enum { EXCHANGES = G_N_ELEMENTS(exchanges), APIC = EXCHANGES - 1 };

/* of a crowd */
static void add_laws(struct settings *settings, const struct law *law)
{
    if (law->first != NULL)
        settings_add(settings, law->first);
    else
        settings_add_formatted(settings, "materials.soft.law=%s", law->names[0]);
    settings_add_formatted(settings, "materials.heavy.law=%s", law->names[1]);
}

#endif
