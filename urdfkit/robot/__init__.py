"""Robot models: tree, frames, inertias, shapes and meshes; protocols for computations on them."""

from __future__ import annotations

from urdfkit.core.static_typing import TYPE_CHECKING, Protocol

if TYPE_CHECKING:
    from collections.abc import Mapping

    from urdfkit.mesh.measures import Measures
    from urdfkit.robot.assets.mesh_files import MeshFiles
    from urdfkit.robot.assets.triangles import Meshes
    from urdfkit.robot.link import Shape
    from urdfkit.robot.model import RobotModel
    from urdfkit.robot.tree import KinematicTree
    from urdfkit.text.document import Tag
    from urdfkit.text.source import Source
    from urdfkit.workspace.resolve import Resolver
    from urdfkit.xacro import Xacro


class Robot(Protocol):
    """A robot with its meshes."""

    @property
    def model(self) -> RobotModel: ...

    @property
    def tree(self) -> KinematicTree: ...

    @property
    def files(self) -> MeshFiles: ...

    @property
    def meshes(self) -> Meshes: ...

    def measures(self, shape: Shape) -> Measures | str: ...


class DescribedRobot(Robot, Protocol):
    """A robot with its source file."""

    source: Source
    resolver: Resolver

    @property
    def xacro(self) -> Xacro: ...

    @property
    def uses(self) -> Mapping[Tag, int]: ...

    @property
    def is_included(self) -> bool: ...
