"""Draws contact between bodies: the function (canvas, key) of the table in meaning.py, and where the
bodies are.

SPDX-License-Identifier: GPL-3.0-or-later
"""

from draw import ABSENT, short
from draw_passages import draw_gap, draw_heat_between

HOLDS = ("stick", "frictionless", "friction")  # laws with detection and adhesion
SMALLEST = 2  # cells that a body keeps along each axis


# ------------------------------------------------------------------- where bodies are
def split_box(canvas, boxes, refine):
    """Divides the largest box, along either axis where it is long enough, by a gap of none, half a
    cell, a cell, or more than that. Bodies with gaps below two or three cells share nodes."""
    sizes = [(box[1][0] - box[0][0]) * (box[1][1] - box[0][1]) for box in boxes]
    low, high = boxes.pop(sizes.index(max(sizes)))
    gap = canvas.pick([0, 0.5, 0, 1, 2])
    room = [high[k] - low[k] - gap - 2 * SMALLEST * refine for k in range(2)]
    axis = canvas.integer(0, 1)
    if room[axis] < 0:
        axis = 1 - axis
    if room[axis] < 0:
        boxes.append([low, high])
        return
    middle = low[axis] + SMALLEST * refine + canvas.integer(0, int(room[axis]))
    ends, begins = list(high), list(low)
    ends[axis], begins[axis] = middle, middle + gap
    canvas.notes["halves"] = canvas.notes.get("halves") or gap == 0.5
    boxes += [[low, ends], [begins, high]]


def place_touching(canvas, low, high, refine):
    """Boxes of two to five bodies in the box between two corners: beside each other, on top of each
    other, three that meet in a T, four that meet in a corner."""
    boxes = [[low, high]]
    for _ in range(canvas.notes["bodies"] - 1):
        split_box(canvas, boxes, refine)
    return boxes


# ------------------------------------------------------------------------------- laws
def draw_law(canvas, key, law):
    """The keys that the law takes, but for normal and detection; `key` is contact, or its pairs."""
    def size(name):
        return canvas.scale(key.child(name).unit)
    entry = {}
    if law == "friction":
        entry["friction"] = canvas.pick([0.3, 0, 1])
        if canvas.chance(50):
            entry["static_friction"] = short(entry["friction"] + canvas.pick([0.2, 0, 1]))
    if law in HOLDS and not canvas.notes["still"] and canvas.chance(25):
        entry["adhesion"] = short(canvas.pick([0.01, 0.001, 0.1]) * size("adhesion"))
    if law == "interface":
        for name in ("tension", "compression", "shear"):
            if name != "compression" or canvas.chance(50):
                entry[name] = short(canvas.pick([0.1, 1, 0.01, 0, 100]) * size(name))
    return entry


def allow_ratio(entry, usual):
    """An interface whose stiffnesses differ by more than a factor of 10, with such a normal."""
    across, along = max(entry.get("tension", 0), entry.get("compression", 0)), entry.get("shear", 0)
    normal = entry.get("normal", usual.get("normal", "larger"))
    if along * across > 0 and normal not in ("logistic", "given") and not 0.1 < along / across < 10:
        entry["ratio_limit"] = short(1.01 * max(along / across, across / along))


def draw_pair(canvas, key, law, usual, rigid=False):
    """A pair with its law, or contact itself, of which all pairs have what they do not give: `usual`."""
    entry = {"law": law, **draw_law(canvas, key, law)}
    heat = canvas.notes["heat"] and canvas.chance(60) and not rigid and law != "none"
    if canvas.chance(60 if usual else 70):
        normals = [name for name in key.child("normal").choices if usual or name != "given"]
        given = law == "interface" and "given" in normals and canvas.chance(30)
        entry["normal"] = "given" if given else canvas.pick(normals)
    if entry.get("normal") == "given":
        entry["direction"] = canvas.pick([[0, 1], [1, 0], [0, -2], [-1, 0], [0.6, 0.8], [1, -3]])
    if canvas.chance(50):
        entry["detection"] = canvas.pick(key.child("detection").choices)
    detection = entry.get("detection", usual.get("detection"))
    if law in HOLDS and detection == "volume" and canvas.chance(40):
        entry["touching"] = canvas.pick([0.9, 0.75, 1.2])
    allow_ratio(entry, usual)
    if heat and usual:
        entry |= draw_heat_between(canvas, key)
        entry |= draw_gap(canvas, key, entry, usual)
    return entry


