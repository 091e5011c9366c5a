"""Mesh simplification to a triangle budget or an error bound, with the deviation measured.

A mesh is coarsened within a tolerance first, which removes slivers that nothing else can handle,
and then by quadric error metrics, which choose best what to remove. Neither guarantees a result, so
several candidates are made and measured, and the best is returned.
"""

from __future__ import annotations

from math import inf

from urdfkit.core.progress import Progress
from urdfkit.core.record import Record
from urdfkit.errors import UrdfkitError
from urdfkit.mesh.decimation import in_cells, with_fewer, within_tolerances
from urdfkit.mesh.distance import directed_distance
from urdfkit.mesh.geometry import Mesh
from urdfkit.mesh.health import Health, examine_mesh
from urdfkit.mesh.repair.soup import soup_of

#: Tolerances, as a part of the diagonal, and as a part of the allowed error.
_FINEST, _COARSEST = 1e-5, 0.2
_FINEST_OF_ERROR, _COARSEST_OF_ERROR = 0.01, 2.0
#: Triangles with which quadric simplification starts, as multiples of the target.
_START_FACTORS = (1.5, 2.5, 5)
#: Greatest further reduction by quadrics after coarsening, and search steps for it.
_MAX_REDUCTION, _STEPS = 8.0, 5


class Unreachable(UrdfkitError):
    """No simplification meets the bound."""


class Simplified(Record):
    """Result of a simplification."""

    mesh: Mesh  # with fewer triangles; without normals, texture coordinates and vertex colours
    #: before and after: the state of the mesh.
    before: Health
    after: Health
    lost: float  # greatest distance from the old surface to the new one, in the unit of the mesh
    gained: float  # greatest distance from the new surface to the old one
    diagonal: float  # of the bounding box, as a reference for the distances

    @property
    def deviation(self) -> float:
        return max(self.lost, self.gained)


def to_budget(mesh: Mesh, triangles: int, progress: Progress | None = None) -> Simplified:
    """Simplify to at most ``triangles`` triangles, with as little change as possible.

    A solid stays a solid unless another candidate deviates by less than half as much.

    Args:
        progress: called with the number of finished steps and of all steps.

    Raises:
        Unreachable: the shape needs more triangles, or the mesh has no extent.
    """
    measure = _Deviations(mesh, progress)
    if len(mesh.faces) <= triangles:
        return measure.unchanged
    finer = [mesh]
    candidates = []
    for coarser in within_tolerances(
        mesh, _FINEST * measure.diagonal, _COARSEST * measure.diagonal
    ):
        if len(coarser.faces) <= triangles:
            candidates.append(coarser)
            break
        finer.append(coarser)
    candidates += [with_fewer(start, triangles) for start in _starts(finer, triangles)]
    small = [coarser for coarser in candidates if 0 < len(coarser.faces) <= triangles]
    small = small or [mesh for mesh in in_cells(mesh) if 0 < len(mesh.faces) <= triangles][:1]
    if not small:
        raise Unreachable(f"{triangles} triangles are too few for this shape")
    measure.expect(len(small))
    return min(
        map(measure, small), key=lambda new: new.deviation / (2 if new.after.is_solid else 1)
    )


def to_error(mesh: Mesh, error: float, progress: Progress | None = None) -> Simplified:
    """Simplify as far as possible while no surface moves farther than a bound.

    Args:
        error: the bound in the unit of the mesh, for both directions.
        progress: called with the number of finished steps and of all steps.

    Raises:
        Unreachable: the mesh has no extent.
    """
    measure = _Deviations(mesh, progress)
    coarser = [mesh, *within_tolerances(mesh, _FINEST_OF_ERROR * error, _COARSEST_OF_ERROR * error)]
    measure.expect(len(coarser).bit_length() + len(_START_FACTORS) + 1 + _STEPS)
    best, at = measure.unchanged, 0
    low, high = 1, len(coarser)
    while low < high:
        middle = (low + high) // 2
        result = measure(coarser[middle])
        if result.deviation <= error:
            best, at, low = result, middle, middle + 1
        else:
            high = middle
    number = len(best.mesh.faces)
    starts = _starts(coarser[: at + 1], number)
    start = min(starts, key=lambda start: measure(with_fewer(start, number // 2)).deviation)
    fewest, most = number / _MAX_REDUCTION, float(number)
    for _ in range(_STEPS):
        target = (fewest * most) ** 0.5
        result = measure(with_fewer(start, round(target)))
        if result.deviation > error:
            fewest = target
            continue
        most = target
        if len(result.mesh.faces) < len(best.mesh.faces):
            best = result
    measure.done()
    return best


class _Deviations:
    """Measures the deviation of simplified meshes from the original."""

    def __init__(self, mesh: Mesh, progress: Progress | None) -> None:
        sound = soup_of(mesh)
        self.diagonal = sound.size  # of its bounding box
        if not self.diagonal > 0:
            raise Unreachable("all triangles are at one point, or not finite")
        before = examine_mesh(mesh)
        #: The result for the original mesh.
        self.unchanged = Simplified(mesh, before, before, 0.0, 0.0, self.diagonal)
        self._surface = sound.points, sound.faces
        self._progress = progress
        self._done = self._total = 0

    def expect(self, steps: int) -> None:
        """Announce the greatest number of meshes to measure."""
        self._total = steps

    def done(self) -> None:
        """Report that measuring is finished."""
        if self._progress:
            self._progress(self._total, self._total)

    def __call__(self, mesh: Mesh) -> Simplified:
        """The result for a simplified mesh; without triangles, its deviation is infinite."""
        self._done += 1
        if self._progress:
            self._progress(self._done, self._total)
        old, new = self._surface, (mesh.vertices, mesh.faces)
        lost = gained = inf
        if len(mesh.faces):
            lost, gained = directed_distance(*old, *new), directed_distance(*new, *old)
        return self.unchanged._replace(
            mesh=mesh, after=examine_mesh(mesh), lost=lost, gained=gained
        )


def _starts(finer: list[Mesh], triangles: float) -> list[Mesh]:
    """Meshes to simplify by quadrics: the original, and for each multiple the coarsest above it."""
    starts = {0: finer[0]}
    for more in _START_FACTORS:
        enough = [i for i, mesh in enumerate(finer) if len(mesh.faces) >= more * triangles]
        starts.update({i: finer[i] for i in enough[-1:]})
    return list(starts.values())
