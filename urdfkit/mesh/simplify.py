"""Fewer triangles: to a budget, or as few as an error bound allows, with the deviation measured.

A mesh is coarsened within a tolerance first, which takes slivers away that nothing else can handle,
and then by quadric error metrics, which say best what can be missed. Neither promises anything, so
several ways are tried, what came out is measured, and the best is taken.
"""

from __future__ import annotations

from math import inf

from urdfkit.core.progress import Progress
from urdfkit.core.record import Record
from urdfkit.errors import UrdfkitError
from urdfkit.mesh.decimation import in_cells, with_fewer, within_tolerances
from urdfkit.mesh.distance import one_way
from urdfkit.mesh.geometry import Mesh
from urdfkit.mesh.health import Health, examine_mesh
from urdfkit.mesh.repair.soup import soup_of

#: Tolerances, as a part of the diagonal; and as a part of the error that is allowed.
_FINEST, _COARSEST = 1e-5, 0.2
_FINEST_OF_ERROR, _COARSEST_OF_ERROR = 0.01, 2.0
#: How many times as many triangles as are wanted the quadrics begin with.
_MORE = (1.5, 2.5, 5)
#: How much simpler than within a tolerance a mesh may be by quadrics, and steps to find that.
_FEWER, _STEPS = 8.0, 5


class Unreachable(UrdfkitError):
    """No simplification meets the bound."""


class Simplified(Record):
    """What came of a simplification."""

    mesh: Mesh  # with fewer triangles; without normals, texture coordinates and colours of vertices
    #: before and after: the state of the mesh.
    before: Health
    after: Health
    lost: float  # how far the old surface lies from the new one at most, in the unit of the mesh
    gained: float  # how far the new surface lies from the old one at most
    diagonal: float  # of the bounding box, to compare these with

    @property
    def deviation(self) -> float:
        return max(self.lost, self.gained)


def to_budget(mesh: Mesh, triangles: int, progress: Progress | None = None) -> Simplified:
    """Simplify to at most ``triangles`` triangles, with as little change as possible.

    A solid is kept a solid unless another way is twice as good.

    Args:
        mesh: any.
        triangles: how many.
        progress: called with the number of steps done, and of all.

    Raises:
        Unreachable: the shape cannot be kept with so few, or there is none.
    """
    measured = _Deviations(mesh, progress)
    if len(mesh.faces) <= triangles:
        return measured.unchanged
    finer = [mesh]
    tries = []
    for coarser in within_tolerances(
        mesh, _FINEST * measured.diagonal, _COARSEST * measured.diagonal
    ):
        if len(coarser.faces) <= triangles:
            tries.append(coarser)
            break
        finer.append(coarser)
    tries += [with_fewer(start, triangles) for start in _starts(finer, triangles)]
    few = [one for one in tries if 0 < len(one.faces) <= triangles]
    few = few or [one for one in in_cells(mesh) if 0 < len(one.faces) <= triangles][:1]
    if not few:
        raise Unreachable(f"{triangles} triangles are too few for this shape")
    measured.expect(len(few))
    return min(map(measured, few), key=lambda one: one.deviation / (2 if one.after.is_solid else 1))


def to_error(mesh: Mesh, error: float, progress: Progress | None = None) -> Simplified:
    """Simplify as far as possible while no surface moves farther than a bound.

    Args:
        mesh: any.
        error: in the unit of the mesh, measured both ways.
        progress: called with the number of steps done, and of all.

    Raises:
        Unreachable: there is no shape.
    """
    measured = _Deviations(mesh, progress)
    coarser = [mesh, *within_tolerances(mesh, _FINEST_OF_ERROR * error, _COARSEST_OF_ERROR * error)]
    measured.expect(len(coarser).bit_length() + len(_MORE) + 1 + _STEPS)
    best, at = measured.unchanged, 0
    low, high = 1, len(coarser)
    while low < high:
        middle = (low + high) // 2
        found = measured(coarser[middle])
        if found.deviation <= error:
            best, at, low = found, middle, middle + 1
        else:
            high = middle
    number = len(best.mesh.faces)
    starts = _starts(coarser[: at + 1], number)
    start = min(starts, key=lambda one: measured(with_fewer(one, number // 2)).deviation)
    fewest, most = number / _FEWER, float(number)
    for _ in range(_STEPS):
        wanted = (fewest * most) ** 0.5
        found = measured(with_fewer(start, round(wanted)))
        if found.deviation > error:
            fewest = wanted
            continue
        most = wanted
        if len(found.mesh.faces) < len(best.mesh.faces):
            best = found
    measured.done()
    return best


class _Deviations:
    """Measures how far simpler meshes are from one."""

    def __init__(self, mesh: Mesh, progress: Progress | None) -> None:
        sound = soup_of(mesh)
        self.diagonal = sound.size  # of its bounding box
        if not self.diagonal > 0:
            raise Unreachable("all triangles are in one place, or at no place at all")
        before = examine_mesh(mesh)
        #: The mesh itself, measured.
        self.unchanged = Simplified(mesh, before, before, 0.0, 0.0, self.diagonal)
        self._surface = sound.points, sound.faces
        self._progress = progress
        self._done = self._total = 0

    def expect(self, steps: int) -> None:
        """Say how many meshes will be measured, at most."""
        self._total = steps

    def done(self) -> None:
        """Say that no more will be measured."""
        if self._progress:
            self._progress(self._total, self._total)

    def __call__(self, mesh: Mesh) -> Simplified:
        """A simpler mesh, measured; one without triangles is infinitely far."""
        self._done += 1
        if self._progress:
            self._progress(self._done, self._total)
        old, new = self._surface, (mesh.vertices, mesh.faces)
        lost = gained = inf
        if len(mesh.faces):
            lost, gained = one_way(*old, *new), one_way(*new, *old)
        return self.unchanged._replace(
            mesh=mesh, after=examine_mesh(mesh), lost=lost, gained=gained
        )


def _starts(finer: list[Mesh], triangles: float) -> list[Mesh]:
    """What quadrics begin with: the mesh itself, and the coarsest of several numbers."""
    found = {0: finer[0]}
    for more in _MORE:
        enough = [i for i, one in enumerate(finer) if len(one.faces) >= more * triangles]
        found.update({i: finer[i] for i in enough[-1:]})
    return list(found.values())
