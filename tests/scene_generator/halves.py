"""Invariant: half a model with a plane of symmetry against the whole one. As in balance.py.

SPDX-License-Identifier: GPL-3.0-or-later
"""

import copy
import re

import numpy

import compare
from case import Case, require
from images import agrees
from scalars import scalars_of
from scales import SCALARS
from transform import Motion, names_of


class Fold:
    """A plane of symmetry of a scene, and what becomes of its parts where the other half is added.
    Expressions take |x - p| for x - p, and the component across the plane the sign of that."""

    def __init__(self, scene, axis, place, inward):
        self.scene, self.axis, self.place, self.inward = scene, axis, place, inward
        self.name = names_of(scene)[axis]

    def expression(self, text, across=False):
        """A number or expression, of a component across the plane or not."""
        if text == "free" or not across and not isinstance(text, str) or text == 0:
            return text
        away = f"({self.name}-({self.place!r}))"
        if isinstance(text, str):
            text = re.sub(rf"\b{self.name}\b(?!\()",
                          f"({self.place!r}+({self.inward})*abs{away})", text)
        return f"({text})*({self.inward})*sign{away}" if across else text

    def components(self, pair):
        """A pair of them."""
        return [self.expression(part, k == self.axis) for k, part in enumerate(pair)]

    def point(self, point):
        """The image of a point."""
        image = list(point)
        image[self.axis] = 2 * self.place - point[self.axis]
        return image

    def box(self, box):
        """What a box, or a line, becomes: itself with its image where both meet, else two; none where
        it is beyond the plane."""
        ends = [list(box["from"]), list(box["to"])]
        low, high = sorted(self.inward * (end[self.axis] - self.place) for end in ends)
        slack = 1e-9 * max(abs(self.place), abs(high), 1)
        if high < -slack:
            return []
        if low > slack:
            return [box, sorted_box(self.point(ends[0]), self.point(ends[1]))]
        far = self.place + self.inward * max(high, 0.0)
        for end, value in zip(ends, (far, 2 * self.place - far)):
            end[self.axis] = value
        return [sorted_box(*ends)]

    def region(self, region):
        """The same of a body's region, or a boundary's."""
        if "all" in region:
            return [region]
        (kind, shape), = region.items()
        if kind in ("rectangle", "line"):
            return [{kind: box} for box in self.box(shape)]
        image = dict(shape, points=[self.point(point) for point in shape["points"]]) \
            if kind == "polygon" else dict(shape, center=self.point(shape["center"]))
        return [region, {kind: image}]


def sorted_box(one, other):
    """The box between two corners."""
    return {"from": [min(pair) for pair in zip(one, other)],
            "to": [max(pair) for pair in zip(one, other)]}


def fold_of(case):
    """The plane of symmetry of a scene to unfold, along z in axisymmetry, and its index; None without."""
    middle = case.plain.start.position.mean(axis=0)
    grid = case.scene["grid"]
    for index, boundary in enumerate(case.scene.get("boundary", [])):
        line = boundary["region"].get("line")
        if not boundary.get("symmetry") or line is None:
            continue
        axis = 0 if line["from"][0] == line["to"][0] else 1
        place = line["from"][axis]
        cells = (place - grid.get("origin", [0, 0])[axis]) / grid["cell"][axis]
        if not (case.axisymmetric and axis == 0) and abs(cells - round(cells)) < 1e-9:
            inward = 1 if middle[axis] > place else -1
            return Fold(case.scene, axis, place, inward), index, round(cells)
    return None


def halved(case):
    """The brief scene with a plane of symmetry through the lowest sides of its bodies, across x, or z
    in axisymmetry, if they are rectangles: half of a model, though it is drawn as a whole."""
    axis = 1 if case.axisymmetric else 0
    scene, grid = case.brief, case.scene["grid"]
    boxes = [body["region"].get("rectangle") for body in scene["bodies"]]
    if None in boxes or any(boundary.get("symmetry") for boundary in scene.get("boundary", [])):
        return None
    first = grid.get("origin", [0, 0])
    line = {"from": list(first), "to": [start + side * count for start, side, count in
                                        zip(first, grid["cell"], grid["cells"])]}
    line["from"][axis] = line["to"][axis] = min(box["from"][axis] for box in boxes)
    scene["boundary"] = [*scene.get("boundary", []), {"region": {"line": line}, "symmetry": True}]
    return Case(case.runner, case.schema, scene)


def with_images(fold, entries, move):
    """Bodies or boundaries, moved, with their images; and the names of those, by the old ones."""
    whole, images = [], {}
    for entry in entries:
        for count, region in enumerate(fold.region(entry["region"])):
            whole.append(move(fold, dict(entry, region=region)))
            if count and "name" in entry:
                images[entry["name"]] = whole[-1]["name"] = entry["name"] + " image"
    return whole, images


def moving(fold, entry):
    """The body or boundary with the velocity and scalars of the whole model."""
    if "rigid" in entry:
        return dict(entry, rigid=moving(fold, entry["rigid"]))
    entry = heated(fold, entry)
    if "velocity" in entry:
        return dict(entry, velocity=fold.components(entry["velocity"]))
    return entry


