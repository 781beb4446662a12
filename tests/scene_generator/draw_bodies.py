"""Draws grid, materials and bodies: functions (canvas, key) of the tables in meaning.py.

SPDX-License-Identifier: GPL-3.0-or-later
"""

from draw import ABSENT, short
from draw_contact import place_touching


# -------------------------------------------------------------------------- grid
def draw_cell(canvas, _):
    """Square cells of size 1 in most scenes."""
    if canvas.chance(30):
        return [canvas.pick([1, 0.5, 0.8, 2]), canvas.pick([1, 0.5, 1.25])]
    return [1, 1]


def draw_cells(canvas, _):
    """A grid in which a body has room to move; with a contour around a tip, a larger body."""
    if canvas.notes["fracture"]:
        return [15, 13]
    if canvas.situation == "pressed":
        return [canvas.integer(10, 12), canvas.integer(12, 14)]
    if canvas.notes["past"]:
        return [canvas.integer(12, 13), canvas.integer(12, 13)]
    return [canvas.integer(9, 13), canvas.integer(9, 13)]


def draw_origin(canvas, _):
    """Anywhere in planar scenes; in axisymmetry r = 0 is a node: the first one, within or not."""
    cell = canvas.notes["group"]["cell"]
    if canvas.axisymmetric:
        first = 0 if canvas.situation == "pressed" else canvas.pick([0, 0, 0, 3, -2])
        return [short(first * cell[0]), short(canvas.integer(0, 2) * cell[1])]
    return canvas.pick([[0, 0], [-3, 5], [0.7, -1.3]])


# ---------------------------------------------------------------------- materials
def draw_material_count(canvas):
    """One, or two for two bodies, or three for more."""
    return canvas.integer(1, min(3, canvas.notes["bodies"]))


def draw_name(canvas, _):
    """Distinct names: m0, m1."""
    return f"m{canvas.path[-1]}"


def draw_density(canvas, _):
    """1 in most scenes."""
    return canvas.pick([1, 1, 0.5, 4])


def draw_young(canvas, _):
    """One of both pairs of moduli must be given: this one in most scenes."""
    canvas.notes["by_bulk"] = canvas.chance(30)
    return ABSENT if canvas.notes["by_bulk"] else canvas.pick([1, 10, 3])


def draw_poisson(canvas, _):
    """Goes with Young's modulus."""
    return ABSENT if canvas.notes["by_bulk"] else canvas.pick([0.3, 0, 0.45, -0.2])


def draw_modulus(canvas, key):
    """Bulk and shear modulus replace the other pair, which laws without a bulk modulus do not have."""
    law = canvas.laws[canvas.notes["group"]["law"]]
    if key.name not in law:
        return ABSENT
    return canvas.pick([1, 2, 5]) if canvas.notes["by_bulk"] or "bulk" not in law else ABSENT


# ------------------------------------------------------------------------- bodies
SIDES = {"left": (0, False), "right": (0, True), "bottom": (1, False), "top": (1, True)}
PAST_ROOM = 4  # cells beyond a plane of symmetry that a crack passes


def draw_past_side(canvas):
    """The side of the body with a plane of symmetry that a crack passes: along z in axisymmetry, and
    not where a rigid body lies."""
    sides = ["right", "left", "top", "bottom"]
    return canvas.pick([side for side in sides[2 if canvas.axisymmetric else 0:]
                        if side != "bottom" or not canvas.notes["rigid"]])


