"""The self-collisions of one robot: what sampling shows, and what a few poses show at once."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from urdfkit.collision.matrix import Matrix
from urdfkit.collision.sampling import collisions

if TYPE_CHECKING:
    from urdfkit.subject import Subject


class Collisions:
    """Of one robot.

    Args:
        robot: with its meshes.
    """

    def __init__(self, robot: Subject) -> None:
        self._robot = robot

    def matrix(self, **options: Any) -> Matrix:
        """Which links can collide; the options are those of `sampling.collisions`."""
        return collisions(self._robot, **options)
