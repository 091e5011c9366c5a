"""Comparison of meshes by the distance of their surfaces, not by their bytes."""

import hashlib
import posixpath
from collections.abc import Iterator

from urdfkit.core import disk
from urdfkit.core.installation import install_command
from urdfkit.errors import MissingLibrary, Unavailable
from urdfkit.lint.context import Context
from urdfkit.output.comparison.differences import Difference, RenamedParts, Tolerances
from urdfkit.robot.link import Shape


def changed_surfaces(
    before: Context, after: Context, allowed: Tolerances, names: RenamedParts
) -> tuple[list[Difference], list[str]]:
    """Meshes whose surfaces differ by more than the tolerance of positions.

    Meshes of links with an unchanged number of visuals, or collisions, are compared, each in the
    frame of its visual or collision and with its scale.

    Returns:
        The differences, and sentences on parts that could not be compared.
    """
    differences: list[Difference] = []
    notes: dict[str, None] = {}
    measured: dict[tuple[object, ...], float | None] = {}
    for link, role, old, new in _pairs(before, after, names):
        files = before.files.path(old), after.files.path(new)
        if files[0] is None or files[1] is None:
            if files[0] is not files[1]:
                found = "found now" if files[1] else "not found any more"
                text = f"the file of its {role} mesh {_name(new if files[1] else old)} is {found}"
                differences.append(Difference("meshes", "link", link, text, *map(bool, files)))
            continue
        if old.scale == new.scale and _digest(files[0]) == _digest(files[1]):
            continue
        key = (*files, old.scale, new.scale)
        if key not in measured:
            try:
                measured[key] = _distance(before, old, after, new)
            except (ImportError, MissingLibrary, Unavailable):
                needed = install_command("meshes")
                notes[f"the distance between meshes needs: {needed}"] = None
                measured[key] = None
        deviation = measured[key]
        if deviation is None:
            text = f"the file of its {role} mesh {_name(new)} differs"
            differences.append(Difference("meshes", "link", link, text))
        elif deviation > allowed.position:
            text = f"its {role} mesh {_name(new)} differs by up to {1000 * deviation:.4g} mm"
            differences.append(Difference("meshes", "link", link, text, 0.0, deviation))
    return differences, list(notes)


def _pairs(
    before: Context, after: Context, names: RenamedParts
) -> Iterator[tuple[str, str, Shape, Shape]]:
    """Link, role, and the mesh before and after."""
    links = after.model.links_by_name
    for name, old in before.model.links_by_name.items():
        new = links.get(names.links.get(name, name))
        if new is None:
            continue
        for role, bodies in (
            ("visual", (old.visuals, new.visuals)),
            ("collision", (old.collisions, new.collisions)),
        ):
            if len(bodies[0]) != len(bodies[1]):
                continue
            for one, other in zip(*bodies, strict=True):
                shapes = one.shape, other.shape
                if shapes[0] and shapes[1] and shapes[0].filename and shapes[1].filename:
                    yield new.name, role, shapes[0], shapes[1]


def _name(shape: Shape) -> str:
    """The name of a mesh file, without its directory."""
    return repr(posixpath.basename(shape.filename.value)) if shape.filename else ""


def _digest(path: str) -> bytes:
    return hashlib.sha256(disk.read(path)).digest()


def _distance(before: Context, old: Shape, after: Context, new: Shape) -> float | None:
    """The distance of two surfaces in m; None if a file has no triangles."""
    meshes = before.meshes.mesh(old), after.meshes.mesh(new)
    vertices = before.meshes.vertices(old), after.meshes.vertices(new)
    if meshes[0] is None or meshes[1] is None or vertices[0] is None or vertices[1] is None:
        return None
    from urdfkit.mesh.distance import distance

    return distance(vertices[0], meshes[0].faces, vertices[1], meshes[1].faces)
