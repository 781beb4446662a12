/* Keys of transport, as those of scene_keys.h, which includes this.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MPM_IO_TRANSPORT_KEYS_H
#define MPM_IO_TRANSPORT_KEYS_H

/* clang-format off */
#define KEYS_conduction(X, S) /* of a material */                                                          \
    X(S, ONE, heat_capacity, NUMBER, ANYWHERE, OPTIONAL, HEAT_CAPACITY, NULL, ABOVE(0),              \
      "specific heat capacity, or heat_capacity_table; with transport.temperature, and only there") \
    X(S, POINTS, heat_capacity_table, NUMBER, ANYWHERE, OPTIONAL, HEAT_CAPACITY, NULL, FROM_TO(2, MPM_POINTS_MAX), \
      "points [temperature, specific heat capacity], linear between them; temperatures rise, capacities are above 0; instead of heat_capacity") \
    X(S, ONE, conductivity, NUMBER, ANYWHERE, OPTIONAL, CONDUCTIVITY, NULL, AT_LEAST(0),             \
      "of heat, the same in all directions; or principal_conductivities, or conductivity_table")   \
    X(S, POINTS, conductivity_table, NUMBER, ANYWHERE, OPTIONAL, CONDUCTIVITY, NULL, FROM_TO(2, MPM_POINTS_MAX), \
      "points [temperature, conductivity], linear between them; temperatures rise, conductivities are above 0; instead of conductivity") \
    X(S, PAIR, principal_conductivities, NUMBER, ANYWHERE, OPTIONAL, CONDUCTIVITY, NULL, AT_LEAST(0), \
      "of heat along two axes of the material, which turn with it; instead of conductivity")       \
    X(S, ONE, conductivity_angle, NUMBER, ANYWHERE, OPTIONAL, NONE, NULL, FROM_TO(-360, 360),        \
      "degrees from the first axis of the grid to the first principal one, in the undeformed body; 0 if missing") \
    X(S, ONE, thermal_expansion, NUMBER, ANYWHERE, OPTIONAL, EXPANSION, NULL, ANY,                   \
      "linear, alpha of the stretch exp(alpha (T - stress_free_temperature)); with transport.temperature, and only there; none if missing") \
    X(S, ONE, stress_free_temperature, NUMBER, ANYWHERE, OPTIONAL, TEMPERATURE, NULL, ANY,           \
      "at which the undeformed body has no stress; with thermal_expansion")                        \
    X(S, ONE, saturation, NUMBER, ANYWHERE, OPTIONAL, DENSITY, NULL, ABOVE(0),                       \
      "mass of solvent per undeformed volume at the concentration 1; with transport.concentration, and only there") \
    X(S, ONE, diffusivity, NUMBER, ANYWHERE, OPTIONAL, AREA_RATE, NULL, AT_LEAST(0),                 \
      "of the solvent, the same in all directions; or principal_diffusivities, or diffusivity_table") \
    X(S, POINTS, diffusivity_table, NUMBER, ANYWHERE, OPTIONAL, AREA_RATE, NULL, FROM_TO(2, MPM_POINTS_MAX), \
      "points [concentration, diffusivity], linear between them; concentrations rise, diffusivities are above 0; instead of diffusivity") \
    X(S, PAIR, principal_diffusivities, NUMBER, ANYWHERE, OPTIONAL, AREA_RATE, NULL, AT_LEAST(0),    \
      "of the solvent along two axes of the material, which turn with it; instead of diffusivity") \
    X(S, ONE, diffusivity_angle, NUMBER, ANYWHERE, OPTIONAL, NONE, NULL, FROM_TO(-360, 360),         \
      "degrees from the first axis of the grid to the first principal one, in the undeformed body; 0 if missing") \
    X(S, ONE, swelling, NUMBER, ANYWHERE, OPTIONAL, NONE, NULL, ANY,                                 \
      "linear, beta of the stretch exp(beta (concentration - stress_free_concentration)); none if missing") \
    X(S, ONE, stress_free_concentration, NUMBER, ANYWHERE, OPTIONAL, NONE, NULL, ANY,                \
      "at which the undeformed body has no stress; with swelling")

