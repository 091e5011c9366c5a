"""The mesh files of a robot, measured, and their defects."""

from __future__ import annotations

import os
from functools import cached_property
from typing import TYPE_CHECKING

from urdfkit.core.record import Record
from urdfkit.core.spatial import Vector
from urdfkit.mesh.io.facts import MAX_BYTES, READ
from urdfkit.mesh.measures import Measures
from urdfkit.robot.inertia import MassProperties, rotated
from urdfkit.robot.model import Body, Link, Placed, Shape
from urdfkit.robot.shapes import BoundingBox, MeshSolid
from urdfkit.text.document import Attribute

if TYPE_CHECKING:
    from collections.abc import Callable

    from urdfkit.mesh.measure_cache import Store
    from urdfkit.robot.assets.mesh_diagnoses import MeshDefect
    from urdfkit.robot.assets.mesh_files import Files
    from urdfkit.robot.model import RobotModel


class MeshUse(Record):
    """A mesh file in a visual or a collision of a link.

    Attributes:
        at: the file name as it is after expansion.
        link: the link.
        role: ``visual`` or ``collision``.
        body: the visual or collision.
        shape: the mesh in it.
        path: of the file.
        measures: of its triangles.
    """

    at: Placed[str]
    link: Link
    role: str
    body: Body
    shape: Shape
    path: str
    measures: Measures

    @property
    def who(self) -> str:
        """The subject of a message."""
        return f"link '{self.link.name}': the {self.role} mesh '{self.at.value}'"

    @property
    def factors(self) -> Vector:
        """From coordinates of the file to m along x, y and z, as RViz and Gazebo multiply."""
        x, y, z = self.shape.scale
        unit = self.measures.unit
        return (x * unit, y * unit, z * unit)

    @property
    def edges(self) -> Vector:
        """Of the bounding box along the axes of the file, in m."""
        x, y, z = (abs(f) * e for f, e in zip(self.factors, self.measures.edges, strict=True))
        return (x, y, z)

    @property
    def longest(self) -> float:
        """The longest edge of that box, in m."""
        return max(self.edges)

    @property
    def points(self) -> tuple[Vector, ...]:
        """The extreme vertices in m, in the frame of the link."""
        x, y, z = self.factors
        apply = self.body.origin.apply
        return tuple(apply((a * x, b * y, c * z)) for a, b, c in self.measures.points)

    @property
    def box(self) -> BoundingBox:
        """The bounding box along the axes of the link, in m."""
        columns = tuple(zip(*self.points, strict=True))
        (a, b, c), (d, e, f) = map(min, columns), map(max, columns)
        return BoundingBox((a, b, c), (d, e, f))

    @property
    def lump(self) -> MeshSolid | None:
        """The mesh as a solid in the frame of the link; None if it is flat."""
        from urdfkit.robot.inertials.shape_mass import stretched

        measures = self.measures
        uniform, hull = measures.solid or measures.hull, measures.hull
        if uniform is None or hull is None:
            return None
        whole = stretched(uniform, self.shape, measures.unit)
        around = stretched(hull, self.shape, measures.unit)
        if whole is None or around is None:
            return None
        mass, center, tensor = whole
        origin = self.body.origin
        shape_mass = MassProperties(mass, origin.apply(center), rotated(tensor, origin.rotation))
        name = os.path.basename(self.path)
        return MeshSolid(name, shape_mass, around.mass, measures.solid is not None, self.points)

    @property
    def scale_at(self) -> Attribute | None:
        """The attribute ``scale``, if there is one."""
        return self.shape.at.attributes.get("scale")


class UnmeasuredMesh(Record):
    """A mesh file that looks whole and gives no triangles.

    Attributes:
        at: the file name as it is after expansion.
        link: name of the link.
        role: ``visual`` or ``collision``.
        reason: a predicate whose subject is the file.
    """

    at: Placed[str]
    link: str
    role: str
    reason: str

    @property
    def who(self) -> str:
        """The subject of a message."""
        return f"link '{self.link}': the {self.role} mesh '{self.at.value}'"


class MeasuredMeshes:
    """The meshes of one model that can be measured.

    Args:
        model: that names them.
        files: finds them.
        store: measures them.
        progress: called with the number of files measured, and of all.
    """

    def __init__(
        self,
        model: RobotModel,
        files: Files,
        store: Store,
        progress: Callable[[int, int], None] | None = None,
    ) -> None:
        self.model = model
        self._files = files
        self._store = store
        self._progress = progress
        self._known: dict[str, Measures | str] = {}

    def measures(self, shape: Shape) -> Measures | str:
        """Of the mesh of a shape; or why there are none, as a predicate whose subject is the file.

        Args:
            shape: a mesh.
        """
        path = self._files.path(shape)
        if path is None:
            return "is missing"
        if path not in self._known:
            self._known[path] = self._measured(path)
        return self._known[path]

    def _measured(self, path: str) -> Measures | str:
        facts = self._files.facts(path)
        if facts.defect:
            return facts.defect.reason
        if facts.format not in READ:
            return f"is {facts.format}, which is not read"
        if facts.size > MAX_BYTES:
            return f"has more than {MAX_BYTES // 1024**2} MiB, which is not read"
        if self._progress:
            self._progress(len(self._known), len(self._files.paths))
        return self._store.measures(path, facts.format)

    @cached_property
    def uses(self) -> list[MeshUse]:
        """Every use of a mesh that can be measured, in the order of the document."""
        return [use for use in self._every_use if isinstance(use, MeshUse)]

    @cached_property
    def unmeasured(self) -> list[UnmeasuredMesh]:
        """The others whose files look whole."""
        return [use for use in self._every_use if isinstance(use, UnmeasuredMesh)]

    @cached_property
    def _every_use(self) -> list[MeshUse | UnmeasuredMesh]:
        return [
            use
            for link in self.model.links
            for role, bodies in (("visual", link.visuals), ("collision", link.collisions))
            for body in bodies
            if (use := self._use(link, role, body)) is not None
        ]

    @cached_property
    def files(self) -> list[MeshUse]:
        """One use of each file: the first collision, else the first visual."""
        first: dict[str, MeshUse] = {}
        for use in sorted(self.uses, key=lambda use: use.role):
            first.setdefault(use.path, use)
        return list(first.values())

    def lump(self, body: Body) -> MeshSolid | None:
        """A visual or collision as a solid; None if it is no mesh, or not measured, or flat."""
        use = self._by_body.get(id(body))
        return use.lump if use else None

    @cached_property
    def _by_body(self) -> dict[int, MeshUse]:
        """The uses by the identity of their visual or collision."""
        return {id(use.body): use for use in self.uses}

    @cached_property
    def diagnoses(self) -> dict[MeshDefect, list[MeshUse]]:
        """The meshes with each defect."""
        from urdfkit.robot.assets.mesh_diagnoses import diagnoses

        return diagnoses(self)

    def _use(self, link: Link, role: str, body: Body) -> MeshUse | UnmeasuredMesh | None:
        """A use of a mesh; None for what is no mesh, and for files with a defect."""
        shape = body.shape
        path = self._files.path(shape) if shape else None
        if shape is None or shape.filename is None or path is None:
            return None
        facts = self._files.facts(path)
        if facts.defect or facts.format not in READ or facts.size > MAX_BYTES:
            return None
        measures = self.measures(shape)
        if isinstance(measures, str):
            return UnmeasuredMesh(shape.filename, link.name, role, measures)
        return MeshUse(shape.filename, link, role, body, shape, path, measures)
