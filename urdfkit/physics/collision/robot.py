"""The self-collisions of a robot: in the initial, in sampled and in all poses."""

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
    """The self-collisions of a robot, computed on first use.

    Args:
        need_coal: called before coal is imported; raises an error if it is not installed.
    """

    def __init__(self, robot: RosDescription, need_coal: Callable[[], None]) -> None:
        self._robot = robot
        self._need_coal = need_coal

    @cached_property
    def contacts(self) -> Contacts:
        """The links that overlap in the initial pose."""
        return self._contacts(unit=self._robot.targets.applies_units)

    @cached_property
    def contacts_in_moveit(self) -> Contacts:
        """The same for MoveIt, which ignores the units of COLLADA files."""
        return self._contacts(unit=False)

    @cached_property
    def sampled_in_moveit(self) -> SampledPoses:
        """The robot in sampled poses, for MoveIt."""
        self._need_coal()
        from urdfkit.physics.collision.sampled_poses import SampledPoses

        return SampledPoses(self._robot.model, self._robot.tree, self._robot.meshes, unit=False)

    def matrix(self, **options: Any) -> Matrix:
        """The collision matrix; the options are those of `sampling.collisions`."""
        self._need_coal()
        from urdfkit.physics.collision.sampling import collisions

        return collisions(self._robot, **options)

    def _contacts(self, *, unit: bool) -> Contacts:
        def load() -> ExactDistances:
            self._need_coal()
            from urdfkit.physics.collision import exact

            return exact.ExactDistances(self._robot, unit=unit)

        return Contacts(self._robot, load, unit=unit)
