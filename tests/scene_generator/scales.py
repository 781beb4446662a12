"""Scales of a scene: its cell, its waves.

SPDX-License-Identifier: GPL-3.0-or-later
"""

import math


def wave_speed(material):
    """Of longitudinal waves in the undeformed material."""
    if "young" in material:
        young, poisson = material["young"], material["poisson"]
        modulus = young * (1 - poisson) / ((1 + poisson) * (1 - 2 * poisson))
    else:
        modulus = material.get("bulk", 1) + 4 / 3 * material.get("shear", 0)
    return math.sqrt(modulus / material["density"])


class Scales:
    """Of self.scene."""

    @property
    def axisymmetric(self):
        """Is the scene axisymmetric?"""
        return self.scene["geometry"] == "axisymmetric"

    @property
    def cell(self):
        """The size of a cell of the refined grid."""
        grid = self.scene["grid"]
        return [side / grid.get("refine", 1) for side in grid["cell"]]

    @property
    def wave(self):
        """Speed of waves in the stiffest material."""
        return max(map(wave_speed, self.scene["materials"]))
