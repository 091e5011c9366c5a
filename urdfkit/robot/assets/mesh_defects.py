"""The defects of meshes that the triangles in them show."""

from __future__ import annotations

import os
from enum import Enum
from itertools import product
from math import hypot

from urdfkit.core.static_typing import TYPE_CHECKING
from urdfkit.mesh.io.referenced_files import find_image
from urdfkit.mesh.measures import OVERLAP

if TYPE_CHECKING:
    from collections.abc import Callable

    from urdfkit.robot.assets.mesh_uses import MeshUse
    from urdfkit.robot.model import RobotModel

#: Triangles of a collision mesh over which simulation and planning become slow.
DENSE_COLLISION = 20_000

#: Triangles of a visual mesh over which loading and drawing a robot becomes slow.
DENSE_VISUAL = 100_000

#: Triangles of a mesh that serves as visual and collision, over which a simpler one is worth it.
DENSE_SHARED = 5_000

#: A part this many m long is no part of a robot, if the rest of it is this many times smaller.
HUGE, HUGE_RATIO = 10.0, 20.0

#: A mesh that is shorter, in m, is no part of a robot; and the scale from which on it is to blame.
MICROSCOPIC, SHRINKING = 0.001, 0.01

#: Words of the losses that only concern appearance.
_APPEARANCE = ("normals", "texture coordinates", "material", "colour")

#: What the description of colours in an STL file begins with.
COLOURS = "colours of"


class MeshDefect(Enum):
    """What is wrong with a mesh."""

    PARTLY_UNREADABLE = "partly unreadable"
    MILLIMETRES = "in millimetres"
    MICROSCOPIC = "microscopic by its scale"
    OPEN = "open"
    FLAT = "flat"
    OVERLAPPING = "overlapping pieces"
    INVERTED = "inside out"
    DEGENERATE = "degenerate triangles"
    DENSE_SHARED = "dense visual used for collision"
    DENSE_VISUAL = "dense visual"
    MISSING_TEXTURES = "missing textures"
    MISSING_MATERIALS = "missing material file"
    EXTRAS = "content besides triangles"
    STL_COLOURS = "colours in an STL file"


def find_defects(
    model: RobotModel, uses: list[MeshUse], files: list[MeshUse]
) -> dict[MeshDefect, list[MeshUse]]:
    """The meshes with each defect.

    Args:
        uses: every use of a mesh, in the order of the document.
    """
    found: dict[MeshDefect, list[MeshUse]] = {}
    reported: set[tuple[MeshDefect, str]] = set()
    visuals = [use for use in uses if use.role == "visual"]
    for chosen, tests in ((visuals, OF_APPEARANCE), (files, OF_FILES)):
        for use, (defect, has_it) in product(chosen, tests.items()):
            if (defect, use.path) not in reported and has_it(use):
                reported.add((defect, use.path))
                found.setdefault(defect, []).append(use)
    # What has no joints may be scenery, where a landscape lies next to a tree.
    span = rest_of_robot(model) if model.joints else 0.0
    for use in uses:
        if looks_like_millimetres(use, span):
            found.setdefault(MeshDefect.MILLIMETRES, []).append(use)
        elif is_microscopic(use):
            found.setdefault(MeshDefect.MICROSCOPIC, []).append(use)
    if shared := _dense_shared(uses):
        found[MeshDefect.DENSE_SHARED] = shared
    return found


def missing_textures(use: MeshUse) -> list[str]:
    """The images that a mesh uses and that do not exist, as written."""
    directory = os.path.dirname(use.path)
    return [name for name in use.measures.textures if name and find_image(name, directory) is None]


def extras(use: MeshUse) -> list[str]:
    """What a file holds besides triangles and colours."""
    return [extra for extra in use.measures.extras if not extra.startswith(COLOURS)]


