"""Changes of what a scene conducts: its values, what comes in, what passes between surfaces.

SPDX-License-Identifier: GPL-3.0-or-later
"""

import copy

from case import evaluate
from meaning import OF_MOTION
from scales import SCALARS


def scalars_of(scene):
    """What a scene conducts: keys of transport that are no steps."""
    return {SCALARS[name]: scene["transport"][name] for name in SCALARS
            if name in scene.get("transport", {})}


def with_values(scene, change):
    """The scene with each value of its scalars changed: start, bodies', conditions', surroundings',
    and those at which materials are free of stress."""
    new = copy.deepcopy(scene)
    for scalar, given in scalars_of(new).items():
        given["start"] = change(given.get("start", 0))
        entries = [(body, scalar.name) for body in new["bodies"]]
        entries += [(condition, "value") for condition in given.get("conditions", [])]
        entries += [(flux[kind], "ambient") for flux in given.get("fluxes", [])
                    for kind in ("convection", "radiation") if kind in flux]
        for entry, name in entries:
            if name in entry:
                entry[name] = change(entry[name])
        for material in new["materials"]:
            if scalar.stress_free in material:
                material[scalar.stress_free] = evaluate(change(material[scalar.stress_free]))
    return new


def with_tables_higher(scene, change):
    """The scene with tables of properties whose temperatures and concentrations are higher."""
    for scalar in scalars_of(scene):
        for material in scene["materials"]:
            for name in (scalar.capacity_table, scalar.one_table):
                if name in material:
                    material[name] = [[point + change, value] for point, value in material[name]]
    return scene


def without_tables(scene):
    """The scene with constants in the place of tables: the first of each."""
    for scalar in scalars_of(scene):
        for material in scene["materials"]:
            for name, table in ((scalar.capacity, scalar.capacity_table),
                                (scalar.one, scalar.one_table)):
                if table in material:
                    material[name] = material.pop(table)[0][1]
    return scene


def has_table(scene, name):
    """Has a material that table?"""
    return any(name in material for material in scene["materials"])


def without_input(scene, conditions=False):
    """The scene, whose scalars get no source and no given fluxes any more; also no conditions and
    surroundings where `conditions` is to go."""
    for given in scalars_of(scene).values():
        given.pop("source", None)
        if conditions:
            given.pop("conditions", None), given.pop("fluxes", None)
        elif "fluxes" in given:
            given["fluxes"] = [flux for flux in given["fluxes"] if "value" not in flux]
    return scene


OF_SCALARS = set().union(*(scalar.of_material for scalar in SCALARS.values()))
OF_STRENGTH = ("taylor_quinney", "softening_exponent", "reference_temperature",
               "melting_temperature")
OF_PASSAGES = ("heat", "conductance", "heat_gap")


def without_passages(scene):
    """The scene, whose surfaces let no heat through any more."""
    contact = scene.get("contact", {})
    for entry in [contact, *contact.get("pairs", []), *scene.get("cracks", [])]:
        for name in OF_PASSAGES:
            entry.pop(name, None)
    return scene


def without_heat_of_strength(material):
    """The material, whose strength has nothing to do with a temperature that is conducted any more."""
    if "specific_heat" not in material:
        for name in OF_STRENGTH:
            material.pop(name, None)


def without_scalars(scene):
    """The scene, which conducts nothing any more."""
    scene.pop("transport", None)
    for body in scene["bodies"]:
        for name in SCALARS:
            body.pop(name, None)
    for material in scene["materials"]:
        for name in OF_SCALARS:
            material.pop(name, None)
        without_heat_of_strength(material)
    return without_passages(scene)


# ------------------------------------------------------------------------- at rest
def still(scene):
    """The scene without motion and loads."""
    new = copy.deepcopy(scene)
    new.pop("loads", None)
    new["time"].pop("rest", None)
    for body in new["bodies"]:
        body.pop("velocity", None)
        if "rigid" in body:
            body["rigid"]["velocity"] = ["free" if part == "free" else 0
                                         for part in body["rigid"]["velocity"]]
    for boundary in new.get("boundary", []):
        if "velocity" in boundary:
            boundary["velocity"] = ["free" if part == "free" else 0
                                    for part in boundary["velocity"]]
    return new


def contact_at_rest(contact, deformable):
    """Contact of bodies that do not move: what says whether they touch."""
    laws = {"none": "none", "bonded": "bonded", "interface": "bonded"}
    keys = ("fields", "of", "normal", "direction", "detection", "touching", *OF_PASSAGES)

    def at_rest(entry):
        law = laws.get(entry.get("law", "none"), "stick")
        return {"law": law} | {name: entry[name] for name in keys if name in entry}

    made = at_rest(contact)
    pairs = [at_rest(pair) for pair in contact.get("pairs", [])
             if pair["of"][1] in deformable and pair["of"][0] in deformable]
    return made | ({"pairs": pairs} if pairs else {})


def alone(scene):
    """The scene without mechanics."""
    new = still(scene)
    for path in OF_MOTION:
        section, _, name = path.partition(".")
        if "[]" in section:
            for entry in new.get(section[:-2], []) if section == "cracks[]" else []:
                entry.pop(name, None)
        elif name:
            new.get(section, {}).pop(name, None)
        else:
            new.pop(section, None)
    for material in new["materials"]:
        for name in set(material) - {"name", "density"} - OF_SCALARS:
            del material[name]
        for scalar in SCALARS.values():
            material.pop(scalar.expansion, None), material.pop(scalar.stress_free, None)
        material["law"] = "none"
    new["transport"] = {scalar.name: given for scalar, given in scalars_of(new).items()}
    new["transport"].get("temperature", {}).pop("heating", None)
    rigid = [body["name"] for body in new["bodies"] if "rigid" in body]
    new["bodies"] = [body for body in new["bodies"] if "rigid" not in body]
    if "contact" in new:
        names = [entry["name"] for entry in new["materials"] + new["bodies"]]
        new["contact"] = contact_at_rest(new["contact"], set(names) - set(rigid))
    new["boundary"] = [boundary for boundary in new.get("boundary", []) if "symmetry" in boundary]
    if not new["boundary"]:
        del new["boundary"]
    return new


def groups_of(scene):
    """Names of bodies, in groups that share velocity fields, in the order of these, which is that of
    materials or bodies: all where there is no contact."""
    bodies = [body for body in scene["bodies"] if "rigid" not in body]
    contact = scene.get("contact")
    if contact is None:
        return [[body["name"] for body in bodies]]
    own = "name" if contact.get("fields") == "bodies" else "material"
    used = [body[own] for body in bodies]
    entries = scene["bodies"] if own == "name" else scene["materials"]
    fields = {entry["name"]: {entry["name"]} for entry in entries if entry["name"] in used}
    laws = {frozenset(pair["of"]): pair["law"] for pair in contact.get("pairs", [])}
    for one in list(fields):
        for other in list(fields):
            if one != other and laws.get(frozenset((one, other)), contact.get("law", "none")) == "none":
                fields[one] |= fields[other]
                for name in fields[one]:
                    fields[name] = fields[one]
    unique = {id(field): field for field in fields.values()}
    return [[body["name"] for body in bodies if body[own] in field] for field in unique.values()]
