"""Mesh repair with a list of its steps and a check that the result is better."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from urdfkit.core.progress import Progress, silent
from urdfkit.core.record import Record
from urdfkit.mesh.distance import directed_distance
from urdfkit.mesh.geometry import Mesh
from urdfkit.mesh.health import Health, examine, examine_mesh
from urdfkit.mesh.repair.cleaning import (
    drop_back_sides,
    drop_collapsed,
    drop_fins,
    drop_repeated,
    drop_scraps,
    drop_walls,
    weld_open_edges,
)
from urdfkit.mesh.repair.holes import fill
from urdfkit.mesh.repair.soup import TriangleSoup, mesh_of, soup_of
from urdfkit.mesh.repair.union import unite
from urdfkit.mesh.repair.winding import face_outwards, orient_consistently
from urdfkit.mesh.welding import finite

#: Distance, as a part of the diagonal, below which points of open edges are merged.
WELD = 2e-5

#: Optional steps; requested by the user, they always count as an improvement.
_OPTIONAL = ("dropped one side of sheets", "united bodies that overlap")

#: A round may fix defects left by the previous one, such as a fill that meets another one.
_ROUNDS = 3

_Action = Callable[[TriangleSoup], TriangleSoup]


class RepairStep(Record):
    """One step of a repair."""

    name: str  # in the past tense, such as ``closed holes``
    removed: int = 0  # number of removed faces
    added: int = 0  # number of new faces
    turned: int = 0  # number of flipped faces


class Repair(Record):
    """The result of a repair."""

    mesh: Mesh  # the repaired mesh; the original object if nothing was changed
    steps: tuple[RepairStep, ...]  # in order
    #: before and after: the state of the mesh.
    before: Health
    after: Health
    #: Greatest distance from the old surface to the new one, in the unit of the mesh.
    lost: float = 0.0
    gained: float = 0.0  # greatest distance from the new surface to the old one
    discarded: str = ""  # why the repair was discarded; otherwise empty

    @property
    def changed(self) -> bool:
        """True if the mesh was changed."""
        return bool(self.steps) and not self.discarded


def repair(
    mesh: Mesh,
    *,
    holes: bool = True,
    one_sided: bool = False,
    union: bool = False,
    progress: Progress | None = None,
) -> Repair:
    """Make a mesh the surface of a solid, as far as possible without inventing much geometry.

    The surface of a solid is returned unchanged.

    Args:
        holes: close holes, too.
        one_sided: drop one side of two-sided sheets.
        union: unite overlapping bodies; texture coordinates and vertex colours are lost.
        progress: called with the number of finished rounds and of all; the last one measures.
    """
    before = examine_mesh(mesh)
    if before.is_solid and not (union and before.overlap):
        return Repair(mesh, (), before, before)
    report = progress or silent
    soup = soup_of(mesh)
    steps: list[RepairStep] = []
    if before.non_finite:
        steps.append(RepairStep("dropped triangles that are not finite", before.non_finite))
    if one_sided:
        soup = _apply(_OPTIONAL[0], drop_back_sides, soup, steps)
    initial = best = examine(soup.points, soup.faces)
    for number in range(_ROUNDS):  # while they reduce the defects
        if best.defects == 0:
            break
        report(number, _ROUNDS + 1)
        new_steps: list[RepairStep] = []
        candidate = _round(soup, new_steps, holes=holes)
        state = examine(candidate.points, candidate.faces)
        if not new_steps or state.defects >= best.defects:
            break
        soup, best = candidate, state
        steps += new_steps
    if union and (united := _apply(_OPTIONAL[1], unite, soup, steps)) is not soup:
        soup, mesh = united, _without_vertex_attributes(mesh)
    if not steps:
        return Repair(mesh, (), before, before)
    report(_ROUNDS, _ROUNDS + 1)
    return _if_better(mesh, soup, _summed(steps), before, initial)


def _without_vertex_attributes(mesh: Mesh) -> Mesh:
    """The mesh without texture coordinates and vertex colours."""
    parts = [part._replace(uv=None, colors=None) for part in mesh.parts]
    return mesh._replace(parts=tuple(parts))


def _round(soup: TriangleSoup, steps: list[RepairStep], *, holes: bool) -> TriangleSoup:
    """Run all actions once; appends to ``steps``."""
    tolerance = WELD * soup.size
    actions: list[tuple[str, _Action]] = [
        ("dropped collapsed triangles", drop_collapsed),
        ("dropped repeated triangles", drop_repeated),
        ("welded open edges", lambda soup: drop_collapsed(weld_open_edges(soup, tolerance))),
        ("dropped repeated triangles", drop_repeated),
        ("dropped fins", drop_fins),
        ("dropped walls inside", drop_walls),
        ("dropped loose scraps", drop_scraps),
        ("turned triangles to agree with their neighbours", orient_consistently),
        *([("closed holes", fill)] if holes else []),
        ("turned bodies outside out", face_outwards),
    ]
    for name, act in actions:
        soup = _apply(name, act, soup, steps)
    return soup


def _summed(steps: list[RepairStep]) -> list[RepairStep]:
    """The steps of all rounds, with equal names added up."""
    sums: dict[str, RepairStep] = {}
    for name, *counts in steps:
        before = sums.get(name, RepairStep(name))
        sums[name] = RepairStep(name, *(a + b for a, b in zip(before[1:], counts, strict=True)))
    return [*sums.values()]


def _apply(name: str, act: _Action, soup: TriangleSoup, steps: list[RepairStep]) -> TriangleSoup:
    result = act(soup) if len(soup.faces) else soup
    if result is soup:
        return soup
    change = len(result.faces) - len(soup.faces)
    if change == 0:
        moved = (result.faces != soup.faces).any(axis=1)
        if not moved.any():
            return soup
        same = (np.sort(result.faces, axis=1) == np.sort(soup.faces, axis=1)).all(axis=1)
        steps.append(RepairStep(name, turned=int((moved & same).sum())))
    else:
        steps.append(RepairStep(name, max(0, -change), max(0, change)))
    return result


def _if_better(
    mesh: Mesh, soup: TriangleSoup, steps: list[RepairStep], before: Health, initial: Health
) -> Repair:
    """The repair, or the original mesh if the repair is not an improvement.

    Args:
        initial: the state after the optional step, which may have opened the mesh.
    """
    if not len(soup.faces):
        return Repair(mesh, tuple(steps), before, before, discarded="nothing would be left")
    after = examine_mesh(mesh_of(soup, mesh))
    is_requested = any(step.name in _OPTIONAL for step in steps)
    if after.defects > initial.defects or (after.defects >= before.defects and not is_requested):
        return Repair(mesh, tuple(steps), before, before, discarded="it would be no better")
    is_finite = finite(mesh.vertices)
    sound = mesh.faces[is_finite[mesh.faces].all(axis=1)]
    old = (np.where(is_finite[:, None], mesh.vertices, 0.0), sound)
    new = (soup.points, soup.faces)
    lost, gained = directed_distance(*old, *new), directed_distance(*new, *old)
    return Repair(mesh_of(soup, mesh), tuple(steps), before, after, lost, gained)
