# The arm with plain four-node elements (bilinear, 2 x 2 Gauss points), without CalculiX:
# the opening that deck() of beam.py must give in plane strain and in plane stress.
#
# SPDX-License-Identifier: GPL-3.0-or-later
from beam import ARM, CRACK, FORCE, LENGTH, POISSON, THICKNESS, YOUNG

CORNERS = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
GAUSS = 3 ** -0.5


def moduli(state):
    """D of (xx, yy, xy): direct, cross and shear entry."""
    shear = YOUNG / (2 * (1 + POISSON))
    if state == "plane_stress":
        direct = YOUNG / (1 - POISSON ** 2)
        return direct, POISSON * direct, shear
    direct = YOUNG * (1 - POISSON) / ((1 + POISSON) * (1 - 2 * POISSON))
    return direct, direct * POISSON / (1 - POISSON), shear


def stiffness(state):
    """Of a square element; its size does not matter in two dimensions."""
    direct, cross, shear = moduli(state)
    total = [[0.0] * 8 for _ in range(8)]
    for s, t in [(a * GAUSS, b * GAUSS) for a, b in CORNERS]:
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


def opening(size, state):
    """Mean rise of the loaded face, weighted as the load is."""
    columns, rows = round(LENGTH / size), round(ARM / size)
    element, count = stiffness(state), rows + 1
    matrix = [[0.0] * (2 * count + 4) for _ in range(2 * count * (columns + 1))]
    for i in range(columns):
        for j in range(rows):
            nodes = [(i + (a + 1) // 2) * count + j + (b + 1) // 2 for a, b in CORNERS]
            places = [2 * n + axis for n in nodes for axis in range(2)]
            for m, row in enumerate(places):
                for n, column in enumerate(places):
                    if column >= row:
                        matrix[row][column - row] += element[m][n]
    held = [2 * i * count + 1 for i in range(columns + 1) if i * size > CRACK - 1e-9]
    for row in held + [2 * columns * count]:
        matrix[row][0] += 1e12 * YOUNG
    shares = [(0.5 if j in (0, rows) else 1.0) / rows for j in range(count)]
    load = [0.0] * len(matrix)
    for j, share in enumerate(shares):
        load[2 * j + 1] = share * FORCE
    moved = solve(matrix, load)
    return sum(share * moved[2 * j + 1] for j, share in enumerate(shares))