#define KEYS_temperature_condition(X, S)                                                           \
    X(S, GROUP, region, boundary_region, ANYWHERE, REQUIRED, NONE, NULL, ANY,                        \
      "which nodes: exactly one shape")                                                            \
    X(S, ONE, value, EXPRESSION, ANYWHERE, REQUIRED, TEMPERATURE, NULL, ANY,                         \
      "their temperature, in coordinates and t")

#define KEYS_convection(X, S)                                                                      \
    X(S, ONE, coefficient, NUMBER, ANYWHERE, REQUIRED, FILM, NULL, ABOVE(0),                         \
      "h of the heat flux h (ambient - T)")                                                        \
    X(S, ONE, ambient, EXPRESSION, ANYWHERE, REQUIRED, TEMPERATURE, NULL, ANY,                       \
      "temperature of the surroundings, in coordinates and t")

#define KEYS_radiation(X, S)                                                                       \
    X(S, ONE, emissivity, NUMBER, ANYWHERE, REQUIRED, NONE, NULL, ABOVE_TO(0, 1),                    \
      "e of the heat flux e sigma (ambient^4 - T^4); temperatures are absolute")                   \
    X(S, ONE, sigma, NUMBER, ANYWHERE, REQUIRED, RADIATION, NULL, ABOVE(0),                          \
      "constant of Stefan and Boltzmann in the scene's units: 5.670374419e-8 W/(m^2 K^4)")         \
    X(S, ONE, ambient, EXPRESSION, ANYWHERE, REQUIRED, TEMPERATURE, NULL, ANY,                       \
      "absolute temperature of the surroundings, in coordinates and t")

#define KEYS_heat_flux(X, S)                                                                       \
    X(S, ONE, body, NAME, ANYWHERE, REQUIRED, NONE, NULL, ANY, "name of a deformable body")          \
    X(S, CHOICE, edge, edge, ANYWHERE, REQUIRED, NONE, NULL, ANY,                                    \
      "which edges of its particles: those on that side beyond which the body has no site at t = 0") \
    X(S, ONE, value, EXPRESSION, ANYWHERE, OPTIONAL, HEAT_FLUX, NULL, ANY,                           \
      "heat per area and time into the body, in coordinates and t; or convection, or radiation")   \
    X(S, GROUP, convection, convection, ANYWHERE, OPTIONAL, NONE, NULL, ANY,                         \
      "heat exchanged with surroundings, proportional to the difference of temperatures")          \
    X(S, GROUP, radiation, radiation, ANYWHERE, OPTIONAL, NONE, NULL, ANY,                           \
      "heat exchanged with surroundings by radiation")

#define KEYS_temperature(X, S)                                                                     \
    X(S, CHOICE, transfer, scalar_transfer, ANYWHERE, OPTIONAL, NONE, "flip", ANY,                   \
      "how particles' temperatures follow the grid: by its rates, by its values, which conducts of itself (pic), or by values to a higher order") \
    X(S, ONE, order, INTEGER, ANYWHERE, OPTIONAL, NONE, NULL, FROM_TO(1, 100),                       \
      "of transfer: xpic and fmpm, which must have it; 1 is pic, each more costs a pass over the particles") \
    X(S, ONE, start, EXPRESSION, ANYWHERE, OPTIONAL, TEMPERATURE, "0", ANY,                          \
      "initial temperature of bodies without their own, in the coordinates")                       \
    X(S, ONE, source, EXPRESSION, ANYWHERE, OPTIONAL, HEAT_SOURCE, NULL, ANY,                        \
      "heat per volume and time, in coordinates of the particle and t")                            \
    X(S, ONE, heating, BOOLEAN, ANYWHERE, OPTIONAL, NONE, "false", ANY,                              \
      "deformation changes temperatures: -alpha T d(tr tau)/rho_0 of materials that expand, and compression of gases; temperatures are absolute") \
    X(S, LIST, conditions, temperature_condition, ANYWHERE, OPTIONAL, NONE, "[]", ANY,               \
      "prescribed temperatures of nodes")                                                          \
    X(S, LIST, fluxes, heat_flux, ANYWHERE, OPTIONAL, NONE, "[]", ANY,                               \
      "on edges of particles, deformed as those of tractions; edges without one insulate")

