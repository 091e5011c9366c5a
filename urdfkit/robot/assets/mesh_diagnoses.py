"""Which meshes are doubtful, each given to the rule that tells it."""

from __future__ import annotations

import os
from math import hypot
from typing import TYPE_CHECKING

from urdfkit.mesh.io.referenced_files import find_image
from urdfkit.mesh.measures import OVERLAP

if TYPE_CHECKING:
    from collections.abc import Callable

    from urdfkit.robot.assets.measured_meshes import MeasuredMeshes, MeshUse

#: Triangles of a collision mesh over which simulation and planning become slow.
DENSE_COLLISION = 20_000

#: Triangles of a mesh over which MuJoCo refuses it.
MUJOCO_MOST = 200_000

#: Triangles of a visual mesh over which loading and drawing a robot becomes slow.
DENSE_VISUAL = 100_000

#: Triangles of a mesh that serves as visual and collision, over which a simpler one is worth it.
DENSE_SHARED = 5_000

#: A part this many m long is no part of a robot, if the rest of it is this many times smaller.
HUGE, HUGE_RATIO = 10.0, 20.0

#: A mesh that is shorter, in m, is no part of a robot; and the scale from which on it is to blame.
GRAIN, SHRINKING = 0.001, 0.01

#: A mesh that begins this many times its own length away from its link is misplaced, from this
#: distance in m on.
FAR_RATIO, FAR = 3.0, 0.3

#: A convex hull with this many times the volume of its pieces fills what is meant to be open.
EMPTY = 3.0

#: Words of the losses that only concern looks.
_OF_LOOKS = ("normals", "texture coordinates", "material", "colour")

#: What an extra begins with that is told by a rule of its own.
COLOURS = "colours of"


def diagnoses(measured: MeasuredMeshes) -> dict[str, list[MeshUse]]:
    """The doubtful meshes by the code of the rule that tells them."""
    found: dict[str, list[MeshUse]] = {}
    reported: set[tuple[str, str]] = set()
    visuals = [use for use in measured.uses if use.role == "visual"]
    for uses, rules in ((visuals, OF_LOOKS), (measured.files, OF_FILES)):
        for use in uses:
            for code, is_doubtful in rules.items():
                if (code, use.path) not in reported and is_doubtful(use):
                    reported.add((code, use.path))
                    found.setdefault(code, []).append(use)
    # What has no joints may be scenery, where a landscape lies beside a tree.
    span = rest_of_robot(measured) if measured.model.joints else 0.0
    shared = _shared(measured)
    for use in measured.uses:
        if looks_like_millimetres(use, span):
            found.setdefault("MSH012", []).append(use)
        elif is_shrunk(use):
            found.setdefault("MSH038", []).append(use)
        elif _is_far(use) and not _has_neighbour(use, measured):
            found.setdefault("MSH032", []).append(use)
        if id(use) in shared:
            found.setdefault("MSH031", []).append(use)
    return found


def missing_textures(use: MeshUse) -> list[str]:
    """The images that a mesh uses and that are not there, as written."""
    folder = os.path.dirname(use.path)
    return [name for name in use.measures.textures if name and find_image(name, folder) is None]


def extras(use: MeshUse) -> list[str]:
    """What a file holds besides triangles and colours."""
    return [extra for extra in use.measures.extras if not extra.startswith(COLOURS)]


def losses(use: MeshUse) -> list[str]:
    """What is broken in a file and matters: nobody sees the looks of a collision."""
    found = use.measures.losses
    if use.role == "visual":
        return list(found)
    return [loss for loss in found if not any(word in loss for word in _OF_LOOKS)]


def looks_like_millimetres(use: MeshUse, span: float) -> bool:
    """True for a mesh that is huge beside the robot, and of the size of a part in mm.

    Args:
        use: the mesh.
        span: the size of the rest of the robot in m.
    """
    return use.longest > HUGE and 0 < HUGE_RATIO * span < use.longest


