/* Every key of a scene, once. From these lists come the C structs that a scene's tree fills,
 * how it fills them, the checks of type and range, the defaults and `mpm schema`.
 *
 * A line is X(S, shape, key, value, where, need, unit, default, range, help):
 *   S        what the user of the list needs in each line: the list's name
 *   shape    ONE value, a PAIR of values, a list of POINTS (pairs), a CHOICE among names,
 *            a GROUP of keys, a LIST of groups
 *   value    kind of the value; for a CHOICE its list below; for GROUP and LIST the list
 *            of their keys
 *   where    geometry that the key belongs to: ANYWHERE, PLANAR, AXISYMMETRIC
 *   unit     its dimension: MPM_DIMENSION_... without the prefix
 *   range    of values; for POINTS how many
 *   default  YAML used for a missing OPTIONAL key, or NULL: then the key stays
 *            missing and `help` states what that means
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_IO_SCENE_KEYS_H
#define MPM_IO_SCENE_KEYS_H

#include "io/scene/contact_keys.h"
#include "io/scene/transport_keys.h"

/* ----------------------------------------------------------------- choices */

/* NOLINTBEGIN(readability-identifier-naming): pasted from the names of keys */

#define CHOICES_geometry(C)                                                                        \
    C("plane_strain", MPM_PLANE_STRAIN)                                                            \
    C("plane_stress", MPM_PLANE_STRESS)                                                            \
    C("axisymmetric", MPM_AXISYMMETRIC)

#define CHOICES_shape(C) MPM_SHAPES(C)

#define CHOICES_axis(C)                                                                            \
    C("truncated", MPM_TRUNCATED)                                                                  \
    C("untruncated", MPM_UNTRUNCATED)                                                              \
    C("planar", MPM_PLANAR)

#define CHOICES_axis_nodes(C)                                                                      \
    C("free", MPM_AXIS_NODES_FREE)                                                                 \
    C("zero", MPM_AXIS_NODES_ZERO)                                                                 \
    C("mirrored", MPM_AXIS_NODES_MIRRORED)

#define CHOICES_stress_update(C)                                                                   \
    C("usl", MPM_USL)                                                                              \
    C("musl", MPM_MUSL)                                                                            \
    C("usf", MPM_USF)                                                                              \
    C("usavg", MPM_USAVG)

#define CHOICES_position_update(C)                                                                 \
    C("grid_velocity", MPM_GRID_VELOCITY)                                                          \
    C("midpoint", MPM_MIDPOINT)

#define CHOICES_radius_update(C)                                                                   \
    C("shape", MPM_RADIUS_SHAPE)                                                                   \
    C("hoop", MPM_RADIUS_HOOP)

#define CHOICES_transfer_kind(C) MPM_TRANSFERS(C)

#define CHOICES_form(C)                                                                            \
    C("velocity", MPM_FORM_VELOCITY)                                                               \
    C("momentum", MPM_FORM_MOMENTUM)

#define CHOICES_edge(C)                                                                            \
    C("top", MPM_EDGE_TOP)                                                                         \
    C("bottom", MPM_EDGE_BOTTOM)                                                                   \
    C("left", MPM_EDGE_LEFT)                                                                       \
    C("right", MPM_EDGE_RIGHT)                                                                     \
    C("all", MPM_EDGE_ALL)

#define CHOICES_frame(C)                                                                           \
    C("global", MPM_FRAME_GLOBAL)                                                                  \
    C("edge", MPM_FRAME_EDGE)

#define CHOICES_crack_method(C)                                                                    \
    C("fields", MPM_CRACKS_FIELDS)                                                                 \
    C("visibility", MPM_CRACKS_VISIBILITY)

#define CHOICES_contact(C)                                                                         \
    C("frictionless", MPM_CONTACT_FRICTIONLESS)                                                    \
    C("friction", MPM_CONTACT_FRICTION)                                                            \
    C("stick", MPM_CONTACT_STICK)                                                                  \
    C("none", MPM_CONTACT_NONE)

#define CHOICES_detection(C)                                                                       \
    C("volume", MPM_DETECT_VOLUME)                                                                 \
    C("displacement", MPM_DETECT_DISPLACEMENT)                                                     \
    C("cell", MPM_DETECT_CELL)

#define CHOICES_tip(C)                                                                             \
    C("end", false)                                                                                \
    C("start", true)

#define CHOICES_j_form(C)                                                                          \
    C("bergkvist_huong", MPM_J_BERGKVIST_HUONG)                                                    \
    C("broberg", MPM_J_BROBERG)                                                                    \
    C("contour", MPM_J_CONTOUR)

#define CHOICES_growth_direction(C)                                                                \
    C("straight", MPM_GROWS_STRAIGHT)                                                              \
    C("hoop_stress", MPM_GROWS_HOOP)

#define CHOICES_body_force_at(C)                                                                   \
    C("particles", MPM_BODY_FORCE_AT_PARTICLES)                                                    \
    C("nodes", MPM_BODY_FORCE_AT_NODES)