def heated(fold, entry):
    """A body, a condition or a flux with its scalars and fluxes on both sides."""
    entry = dict(entry)
    for name in (*SCALARS, "value", "ambient", "start", "source"):
        if name in entry:
            entry[name] = fold.expression(entry[name])
    return entry


def given_with_images(fold, given, images):
    """Conduction of a scalar in the whole model; edges are those of faces that the plane cuts."""
    given = heated(fold, given)
    given["conditions"], _ = with_images(fold, given.get("conditions", []), heated)
    fluxes = [heated(fold, flux) | {kind: heated(fold, flux[kind])
                                    for kind in ("convection", "radiation") if kind in flux}
              for flux in given.get("fluxes", [])]
    given["fluxes"] = fluxes + [dict(flux, body=images[flux["body"]]) for flux in fluxes
                                if flux["body"] in images]
    return given


def contact_with_images(contact, images, rigid):
    """Contact of the whole model: images have the laws of what they are images of, and a body shares its
    field with its image. A pair that is not listed has the law of contact, images or not."""
    pairs = []
    for pair in contact.get("pairs", []):
        names = [[name, images[name]] if name in images else [name] for name in pair["of"]]
        pairs += [dict(pair, of=[one, other]) for one in names[0] for other in names[1]]
    if contact.get("fields") == "bodies":
        pairs += [{"of": [name, image], "law": "none"} for name, image in images.items()
                  if name not in rigid]
    return dict(contact, pairs=pairs) if pairs else contact


def unfolded(fold, index, cells):
    """The whole model of the scene, half of it being inside of the plane, boundary `index`, which is
    so many cells from the grid's first node."""
    scene = copy.deepcopy(fold.scene)
    grid, axis = scene["grid"], fold.axis
    inside = grid["cells"][axis] - cells if fold.inward > 0 else cells
    grid["origin"] = list(grid.get("origin", [0, 0]))
    grid["origin"][axis] = fold.place - inside * grid["cell"][axis]
    grid["cells"][axis] = 2 * inside
    del scene["boundary"][index]
    scene["boundary"], _ = with_images(fold, scene["boundary"], moving)
    if not scene["boundary"]:
        del scene["boundary"]
    rigid = [body["name"] for body in scene["bodies"] if "rigid" in body]
    scene["bodies"], images = with_images(fold, scene["bodies"], moving)
    if "contact" in scene:
        scene["contact"] = contact_with_images(scene["contact"], images, rigid)
    if "body_force" in scene.get("loads", {}):
        scene["loads"]["body_force"] = fold.components(scene["loads"]["body_force"])
    if "transport" in scene:
        scene["transport"] |= {scalar.name: given_with_images(fold, given, images)
                               for scalar, given in scalars_of(scene).items()}
    for name, rate in scene.get("damping", {}).items():
        if name in ("grid", "particle"):
            scene["damping"][name] = fold.expression(rate)
    for name in ("target", "scale"):
        if name in scene.get("damping", {}).get("thermostat", {}):
            scene["damping"]["thermostat"][name] *= 2
    return scene


def is_foldable(case, axis):
    """No loads on faces, which may have no other half in the same entry, nor fluxes but through faces that
    the plane cuts; no cracks; no normal given across the plane, which would have to be another one
    beyond it, nor axes of conduction that are oblique to it; no rigid body that moves across it, which is
    not half of one."""
    given = [pair["direction"][axis] for pair in case.scene.get("contact", {}).get("pairs", [])
             if "direction" in pair]
    moving_across = any("rigid" in body and body["rigid"]["velocity"][axis] not in (0, "free")
                        for body in case.scene["bodies"])
    cut = (("bottom", "top"), ("left", "right"))[axis]
    oblique = any(material.get(scalar.angle, 0) % 90 for scalar in case.scalars
                  for material in case.scene["materials"])
    if oblique or any(flux["edge"] not in cut for flux in case.fluxes):
        return False
    return not case.cracks and not set(case.loads) & {"tractions", "particle_forces"} and \
        not any(given) and not moving_across


def half_is_the_whole(case):
    """The answer to half a model with a plane of symmetry is that to the whole one, in which bodies that
    touch the plane go on beyond it and others have an image; energies are half of those."""
    if case.plain.status != 0:
        return False
    found = fold_of(case)
    if found is None and halved(case) is not None:
        case = halved(case)
        found = fold_of(case) if case.plain.status == 0 else None
    if found is None or not is_foldable(case, found[0].axis):
        return False
    fold, index, cells = found
    fold.scene = case.brief
    other = case.runner.run(unfolded(fold, index, cells))
    if other.status == 2:
        return False  # more fields than there may be
    require(other.status == 0, f"the whole model: exit {other.status}: {other.message}")
    here, there = case.plain.start.position, other.start.position
    away = numpy.abs(here[:, None, :] - there[None, :, :]).max(axis=2)
    require(len(there) == 2 * len(here) and away.min(axis=1).max() <= 1e-6 * min(case.cell),
            "the whole model: other particles at t = 0")
    order = away.argmin(axis=1)
    sums = [name for scalar in case.scalars for name in (scalar.content, *scalar.flows)]
    for name in (*compare.NUMBERS, *compare.COUPLED, *sums):
        if name in other.history:
            other.history[name] = other.history[name] / 2
    return agrees(case, other, order, Motion(), "the whole model")