def place_bodies(canvas):
    """Settles the boxes of all bodies, in cells of the refined grid counted from its first node."""
    grid, notes = canvas.scene["grid"], canvas.notes
    refine = grid.get("refine", 1)
    cells = [count * refine for count in grid["cells"]]
    axis = 0
    if canvas.axisymmetric:
        axis = round(-grid["origin"][0] / canvas.cell[0])
    pressed = canvas.situation == "pressed"
    low, high = [0, 0], [0, 0]
    for k in range(2):
        margin = 2 if not pressed else 1
        most = 0 if pressed or notes["fracture"] else refine
        low[k] = margin * refine + canvas.integer(0, most)
        high[k] = cells[k] - margin * refine - canvas.integer(0, most)
    if notes["fracture"]:
        low[0] = PAST_ROOM
    elif notes["past"]:
        notes["past"] = draw_past_side(canvas)
        normal, at_end = SIDES[notes["past"]]
        (high if at_end else low)[normal] = cells[normal] - PAST_ROOM if at_end else PAST_ROOM
    if canvas.axisymmetric and axis >= 0 and (pressed or canvas.chance(70)):
        low[0] = axis
    elif canvas.axisymmetric:
        low[0] = max(low[0], axis + 1)
    notes["axis"] = axis if canvas.axisymmetric else None
    boxes = [[low, high]]
    if notes["contact"]:
        boxes = place_touching(canvas, low, high, refine)
    elif notes["bodies"] == 2:
        middle = (low[1] + high[1]) // 2
        gap = canvas.integer(0, 1)
        boxes = [[low, [high[0], middle]], [[low[0], middle + gap], high]]
    notes["deformable"] = len(boxes)
    sizes = [min(box[1][k] - box[0][k] for k in range(2)) for box in boxes]
    notes["cut"] = sizes.index(max(sizes)) if notes["contact"] else 0  # what a crack is in
    if notes["rigid"]:
        boxes.append([[low[0], low[1] - 1], [high[0], low[1]]])
    if pressed:
        boxes.append([[low[0], low[1] - 1], [high[0] + 1, low[1]]])
        boxes.append([[low[0], high[1]], [high[0] + 1, high[1] + 1]])
    notes["boxes"] = boxes
    whole = [[min(box[0][k] for box in boxes) for k in range(2)],
             [max(box[1][k] for box in boxes) for k in range(2)]]
    notes["whole"] = whole
    notes["centre"] = place(canvas, [(boxes[0][0][k] + boxes[0][1][k]) / 2 for k in range(2)])


def place(canvas, point):
    """Coordinates of a point in cells of the refined grid."""
    origin = canvas.scene["grid"].get("origin", [0, 0])
    return [short(origin[k] + point[k] * canvas.cell[k]) for k in range(2)]


def draw_body_count(canvas):
    """All that have a box."""
    place_bodies(canvas)
    return len(canvas.notes["boxes"])


def is_rigid(canvas):
    """Is the body in hand rigid?"""
    return canvas.path[-1] >= canvas.notes["deformable"]


def draw_body_name(canvas, _):
    """Deformable bodies are b0, b1; rigid ones r0, r1."""
    position, deformable = canvas.path[-1], canvas.notes["deformable"]
    return f"r{position - deformable}" if is_rigid(canvas) else f"b{position}"


def draw_material(canvas, _):
    """A material's name."""
    if is_rigid(canvas):
        return ABSENT
    return canvas.pick([material["name"] for material in canvas.scene["materials"]])


def draw_rigid(canvas, key):
    """A rigid body drives at least one component, at up to a twentieth of the wave speed."""
    if not is_rigid(canvas):
        return ABSENT
    if canvas.situation == "pressed":
        upwards = canvas.path[-1] == canvas.notes["deformable"]
        speed = canvas.notes["press"] = canvas.notes.get("press") or canvas.pick([0.02, 0.015])
        rate = speed / 20 * canvas.scale("length/time^2") * (1 if upwards else -1)
        return {"velocity": ["free", f"{short(rate)}*t"]}
    unit = key.child("velocity").unit
    drives = [canvas.expression(unit, 0.05), canvas.expression(unit, 0.05)]
    free = 0 if canvas.notes["contact"] and canvas.chance(70) else canvas.integer(0, 2)
    return {"velocity": ["free" if free == k + 1 else drives[k] for k in range(2)]}


