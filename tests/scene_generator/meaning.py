"""What a scene's keys mean where their kind does not state it: tables for `draw.py`.

SPDX-License-Identifier: GPL-3.0-or-later
"""

from draw import ABSENT
import draw_bodies as bodies
import draw_contact as contact
import draw_cracks as cracks
import draw_heat as heat
import draw_loads as loads
import draw_method as method
import draw_passages as passages
import draw_plastic as plastic
from scales import SCALARS

# ------------------------------------------------------------------- left out
LEFT_OUT = {
    "time.allow_unstable": "beyond the stability limit nothing is promised",
    "output.checkpoint": "the invariant of runs that go on from one has its own",
    "output.checkpoint_seconds": "by the clock; checkpoints are the same",
    "output.snapshots": "the first state and the last are compared; more would land steps on them",
    "contact.normal=given": "refused: it is for pairs, each with its direction",
    "output.fringe": "a field for pictures; its values follow from the stress",
    "output.derived": "fields for pictures; their values follow from others",
    "output.probes": "fields at places; they follow from those of the particles",
    "output.lines": "the same",
}

# Refused where nothing moves, since materials have law: none.
OF_MOTION = {
    "method.stress_update", "method.extrapolate", "method.position_update", "method.radius_update",
    "method.axis_nodes", "method.form", "method.transfer", "method.cracks",
    "method.deformation_terms", "loads", "damping", "output.energy_balance", "output.fringe",
    "bodies[].velocity", "bodies[].rigid", "cracks[].contact", "cracks[].detection",
    "cracks[].friction", "cracks[].separated", "cracks[].touching", "cracks[].opening",
    "cracks[].cohesive", "cracks[].j_integral",
}

# Drawn by the function of a group or list in MEANING: all keys within must be named.
COVERED = {
    "materials[].viscosity.linear", "materials[].viscosity.quadratic",
    "time.end", "time.courant", "time.step", "time.steps", "time.rest", "bodies[].region.rectangle",
    "bodies[].region.rectangle.from", "bodies[].region.rectangle.to", "bodies[].region.disk",
    "bodies[].region.disk.center", "bodies[].region.disk.radius", "bodies[].region.annulus",
    "bodies[].region.annulus.center", "bodies[].region.annulus.inner",
    "bodies[].region.annulus.outer", "bodies[].region.polygon", "bodies[].region.polygon.points",
    "boundary[].region", "boundary[].region.line", "boundary[].region.line.from",
    "boundary[].region.line.to", "boundary[].region.rectangle",
    "boundary[].region.rectangle.from", "boundary[].region.rectangle.to", "boundary[].region.all",
    "boundary[].velocity", "boundary[].symmetry", "cracks[].cohesive.law",
    "cracks[].cohesive.strength", "cracks[].cohesive.toughness", "cracks[].cohesive.stiffness",
    "cracks[].cohesive.knee_opening", "cracks[].cohesive.knee_traction",
    "cracks[].j_integral[].propagation.toughness", "cracks[].j_integral[].propagation.longest",
    "cracks[].j_integral[].propagation.increment", "cracks[].j_integral[].propagation.direction",
    "cracks[].j_integral[].propagation.every", "loads.tractions[].body", "loads.tractions[].edge",
    "loads.tractions[].value", "loads.tractions[].frame", "loads.particle_forces[].body",
    "loads.particle_forces[].edge", "loads.particle_forces[].value",
    "loads.particle_forces[].frame", "bodies[].rigid.velocity", "damping.thermostat.gain",
    "damping.thermostat.target", "damping.thermostat.scale", "method.transfer.kind",
    "method.transfer.fraction", "method.transfer.order", "contact.fields", "contact.law",
    "contact.normal", "contact.detection", "contact.friction", "contact.static_friction",
    "contact.adhesion", "contact.touching", "contact.tension", "contact.compression",
    "contact.shear", "contact.ratio_limit", "contact.pairs", "contact.pairs[].of", "contact.pairs[].law",
    "contact.pairs[].normal", "contact.pairs[].direction", "contact.pairs[].detection",
    "contact.pairs[].friction", "contact.pairs[].static_friction", "contact.pairs[].adhesion",
    "contact.pairs[].touching", "contact.pairs[].tension", "contact.pairs[].compression",
    "contact.pairs[].shear", "contact.pairs[].ratio_limit",
    "contact.heat", "contact.conductance", "contact.heat_gap", "contact.pairs[].heat",
    "contact.pairs[].conductance", "contact.pairs[].heat_gap", "transport.substeps",
    "transport.every", "transport.temperature.heating", "transport.temperature.fluxes[].radiation",
    "transport.temperature.fluxes[].radiation.emissivity",
    "transport.temperature.fluxes[].radiation.sigma",
    "transport.temperature.fluxes[].radiation.ambient",
}

