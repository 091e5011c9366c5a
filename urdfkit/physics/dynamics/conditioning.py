"""Condition number of the joint-space mass matrix, which simulators invert at each step."""

from __future__ import annotations

import numpy as np

from urdfkit.core.record import Record
from urdfkit.physics.dynamics.robot import Dynamics

#: Limit of single precision, which several simulators use: seven digits.
MAX_RATIO = 1e7


class Conditioning(Record):
    """Condition of the mass matrix with all joints at zero, scaled to be independent of units."""

    #: Ratio of the largest to the smallest eigenvalue; infinite if the smallest is not positive.
    number: float
    #: Joints of the combined motion with the least inertia, by their contribution.
    joints: tuple[str, ...]

    @property
    def is_ill(self) -> bool:
        """True if single precision is not sufficient to invert the matrix."""
        return self.number > MAX_RATIO


def conditioning(robot: Dynamics) -> Conditioning:
    """Condition of the mass matrix of the coordinates that move any mass."""
    matrix = robot.mass_matrix({})
    diagonal = np.diag(matrix)
    moving = np.flatnonzero(diagonal)
    if not len(moving):
        return Conditioning(1.0, ())
    scale = np.sqrt(np.abs(diagonal[moving]))
    with np.errstate(over="ignore", invalid="ignore"):
        scaled = matrix[np.ix_(moving, moving)] / np.outer(scale, scale)
    overflown = ~np.isfinite(scaled).all(axis=1)
    if overflown.any():  # from negative masses
        names = (robot.columns[index].partition("[")[0] for index in moving[overflown])
        return Conditioning(float("inf"), tuple(dict.fromkeys(names)))
    values, vectors = np.linalg.eigh(scaled)
    number = float(values[-1] / values[0]) if values[0] > 0 else float("inf")
    part = np.abs(vectors[:, 0])
    order = [index for index in np.argsort(-part) if part[index] > 0.3]
    names = (robot.columns[moving[index]].partition("[")[0] for index in order)
    return Conditioning(number, tuple(dict.fromkeys(names)))