#define KEYS_concentration_condition(X, S)                                                         \
    X(S, GROUP, region, boundary_region, ANYWHERE, REQUIRED, NONE, NULL, ANY,                        \
      "which nodes: exactly one shape")                                                            \
    X(S, ONE, value, EXPRESSION, ANYWHERE, REQUIRED, NONE, NULL, ANY,                                \
      "their concentration, in coordinates and t")

#define KEYS_evaporation(X, S)                                                                     \
    X(S, ONE, coefficient, NUMBER, ANYWHERE, REQUIRED, MASS_FLUX, NULL, ABOVE(0),                    \
      "of the flux coefficient (ambient - concentration)")                                         \
    X(S, ONE, ambient, EXPRESSION, ANYWHERE, REQUIRED, NONE, NULL, ANY,                              \
      "concentration that the surroundings lead to, in coordinates and t")

#define KEYS_solvent_flux(X, S)                                                                    \
    X(S, ONE, body, NAME, ANYWHERE, REQUIRED, NONE, NULL, ANY, "name of a deformable body")          \
    X(S, CHOICE, edge, edge, ANYWHERE, REQUIRED, NONE, NULL, ANY,                                    \
      "which edges of its particles, as those of tractions")                                       \
    X(S, ONE, value, EXPRESSION, ANYWHERE, OPTIONAL, MASS_FLUX, NULL, ANY,                           \
      "mass of solvent per area and time into the body, in coordinates and t; or convection")      \
    X(S, GROUP, convection, evaporation, ANYWHERE, OPTIONAL, NONE, NULL, ANY,                        \
      "solvent exchanged with surroundings, proportional to the difference of concentrations")

#define KEYS_concentration(X, S)                                                                   \
    X(S, CHOICE, transfer, scalar_transfer, ANYWHERE, OPTIONAL, NONE, "flip", ANY,                   \
      "how particles' concentrations follow the grid, as those of temperature")                    \
    X(S, ONE, order, INTEGER, ANYWHERE, OPTIONAL, NONE, NULL, FROM_TO(1, 100),                       \
      "of transfer: xpic and fmpm, which must have it; 1 is pic, each more costs a pass over the particles") \
    X(S, ONE, start, EXPRESSION, ANYWHERE, OPTIONAL, NONE, "0", ANY,                                 \
      "initial concentration of bodies without their own, in the coordinates")                     \
    X(S, ONE, source, EXPRESSION, ANYWHERE, OPTIONAL, MASS_SOURCE, NULL, ANY,                        \
      "mass of solvent per volume and time, in coordinates of the particle and t")                 \
    X(S, LIST, conditions, concentration_condition, ANYWHERE, OPTIONAL, NONE, "[]", ANY,             \
      "prescribed concentrations of nodes")                                                        \
    X(S, LIST, fluxes, solvent_flux, ANYWHERE, OPTIONAL, NONE, "[]", ANY,                            \
      "on edges of particles, deformed as those of tractions; others let nothing through")

#define KEYS_transport(X, S)                                                                       \
    X(S, GROUP, temperature, temperature, ANYWHERE, OPTIONAL, NONE, NULL, ANY,                       \
      "heat conduction: materials need heat_capacity and a conductivity")                       \
    X(S, ONE, substeps, INTEGER, ANYWHERE, OPTIONAL, NONE, "1", FROM_TO(1, 10000),                   \
      "a step of the mechanics may have so many equal ones of transport, as many as the limit of transport requires") \
    X(S, ONE, every, INTEGER, ANYWHERE, OPTIONAL, NONE, "1", FROM_TO(1, 1000000),                    \
      "transport takes place after so many steps of the mechanics, over their time; earlier where its limit requires it, and at times of results") \
    X(S, GROUP, concentration, concentration, ANYWHERE, OPTIONAL, NONE, NULL, ANY,                   \
      "diffusion of a solvent, as a part of saturation: materials need saturation and a diffusivity")

/* clang-format on */

#endif