#define CHOICES_grid_form(C)                                                                       \
    C("nodes", MPM_GRID_DAMPING_NODES)                                                             \
    C("particles", MPM_GRID_DAMPING_PARTICLES)                                                     \
    C("particle_rate", MPM_GRID_DAMPING_PARTICLE_RATE)

#define CHOICES_contact_fields(C)                                                                  \
    C("materials", false)                                                                          \
    C("bodies", true)

#define CHOICES_pair_law(C)                                                                        \
    C("none", MPM_PAIR_NONE)                                                                       \
    C("bonded", MPM_PAIR_BONDED)                                                                   \
    C("stick", MPM_PAIR_STICK)                                                                     \
    C("frictionless", MPM_PAIR_FRICTIONLESS)                                                       \
    C("friction", MPM_PAIR_FRICTION)                                                               \
    C("interface", MPM_PAIR_INTERFACE)

#define CHOICES_pair_normal(C)                                                                     \
    C("average", MPM_NORMAL_AVERAGE)                                                               \
    C("area", MPM_NORMAL_AREA)                                                                     \
    C("volume", MPM_NORMAL_VOLUME)                                                                 \
    C("larger", MPM_NORMAL_LARGER)                                                                 \
    C("linear", MPM_NORMAL_LINEAR)                                                                 \
    C("logistic", MPM_NORMAL_LOGISTIC)                                                             \
    C("given", MPM_NORMAL_GIVEN)

#define CHOICES_pair_detection(C)                                                                  \
    C("extent", MPM_TOUCH_EXTENT)                                                                  \
    C("volume", MPM_TOUCH_VOLUME)                                                                  \
    C("shared", MPM_TOUCH_SHARED)

#define CHOICES_scalar_transfer(C)                                                                 \
    C("flip", MPM_SCALAR_FLIP)                                                                     \
    C("pic", MPM_SCALAR_PIC)                                                                       \
    C("xpic", MPM_SCALAR_XPIC)                                                                     \
    C("fmpm", MPM_SCALAR_FMPM)

#define CHOICES_surface_law(C)                                                                     \
    C("insulated", MPM_SURFACE_INSULATES)                                                          \
    C("perfect", MPM_SURFACE_PERFECT)                                                              \
    C("conductance", MPM_SURFACE_CONDUCTANCE)

#define CHOICES_cohesive_law(C)                                                                    \
    C("linear", MPM_COHESIVE_LINEAR)                                                               \
    C("trilinear", MPM_COHESIVE_TRILINEAR)                                                         \
    C("exponential", MPM_COHESIVE_EXPONENTIAL)

/* NOLINTEND(readability-identifier-naming) */

/* clang-format off */
#define MPM_CHOICE_LISTS(L)                                                                        \
    L(geometry) L(shape) L(axis) L(axis_nodes) L(stress_update) L(position_update) L(radius_update) \
    L(form) L(body_force_at) L(grid_form) L(transfer_kind) L(edge) L(frame) L(crack_method) L(contact) L(detection) L(tip)       \
    L(j_form) L(growth_direction) L(cohesive_law) L(contact_fields) L(pair_law) L(pair_normal) L(pair_detection) \
    L(scalar_transfer) L(surface_law)

/* -------------------------------------------------------------------- keys */

#define KEYS_units(X, S)                                                                           \
    X(S, ONE, length, NAME, ANYWHERE, OPTIONAL, NONE, "\"\"", ANY, "name of the unit of length")     \
    X(S, ONE, mass, NAME, ANYWHERE, OPTIONAL, NONE, "\"\"", ANY, "name of the unit of mass")         \
    X(S, ONE, time, NAME, ANYWHERE, OPTIONAL, NONE, "\"\"", ANY, "name of the unit of time")         \
    X(S, ONE, temperature, NAME, ANYWHERE, OPTIONAL, NONE, "\"\"", ANY, "name of the unit of temperature")

#define KEYS_grid(X, S)                                                                            \
    X(S, PAIR, origin, NUMBER, ANYWHERE, OPTIONAL, LENGTH, "[0, 0]", ANY,                        \
      "position of the first node")                                                                \
    X(S, PAIR, cell, NUMBER, ANYWHERE, REQUIRED, LENGTH, NULL, FROM_TO(1e-100, 1e100),           \
      "size of a cell")                                                                            \
    X(S, PAIR, cells, INTEGER, ANYWHERE, REQUIRED, NONE, NULL, FROM_TO(1, 2147483648.0),             \
      "number of cells along each axis; with refine and ghost rows at most 2^31 nodes")            \
    X(S, ONE, refine, INTEGER, ANYWHERE, OPTIONAL, NONE, "1", FROM_TO(1, 1048576),                   \
      "divides each cell into so many along each axis")

