"""ROS, Gazebo and MoveIt: their files, and how they read a robot."""

from __future__ import annotations

from urdfkit.core.static_typing import TYPE_CHECKING, Protocol
from urdfkit.robot import DescribedRobot

if TYPE_CHECKING:
    from urdfkit.ros.launch.contents import FileUse
    from urdfkit.ros.moveit.config import MoveItConfig
    from urdfkit.ros.moveit.srdf import Srdf
    from urdfkit.ros.targets import Targets


class RosDescription(DescribedRobot, Protocol):
    """A description with the parameter files of its launch file, and its SRDF."""

    parameters: tuple[FileUse, ...]
    trust: bool
    arguments: dict[str, str]

    @property
    def is_readable(self) -> bool: ...

    @property
    def srdf(self) -> Srdf | None: ...

    @property
    def moveit_config(self) -> MoveItConfig: ...

    @property
    def targets(self) -> Targets: ...

    def names_in_robot(self, path: str) -> frozenset[str]: ...
