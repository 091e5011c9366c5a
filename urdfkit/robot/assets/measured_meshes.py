"""Measures and defects of the mesh files of a robot."""

from __future__ import annotations

from functools import cached_property

from urdfkit.core.static_typing import TYPE_CHECKING
from urdfkit.mesh.io.facts import MAX_BYTES, READ
from urdfkit.mesh.measures import Measures
from urdfkit.robot.assets.mesh_files import MeshReference
from urdfkit.robot.assets.mesh_uses import MeshUse
from urdfkit.robot.link import Body, Shape

if TYPE_CHECKING:
    from urdfkit.core.progress import Progress
    from urdfkit.mesh.measure_cache import Store
    from urdfkit.robot.assets.mesh_defects import MeshDefect
    from urdfkit.robot.assets.mesh_files import MeshFiles
    from urdfkit.robot.model import RobotModel
    from urdfkit.robot.shapes import MeshSolid


class MeasuredMeshes:
    """The measurable meshes of a model.

    Args:
        progress: called with the number of measured files and the total number.
    """

    def __init__(
        self, model: RobotModel, files: MeshFiles, store: Store, progress: Progress | None = None
    ) -> None:
        self.model = model
        self._files = files
        self._store = store
        self._progress = progress
        self._known: dict[str, Measures | str] = {}

    def measures(self, shape: Shape) -> Measures | str:
        """Measures of a mesh, or a predicate on the file that states why there are none."""
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
        """All uses of measurable meshes, in document order."""
        return [use for use, _ in self._every_use if isinstance(use, MeshUse)]

    @property
    def unmeasured(self) -> list[tuple[MeshReference, str]]:
        """References to unmeasurable files without a defect, each with a predicate on the file."""
        return [(mesh, why) for mesh, why in self._every_use if isinstance(mesh, MeshReference)]

    @cached_property
    def _every_use(self) -> list[tuple[MeshUse | MeshReference, str]]:
        uses: list[tuple[MeshUse | MeshReference, str]] = []
        for mesh in self._files.meshes:
            path, facts, shape = mesh.located.path, mesh.facts, mesh.body.shape
            if shape is None or path is None or facts is None or facts.defect:
                continue
            if facts.format not in READ or facts.size > MAX_BYTES:
                continue
            measures = self.measures(shape)
            if isinstance(measures, str):
                uses.append((mesh, measures))
            else:
                use = MeshUse(mesh.at, mesh.link, mesh.role, mesh.body, shape, path, measures)
                uses.append((use, ""))
        return uses

    @cached_property
    def files(self) -> list[MeshUse]:
        """One use of each file: the first collision, or else the first visual."""
        first: dict[str, MeshUse] = {}
        for use in sorted(self.uses, key=lambda use: use.role):
            first.setdefault(use.path, use)
        return list(first.values())

    def solid(self, body: Body) -> MeshSolid | None:
        """A visual or collision as a solid; None if it is not a mesh, not measured, or flat."""
        return self._solids.get(id(body))

    @cached_property
    def _solids(self) -> dict[int, MeshSolid | None]:
        """Solids by the identity of their visual or collision."""
        return {id(use.body): use.solid for use in self.uses}

    @cached_property
    def defects(self) -> dict[MeshDefect, list[MeshUse]]:
        from urdfkit.robot.assets.mesh_defects import find_defects

        return find_defects(self.model, self.uses, self.files)
