# The arm with plain four-node elements (bilinear, 2 x 2 points), without CalculiX: the opening
# that deck() of beam.py must give in plane strain and in plane stress, and stresses at any place.
# `points` is how far from the middle they integrate, on -1 to 1: GAUSS, or PARTICLES, where four
# material points of a cell lie, for what the material point method is in the limit of small motion.
#
# SPDX-License-Identifier: GPL-3.0-or-later
from beam import ARM, CRACK, FORCE, LENGTH, POISSON, THICKNESS, YOUNG

CORNERS = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
GAUSS = 3 ** -0.5
PARTICLES = 0.5


def moduli(state):
    """D of (xx, yy, xy): direct, cross and shear entry."""
    shear = YOUNG / (2 * (1 + POISSON))
    if state == "plane_stress":
        direct = YOUNG / (1 - POISSON ** 2)
        return direct, POISSON * direct, shear
    direct = YOUNG * (1 - POISSON) / ((1 + POISSON) * (1 - 2 * POISSON))
    return direct, direct * POISSON / (1 - POISSON), shear


def stiffness(state, points):
    """Of a square element; its size does not matter in two dimensions."""
    direct, cross, shear = moduli(state)
    total = [[0.0] * 8 for _ in range(8)]
    for s, t in [(a * points, b * points) for a, b in CORNERS]:
        slopes = [(a * (1 + b * t) / 4, b * (1 + a * s) / 4) for a, b in CORNERS]
        for m, (px, py) in enumerate(slopes):
            for n, (qx, qy) in enumerate(slopes):
                block = [[direct * px * qx + shear * py * qy, cross * px * qy + shear * py * qx],
                         [cross * py * qx + shear * px * qy, direct * py * qy + shear * px * qx]]
                for a in range(2):
                    for b in range(2):
                        total[2 * m + a][2 * n + b] += THICKNESS * block[a][b]
    return total


def solve(matrix, load):
    """Symmetric, upper half-band matrix[row][column - row]: elimination without pivots."""
    for row, line in enumerate(matrix):
        for k in range(1, len(line)):
            if line[k] and row + k < len(matrix):
                factor = line[k] / line[0]
                below = matrix[row + k]
                for c in range(k, len(line)):
                    below[c - k] -= factor * line[c]
                load[row + k] -= factor * load[row]
    for row in reversed(range(len(matrix))):
        line = matrix[row]
        known = sum(line[k] * load[row + k] for k in range(1, min(len(line), len(load) - row)))
        load[row] = (load[row] - known) / line[0]
    return load


def places(i, j, count):
    """Of an element's displacements among all; `count` nodes to a column."""
    nodes = [(i + (a + 1) // 2) * count + j + (b + 1) // 2 for a, b in CORNERS]
    return [2 * n + axis for n in nodes for axis in range(2)]


def shares(rows):
    """Of the load, by nodes of the loaded face."""
    return [(0.5 if j in (0, rows) else 1.0) / rows for j in range(rows + 1)]


def displacements(size, state, points=GAUSS):
    """Of all nodes, column by column upwards, x and y in turn."""
    columns, rows = round(LENGTH / size), round(ARM / size)
    element, count = stiffness(state, points), rows + 1
    matrix = [[0.0] * (2 * count + 4) for _ in range(2 * count * (columns + 1))]
    for i in range(columns):
        for j in range(rows):
            own = places(i, j, count)
            for m, row in enumerate(own):
                for n, column in enumerate(own):
                    if column >= row:
                        matrix[row][column - row] += element[m][n]
    held = [2 * i * count + 1 for i in range(columns + 1) if i * size > CRACK - 1e-9]
    for row in held + [2 * columns * count]:
        matrix[row][0] += 1e12 * YOUNG
    load = [0.0] * len(matrix)
    for j, share in enumerate(shares(rows)):
        load[2 * j + 1] = share * FORCE
    return solve(matrix, load)


def opening(size, state, points=GAUSS):
    """Mean rise of the loaded face, weighted as the load is."""
    moved, rows = displacements(size, state, points), round(ARM / size)
    return sum(share * moved[2 * j + 1] for j, share in enumerate(shares(rows)))


def stresses(size, state, at, points=GAUSS):
    """sigma_xx at places inside of elements, as their own shape functions give it."""
    moved, count = displacements(size, state, points), round(ARM / size) + 1
    direct, cross, _ = moduli(state)
    found = []
    for x, y in at:
        i, j = int(x // size), int((y - ARM) // size)
        s, t = 2 * (x / size - i) - 1, 2 * ((y - ARM) / size - j) - 1
        own = [moved[k] for k in places(i, j, count)]
        xx = sum(own[2 * k] * a * (1 + b * t) for k, (a, b) in enumerate(CORNERS)) / (2 * size)
        yy = sum(own[2 * k + 1] * b * (1 + a * s) for k, (a, b) in enumerate(CORNERS)) / (2 * size)
        found.append(direct * xx + cross * yy)
    return found