#define KEYS_rest(X, S)                                                                            \
    X(S, ONE, residual, NUMBER, ANYWHERE, REQUIRED, NONE, NULL, ABOVE_TO(0, 1),                      \
      "threshold: unbalanced force of the free nodes over the internal forces of all; of transport, flow to the free nodes over the largest flow to all so far")             \
    X(S, ONE, kinetic_energy, NUMBER, ANYWHERE, OPTIONAL, NONE, NULL, ABOVE_TO(0, 1),                \
      "threshold: kinetic energy over the largest sum of kinetic and strain energy so far; required where something moves, and only there")        \
    X(S, ONE, steps, INTEGER, ANYWHERE, OPTIONAL, NONE, "10", FROM_TO(1, 1000000),                   \
      "both must be below for so many steps in a row")                                             \
    X(S, ONE, after, NUMBER, ANYWHERE, OPTIONAL, TIME, "0", AT_LEAST(0),                         \
      "rest is not tested before: when the loads are complete")                                    \
    X(S, ONE, patience, INTEGER, ANYWHERE, OPTIONAL, NONE, NULL, FROM_TO(1, 1000000000),             \
      "the run has failed if the residual, above its threshold, has not fallen by 10 % for so many steps; without it, it goes on to the end")

#define KEYS_time(X, S)                                                                            \
    X(S, ONE, end, NUMBER, ANYWHERE, REQUIRED, TIME, NULL, ABOVE(0), "when the run ends")        \
    X(S, ONE, courant, NUMBER, ANYWHERE, OPTIONAL, NONE, "0.4", ABOVE(0),                            \
      "time step over the time that waves take through a cell; up to 1 unless allow_unstable; "    \
      "not with step")                                                                             \
    X(S, ONE, step, NUMBER, ANYWHERE, OPTIONAL, TIME, NULL, ABOVE(0),                            \
      "a fixed time step instead of courant; under the stability limit unless allow_unstable")     \
    X(S, ONE, steps, INTEGER, ANYWHERE, OPTIONAL, NONE, NULL, FROM_TO(1, 9007199254740992.0),        \
      "stop after so many steps")                                                                  \
    X(S, ONE, allow_unstable, BOOLEAN, ANYWHERE, OPTIONAL, NONE, "false", ANY,                       \
      "take time steps beyond the stability limit")                                                \
    X(S, GROUP, rest, rest, ANYWHERE, OPTIONAL, NONE, NULL, ANY,                                     \
      "quasi-static: the run is done when it is at rest, and has failed if it is not by the end")

#define KEYS_transfer(X, S)                                                                        \
    X(S, CHOICE, kind, transfer_kind, ANYWHERE, OPTIONAL, NONE, "flip", ANY,                         \
      "how particle velocities follow the grid")                                                   \
    X(S, ONE, fraction, NUMBER, ANYWHERE, OPTIONAL, NONE, "1", ABOVE_TO(0, 1),                       \
      "flip: share of FLIP; the rest takes the grid's velocity")                                   \
    X(S, ONE, order, INTEGER, ANYWHERE, OPTIONAL, NONE, NULL, FROM_TO(1, 100),                       \
      "xpic and fmpm: their order, which must be given; 1 is PIC, each more costs two passes over the particles")

#define KEYS_method(X, S)                                                                          \
    X(S, CHOICE, shape, shape, ANYWHERE, OPTIONAL, NONE, "ugimp", ANY, "shape functions")            \
    X(S, CHOICE, axis, axis, AXISYMMETRIC, OPTIONAL, NONE, "truncated", ANY,                         \
      "domains at r = 0: cut off there, not, or not and with the planar functions")                \
    X(S, CHOICE, axis_nodes, axis_nodes, AXISYMMETRIC, OPTIONAL, NONE, NULL, ANY,                    \
      "v_r of the extra nodes at r < 0, zero if missing; only with axis: planar and ugimp or cpdi") \
    X(S, CHOICE, stress_update, stress_update, ANYWHERE, OPTIONAL, NONE, "musl", ANY,                \
      "where in the step stresses are updated")                                                    \
    X(S, ONE, extrapolate, BOOLEAN, ANYWHERE, OPTIONAL, NONE, NULL, ANY,                             \
      "extrapolate the updated particles' momentum again for the last stress update: usavg with "  \
      "or without, musl always, usl and usf never")                                                \
    X(S, CHOICE, position_update, position_update, ANYWHERE, OPTIONAL, NONE, "grid_velocity", ANY,   \
      "how particles move")                                                                        \
    X(S, CHOICE, radius_update, radius_update, AXISYMMETRIC, OPTIONAL, NONE, "shape", ANY,           \
      "how r moves: with S, or with the hoop strain's T (only axis: truncated)")                   \
    X(S, CHOICE, form, form, ANYWHERE, OPTIONAL, NONE, "velocity", ANY,                              \
      "what the particles' updates take from the grid: velocities, or momenta over the mass that " \
      "the nodes have at the particle; momentum with flip and pic")                                \
    X(S, GROUP, transfer, transfer, ANYWHERE, OPTIONAL, NONE, "{}", ANY, "grid to particle velocities") \
    X(S, ONE, deformation_terms, INTEGER, ANYWHERE, OPTIONAL, NONE, "2", FROM_TO(1, 20),             \
      "terms of the series for the deformation increment exp(dt grad v)")                          \
    X(S, CHOICE, cracks, crack_method, ANYWHERE, OPTIONAL, NONE, "fields", ANY,                      \
      "what a particle gives to nodes behind a crack: velocity fields of their own (CRAMP), or nothing; only with cracks")