def draw_usual_heat(canvas, key, contact, pairs, all_listed):
    """Of contact itself, where a pair of deformable bodies has none of its own."""
    law = contact.get("law", "none")
    used = [{"law": law}] if not all_listed and law != "none" else []
    used += [pair for pair in pairs if "heat" not in pair and pair["of"][1][0] != "r"]
    if not canvas.notes["heat"] or not used or not canvas.chance(70):
        return {}
    entry = draw_heat_between(canvas, key)
    for pair in used:
        gap = draw_gap(canvas, key, pair | {"heat": entry["heat"]}, contact)
        if gap:
            return entry | gap
    return entry


def groups_of(canvas, by_body):
    """What has a velocity field: the names of bodies, or of the materials that bodies have."""
    bodies = [body for body in canvas.scene["bodies"] if "rigid" not in body]
    if by_body:
        return [body["name"] for body in bodies]
    used = {body["material"] for body in bodies}
    return [material["name"] for material in canvas.scene["materials"]
            if material["name"] in used]


def draw_contact(canvas, key):
    """Fields, a law for each pair of them, and of rigid bodies that could have one. Groups without a law
    between them share a field, and both have the laws of that with others."""
    if not canvas.notes["contact"]:
        return ABSENT
    by_body = canvas.chance(40) or len(groups_of(canvas, False)) < 2
    groups = groups_of(canvas, by_body)
    fields = list(range(len(groups)))
    if len(groups) > 2 and canvas.chance(25):
        fields[-1] = canvas.integer(0, len(groups) - 2)
    entry = key.child("pairs")
    laws = [law for law in entry.child("law").choices if law != "none"]
    if canvas.notes["still"]:
        laws = [law for law in laws if law in ("bonded", "stick")]
    usual = draw_pair(canvas, key, canvas.pick(["none", *laws]), {})
    contact = {"fields": "bodies"} if by_body else \
        {"fields": "materials"} if canvas.chance(50) else {}
    contact |= usual if usual["law"] != "none" or canvas.chance(50) else \
        {name: value for name, value in usual.items() if name != "law"}
    pairs = [*pairs_of_fields(canvas, entry, groups, fields, (laws, usual)),
             *pairs_of_rigid(canvas, entry, groups, fields, (laws, usual))]
    if pairs:
        contact["pairs"] = pairs
    listed = sum(pair["of"][1][0] != "r" for pair in pairs)
    contact |= draw_usual_heat(canvas, key, contact, pairs,
                               listed == len(groups) * (len(groups) - 1) // 2)
    return {child.name: contact[child.name] for child in key.children if child.name in contact}


def pairs_of_fields(canvas, key, groups, fields, given):
    """A law for each pair of deformable fields: that of contact for some, if there is one."""
    laws, usual = given
    made, pairs = {}, []
    for other in range(len(groups)):
        for one in range(other):
            ends = (min(fields[one], fields[other]), max(fields[one], fields[other]))
            if ends[0] == ends[1]:
                law = {"law": "none"} if usual["law"] != "none" else None
            else:
                if ends not in made:
                    left_out = usual["law"] != "none" and canvas.chance(40)
                    made[ends] = None if left_out else \
                        draw_pair(canvas, key, canvas.pick(laws), usual)
                law = made[ends]
            if law is not None:
                pairs.append(with_names(law, groups[one], groups[other],
                                        fields[one] > fields[other]))
    return pairs


def pairs_of_rigid(canvas, key, groups, fields, given):
    """Laws of rigid bodies that have both components of their velocity, with some of the fields or
    all: those without one are driven. A rigid body has no displacement for an interface."""
    laws, usual = given
    laws = [law for law in laws if law != "interface"]
    pairs = []
    for body in canvas.scene["bodies"]:
        if "rigid" not in body or "free" in body["rigid"]["velocity"]:
            continue
        made = {field: draw_pair(canvas, key, canvas.pick(laws), usual, rigid=True) if canvas.chance(80)
                else None for field in sorted(set(fields))}
        pairs += [with_names(made[field], group, body["name"], False)
                  for group, field in zip(groups, fields) if made[field] is not None]
    return pairs


def with_names(law, one, other, turned):
    """The pair of two groups; `turned`: their fields have the other order."""
    entry = {"of": [one, other], **law}
    if turned and "direction" in entry:
        entry["direction"] = [-part for part in entry["direction"]]
    return entry
