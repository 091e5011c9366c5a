"""The self-collisions of one robot: where it begins, in sampled poses, and in all poses."""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property

from urdfkit.core.static_typing import TYPE_CHECKING, Any
from urdfkit.physics.collision.contacts import Contacts

if TYPE_CHECKING:
    from urdfkit.physics.collision.exact import ExactDistances
    from urdfkit.physics.collision.matrix import Matrix
    from urdfkit.physics.collision.sampled_poses import SampledPoses
    from urdfkit.ros import RosDescription


class Collisions:
    """The self-collisions of one robot, each computed when it is first needed.

    Args:
        need_coal: raises an error if coal cannot be imported; called before it is.
    """

    def __init__(self, robot: RosDescription, need_coal: Callable[[], None]) -> None:
        self._robot = robot
        self._need_coal = need_coal

    @cached_property
    def contacts(self) -> Contacts:
        """The links that overlap where the robot begins."""
        return self._contacts(unit=self._robot.targets.applies_units)

    @cached_property
    def contacts_in_moveit(self) -> Contacts:
        """The same as MoveIt has it, which ignores the units of COLLADA files."""
        return self._contacts(unit=False)

    @cached_property
    def sampled_in_moveit(self) -> SampledPoses:
        """The robot in sampled poses, as MoveIt has it."""
        self._need_coal()
        from urdfkit.physics.collision.sampled_poses import SampledPoses

        return SampledPoses(self._robot.model, self._robot.tree, self._robot.meshes, unit=False)

    def matrix(self, **options: Any) -> Matrix:
        """Which links can collide; the options are those of `sampling.collisions`."""
        self._need_coal()
        from urdfkit.physics.collision.sampling import collisions

        return collisions(self._robot, **options)

    def _contacts(self, *, unit: bool) -> Contacts:
        def load() -> ExactDistances:
            self._need_coal()
            from urdfkit.physics.collision import exact

            return exact.ExactDistances(self._robot, unit=unit)

        return Contacts(self._robot, load, unit=unit)