/* A parameter of laws: which of them a material has is checked when its law is known. */
#define KEY_PARAMETER(X, S, name, key, dimension, range, help)                                     \
    X(S, ONE, key, NUMBER, ANYWHERE, OPTIONAL, dimension, NULL, range, help)

#define KEYS_viscosity(X, S)                                                                       \
    X(S, ONE, linear, NUMBER, ANYWHERE, REQUIRED, NONE, NULL, AT_LEAST(0),                           \
      "A_1 of q = rho h |D| (A_1 c + A_2 h |D|), D < 0 the rate of volume, h the cell size")       \
    X(S, ONE, quadratic, NUMBER, ANYWHERE, REQUIRED, NONE, NULL, AT_LEAST(0), "A_2 of the same")

#define KEYS_material(X, S)                                                                        \
    X(S, ONE, name, NAME, ANYWHERE, REQUIRED, NONE, NULL, ANY, "unique name")                         \
    X(S, ONE, law, LAW, ANYWHERE, REQUIRED, NONE, NULL, ANY, "constitutive law")                     \
    X(S, ONE, density, NUMBER, ANYWHERE, REQUIRED, DENSITY, NULL, ABOVE(0),                \
      "initial density")                                                                           \
    MPM_LAW_PARAMETERS(KEY_PARAMETER, X, S)                                                         \
    X(S, ONE, young, NUMBER, ANYWHERE, OPTIONAL, STRESS, NULL, ABOVE(0),           \
      "Young's modulus, together with poisson; instead of bulk and shear")                         \
    X(S, ONE, poisson, NUMBER, ANYWHERE, OPTIONAL, NONE, NULL, BETWEEN(-1, 0.5),                     \
      "Poisson's ratio, together with young; instead of bulk and shear")                           \
    X(S, POINTS, hardening_table, NUMBER, ANYWHERE, OPTIONAL, STRESS, NULL, FROM_TO(1, MPM_POINTS_MAX), \
      "points [equivalent plastic strain, yield stress], linear between them, constant beyond the last; the first strain is 0, stresses are above 0 and do not fall; instead of yield_stress and isotropic hardening") \
    X(S, GROUP, viscosity, viscosity, ANYWHERE, OPTIONAL, NONE, NULL, ANY,                           \
      "artificial viscosity, which spreads shocks over some cells; none if missing")               \
    KEYS_conduction(X, S)

#define KEYS_rectangle(X, S)                                                                       \
    X(S, PAIR, from, NUMBER, ANYWHERE, REQUIRED, LENGTH, NULL, ANY, "lower left corner")         \
    X(S, PAIR, to, NUMBER, ANYWHERE, REQUIRED, LENGTH, NULL, ANY, "upper right corner")

#define KEYS_disk(X, S)                                                                            \
    X(S, PAIR, center, NUMBER, ANYWHERE, REQUIRED, LENGTH, NULL, ANY, "centre")                  \
    X(S, ONE, radius, NUMBER, ANYWHERE, REQUIRED, LENGTH, NULL, ABOVE(0), "radius")

#define KEYS_annulus(X, S)                                                                         \
    X(S, PAIR, center, NUMBER, ANYWHERE, REQUIRED, LENGTH, NULL, ANY, "centre")                  \
    X(S, ONE, inner, NUMBER, ANYWHERE, REQUIRED, LENGTH, NULL, ABOVE(0), "inner radius")         \
    X(S, ONE, outer, NUMBER, ANYWHERE, REQUIRED, LENGTH, NULL, ABOVE(0), "outer radius")

#define KEYS_polygon(X, S)                                                                         \
    X(S, POINTS, points, NUMBER, ANYWHERE, REQUIRED, LENGTH, NULL, FROM_TO(3, MPM_POINTS_MAX),   \
      "corners in order; edges must not cross")

#define KEYS_line(X, S)                                                                            \
    X(S, PAIR, from, NUMBER, ANYWHERE, REQUIRED, LENGTH, NULL, ANY, "one end")                   \
    X(S, PAIR, to, NUMBER, ANYWHERE, REQUIRED, LENGTH, NULL, ANY,                                \
      "other end; the line must be parallel to an axis")

#define KEYS_body_region(X, S)                                                                     \
    X(S, GROUP, rectangle, rectangle, ANYWHERE, OPTIONAL, NONE, NULL, ANY, "a rectangle")            \
    X(S, GROUP, disk, disk, ANYWHERE, OPTIONAL, NONE, NULL, ANY, "a disk")                           \
    X(S, GROUP, annulus, annulus, ANYWHERE, OPTIONAL, NONE, NULL, ANY, "a ring")                     \
    X(S, GROUP, polygon, polygon, ANYWHERE, OPTIONAL, NONE, NULL, ANY, "a polygon")