def draw_body_region(canvas, _):
    """A rectangle of whole cells in most scenes; else one that cuts cells, or another shape."""
    low, high = canvas.notes["boxes"][canvas.path[-1]]
    form = 0 if is_rigid(canvas) or canvas.notes["plain"] else canvas.integer(0, 5)
    centre = place(canvas, [(low[k] + high[k]) / 2 for k in range(2)])
    radius = min((high[k] - low[k]) / 2 * canvas.cell[k] for k in range(2))
    at_axis = canvas.notes["axis"] is not None and low[0] <= canvas.notes["axis"]
    if form in (0, 1):
        cut = [canvas.integer(0, 2) * 0.31 if form == 1 else 0 for _ in range(2)]
        return {"rectangle": {"from": place(canvas, low),
                              "to": place(canvas, [high[k] - cut[k] for k in range(2)])}}
    if form == 2:
        return {"disk": {"center": centre, "radius": short(0.97 * radius)}}
    if form == 3 and not at_axis:
        return {"annulus": {"center": centre, "inner": short(0.47 * radius),
                            "outer": short(0.97 * radius)}}
    corners = [[low[0], low[1]], [high[0], low[1]], [high[0] - canvas.integer(0, 3) - 0.137, high[1]]]
    if form == 5:
        corners.append([low[0], high[1]])
    return {"polygon": {"points": [place(canvas, corner) for corner in corners]}}


def draw_lattice(canvas, _):
    """1, 2 or 3 particles along an axis of a cell."""
    if canvas.situation == "pressed" or canvas.notes["fracture"] or canvas.notes.get("halves"):
        return [2, 2]
    if canvas.chance(40):
        return [canvas.integer(1, 3), canvas.integer(1, 3)]
    return [2, 2]


def spin_of(canvas):
    """The rate at which all bodies of the scene turn about one point; 0 in most."""
    notes = canvas.notes
    if "spin" not in notes:
        sizes = [(notes["whole"][1][k] - notes["whole"][0][k]) * canvas.cell[k] for k in range(2)]
        turns = notes["contact"] and not canvas.axisymmetric and canvas.chance(25)
        notes["spin"] = short(canvas.pick([0.1, -0.1, 0.4, -0.02]) *
                              canvas.scale("length/time") / max(sizes)) if turns else 0
    return notes["spin"]


def draw_body_velocity(canvas, key):
    """At rest, or a rigid motion with a stretch and a turn; on the axis none across it. Bodies that touch
    all turn about one point in some planar scenes. Some of metals are thrown at up to half the speed
    of waves."""
    if not is_rigid(canvas) and canvas.situation == "any" and spin_of(canvas):
        low, high = canvas.notes["whole"]
        x, y = place(canvas, [(low[k] + high[k]) / 2 for k in range(2)])
        return [f"({short(-spin_of(canvas))})*(y-({y}))", f"({spin_of(canvas)})*(x-({x}))"]
    if is_rigid(canvas) or canvas.situation != "any" or canvas.chance(25):
        return ABSENT
    speed = canvas.scale(key.unit)
    names = ["r", "z"] if canvas.axisymmetric else ["x", "y"]
    low, high = canvas.notes["boxes"][canvas.path[-1]]
    centre = canvas.notes["centre"]
    if canvas.notes["contact"]:  # bodies beside each other: its own
        centre = place(canvas, [(low[k] + high[k]) / 2 for k in range(2)])
    at_axis = canvas.axisymmetric and low[0] <= canvas.notes["axis"]
    components = []
    for k in range(2):
        half = max(1, (high[k] - low[k]) / 2) * canvas.cell[k]
        thrown = canvas.notes["plastic"] and canvas.chance(10)
        mean = canvas.pick([0.3, -0.3, -0.5] if thrown else [0, 0, 0.02, -0.1, 0.1])
        stretch = canvas.pick([0, 0.02, -0.05, 0.1, 0.2, -0.3])
        shear = canvas.pick([0, 0, 0.05, -0.1])
        if k == 0 and at_axis:
            components.append(f"{short(stretch * speed / half)}*r" if stretch else 0)
            continue
        terms = [str(short(mean * speed))] if mean else []
        if stretch:
            terms.append(f"({short(stretch * speed / half)})*({names[k]}-({centre[k]}))")
        if shear and not at_axis:
            terms.append(f"({short(shear * speed / half)})*({names[1 - k]}-({centre[1 - k]}))")
        components.append("+".join(terms) if len(terms) > 1 or stretch or shear and terms
                          else (short(mean * speed) if mean else 0))
    return components
