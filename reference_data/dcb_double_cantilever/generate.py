#!/usr/bin/env python3
# Runs CalculiX on all meshes and writes the tables of this folder. See SOURCE.md.
#
# SPDX-License-Identifier: GPL-3.0-or-later
import os
import sys
import tempfile

sys.dont_write_bytecode = True  # this folder holds what MANIFEST.sha256 lists, nothing else

from beam import ARM, CRACK, FORCE, LENGTH, POISSON, THICKNESS, THIN, YOUNG, Mesh, Result, deck
from bilinear import GAUSS, PARTICLES, opening as bilinear_opening, stresses as four_node

HERE = os.path.dirname(os.path.abspath(__file__))
STATES = ["plane_strain", "plane_stress"]
LINEAR = [(4, 1.0), (4, 0.5), (4, 0.25), (8, 1.0), (8, 0.5), (8, 0.25)]
LARGE = [(4, 1.0), (8, 0.5), (8, 0.25)]
FINEST = (8, 0.25)
CELL, PER_CELL = 1.0, 2  # grid and particles of the material point model
TIP_ZONES = [2.0, 5.0]   # not compared: |x - 50| up to here (the tip is singular)
INERTIA = THICKNESS * ARM ** 3 / 12
BENDING = FORCE * CRACK * (ARM / 2) / INERTIA  # stress at the root of the arm, the scale


def write(name, comments, header, rows):
    with open(os.path.join(HERE, name), "w") as out:
        for line in comments + ["Written by generate.py; see SOURCE.md."]:
            out.write("# " + line + "\n")
        out.write(",".join(header) + "\n")
        for row in rows:
            out.write(",".join(v if isinstance(v, str) else "%.7g" % v for v in row) + "\n")


def label(mesh, large=False):
    return "q%d_%.2fmm%s" % (mesh + ("_large" if large else "",))


def runs(folder, state):
    """{label: result} of one state; finite displacements need ccx's own plane stress."""
    found = {label(m): Result(folder, Mesh(m[1], m[0]), state) for m in LINEAR}
    thin = THIN if state == "plane_stress" else None
    for m in LARGE:
        found[label(m, True)] = Result(folder, Mesh(m[1], m[0]), state, solid=thin, large=True)
    return found


def steps(start, spacing, end):
    return [start + spacing * k for k in range(round((end - start) / spacing) + 1)]


def particles():
    """Where the material points lie at the start."""
    gap = CELL / PER_CELL
    return [(x, y) for y in steps(ARM + gap / 2, gap, 2 * ARM - gap / 2)
            for x in steps(gap / 2, gap, LENGTH - gap / 2)]