#define KEYS_boundary_region(X, S)                                                                 \
    X(S, GROUP, line, line, ANYWHERE, OPTIONAL, NONE, NULL, ANY, "the nodes on a line")              \
    X(S, GROUP, rectangle, rectangle, ANYWHERE, OPTIONAL, NONE, NULL, ANY, "the nodes in a rectangle") \
    X(S, ONE, all, BOOLEAN, ANYWHERE, OPTIONAL, NONE, NULL, ANY,                                     \
      "all nodes; `region: all` is the same as `region: {all: true}`")

#define KEYS_rigid(X, S)                                                                           \
    X(S, PAIR, velocity, DRIVE, ANYWHERE, REQUIRED, VELOCITY, NULL, ANY,                      \
      "velocity that it gives to the nodes it reaches, in coordinates and t")

#define KEYS_body(X, S)                                                                            \
    X(S, ONE, name, NAME, ANYWHERE, REQUIRED, NONE, NULL, ANY, "unique name")                      \
    X(S, ONE, material, NAME, ANYWHERE, OPTIONAL, NONE, NULL, ANY,                                   \
      "name of its material, for a deformable body")                                               \
    X(S, GROUP, rigid, rigid, ANYWHERE, OPTIONAL, NONE, NULL, ANY,                                   \
      "instead of material: a rigid body that drives nodes")                                       \
    X(S, GROUP, region, body_region, ANYWHERE, REQUIRED, NONE, NULL, ANY,                            \
      "where it is at t = 0: exactly one shape, inside the grid")                                  \
    X(S, PAIR, particles_per_cell, INTEGER, ANYWHERE, OPTIONAL, NONE, "[2, 2]", FROM_TO(1, 16),      \
      "lattice sites of a cell along each axis")                                                   \
    X(S, PAIR, velocity, EXPRESSION, ANYWHERE, OPTIONAL, VELOCITY, "[0, 0]", ANY,             \
      "initial velocity of a deformable body, in the coordinates")                                 \
    X(S, ONE, temperature, EXPRESSION, ANYWHERE, OPTIONAL, TEMPERATURE, NULL, ANY,                   \
      "initial temperature of a deformable body, in the coordinates; transport.temperature.start if missing") \
    X(S, ONE, concentration, EXPRESSION, ANYWHERE, OPTIONAL, NONE, NULL, ANY,                        \
      "initial concentration of solvent, in the coordinates; transport.concentration.start if missing")

#define KEYS_boundary(X, S)                                                                        \
    X(S, GROUP, region, boundary_region, ANYWHERE, REQUIRED, NONE, NULL, ANY,                        \
      "which nodes: exactly one shape")                                                            \
    X(S, PAIR, velocity, DRIVE, ANYWHERE, OPTIONAL, VELOCITY, NULL, ANY,                      \
      "their velocity, in coordinates and t")                                                      \
    X(S, ONE, symmetry, BOOLEAN, ANYWHERE, OPTIONAL, NONE, NULL, ANY,                                \
      "true instead of velocity, for a line of nodes: a plane of symmetry, which reflects what reaches beyond it; false is refused")

#define KEYS_traction(X, S)                                                                        \
    X(S, ONE, body, NAME, ANYWHERE, REQUIRED, NONE, NULL, ANY, "name of a deformable body")          \
    X(S, CHOICE, edge, edge, ANYWHERE, REQUIRED, NONE, NULL, ANY,                                    \
      "which edges of its particles: those on that side beyond which the body has no site at t = 0") \
    X(S, PAIR, value, EXPRESSION, ANYWHERE, REQUIRED, STRESS, NULL, ANY,           \
      "force per area, in coordinates and t: two components, or normal (outwards) and tangential (counter clockwise)") \
    X(S, CHOICE, frame, frame, ANYWHERE, OPTIONAL, NONE, "global", ANY,                              \
      "components along the axes, or along the deformed edge's normal and the edge itself")

#define KEYS_loads(X, S)                                                                           \
    X(S, PAIR, body_force, EXPRESSION, ANYWHERE, OPTIONAL, ACCELERATION, "[0, 0]", ANY,         \
      "force per unit mass, in coordinates and t")                                                 \
    X(S, CHOICE, body_force_at, body_force_at, ANYWHERE, OPTIONAL, NONE, "particles", ANY,           \
      "coordinates in body_force: of the particles, whose shape functions spread it, or of the nodes, times their mass") \
    X(S, LIST, tractions, traction, ANYWHERE, OPTIONAL, NONE, "[]", ANY,                             \
      "on edges of particles: value times the area of the deformed edge (ugimp: of the undeformed one)") \
    X(S, LIST, particle_forces, traction, ANYWHERE, OPTIONAL, NONE, "[]", ANY,                       \
      "on the particles that have these edges: value times the area of the undeformed edge")