def is_shrunk(use: MeshUse) -> bool:
    """True for a mesh that its scale makes a grain, and that without it were a part."""
    return max(map(abs, use.shape.scale)) <= SHRINKING and 0 < use.longest < GRAIN


def distance(use: MeshUse) -> float:
    """How far the mesh is from the origin of its link, in m."""
    box = use.box
    return hypot(*(max(low, 0.0, -high) for low, high in zip(box.low, box.high, strict=True)))


def _is_far(use: MeshUse) -> bool:
    return distance(use) > max(FAR, FAR_RATIO * use.longest)


def _has_neighbour(use: MeshUse, measured: MeasuredMeshes) -> bool:
    """True if other meshes of the link lead there: it is the end of a long part.

    Or if the link has the same mesh nearby, too; GEO004 tells that.
    """
    return any(
        other.link is use.link
        and not _is_far(other)
        and (other.path == use.path or _gap(other, use) < use.longest / 2)
        for other in measured.uses
    )


def _gap(one: MeshUse, other: MeshUse) -> float:
    """The distance of the boxes around two meshes of a link, in m."""
    a, b = one.box, other.box
    apart = zip(a.low, a.high, b.low, b.high, strict=True)
    return hypot(*(max(low - top, bottom - high, 0.0) for bottom, top, low, high in apart))


def rest_of_robot(measured: MeasuredMeshes) -> float:
    """The size of the robot in m, by its joints and primitives; 0 if they say nothing."""
    offsets = [hypot(*joint.origin.position) for joint in measured.model.joints]
    sizes = [2 * max(shape.half_extents) for shape in measured.model.shapes if shape.half_extents]
    return max((*offsets, *sizes), default=0.0)


def _shared(measured: MeasuredMeshes) -> set[int]:
    """The collisions with the dense file that a visual of the same link has, too."""
    visuals = {(use.link.name, use.path) for use in measured.uses if use.role == "visual"}
    found: dict[str, MeshUse] = {}
    for use in measured.uses:
        dense = DENSE_SHARED < use.measures.triangles <= DENSE_COLLISION
        if use.role == "collision" and dense and (use.link.name, use.path) in visuals:
            found.setdefault(use.path, use)
    return set(map(id, found.values()))


def _lacks_materials(use: MeshUse) -> bool:
    """True if nothing else says which colour the mesh has."""
    return bool(use.measures.no_materials) and use.body.material is None


def _is_open(use: MeshUse) -> bool:
    """True also for a sheet with two sides: it has no edge, and encloses nothing."""
    measures = use.measures
    encloses = measures.solid is not None or measures.inverted_bodies > 0
    is_solid = measures.is_closed and encloses
    return use.role == "collision" and measures.hull is not None and not is_solid


def _has_gaps(use: MeshUse) -> bool:
    """True for a collision of several pieces in a hull that is mostly empty."""
    measures = use.measures
    if use.role == "visual" or measures.bodies < 2 or not measures.solid or not measures.hull:
        return False
    return measures.hull.volume > EMPTY * measures.solid.volume


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


OF_FILES: dict[str, Callable[[MeshUse], bool]] = {
    "MSH015": _is_open,
    "MSH016": lambda use: use.measures.inside_out or use.measures.inverted_bodies > 0,
    "MSH017": _is_degenerate,
    "MSH020": lambda use: use.role == "visual" and use.measures.triangles > DENSE_VISUAL,
    "MSH022": _overlaps,
    "MSH023": _has_gaps,
    "MSH029": lambda use: bool(extras(use)),
    "MSH033": _is_flat,
    "MSH034": lambda use: bool(losses(use)),
}

#: Of what nobody sees of a collision.
OF_LOOKS: dict[str, Callable[[MeshUse], bool]] = {
    "MSH021": lambda use: bool(missing_textures(use)),
    "MSH028": lambda use: any(extra.startswith(COLOURS) for extra in use.measures.extras),
    "MSH034": lambda use: bool(losses(use)),
    "MSH037": _lacks_materials,
}
