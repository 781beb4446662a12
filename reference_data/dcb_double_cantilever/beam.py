# The double cantilever beam of CRAMP 3.1 as a CalculiX deck, and the reading of its results.
# Upper half only: the mid-plane ahead of the crack is held by symmetry. Units: mm, N, MPa.
#
# SPDX-License-Identifier: GPL-3.0-or-later
import os
import subprocess

LENGTH, ARM, CRACK, THICKNESS = 100.0, 3.0, 50.0, 1.0
YOUNG, POISSON, FORCE = 0.1, 0.33, 4e-5
STATES = {"plane_strain": "CPE", "plane_stress": "CPS"}


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

    def midplane(self):
        """Corner nodes of the plane y = 3 with their x."""
        return [(self.place(i, 0)[0], self.number(i, 0))
                for i in range(0, self.columns + 1, self.step)]


def deck(mesh, state, crack=CRACK, thickness=THICKNESS, large=False):
    """The input of ccx. The force stays that of 1 mm of thickness for each mm."""
    lines = ["** Double cantilever beam of CRAMP 3.1, upper half; mm, N, MPa",
             "** SPDX-License-Identifier: GPL-3.0-or-later", "*NODE, NSET=ALL"]
    for i, j in mesh.points():
        lines.append("%d, %.9g, %.9g" % ((mesh.number(i, j),) + mesh.place(i, j)))
    lines.append("*ELEMENT, TYPE=%s%d, ELSET=ARM" % (STATES[state], mesh.nodes))
    for k, corners in enumerate(mesh.elements()):
        lines.append(", ".join(map(str, [k + 1] + corners)))
    lines.append("*NSET, NSET=LIGAMENT")
    held = [mesh.number(i, 0) for i in range(mesh.columns + 1)
            if mesh.place(i, 0)[0] > crack - 1e-9]
    lines += [", ".join(map(str, held[k:k + 12])) + "," for k in range(0, len(held), 12)]
    lines += ["*BOUNDARY", "LIGAMENT, 2, 2", "%d, 1, 1" % mesh.number(mesh.columns, 0),
              "*MATERIAL, NAME=SOFT", "*ELASTIC", "%g, %g" % (YOUNG, POISSON),
              "*SOLID SECTION, ELSET=ARM, MATERIAL=SOFT", "%g" % thickness,
              "*STEP, NLGEOM" if large else "*STEP", "*STATIC"]
    if large:
        lines.append("0.1, 1.")
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
    """One run of ccx: stress along the mid-plane and how far the loaded end opens."""

    def __init__(self, folder, mesh, state, **variant):
        name = os.path.join(folder, "arm")
        with open(name + ".inp", "w") as out:
            out.write(deck(mesh, state, **variant))
        subprocess.run(["ccx", "arm"], cwd=folder, check=True, stdout=subprocess.DEVNULL)
        with open(name + ".frd") as results:
            found = fields(results.read())
        self.stress = {round(x, 6): found["STRESS"][n][0] for x, n in mesh.midplane()}
        end = [(share, found["DISP"][mesh.number(0, j)][1])
               for j, share in enumerate(mesh.end_weights())]
        self.opening = sum(share * rise for share, rise in end)  # does the work of the load
        self.corner = end[0][1]