#define KEYS_propagation(X, S)                                                                     \
    X(S, ONE, toughness, NUMBER, ANYWHERE, REQUIRED, TOUGHNESS, NULL, ABOVE(0),                \
      "G_c: the tip grows when J_1 reaches it")                                                    \
    X(S, ONE, longest, NUMBER, ANYWHERE, REQUIRED, LENGTH, NULL, ABOVE(0),                       \
      "length that there is room for; the run fails when the tip would grow further")              \
    X(S, ONE, increment, NUMBER, ANYWHERE, OPTIONAL, NONE, "0.5", FROM_TO(0.05, 1),                  \
      "length of one growth, as a fraction of the shorter cell side")                              \
    X(S, CHOICE, direction, growth_direction, ANYWHERE, OPTIONAL, NONE, "straight", ANY,             \
      "straight on, or across the largest hoop stress of the field of K_I and K_II")               \
    X(S, ONE, every, INTEGER, ANYWHERE, OPTIONAL, NONE, "1", FROM_TO(1, 1e9),                        \
      "steps from one evaluation of J to the next; one growth at each")

#define KEYS_j_integral(X, S)                                                                      \
    X(S, CHOICE, tip, tip, ANYWHERE, OPTIONAL, NONE, "end", ANY, "of the chain of points")           \
    X(S, ONE, contour, INTEGER, ANYWHERE, REQUIRED, NONE, NULL, FROM_TO(2, 10000),                   \
      "cells from the node nearest to the tip to each side of the rectangle that J is integrated along") \
    X(S, ONE, dynamic, BOOLEAN, ANYWHERE, OPTIONAL, NONE, "true", ANY,                               \
      "with kinetic energy, accelerations and body forces; without, J is that of a state at rest") \
    X(S, CHOICE, form, j_form, AXISYMMETRIC, OPTIONAL, NONE, "bergkvist_huong", ANY,                 \
      "area term: with the radius as weight, without, or no area term at all, which depends on the contour") \
    X(S, GROUP, propagation, propagation, ANYWHERE, OPTIONAL, NONE, NULL, ANY,                       \
      "lets the tip grow, up to where it or the contour would meet a crack; at most once for each tip")

#define KEYS_cohesive(X, S)                                                                        \
    X(S, CHOICE, law, cohesive_law, ANYWHERE, REQUIRED, NONE, NULL, ANY,                             \
      "how the traction falls with the opening, once it has reached the strength")                 \
    X(S, ONE, strength, NUMBER, ANYWHERE, REQUIRED, STRESS, NULL, ABOVE(0),        \
      "largest traction")                                                                          \
    X(S, ONE, toughness, NUMBER, ANYWHERE, REQUIRED, TOUGHNESS, NULL, ABOVE(0),                \
      "work per area until nothing is left, G_c: opening, sliding or both")                        \
    X(S, ONE, stiffness, NUMBER, ANYWHERE, REQUIRED, STIFFNESS, NULL, ABOVE(0),     \
      "traction per opening before the strength is reached; the time step limits it")              \
    X(S, ONE, knee_opening, NUMBER, ANYWHERE, OPTIONAL, LENGTH, NULL, ABOVE(0),                  \
      "trilinear, and only there: opening between both slopes")                                    \
    X(S, ONE, knee_traction, NUMBER, ANYWHERE, OPTIONAL, STRESS, NULL, ABOVE(0),   \
      "trilinear, and only there: traction at knee_opening, up to the strength")

