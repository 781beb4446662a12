# The double cantilever beam of CRAMP 3.1 as a CalculiX deck, and the reading of its results.
# Upper half only: the mid-plane ahead of the crack is held by symmetry. Units: mm, N, MPa.
# Each node lies at (x, y) with y from 3 (mid-plane) to 6.
#
# SPDX-License-Identifier: GPL-3.0-or-later
import os
import subprocess

LENGTH, ARM, CRACK, THICKNESS = 100.0, 3.0, 50.0, 1.0
YOUNG, POISSON, FORCE = 0.1, 0.33, 4e-5
THIN = 0.01  # thickness at which CalculiX's own plane-stress elements are plane (SOURCE.md)


def constants(state):
    """E and nu whose plane strain is `state`: same moduli in the plane, so the same matrices."""
    if state == "plane_strain":
        return YOUNG, POISSON
    return YOUNG * (1 + 2 * POISSON) / (1 + POISSON) ** 2, POISSON / (1 + POISSON)


class Mesh:
    """Square elements of `nodes` (4 or 8) nodes on a grid of spacing `size` over the arm."""

    def __init__(self, size, nodes):
        self.size, self.nodes = size, nodes
        self.step = 1 if nodes == 4 else 2  # node spacings along an element's edge
        self.columns = self.step * round(LENGTH / size)
        self.rows = self.step * round(ARM / size)

    def number(self, i, j):
        return 1 + j * (self.columns + 1) + i

    def holds(self, i, j):
        """Eight-node elements have no node at their centre."""
        return self.step == 1 or i % 2 == 0 or j % 2 == 0

    def place(self, i, j):
        return i * self.size / self.step, j * self.size / self.step + ARM

    def points(self):
        return [(i, j) for j in range(self.rows + 1) for i in range(self.columns + 1)
                if self.holds(i, j)]

    def elements(self):
        s = self.step
        corners = [(0, 0), (s, 0), (s, s), (0, s)]
        middles = [] if s == 1 else [(1, 0), (2, 1), (1, 2), (0, 1)]
        return [[self.number(i + a, j + b) for a, b in corners + middles]
                for j in range(0, self.rows, s) for i in range(0, self.columns, s)]

    def end_weights(self):
        """Shares of an even traction on the face x = 0 that its nodes carry (they sum to 1)."""
        edge = [0.5, 0.5] if self.step == 1 else [1 / 6, 4 / 6, 1 / 6]
        shares = [0.0] * (self.rows + 1)
        for j in range(0, self.rows, self.step):
            for k, part in enumerate(edge):
                shares[j + k] += part * self.step / self.rows
        return shares

    def corners(self):
        """Corner nodes: {(column, row) in elements: number}."""
        s = self.step
        return {(i // s, j // s): self.number(i, j)
                for i in range(0, self.columns + 1, s) for j in range(0, self.rows + 1, s)}


def deck(mesh, state, solid=None, large=False):
    """The input of ccx: plane-strain elements, with the constants of `state`; or, for `solid`,
    CalculiX's plane-stress elements of that thickness, loaded in proportion to it. `large`:
    finite displacements, loads that keep their direction."""
    kind, young, poisson = ("CPE",) + constants(state)
    if solid:
        kind, young, poisson = "CPS", YOUNG, POISSON
    thickness = solid or THICKNESS
    lines = ["** Double cantilever beam of CRAMP 3.1, upper half; mm, N, MPa",
             "** SPDX-License-Identifier: GPL-3.0-or-later", "*NODE, NSET=ALL"]
    for i, j in mesh.points():
        lines.append("%d, %.9g, %.9g" % ((mesh.number(i, j),) + mesh.place(i, j)))
    lines.append("*ELEMENT, TYPE=%s%d, ELSET=ARM" % (kind, mesh.nodes))
    for k, corners in enumerate(mesh.elements()):
        lines.append(", ".join(map(str, [k + 1] + corners)))
    lines.append("*NSET, NSET=LIGAMENT")
    held = [mesh.number(i, 0) for i in range(mesh.columns + 1)
            if mesh.place(i, 0)[0] > CRACK - 1e-9]
    lines += [", ".join(map(str, held[k:k + 12])) + "," for k in range(0, len(held), 12)]
    lines += ["*BOUNDARY", "LIGAMENT, 2, 2", "%d, 1, 1" % mesh.number(mesh.columns, 0),
              "*MATERIAL, NAME=SOFT", "*ELASTIC", "%.15g, %.15g" % (young, poisson),
              "*SOLID SECTION, ELSET=ARM, MATERIAL=SOFT", "%g" % thickness,
              "*STEP, NLGEOM" if large else "*STEP", "*STATIC"]
    if large:
        lines.append("0.25, 1.")
    lines.append("*CLOAD")
    for j, share in enumerate(mesh.end_weights()):
        load = share * FORCE * thickness / THICKNESS
        lines.append("%d, 2, %.12g" % (mesh.number(0, j), load))
    lines += ["*NODE FILE, OUTPUT=2D, FREQUENCY=1000", "U", "*EL FILE, FREQUENCY=1000", "S",
              "*END STEP"]
    return "\n".join(lines) + "\n"


def fields(text):
    """Last displacements and stresses of a .frd file: {name: {node: components}}."""
    found, name = {}, None
    for line in text.splitlines():
        if line.startswith(" -4"):
            name = line.split()[1]
            found[name] = {}
        elif line.startswith(" -3"):
            name = None
        elif name and line.startswith(" -1"):
            numbers = [float(line[c:c + 12]) for c in range(13, len(line.rstrip()), 12)]
            found[name][int(line[3:13])] = numbers
    return found


class Result:
    """One run of ccx: stress (xx, yy, xy) at the corner nodes, opening of the loaded end."""

    def __init__(self, folder, mesh, state, **variant):
        name = os.path.join(folder, "arm")
        with open(name + ".inp", "w") as out:
            out.write(deck(mesh, state, **variant))
        subprocess.run(["ccx", "arm"], cwd=folder, check=True, stdout=subprocess.DEVNULL,
                       env=dict(os.environ, OMP_NUM_THREADS="1"))
        with open(name + ".frd") as results:
            found = fields(results.read())
        self.size = mesh.size
        self.stress = {place: [found["STRESS"][n][k] for k in (0, 1, 3)]
                       for place, n in mesh.corners().items()}
        end = [(share, found["DISP"][mesh.number(0, j)][1])
               for j, share in enumerate(mesh.end_weights())]
        self.opening = sum(share * rise for share, rise in end)  # does the work of the load
        self.corner = end[0][1]

    def at(self, x, y):
        """Stress at a point of the arm, bilinear between the averaged values of the corners."""
        s, t = x / self.size, (y - ARM) / self.size
        i, j = int(min(s, LENGTH / self.size - 1)), int(min(t, ARM / self.size - 1))
        s, t = s - i, t - j
        shares = {(0, 0): (1 - s) * (1 - t), (1, 0): s * (1 - t), (0, 1): (1 - s) * t,
                  (1, 1): s * t}
        return [sum(share * self.stress[i + a, j + b][k] for (a, b), share in shares.items()
                    if share) for k in range(3)]