def seen_by_grid(result):
    """{x: sigma_xx} that nodes of the mid-plane get from particles by linear shape functions."""
    sums = {x: [0.0, 0.0] for x in steps(0.0, CELL, LENGTH)}
    for x, y in particles():
        if y - ARM < CELL:
            stress = result.at(x, y)[0]
            left = CELL * (x // CELL)
            for node in (left, left + CELL):
                share = (1 - abs(x - node) / CELL) * (1 - (y - ARM) / CELL)
                sums[node][0] += share * stress
                sums[node][1] += share
    return {x: total / weight for x, (total, weight) in sums.items()}


def tables(state, found):
    """Writes the stresses of one state; gives {what: {label: {place: sigma_xx}}}."""
    lines = {n: {x: r.at(x, ARM)[0] for x in steps(0.0, r.size, LENGTH)}
             for n, r in found.items()}
    grid = {n: seen_by_grid(r) for n, r in found.items() if "large" not in n}
    words = state.replace("_", " ")
    about = ["Double cantilever beam, %s: sigma_xx on y = 3 mm of the upper arm; " % words +
             "x in mm, stress in MPa."]
    columns = list(lines)
    write("midplane_%s.csv" % state, about, ["x"] + columns,
          [[x] + [lines[n][x] for n in columns] for x in steps(0.0, 1.0, LENGTH)])
    fine = [label(m, large) for m, large in ((FINEST, False), (FINEST, True))]
    near = [x for x in steps(0.0, FINEST[1], LENGTH) if abs(x - CRACK) <= 10]
    write("midplane_tip_%s.csv" % state, about, ["x"] + fine,
          [[x] + [lines[n][x] for n in fine] for x in near])
    columns = list(grid)
    write("grid_%s.csv" % state,
          about + ["As nodes of a 1 mm grid see it: mean over the particles (4 in a cell) " +
                   "by linear shape functions."], ["x"] + columns,
          [[x] + [grid[n][x] for n in columns] for x in steps(0.0, CELL, LENGTH)])
    write("particles_%s.csv" % state,
          ["Double cantilever beam, %s: Cauchy stress at points of the upper arm; " % words +
           "x and y before deformation in mm, stress in MPa; mesh %s." % fine[0],
           "Small strains, then finite displacements (large_)."],
          ["x", "y", "xx", "yy", "xy", "large_xx", "large_yy", "large_xy"],
          [[x, y] + [v for n in fine for v in found[n].at(x, y)] for x, y in particles()])
    write("four_node_%s.csv" % state,
          ["Double cantilever beam, %s: sigma_xx in MPa at the same points, small strains, of " %
           words + "four-node elements of 1 mm", "(bilinear.py) integrated at 2 x 2 Gauss points " +
           "and at the 2 x 2 particles of a cell; rise of their loaded end: %.7g and %.7g mm."
           % tuple(bilinear_opening(CELL, state, p) for p in (GAUSS, PARTICLES))],
          ["x", "y", "gauss", "particles"],
          [[*p, *both] for p, *both in
           zip(particles(), *(four_node(CELL, state, particles(), q) for q in (GAUSS, PARTICLES)))])
    points = {n: {p: r.at(*p)[0] for p in particles()} for n, r in found.items()}
    return {"midplane": lines, "grid": grid, "particles": points}


def differences(state, stresses):
    """Largest difference of sigma_xx from the finest mesh outside the zones at the tip."""
    for what, columns in stresses.items():
        for name, values in columns.items():
            best = columns[label(FINEST, name.endswith("large"))]
            along = {p: p if isinstance(p, float) else p[0] for p in values if p in best}
            for zone in TIP_ZONES if values is not best else []:
                apart, x = max((abs(values[p] - best[p]), x) for p, x in along.items()
                               if abs(x - CRACK) > zone)
                yield [state, what, name, zone, apart, 100 * apart / BENDING, x]


def theories(state):
    """Openings of one arm by beam theory: {name: mm}."""
    modulus = YOUNG / (1 - POISSON ** 2) if state == "plane_strain" else YOUNG
    bending = FORCE / (3 * modulus * INERTIA)
    shear = 1.2 * FORCE * CRACK * 2 * (1 + POISSON) / (YOUNG * ARM * THICKNESS)
    reach = ARM / 6 ** 0.25
    foundation = CRACK ** 3 + 3 * CRACK ** 2 * reach + 3 * CRACK * reach ** 2 + 1.5 * reach ** 3
    return {"clamped_beam": bending * CRACK ** 3 + shear,
            "elastic_foundation": bending * foundation + shear,
            "rotated_root": bending * (CRACK + 0.673 * ARM) ** 3}


def openings(folder, state, found):
    theory = theories(state)
    exact = theory["rotated_root"]
    rows = [(n, r.opening, r.corner) for n, r in found.items()]
    fine, middle = found[label(FINEST)].opening, found[label((8, 0.5))].opening
    rows.append(("q8_extrapolated", 2 * fine - middle, 2 * fine - middle))
    rows += [(n, value, value) for n, value in theory.items()]
    for size in (1.0, 0.5, 0.25):
        value = bilinear_opening(size, state)
        rows.append(("plain_q4_%.2fmm" % size, value, value))
    if state == "plane_stress":
        for thickness in (THICKNESS, THIN):
            r = Result(folder, Mesh(FINEST[1], FINEST[0]), state, solid=thickness)
            rows.append(("cps8_0.25mm_%gmm_thick" % thickness, r.opening, r.corner))
            print(rows[-1][0], "sigma_xx at x = 25:", r.at(25.0, ARM)[0])
    return [[state, n, mean, corner, 100 * (mean / exact - 1)] for n, mean, corner in rows]


def main():
    apart, opened = [], []
    with tempfile.TemporaryDirectory() as folder:
        for state in STATES:
            found = runs(folder, state)
            apart += differences(state, tables(state, found))
            opened += openings(folder, state, found)
    write("differences.csv",
          ["Largest difference of sigma_xx (MPa) from q8_0.25mm, or q8_0.25mm_large, at common " +
           "points further than `beyond` (mm) in x from the tip;",
           "in per cent of the bending stress P a (h/2) / I = %.6g MPa; and the x (mm) where."
           % BENDING], ["state", "where", "mesh", "beyond", "difference", "percent", "x"], apart)
    write("opening.csv",
          ["Rise of the loaded end of the upper arm in mm: mean over its face (weighted as the " +
           "load is), and at the crack's face;",
           "per cent by which the mean differs from rotated_root."],
          ["state", "solution", "mean", "corner", "percent"], opened)
    with open(os.path.join(HERE, "arm_q4_1mm_plane_strain.inp"), "w") as out:
        out.write(deck(Mesh(1.0, 4), "plane_strain"))


if __name__ == "__main__":
    main()