#define KEYS_crack(X, S)                                                                           \
    X(S, POINTS, points, NUMBER, ANYWHERE, REQUIRED, LENGTH, NULL, FROM_TO(2, MPM_POINTS_MAX),   \
      "the crack at t = 0, as a chain that does not meet itself or another crack")                 \
    X(S, CHOICE, contact, contact, ANYWHERE, OPTIONAL, NONE, "frictionless", ANY,                    \
      "what its surfaces do where they meet; with method.cracks: fields")                          \
    X(S, CHOICE, detection, detection, ANYWHERE, OPTIONAL, NONE, "volume", ANY,                      \
      "relative volume at a node: areas over those with the crack closed (volume), 1 - distance of the surfaces over the cell's size (displacement), areas over what the node can see of the grid, mostly a cell (cell: CRAMP)") \
    X(S, ONE, friction, NUMBER, ANYWHERE, OPTIONAL, NONE, NULL, AT_LEAST(0),                         \
      "coefficient of friction; with contact: friction, and only there")                           \
    X(S, ONE, separated, NUMBER, ANYWHERE, OPTIONAL, NONE, "0.9", BETWEEN(0, 1),                     \
      "surfaces are apart below this relative volume at a node (V_sep)")                           \
    X(S, ONE, touching, NUMBER, ANYWHERE, OPTIONAL, NONE, "1.1", ABOVE(1),                           \
      "surfaces touch above this relative volume at a node; between both, if they approach (V_contact)") \
    X(S, ONE, spacing, NUMBER, ANYWHERE, OPTIONAL, NONE, "0.5", FROM_TO(0.05, 1),                    \
      "longest distance of the massless points that carry it, over the shorter cell side")         \
    X(S, ONE, opening, BOOLEAN, ANYWHERE, OPTIONAL, NONE, "false", ANY,                              \
      "track both surfaces, and write how far they have opened and slid to history.csv, at an end outside of bodies where the chain enters one; with cohesive they always are") \
    X(S, GROUP, cohesive, cohesive, ANYWHERE, OPTIONAL, NONE, NULL, ANY,                             \
      "traction between its surfaces; without it there is none") \
    X(S, CHOICE, heat, surface_law, ANYWHERE, OPTIONAL, NONE, "insulated", ANY,                      \
      "with transport.temperature: what flows across, open or closed: nothing (insulated), as without the crack (perfect), conductance times the difference of temperatures") \
    X(S, ONE, conductance, NUMBER, ANYWHERE, OPTIONAL, FILM, NULL, AT_LEAST(0),                      \
      "heat: conductance, and only there: heat per area, time and difference of temperatures") \
    X(S, LIST, j_integral, j_integral, ANYWHERE, OPTIONAL, NONE, "[]", ANY,                          \
      "J integrals around its tips, and K_I and K_II: columns of history.csv")

#define KEYS_thermostat(X, S)                                                                      \
    X(S, ONE, gain, NUMBER, ANYWHERE, REQUIRED, RATE_SQUARED, NULL, ABOVE(0),                        \
      "growth of alpha: d alpha/dt = gain (K - target)/scale; near the square of twice the lowest angular frequency") \
    X(S, ONE, target, NUMBER, ANYWHERE, OPTIONAL, ENERGY, "0", AT_LEAST(0),        \
      "kinetic energy K that it leads to")                                                         \
    X(S, ONE, scale, NUMBER, ANYWHERE, OPTIONAL, ENERGY, NULL, ABOVE(0),           \
      "kinetic energy that gain is meant for; without it the largest K so far")

#define KEYS_damping(X, S)                                                                         \
    X(S, ONE, grid, EXPRESSION, ANYWHERE, OPTIONAL, RATE, NULL, ANY,                           \
      "alpha_g: nodes slow down by alpha_g v, in coordinates of the node and t")                   \
    X(S, CHOICE, grid_form, grid_form, ANYWHERE, OPTIONAL, NONE, "nodes", ANY,                       \
      "where grid and thermostat act: in the nodes' momentum update, in the particles' update with alpha_g of the nodes, or there with alpha_g of the particle's place") \
    X(S, ONE, particle, EXPRESSION, ANYWHERE, OPTIONAL, RATE, NULL, ANY,                       \
      "alpha_p: particles slow down by alpha_p v, in coordinates of the particle and t")           \
    X(S, ONE, pic, EXPRESSION, ANYWHERE, OPTIONAL, NONE, NULL, ANY,                                  \
      "beta, from 0 to 1, in t: what of a particle's velocity the grid does not carry is multiplied by it in each step") \
    X(S, GROUP, thermostat, thermostat, ANYWHERE, OPTIONAL, NONE, NULL, ANY,                         \
      "adds to alpha_g a rate that follows the kinetic energy")

#define KEYS_probe(X, S)                                                                           \
    X(S, ONE, name, NAME, ANYWHERE, REQUIRED, NONE, NULL, ANY, "name in the rows of probes.csv")     \
    X(S, PAIR, at, NUMBER, ANYWHERE, REQUIRED, LENGTH, NULL, ANY, "place, which stays where it is")

#define KEYS_probe_line(X, S)                                                                      \
    X(S, ONE, name, NAME, ANYWHERE, REQUIRED, NONE, NULL, ANY, "name in the rows of probes.csv")     \
    X(S, PAIR, from, NUMBER, ANYWHERE, REQUIRED, LENGTH, NULL, ANY, "first place")                   \
    X(S, PAIR, to, NUMBER, ANYWHERE, REQUIRED, LENGTH, NULL, ANY, "last place")                      \
    X(S, ONE, points, INTEGER, ANYWHERE, REQUIRED, NONE, NULL, FROM_TO(2, 10000),                    \
      "places along the line, at equal distances, both ends included")

