"""Draws boundaries and loads: functions (canvas, key) of the tables in meaning.py.

SPDX-License-Identifier: GPL-3.0-or-later
"""

from draw import ABSENT, short
from draw_bodies import SIDES, place


# ----------------------------------------------------------------------- boundary
def draw_boundaries(canvas, key):
    """Lines of nodes along sides of the bodies or the grid, held or moved or planes of symmetry;
    rectangles; all nodes."""
    if canvas.situation == "loaded":
        return ABSENT
    count = canvas.pick([0, 0, 0, 1, 1, 2, 3])
    if canvas.situation == "pressed":
        count = canvas.integer(0, 1)
    velocity = key.child("velocity")
    sides = ["left", "bottom", "right", "top"]
    canvas.notes["planes"] = []
    planes = []
    if canvas.notes["past"]:
        sides.remove(canvas.notes["past"])
        normal, at_end = SIDES[canvas.notes["past"]]
        planes = [draw_plane(canvas, normal, canvas.notes["whole"][at_end][normal])]
    made = [draw_boundary(canvas, velocity, sides) for _ in range(count)]
    return planes + [boundary for boundary in made if boundary is not None] or ABSENT


def last_nodes(canvas):
    """The last node of the grid along each axis, in cells of the refined grid."""
    grid = canvas.scene["grid"]
    return [count * grid.get("refine", 1) for count in grid["cells"]]


def nodes_across(canvas, normal, along):
    """Both ends of a line of nodes through the grid."""
    ends = [[0, 0], last_nodes(canvas)]
    ends[0][normal] = ends[1][normal] = along
    return ends


def draw_plane(canvas, normal, along):
    """A plane of symmetry."""
    canvas.notes["planes"].append((normal, along))
    return {"region": line(canvas, nodes_across(canvas, normal, along)), "symmetry": True}


def draw_boundary(canvas, velocity, sides):
    """One of them; each side is taken once. None where there can be none."""
    low, high = canvas.notes["whole"]
    last = last_nodes(canvas)
    axis = canvas.notes["axis"]
    pressed = canvas.situation == "pressed"
    side = "left" if pressed else canvas.pick(sides)
    sides.remove(side)
    normal, at_end = SIDES[side]
    along = (high if at_end else low)[normal]
    if pressed:
        along = low[0]
    elif canvas.chance(20):
        along = last[normal] if at_end else 0
    ends = nodes_across(canvas, normal, along)
    on_axis = axis is not None and side == "left" and along <= axis
    far = canvas.notes["contact"] and canvas.notes["cracked"]  # cracks must be far from planes
    still = canvas.notes["still"]  # no velocities
    if not pressed and not on_axis and (still or canvas.chance(25)) and not far:
        return draw_plane(canvas, normal, along)
    if still:
        return None
    form = 0 if pressed else canvas.integer(0, 6)
    held = canvas.integer(0, 2) if form != 0 else 0
    drives = ["free", "free"]
    for k in range(2):
        if k == normal or held == 1:
            drives[k] = 0 if held != 2 or on_axis and k == 0 else \
                canvas.expression(velocity.unit, 0.02)
    if form == 6:
        return {"region": {"all": True}, "velocity": ["free" if k == normal else 0 for k in range(2)]}
    if form == 5:
        inner = [list(ends[0]), list(ends[1])]
        inner[0][normal], inner[1][normal] = sorted(
            (along, along + (1 if along < last[normal] else -1)))
        return {"region": {"rectangle": {"from": place(canvas, inner[0]),
                                         "to": place(canvas, inner[1])}}, "velocity": drives}
    return {"region": line(canvas, ends), "velocity": drives}


def line(canvas, ends):
    """The region of a line between two nodes."""
    return {"line": {"from": place(canvas, ends[0]), "to": place(canvas, ends[1])}}


# -------------------------------------------------------------------------- loads
def draw_load_count(canvas):
    """None in most scenes."""
    if canvas.situation == "pressed" or canvas.situation == "loaded":
        return 0
    return canvas.pick([0, 0, 0, 1, 1, 2])


def draw_tractions(canvas, key):
    """The situation `loaded` pulls or presses at opposite faces alike: the body stays in place."""
    loads = []
    if canvas.situation == "loaded":
        size = canvas.pick([1, -1]) * short(1e-3 * canvas.scale(key.child("value").unit))
        ramp = short(0.125 / canvas.scale("time"))
        names = ["bottom", "top"]
        if not canvas.axisymmetric and canvas.chance(40):
            names = ["left", "right"]
        for sign, edge in zip((-1, 1), names):
            value = [0, f"{sign * size}*min(t*{ramp},1)"]
            loads.append({"body": "b0", "edge": edge, "value": value if names[0] == "bottom"
                          else value[::-1]})
        return loads
    for _ in range(draw_load_count(canvas)):
        loads.append(draw_load(canvas, key))
    return loads or ABSENT


def draw_load(canvas, key):
    """A load on a face of a deformable body, other than the axis."""
    body = canvas.integer(0, canvas.notes["deformable"] - 1)
    edges = key.child("edge").choices
    if canvas.axisymmetric:
        edges = [edge for edge in edges if edge not in ("left", "all")]
    unit = key.child("value").unit
    load = {"body": f"b{body}", "edge": canvas.pick(edges),
            "value": [canvas.expression(unit, 0.02), canvas.expression(unit, 0.02)]}
    if canvas.chance(40):
        load["frame"] = canvas.pick(key.child("frame").choices)
    return load


def draw_body_force(canvas, key):
    """A hundredth of the natural acceleration; none across a plane of symmetry."""
    if canvas.situation != "any" or not canvas.chance(30):
        return ABSENT
    force = [canvas.expression(key.unit, 0.01), canvas.expression(key.unit, 0.01)]
    for normal, _ in canvas.notes.get("planes", ()):
        force[normal] = 0
    return force


def draw_body_force_at(canvas, key):
    """Of a body force."""
    if "body_force" not in canvas.notes["group"] or not canvas.chance(50):
        return ABSENT
    return canvas.pick(key.choices)


def draw_particle_forces(canvas, key):
    """Rarer than tractions."""
    if canvas.situation != "any" or not canvas.chance(15):
        return ABSENT
    return [draw_load(canvas, key)]
