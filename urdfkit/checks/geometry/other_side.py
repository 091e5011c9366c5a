"""Links with the mesh of their left or right counterpart."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator

from urdfkit.core.grouping import by_key
from urdfkit.core.record import Record
from urdfkit.lint.context import Context
from urdfkit.robot.assets.mesh_files import MeshReference
from urdfkit.robot.fingers import finger_of, odd_one, series, with_finger
from urdfkit.robot.symmetry import pairs

#: Least number of pairs of links with a mesh for each side next to one with the same mesh.
_CONSISTENT_PAIRS = 2


class MeshOfOtherSide(Record):
    """A visual or collision with the mesh of the other side."""

    wrong: MeshReference
    correct: MeshReference  # of the counterpart, or the visual of the same link
    unused: str  # name of the file of its own side


def meshes_of_the_other_side(context: Context) -> Iterator[MeshOfOtherSide]:
    """The visual with the mesh of the other side, if it is the only one of several pairs.

    The file of its own side must exist, and no link use it.
    """
    meshes = context.files.meshes
    visuals = [mesh for mesh in meshes if mesh.role == "visual" and mesh.located.path]
    of_link = by_key((mesh.link.name, mesh) for mesh in visuals)
    used = {mesh.located.path for mesh in meshes}
    copied: list[MeshOfOtherSide] = []
    consistent = 0
    for left, right in pairs(of_link):
        if len(of_link[left]) > 1 or len(of_link[right]) > 1:
            continue
        (first,), (second,) = of_link[left], of_link[right]
        files = [os.path.basename(mesh.located.path or "") for mesh in (first, second)]
        if first.located.path != second.located.path:
            consistent += bool(pairs(files))
            continue
        shapes = first.body.shape, second.body.shape
        if all(shapes) and len({shape.scale for shape in shapes if shape}) == 1:  # not mirrored
            copied += _with_unused_file(context, first, second, used)
    if len(copied) == 1 and consistent >= _CONSISTENT_PAIRS:
        yield copied[0]


def meshes_of_another_finger(context: Context) -> Iterator[MeshOfOtherSide]:
    """The visual with the mesh of another finger, if it is the only one of four or more fingers.

    The file of its own finger must exist, and no link use it.
    """
    meshes = context.files.meshes
    of_link = by_key((mesh.link.name, mesh) for mesh in meshes if mesh.role == "visual")
    used = {os.path.basename(mesh.located.path) for mesh in meshes if mesh.located.path}
    for names in series(of_link):
        shown = {name: os.path.basename(of_link[name][0].located.path or "") for name in names}
        is_own = {
            name: finger_of(file).lower() == finger_of(name).lower() for name, file in shown.items()
        }
        odd = odd_one(is_own)
        if odd is None or not odd[1] or any(len(of_link[name]) > 1 for name in names):
            continue
        wrong = of_link[odd[0]][0]
        other = next(
            (name for name in names if name != odd[0] and shown[name] == shown[odd[0]]), ""
        )
        directory, file = os.path.split(wrong.located.path or "")
        own = with_finger(file, finger_of(odd[0])).lower()
        for unused in context.resolver.directories.entries(directory) or () if other else ():
            if unused.lower() == own and unused not in used:
                yield MeshOfOtherSide(wrong, of_link[other][0], unused)


def collisions_of_the_other_side(context: Context) -> Iterator[MeshOfOtherSide]:
    """Collisions with the mesh of the other side than the visual of their link.

    The file of their own side must exist, and no link use it.
    """
    of_link = by_key((mesh.link.name, mesh) for mesh in context.files.meshes if mesh.located.path)
    used = {mesh.located.path for mesh in context.files.meshes}
    for meshes in of_link.values():
        if sorted(mesh.role for mesh in meshes) != ["collision", "visual"]:
            continue
        collision, visual = sorted(meshes, key=lambda mesh: mesh.role)
        path, seen = collision.located.path or "", _part(visual.located.path or "")
        if not pairs((seen, _part(path))):
            continue
        directory = os.path.dirname(path)
        for other in context.resolver.directories.entries(directory) or ():
            if _part(other) == seen and os.path.join(directory, other) not in used:
                yield MeshOfOtherSide(collision, visual, other)
                break


def _part(path: str) -> str:
    """The name of the part that a mesh file shows, in any role and format."""
    name = os.path.basename(path).partition(".")[0].lower()
    return re.sub(r"_?(collision|visual)_?", "", name)


def _with_unused_file(
    context: Context, left: MeshReference, right: MeshReference, used: set[str | None]
) -> Iterator[MeshOfOtherSide]:
    directory, name = os.path.split(left.located.path or "")
    for other in context.resolver.directories.entries(directory) or ():
        if os.path.join(directory, other) not in used and (pair := pairs((name, other))):
            is_left = pair[0][0] == name  # so that the right link has it by mistake
            wrong, correct = (right, left) if is_left else (left, right)
            yield MeshOfOtherSide(wrong, correct, other)