#define KEYS_output(X, S)                                                                          \
    X(S, ONE, history, NUMBER, ANYWHERE, OPTIONAL, TIME, NULL, ABOVE(0),                         \
      "interval of rows in history.csv; without it only t = 0 and end")                            \
    X(S, ONE, snapshots, NUMBER, ANYWHERE, OPTIONAL, TIME, NULL, ABOVE(0),                       \
      "interval of snapshots; without it only t = 0 and end")                                      \
    X(S, ONE, checkpoint, NUMBER, ANYWHERE, OPTIONAL, TIME, NULL, ABOVE(0),                      \
      "interval of checkpoints, at the first step at or after each; mpm run --resume goes on from the last")                         \
    X(S, ONE, checkpoint_seconds, NUMBER, ANYWHERE, OPTIONAL, NONE, NULL, ABOVE(0),                       \
      "checkpoints by the clock: when a run has taken so many seconds since the last one")                         \
    X(S, ONE, energy_balance, BOOLEAN, ANYWHERE, OPTIONAL, NONE, "false", ANY,                       \
      "history.csv has transfer_loss, what is lost between particles and nodes, measured in each step, and with it closes to round-off") \
    X(S, ONE, fringe, NUMBER, PLANAR, OPTIONAL, COMPLIANCE, NULL, ABOVE(0),              \
      "k: snapshots have fringe, cos(k (s1 - s2)) of the principal stresses in the plane (CRAMP 23); 2 pi thickness over the material's stress for one fringe") \
    X(S, ONE, derived, BOOLEAN, ANYWHERE, OPTIONAL, NONE, "false", ANY,                              \
      "snapshots also have displacement, von_mises, pressure and each component of tensors by its name") \
    X(S, LIST, probes, probe, ANYWHERE, OPTIONAL, NONE, "[]", ANY,                                   \
      "places whose fields are rows of probes.csv, at the times of the history")                     \
    X(S, LIST, lines, probe_line, ANYWHERE, OPTIONAL, NONE, "[]", ANY,                               \
      "the same for places along lines")

#define KEYS_scene(X, S)                                                                           \
    X(S, ONE, format, INTEGER, ANYWHERE, REQUIRED, NONE, NULL, FROM_TO(1, 1),                        \
      "version of the scene's format")                                                             \
    X(S, ONE, title, TEXT, ANYWHERE, OPTIONAL, NONE, "\"\"", ANY, "what the scene is about")         \
    X(S, CHOICE, geometry, geometry, ANYWHERE, REQUIRED, NONE, NULL, ANY,                            \
      "axes x, y in planar scenes, r, z in axisymmetric ones")                                     \
    X(S, GROUP, units, units, ANYWHERE, OPTIONAL, NONE, "{}", ANY,                                   \
      "any consistent system; outputs carry the names")                                            \
    X(S, ONE, thickness, NUMBER, PLANAR, OPTIONAL, LENGTH, "1", ABOVE(0), "out of the plane")    \
    X(S, GROUP, grid, grid, ANYWHERE, REQUIRED, NONE, NULL, ANY, "regular background grid")          \
    X(S, GROUP, time, time, ANYWHERE, REQUIRED, NONE, NULL, ANY, "end and step of time")             \
    X(S, GROUP, method, method, ANYWHERE, OPTIONAL, NONE, "{}", ANY, "the numerical method")         \
    X(S, LIST, materials, material, ANYWHERE, REQUIRED, NONE, NULL, ANY, "one or more materials")    \
    X(S, LIST, bodies, body, ANYWHERE, REQUIRED, NONE, NULL, ANY,                                    \
      "one or more bodies, one of them deformable")                                                \
    X(S, LIST, boundary, boundary, ANYWHERE, OPTIONAL, NONE, "[]", ANY, "conditions on grid nodes")  \
    X(S, GROUP, loads, loads, ANYWHERE, OPTIONAL, NONE, "{}", ANY, "forces on bodies")               \
    X(S, LIST, cracks, crack, ANYWHERE, OPTIONAL, NONE, "[]", ANY, "explicit cracks in bodies")      \
    X(S, GROUP, contact, contact, ANYWHERE, OPTIONAL, NONE, NULL, ANY,                               \
      "velocity fields for materials or bodies, and contact between them; without it all share one") \
    X(S, GROUP, transport, transport, ANYWHERE, OPTIONAL, NONE, "{}", ANY,                           \
      "what is conducted; with law: none in all materials nothing else is computed, and nothing moves") \
    X(S, GROUP, damping, damping, ANYWHERE, OPTIONAL, NONE, "{}", ANY, "artificial damping")         \
    X(S, GROUP, output, output, ANYWHERE, OPTIONAL, NONE, "{}", ANY, "what is written, how often")

/* Children before those who hold them; `scene` last. */
#define MPM_KEY_LISTS(L)                                                                           \
    L(units) L(grid) L(rest) L(time) L(transfer) L(method) L(viscosity) L(material) L(rectangle) L(disk) L(annulus)     \
    L(polygon) L(line) L(body_region) L(boundary_region) L(rigid) L(body) L(boundary)            \
    L(traction) L(loads) L(propagation) L(j_integral) L(cohesive) L(crack) L(contact_pair) L(contact) \
    L(temperature_condition) L(convection) L(radiation) L(heat_flux) L(temperature) \
    L(concentration_condition) L(evaporation) L(solvent_flux) L(concentration) L(transport) L(thermostat) L(damping) L(probe) L(probe_line) L(output) L(scene)
/* clang-format on */

#endif
