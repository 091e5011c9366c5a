"""Defects of meshes that are found in their triangles."""

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

#: A mesh longer than this, in m, is not a part of a robot that is smaller by this factor.
HUGE, HUGE_RATIO = 10.0, 20.0

#: A mesh shorter than this, in m, is not a part of a robot; the cause is a scale up to this.
MICROSCOPIC, SHRINKING = 0.001, 0.01

#: Words in losses that concern only the appearance.
_APPEARANCE = ("normals", "texture coordinates", "material", "colour")

#: Prefix of the description of colours in an STL file.
COLOURS = "colours of"


class MeshDefect(Enum):
    """The defect of a mesh."""

    PARTLY_UNREADABLE = "partly unreadable"
    MILLIMETRES = "in millimetres"
    MICROSCOPIC = "microscopic by its scale"
    OPEN = "open"
    FLAT = "flat"
    OVERLAPPING = "overlapping pieces"
    INVERTED = "inside out"
    DEGENERATE = "degenerate triangles"
    MISSING_TEXTURES = "missing textures"
    MISSING_MATERIALS = "missing material file"
    EXTRAS = "content besides triangles"
    STL_COLOURS = "colours in an STL file"


def find_defects(
    model: RobotModel, uses: list[MeshUse], files: list[MeshUse]
) -> dict[MeshDefect, list[MeshUse]]:
    """The meshes with each defect.

    Args:
        uses: all uses of meshes, in document order.
    """
    defects: dict[MeshDefect, list[MeshUse]] = {}
    reported: set[tuple[MeshDefect, str]] = set()
    visuals = [use for use in uses if use.role == "visual"]
    for chosen, tests in ((visuals, OF_APPEARANCE), (files, OF_FILES)):
        for use, (defect, has_it) in product(chosen, tests.items()):
            if (defect, use.path) not in reported and has_it(use):
                reported.add((defect, use.path))
                defects.setdefault(defect, []).append(use)
    # A model without joints may be scenery, with a landscape next to a tree.
    span = rest_of_robot(model) if model.joints else 0.0
    for use in uses:
        if looks_like_millimetres(use, span):
            defects.setdefault(MeshDefect.MILLIMETRES, []).append(use)
        elif is_microscopic(use):
            defects.setdefault(MeshDefect.MICROSCOPIC, []).append(use)
    return defects


def missing_textures(use: MeshUse) -> list[str]:
    """Missing images of a mesh, as written."""
    directory = os.path.dirname(use.path)
    return [name for name in use.measures.textures if name and find_image(name, directory) is None]


def extras(use: MeshUse) -> list[str]:
    """Contents of a file other than triangles and colours."""
    return [extra for extra in use.measures.extras if not extra.startswith(COLOURS)]


def losses(use: MeshUse) -> list[str]:
    """Unreadable contents of a file; for a collision, without those of the appearance."""
    messages = use.measures.losses
    if use.role == "visual":
        return list(messages)
    return [loss for loss in messages if not any(word in loss for word in _APPEARANCE)]


def looks_like_millimetres(use: MeshUse, span: float) -> bool:
    """True for a mesh that is huge compared with the robot, and plausible in mm.

    Args:
        span: the size of the rest of the robot in m.
    """
    return use.longest > HUGE and 0 < HUGE_RATIO * span < use.longest


def is_microscopic(use: MeshUse) -> bool:
    """True for a mesh that only its scale makes too small."""
    return max(map(abs, use.shape.scale)) <= SHRINKING and 0 < use.longest < MICROSCOPIC


def rest_of_robot(model: RobotModel) -> float:
    """Size of the robot in m, from its joints and primitives; 0 if unknown."""
    offsets = [hypot(*joint.origin.position) for joint in model.joints]
    sizes = [2 * max(shape.half_extents) for shape in model.shapes if shape.half_extents]
    return max((*offsets, *sizes), default=0.0)


def _lacks_materials(use: MeshUse) -> bool:
    """True if neither the file nor the URDF defines the colour."""
    return bool(use.measures.no_materials) and use.body.material is None


def _is_open(use: MeshUse) -> bool:
    """True also for a two-sided sheet: it has no boundary edge but encloses no volume."""
    measures = use.measures
    encloses = measures.solid is not None or measures.inverted_bodies > 0
    is_solid = measures.is_closed and encloses
    return use.role == "collision" and measures.hull is not None and not is_solid


def _overlaps(use: MeshUse) -> bool:
    """True if overlaps increase a mass computed from the collision, or the visual without one."""
    return use.measures.overlap > OVERLAP and (use.role == "collision" or not use.link.collisions)


def _is_degenerate(use: MeshUse) -> bool:
    """True if the degenerate triangles matter; a few of them are invisible in a visual."""
    measures = use.measures
    share = measures.degenerate / measures.triangles
    return share > (0.01 if use.role == "visual" else 0)


def _is_flat(use: MeshUse) -> bool:
    return use.role == "collision" and use.measures.hull is None


OF_FILES: dict[MeshDefect, Callable[[MeshUse], bool]] = {
    MeshDefect.OPEN: _is_open,
    MeshDefect.INVERTED: lambda use: use.measures.inside_out or use.measures.inverted_bodies > 0,
    MeshDefect.DEGENERATE: _is_degenerate,
    MeshDefect.OVERLAPPING: _overlaps,
    MeshDefect.EXTRAS: lambda use: bool(extras(use)),
    MeshDefect.FLAT: _is_flat,
    MeshDefect.PARTLY_UNREADABLE: lambda use: bool(losses(use)),
}

#: Defects that are irrelevant in a collision.
OF_APPEARANCE: dict[MeshDefect, Callable[[MeshUse], bool]] = {
    MeshDefect.MISSING_TEXTURES: lambda use: bool(missing_textures(use)),
    MeshDefect.STL_COLOURS: lambda use: any(e.startswith(COLOURS) for e in use.measures.extras),
    MeshDefect.PARTLY_UNREADABLE: lambda use: bool(losses(use)),
    MeshDefect.MISSING_MATERIALS: _lacks_materials,
}
