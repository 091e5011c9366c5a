"""The self-collisions of one robot: what sampling shows, and what a few poses show at once."""

from __future__ import annotations

from functools import cached_property
from typing import TYPE_CHECKING, Any

from urdfkit.physics.collision.sampled_poses import SampledPoses

if TYPE_CHECKING:
    from urdfkit.physics.collision.matrix import Matrix
    from urdfkit.ros import RosDescription


class Collisions:
    """Of one robot.

    Args:
        robot: with its meshes.
    """

    def __init__(self, robot: RosDescription) -> None:
        self._robot = robot

    @cached_property
    def still(self) -> SampledPoses:
        """The robot where it begins, and with each joint at its limits."""
        robot = self._robot
        return SampledPoses(robot.model, robot.tree, robot.meshes, unit=robot.targets.applies_units)

    @cached_property
    def in_moveit(self) -> SampledPoses:
        """The same as MoveIt has it, which ignores the units of COLLADA files."""
        robot = self._robot
        return SampledPoses(robot.model, robot.tree, robot.meshes, unit=False)

    def matrix(self, **options: Any) -> Matrix:
        """Which links can collide; the options are those of `sampling.collisions`."""
        from urdfkit.physics.collision.sampling import (
            collisions,  # processes, which the rules do without
        )

        return collisions(self._robot, **options)
