"""Repairing meshes: what was wrong, what was done, and that nothing became worse."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from urdfkit.core.progress import Progress
from urdfkit.core.record import Record
from urdfkit.mesh.distance import one_way
from urdfkit.mesh.geometry import Mesh
from urdfkit.mesh.health import Health, examine, examine_mesh
from urdfkit.mesh.repair.cleaning import (
    drop_back_sides,
    drop_collapsed,
    drop_fins,
    drop_repeated,
    drop_scraps,
    drop_walls,
)
from urdfkit.mesh.repair.holes import fill
from urdfkit.mesh.repair.seams import weld_rims
from urdfkit.mesh.repair.soup import TriangleSoup, mesh_of, soup_of
from urdfkit.mesh.repair.union import unite
from urdfkit.mesh.repair.winding import agree, face_outwards
from urdfkit.mesh.welding import finite

#: Points of open edges this near, as a part of the diagonal, become one.
WELD = 2e-5


#: Steps that are only done if asked for, and then count as a gain.
_ASKED = ("dropped one side of sheets", "united bodies that overlap")

#: What one round leaves behind, such as a fill that meets another one, the next may fix.
_ROUNDS = 3


_Action = Callable[[TriangleSoup], TriangleSoup]


class RepairStep(Record):
    """One thing that was done."""

    name: str  # in the past tense, such as ``closed holes``
    removed: int = 0  # how many faces it took away
    added: int = 0  # how many faces it made
    turned: int = 0  # how many faces it turned over


class Repair(Record):
    """The result of a repair."""

    #: Repaired; the very one that was given if there was nothing to do, or nothing helped.
    mesh: Mesh
    steps: tuple[RepairStep, ...]  # what was done, in order
    #: before and after: the state of the mesh.
    before: Health
    after: Health
    #: How far the old surface lies from the new one at most, in the unit of the mesh.
    lost: float = 0.0
    gained: float = 0.0  # how far the new surface lies from the old one at most
    discarded: str = ""  # why the repair was discarded; empty if it was not

    @property
    def changed(self) -> bool:
        """True if the mesh is another one now."""
        return bool(self.steps) and not self.discarded


def repair(
    mesh: Mesh,
    *,
    holes: bool = True,
    one_sided: bool = False,
    union: bool = False,
    progress: Progress | None = None,
) -> Repair:
    """Make a mesh the surface of a solid, as far as that can be done without inventing much.

    A mesh that is one already is given back as it is.

    Args:
        mesh: any.
        holes: close holes, too.
        one_sided: drop one side of sheets that have two.
        union: make bodies that overlap one; texture coordinates and colours of vertices are lost.
        progress: called with the number of rounds done, and of all; the measuring is the last.
    """
    before = examine_mesh(mesh)
    if before.is_solid and not (union and before.overlap):
        return Repair(mesh, (), before, before)
    soup = soup_of(mesh)
    steps: list[RepairStep] = []
    if before.non_finite:
        steps.append(RepairStep("dropped triangles that are not finite", before.non_finite))
    if one_sided:
        soup = _do(_ASKED[0], drop_back_sides, soup, steps)
    asked = examine(soup.points, soup.faces)
    soup = _rounds(soup, asked, steps, holes=holes, progress=progress)
    if union and (whole := _do(_ASKED[1], unite, soup, steps)) is not soup:
        soup, mesh = whole, _without_vertex_attributes(mesh)
    if not steps:
        return Repair(mesh, (), before, before)
    if progress:
        progress(_ROUNDS, _ROUNDS + 1)
    return _if_better(mesh, soup, _summed(steps), before, asked)


def _rounds(
    soup: TriangleSoup,
    best: Health,
    steps: list[RepairStep],
    *,
    holes: bool,
    progress: Progress | None,
) -> TriangleSoup:
    """Everything once, and again while that helps; what is done is added to the steps."""
    for number in range(_ROUNDS):
        if best.defects == 0:
            break
        if progress:
            progress(number, _ROUNDS + 1)
        more: list[RepairStep] = []
        tried = _round(soup, more, holes=holes)
        state = examine(tried.points, tried.faces)
        if not more or state.defects >= best.defects:
            break
        soup, best = tried, state
        steps += more
    return soup


def _without_vertex_attributes(mesh: Mesh) -> Mesh:
    """Without what belongs to single vertices, such as the places of a texture."""
    parts = [part._replace(uv=None, colors=None) for part in mesh.parts]
    return mesh._replace(parts=tuple(parts))


def _round(soup: TriangleSoup, steps: list[RepairStep], *, holes: bool) -> TriangleSoup:
    """Everything once; what is done is added to the steps."""
    tolerance = WELD * soup.size
    actions: list[tuple[str, _Action]] = [
        ("dropped collapsed triangles", drop_collapsed),
        ("dropped repeated triangles", drop_repeated),
        ("welded open edges", lambda soup: drop_collapsed(weld_rims(soup, tolerance))),
        ("dropped repeated triangles", drop_repeated),
        ("dropped fins", drop_fins),
        ("dropped walls inside", drop_walls),
        ("dropped loose scraps", drop_scraps),
        ("turned triangles to agree with their neighbours", agree),
        *([("closed holes", fill)] if holes else []),
        ("turned bodies outside out", face_outwards),
    ]
    for name, act in actions:
        soup = _do(name, act, soup, steps)
    return soup


def _summed(steps: list[RepairStep]) -> list[RepairStep]:
    """What was done in several rounds, each thing once."""
    sums: dict[str, RepairStep] = {}
    for name, *counts in steps:
        before = sums.get(name, RepairStep(name))
        sums[name] = RepairStep(name, *(a + b for a, b in zip(before[1:], counts, strict=True)))
    return [*sums.values()]


def _do(name: str, act: _Action, soup: TriangleSoup, steps: list[RepairStep]) -> TriangleSoup:
    done = act(soup)
    if done is soup:
        return soup
    change = len(done.faces) - len(soup.faces)
    if change == 0:
        moved = (done.faces != soup.faces).any(axis=1)
        if not moved.any():
            return soup
        same = (np.sort(done.faces, axis=1) == np.sort(soup.faces, axis=1)).all(axis=1)
        steps.append(RepairStep(name, turned=int((moved & same).sum())))
    else:
        steps.append(RepairStep(name, max(0, -change), max(0, change)))
    return done


def _if_better(
    mesh: Mesh, soup: TriangleSoup, steps: list[RepairStep], before: Health, asked: Health
) -> Repair:
    """The repair, or the mesh as it was if the repair is no gain.

    Args:
        asked: its state when what was asked for had been dropped, which may have opened it.
    """
    if not len(soup.faces):
        return Repair(mesh, tuple(steps), before, before, discarded="nothing would be left")
    after = examine_mesh(mesh_of(soup, mesh))
    was_asked = any(step.name in _ASKED for step in steps)
    if after.defects > asked.defects or (after.defects >= before.defects and not was_asked):
        return Repair(mesh, tuple(steps), before, before, discarded="it would be no better")
    is_finite = finite(mesh.vertices)
    sound = mesh.faces[is_finite[mesh.faces].all(axis=1)]
    old = (np.where(is_finite[:, None], mesh.vertices, 0.0), sound)
    new = (soup.points, soup.faces)
    lost, gained = one_way(*old, *new), one_way(*new, *old)
    return Repair(mesh_of(soup, mesh), tuple(steps), before, after, lost, gained)