def losses(use: MeshUse) -> list[str]:
    """What is broken in a file and matters: the appearance of a collision does not."""
    found = use.measures.losses
    if use.role == "visual":
        return list(found)
    return [loss for loss in found if not any(word in loss for word in _APPEARANCE)]


def looks_like_millimetres(use: MeshUse, span: float) -> bool:
    """True for a mesh that is huge next to the robot, and of the size of a part in mm.

    Args:
        span: the size of the rest of the robot in m.
    """
    return use.longest > HUGE and 0 < HUGE_RATIO * span < use.longest


def is_microscopic(use: MeshUse) -> bool:
    """True for a mesh that is too small by its scale, and would be a part without it."""
    return max(map(abs, use.shape.scale)) <= SHRINKING and 0 < use.longest < MICROSCOPIC


def rest_of_robot(model: RobotModel) -> float:
    """The size of the robot in m, by its joints and primitives; 0 if they say nothing."""
    offsets = [hypot(*joint.origin.position) for joint in model.joints]
    sizes = [2 * max(shape.half_extents) for shape in model.shapes if shape.half_extents]
    return max((*offsets, *sizes), default=0.0)


def _dense_shared(uses: list[MeshUse]) -> list[MeshUse]:
    """The first collision with each dense file that a visual of the same link has, too."""
    visuals = {(use.link.name, use.path) for use in uses if use.role == "visual"}
    found: dict[str, MeshUse] = {}
    for use in uses:
        is_dense = DENSE_SHARED < use.measures.triangles <= DENSE_COLLISION
        if use.role == "collision" and is_dense and (use.link.name, use.path) in visuals:
            found.setdefault(use.path, use)
    return list(found.values())


def _lacks_materials(use: MeshUse) -> bool:
    """True if nothing else says which colour the mesh has."""
    return bool(use.measures.no_materials) and use.body.material is None


def _is_open(use: MeshUse) -> bool:
    """True also for a sheet with two sides: it has no edge, and encloses nothing."""
    measures = use.measures
    encloses = measures.solid is not None or measures.inverted_bodies > 0
    is_solid = measures.is_closed and encloses
    return use.role == "collision" and measures.hull is not None and not is_solid


def _overlaps(use: MeshUse) -> bool:
    """True if masses that are computed from the mesh are too large; the visual serves at need."""
    return use.measures.overlap > OVERLAP and (use.role == "collision" or not use.link.collisions)


def _is_degenerate(use: MeshUse) -> bool:
    """True if it matters: a visual shows nothing of a few triangles without area."""
    measures = use.measures
    share = measures.degenerate / measures.triangles
    return share > (0.01 if use.role == "visual" else 0)


def _is_flat(use: MeshUse) -> bool:
    return use.role == "collision" and use.measures.hull is None


OF_FILES: dict[MeshDefect, Callable[[MeshUse], bool]] = {
    MeshDefect.OPEN: _is_open,
    MeshDefect.INVERTED: lambda use: use.measures.inside_out or use.measures.inverted_bodies > 0,
    MeshDefect.DEGENERATE: _is_degenerate,
    MeshDefect.DENSE_VISUAL: lambda use: (
        use.role == "visual" and use.measures.triangles > DENSE_VISUAL
    ),
    MeshDefect.OVERLAPPING: _overlaps,
    MeshDefect.EXTRAS: lambda use: bool(extras(use)),
    MeshDefect.FLAT: _is_flat,
    MeshDefect.PARTLY_UNREADABLE: lambda use: bool(losses(use)),
}

#: Of what is irrelevant in a collision.
OF_APPEARANCE: dict[MeshDefect, Callable[[MeshUse], bool]] = {
    MeshDefect.MISSING_TEXTURES: lambda use: bool(missing_textures(use)),
    MeshDefect.STL_COLOURS: lambda use: any(e.startswith(COLOURS) for e in use.measures.extras),
    MeshDefect.PARTLY_UNREADABLE: lambda use: bool(losses(use)),
    MeshDefect.MISSING_MATERIALS: _lacks_materials,
}
