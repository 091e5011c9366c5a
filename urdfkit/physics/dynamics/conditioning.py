"""Whether the joint-space mass matrix can be inverted: every simulation does it at each step."""

from __future__ import annotations

import numpy as np

from urdfkit.core.record import Record
from urdfkit.physics.dynamics.robot import Dynamics

#: Single precision, in which several simulators compute, has seven digits.
LARGEST = 1e7


class Conditioning(Record):
    """The mass matrix with all joints at zero, scaled so that units do not matter."""

    #: The ratio of its largest to its smallest eigenvalue; infinite where the smallest is not
    #: positive.
    number: float
    #: Whose motion against each other has the least inertia, the first one most.
    joints: tuple[str, ...]

    @property
    def is_ill(self) -> bool:
        """True if single precision does not hold the matrix."""
        return self.number > LARGEST


def conditioning(robot: Dynamics) -> Conditioning:
    """Condition of the mass matrix, of the coordinates that move some mass."""
    matrix = robot.mass_matrix({})
    diagonal = np.diag(matrix)
    moving = np.flatnonzero(diagonal)
    if not len(moving):
        return Conditioning(1.0, ())
    scale = np.sqrt(np.abs(diagonal[moving]))
    with np.errstate(over="ignore", invalid="ignore"):
        scaled = matrix[np.ix_(moving, moving)] / np.outer(scale, scale)
    strange = ~np.isfinite(scaled).all(axis=1)
    if strange.any():  # negative masses give anything
        lost = (robot.columns[index].partition("[")[0] for index in moving[strange])
        return Conditioning(float("inf"), tuple(dict.fromkeys(lost)))
    values, vectors = np.linalg.eigh(scaled)
    number = float(values[-1] / values[0]) if values[0] > 0 else float("inf")
    part = np.abs(vectors[:, 0])
    order = [index for index in np.argsort(-part) if part[index] > 0.3]
    names = (robot.columns[moving[index]].partition("[")[0] for index in order)
    return Conditioning(number, tuple(dict.fromkeys(names)))