COVERED |= {f"transport.{scalar}{key}" for scalar in SCALARS for key in (
    "", ".transfer", ".order", ".start", ".source", ".conditions", ".conditions[].region",
    ".conditions[].region.line", ".conditions[].region.line.from", ".conditions[].region.line.to",
    ".conditions[].region.rectangle", ".conditions[].region.rectangle.from",
    ".conditions[].region.rectangle.to", ".conditions[].region.all", ".conditions[].value",
    ".fluxes", ".fluxes[].body", ".fluxes[].edge", ".fluxes[].value", ".fluxes[].convection",
    ".fluxes[].convection.coefficient", ".fluxes[].convection.ambient")}

# Groups within those of which keys that the function does not know are drawn by their kind.
OPEN = ("time.rest.",)

# Children that are drawn before the others, in this order.
FIRST = {
    "": ("format", "geometry", "units", "grid", "materials", "bodies", "boundary", "cracks",
         "transport"),
    "grid": ("cell",),
    "materials": ("young", "poisson"),
    "cracks": ("points", "contact", "j_integral", "heat"),
    "method": ("shape", "axis", "stress_update", "form", "transfer"),
    "loads": ("tractions", "particle_forces"),
}
ALWAYS = {"method", "output", "loads", "damping"}  # groups that are left out only where empty

GENERAL = ("any", "touching", "heated", "coupled", "exchanging", "plastic")  # the situations that together have all keys


def prepare(canvas):
    """Settles what several sections must agree on. The situation `touching` is `any` with contact between
    bodies; `heated`, `coupled` and `exchanging` are `any` with transport (draw_heat.py), the last one
    with contact or cracks and the others without. `plastic` is `any` with laws of plastic strain."""
    notes = canvas.notes
    notes["plastic"] = canvas.situation == "plastic"
    notes["contact"] = canvas.situation == "touching" or notes["plastic"] and canvas.chance(30)
    heat.settle(canvas)
    conducts = notes["heat"] or notes["solvent"]
    if notes["exchanging"]:
        notes["contact"] = canvas.chance(65)
    cracked = notes["exchanging"] and not notes["contact"]
    if notes["contact"] or conducts or notes["plastic"]:
        canvas.situation = "any"
    notes["cracked"] = cracked or canvas.situation == "pressed" or canvas.situation == "any" and \
        not conducts and canvas.chance(25 if notes["contact"] or notes["plastic"] else 40)
    free = notes["cracked"] and canvas.situation == "any" and not notes["contact"]
    notes["fracture"] = free and canvas.chance(15)
    notes["past"] = free and not notes["fracture"] and \
        canvas.chance(25)  # a crack past a plane of symmetry
    notes["rigid"] = canvas.situation == "any" and not notes["still"] and \
        canvas.chance(40 if notes["contact"] else 15)
    notes["bodies"] = (2 if canvas.situation == "any" and not notes["fracture"] and
                       not notes["past"] and canvas.chance(25) else 1)
    if notes["contact"]:
        notes["bodies"] = canvas.pick([2, 2, 2, 3, 3, 4, 5])
    # Bodies as most scenes have them: filled with whole cells, in the middle of the grid.
    notes["plain"] = canvas.situation != "any" or notes["cracked"] or canvas.chance(70)


