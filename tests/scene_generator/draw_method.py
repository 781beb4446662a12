"""Draws method, damping, time and output: functions (canvas, key) of the tables in meaning.py.

SPDX-License-Identifier: GPL-3.0-or-later
"""

from draw import ABSENT, draw_value, short


# ------------------------------------------------------------------------- method
def draw_axis_nodes(canvas, key):
    """Only with axis: planar and functions with domains."""
    method = canvas.notes["group"]
    if method.get("axis") != "planar" or method.get("shape", "ugimp") not in ("ugimp", "cpdi"):
        return ABSENT
    return canvas.pick(key.choices) if canvas.chance(60) else ABSENT


def draw_extrapolate(canvas, _):
    """Free with usavg alone."""
    if canvas.notes["group"].get("stress_update") != "usavg" or not canvas.chance(30):
        return ABSENT
    return canvas.pick([True, False])


def draw_radius_update(canvas, key):
    """hoop goes with axis: truncated."""
    if canvas.notes["group"].get("axis", "truncated") != "truncated" or not canvas.chance(30):
        return ABSENT
    return canvas.pick(key.choices)


def draw_always(canvas, key):
    """Drawn in every scene: what the method is made of."""
    return canvas.pick(key.choices)


def draw_form(canvas, key):
    """One scene in three has it."""
    if not canvas.chance(30):
        return ABSENT
    return canvas.pick(key.choices)


def draw_transfer(canvas, key):
    """Those that the form goes with."""
    kinds = key.child("kind").choices
    if canvas.notes["group"].get("form") == "momentum":
        kinds = [kind for kind in kinds if kind in ("flip", "pic")]
    if not canvas.chance(60):
        return ABSENT
    kind = canvas.pick(kinds)
    if kind == "flip" and canvas.situation != "loaded" and canvas.chance(70):
        canvas.notes["fraction"] = True
        return {"kind": kind, "fraction": canvas.pick([0.9, 0.5, 1])}
    if kind in ("xpic", "fmpm"):
        canvas.notes["transfer"] = kind
        return {"kind": kind, "order": canvas.integer(1, 4)}
    canvas.notes["transfer"] = kind
    return {"kind": kind}


def draw_crack_method(canvas, key):
    """Goes with cracks; openings are tracked with fields only, and apic has all nodes."""
    cracks = canvas.scene.get("cracks", [])
    followed = any("opening" in crack or "cohesive" in crack or "j_integral" in crack
                   for crack in cracks)
    if not cracks or followed or "transport" in canvas.scene or canvas.notes.get("transfer") == "apic" or canvas.situation != "any" or not canvas.chance(30):
        return ABSENT
    return canvas.pick(key.choices)


# ------------------------------------------------------------------------ damping
def draw_grid_damping(canvas, key):
    """Up to a twentieth of the inverse time of a wave through a cell; a square of a coordinate's distance
    from the middle has that two cells away."""
    if canvas.situation == "pressed":
        return short(0.2 * canvas.scale(key.unit))
    if canvas.situation == "loaded":
        return short(canvas.pick([0.3, 0.15]) * canvas.scale(key.unit))
    if not canvas.chance(20):
        return ABSENT
    rate = canvas.pick([0.02, 0.05]) * canvas.scale(key.unit)
    if canvas.chance(50):
        return short(rate)
    axis = canvas.integer(0, 1)
    name = ("rz" if canvas.axisymmetric else "xy")[axis]
    centre = short(canvas.notes["centre"][axis])
    return f"{short(rate / canvas.cell[axis] ** 2 / 4)}*(({name}-({centre}))*({name}-({centre})))"


def draw_grid_form(canvas, key):
    """Of a rate of the grid, which particles can take with these transfers."""
    method = canvas.scene.get("method", {})
    if "grid" not in canvas.notes["group"] or method.get("radius_update") == "hoop" or \
            method.get("transfer", {"kind": "flip"})["kind"] in ("fmpm", "apic") or \
            not canvas.chance(60):
        return ABSENT
    return canvas.pick(key.choices)


def draw_particle_damping(canvas, key):
    """The same at the particles."""
    if canvas.situation != "any" or not canvas.chance(20):
        return ABSENT
    return short(canvas.pick([0.02, 0.05]) * canvas.scale(key.unit))


def draw_pic_damping(canvas, _):
    """Only with flip of fraction 1."""
    method = canvas.scene.get("method", {})
    flip = method.get("transfer", {"kind": "flip"})
    plain = flip["kind"] == "flip" and flip.get("fraction", 1) == 1
    if not plain or canvas.situation == "pressed" or not canvas.chance(
            50 if canvas.situation == "loaded" else 15):
        return ABSENT
    return canvas.pick([0.1, 0.5, 0.9])


def draw_thermostat(canvas, key):
    """Rare."""
    if canvas.situation != "any" or not canvas.chance(5):
        return ABSENT
    thermostat = {"gain": short(0.01 * canvas.scale(key.child("gain").unit)),
                  "scale": short(canvas.scale(key.child("scale").unit))}
    if canvas.chance(50):
        thermostat["target"] = short(0.01 * canvas.scale(key.child("target").unit))
    return thermostat


# -------------------------------------------------------------------- time, output
def draw_time(canvas, key):
    """Stops after a number of steps; its end is far beyond."""
    wave = canvas.scale("time")
    time = {"end": short(1e6 * wave)}
    if canvas.situation == "pressed":
        time = {"end": short(40 * wave), "courant": 0.4, "steps": 400}
    elif canvas.situation == "loaded":
        time.update(courant=canvas.pick([0.4, 0.8]), steps=canvas.pick([400, 800]))
    else:
        steps = canvas.pick([10, 5, 20, 20, 60])
        if any(material["law"] == "ideal_gas" for material in canvas.scene["materials"]):
            steps = min(steps, 10)  # it leaves the grid soon
        if canvas.chance(20):
            bound = 1 / max(canvas.wave / min(canvas.cell), 2 * canvas.conduction_rate)
            time.update(step=short(canvas.pick([0.2, 0.4]) * bound), steps=steps)
        else:
            time.update(courant=canvas.pick([0.4, 0.1, 0.5, 0.8, 1]), steps=steps)
        if canvas.chance(4) and not canvas.notes["still"]:
            rest = {"residual": 0.5, "kinetic_energy": 0.5, "steps": canvas.integer(1, 3),
                    "after": short(wave)}
            for child in key.child("rest").children:
                if child.name not in rest and canvas.chance(50):
                    rest[child.name] = draw_value(canvas, child, ())
            time["rest"] = rest
    return {name: time[name] for name in (child.name for child in key.children) if name in time}


def draw_history(canvas, _):
    """A row for every step."""
    return short(1e-6 * canvas.scale("time"))