MEANING = {
    "format": lambda canvas, key: int(key.low),
    "thickness": lambda canvas, key: canvas.pick([2, 0.5]) if canvas.chance(20) else ABSENT,
    "grid.origin": bodies.draw_origin,
    "grid.cell": bodies.draw_cell,
    "grid.cells": bodies.draw_cells,
    "grid.refine": lambda canvas, key: 2 if canvas.situation == "any" and canvas.chance(10)
                   else ABSENT,
    "time": method.draw_time,
    "method.shape": method.draw_always,
    "method.stress_update": method.draw_always,
    "method.position_update": lambda canvas, key: canvas.pick(key.choices),
    "method.axis": lambda canvas, key: canvas.pick(key.choices),
    "method.axis_nodes": method.draw_axis_nodes,
    "method.extrapolate": method.draw_extrapolate,
    "method.radius_update": method.draw_radius_update,
    "method.form": method.draw_form,
    "method.transfer": method.draw_transfer,
    "method.cracks": method.draw_crack_method,
    "materials[].name": bodies.draw_name,
    "materials[].law": heat.draw_law,
    "materials[].gas_constant": heat.draw_gas_constant,
    "materials[].viscosity": heat.draw_viscosity,
    "materials[].sound_speed": heat.draw_of_fluid([1, 2]),
    "materials[].hugoniot_slope": heat.draw_of_fluid([1.5, 1, 2.5]),
    "materials[].gruneisen": heat.draw_of_fluid([2, 0, 1]),
    "materials[].pressure_cutoff": heat.draw_cutoff,
    "materials[].adiabatic_index": heat.draw_of_fluid([4.4, 1.4]),
    "materials[].start_pressure": heat.draw_of_fluid([0, 0.1, 0.3]),
    "materials[].stiffening_pressure": heat.draw_of_fluid([1, 0.3]),
    "materials[].heat_capacity": heat.draw_capacity,
    "materials[].heat_capacity_table": heat.draw_capacity_table,
    "materials[].conductivity": heat.draw_conductivity,
    "materials[].conductivity_table": heat.draw_conductivity_table,
    "materials[].principal_conductivities": heat.draw_principal,
    "materials[].conductivity_angle": heat.draw_angle,
    "materials[].thermal_expansion": heat.draw_expansion,
    "materials[].stress_free_temperature": heat.draw_stress_free,
    "materials[].saturation": heat.draw_capacity,
    "materials[].diffusivity": heat.draw_conductivity,
    "materials[].diffusivity_table": heat.draw_conductivity_table,
    "materials[].principal_diffusivities": heat.draw_principal,
    "materials[].diffusivity_angle": heat.draw_angle,
    "materials[].swelling": heat.draw_expansion,
    "materials[].stress_free_concentration": heat.draw_stress_free,
    "materials[].specific_heat": plastic.draw_specific_heat,
    "materials[].start_temperature": plastic.draw_temperature,
    "materials[].yield_stress": plastic.draw_yield_stress,
    "materials[].hardening_modulus": plastic.draw_modulus,
    "materials[].hardening_strain": plastic.draw_hardening_strain,
    "materials[].hardening_exponent": plastic.draw_exponent,
    "materials[].hardening_coefficient": plastic.draw_coefficient,
    "materials[].kinematic_modulus": plastic.draw_part,
    "materials[].hardening_table": plastic.draw_table,
    "materials[].rate_coefficient": plastic.draw_rate_coefficient,
    "materials[].reference_rate": plastic.draw_reference_rate,
    "materials[].softening_exponent": plastic.draw_of_softening([1, 0.7, 1.5]),
    "materials[].reference_temperature": plastic.draw_of_softening([10]),
    "materials[].melting_temperature": plastic.draw_of_softening([12, 11]),
    "materials[].taylor_quinney": plastic.draw_quinney,
    "materials[].density": bodies.draw_density,
    "materials[].young": bodies.draw_young,
    "materials[].poisson": bodies.draw_poisson,
    "materials[].bulk": bodies.draw_modulus,
    "materials[].shear": bodies.draw_modulus,
    "bodies[].name": bodies.draw_body_name,
    "bodies[].material": bodies.draw_material,
    "bodies[].rigid": bodies.draw_rigid,
    "bodies[].region": bodies.draw_body_region,
    "bodies[].particles_per_cell": bodies.draw_lattice,
    "bodies[].velocity": bodies.draw_body_velocity,
    "bodies[].temperature": heat.draw_body_start,
    "bodies[].concentration": heat.draw_body_start,
    "transport": heat.draw_transport,
    "boundary": loads.draw_boundaries,
    "loads.body_force": loads.draw_body_force,
    "loads.body_force_at": loads.draw_body_force_at,
    "loads.tractions": loads.draw_tractions,
    "loads.particle_forces": loads.draw_particle_forces,
    "cracks[].points": cracks.draw_crack_points,
    "cracks[].contact": cracks.draw_contact,
    "cracks[].friction": cracks.draw_friction,
    "cracks[].separated": cracks.draw_separated,
    "cracks[].touching": cracks.draw_touching,
    "cracks[].opening": cracks.draw_opening,
    "cracks[].cohesive": cracks.draw_cohesive,
    "cracks[].heat": passages.draw_crack_heat,
    "cracks[].conductance": passages.draw_crack_conductance,
    "cracks[].j_integral[].tip": cracks.draw_tip,
    "cracks[].j_integral[].contour": cracks.draw_contour,
    "cracks[].j_integral[].form": cracks.draw_form,
    "cracks[].j_integral[].propagation": cracks.draw_propagation,
    "contact": contact.draw_contact,
    "damping.grid": method.draw_grid_damping,
    "damping.grid_form": method.draw_grid_form,
    "damping.particle": method.draw_particle_damping,
    "damping.pic": method.draw_pic_damping,
    "damping.thermostat": method.draw_thermostat,
    "output.history": method.draw_history,
}
COUNT = {
    "materials": bodies.draw_material_count,
    "bodies": bodies.draw_body_count,
    "cracks": cracks.draw_crack_count,
    "cracks[].j_integral": cracks.draw_integral_count,
}
