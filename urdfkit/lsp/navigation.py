"""From a name to where it is given, to where it is used, and to another name."""

import os
import re
from collections.abc import Iterator

from urdfkit.errors import UrdfkitError
from urdfkit.lsp.markup import Page, TagNode, WrittenAttribute, cursor
from urdfkit.lsp.names import NameUse
from urdfkit.lsp.open_robot import OpenRobot
from urdfkit.lsp.references import package_references, reference_at
from urdfkit.ros.launch.contents import FileUse
from urdfkit.text.diagnostic import Edit
from urdfkit.text.file_kinds import is_launch
from urdfkit.text.source import Source, Span
from urdfkit.workspace.package_references import FIND

_IDENTIFIER = re.compile(r"[A-Za-z_]\w*")


class CannotRename(UrdfkitError):
    """The name cannot be changed by edits of text; the message says why."""


def definitions(robot: OpenRobot, page: Page, offset: int) -> list[Span]:
    """Where the name, the package or the file at a place is given."""
    if found := _file(robot, page, offset):
        return [Span(found, 0, 0)]
    name = _name(robot, page, offset)
    if name is None:
        return []
    if name.kind == "package":
        directory = robot.resolver.packages.known(page.source.path).get(name.text)
        manifest = os.path.join(directory or "", "package.xml")
        return [Span(robot.source(manifest), 0, 0)] if os.path.isfile(manifest) else []
    return [one.span for one in robot.names.same(name) if one.is_definition]


def references(robot: OpenRobot, page: Page, offset: int, *, definitions: bool) -> list[Span]:
    """Where the name at a place is used, and where it is given if that is asked for."""
    name = _name(robot, page, offset)
    if name is None:
        return []
    same = robot.names.same(name)
    own = [one.span for one in same if definitions or not one.is_definition]
    return own + _elsewhere(robot, name, same)


def _name(robot: OpenRobot, page: Page, offset: int) -> NameUse | None:
    """The name at a place, be it in a file that is none of the robot's own."""
    found = reference_at(page.source, offset)
    if found is None:
        return robot.names.at(page.source, offset)
    kind, span = found
    given = (one for one in robot.names.all if one.is_definition and one.kind == kind)
    nodes = [one.node for one in given if span.text in robot.names.values(one)]
    return NameUse(kind, span.text, span, False, nodes[0]) if nodes else None


def _elsewhere(robot: OpenRobot, name: NameUse, same: list[NameUse]) -> list[Span]:
    """Where other files of the package name a link or a joint."""
    kinds = {one.kind for one in same if one.is_definition} & {"link", "joint"}
    if not kinds:
        return []
    values = robot.names.values(name)
    own = {*robot.sources, *(robot.before.sources if robot.before else ())}
    found = package_references(values, robot.path, own, robot.resolver)
    return [one.span for one in found if one.kind in kinds]


def _file(robot: OpenRobot, page: Page, offset: int) -> Source | None:
    """The file that an include, a mesh, a texture or a launch file names at a place."""
    name = robot.names.at(page.source, offset)
    if name is not None and name.kind == "package":
        return None  # the cursor is on the package
    path = _launched if is_launch(page.source.path) else _described
    found = path(robot, page, offset)
    return Source(found, b"") if found else None  # opened by the editor; only the path counts


def links(robot: OpenRobot, page: Page) -> Iterator[tuple[Span, str]]:
    """The places that name a file which exists, each with its path."""
    if is_launch(page.source.path):
        yield from ((file.span, file.path) for file in _launch_files(robot, page))
        return
    for node in page.nodes:
        for written in node.attributes:
            path = _named(robot, node, written) if written.value_span else None
            if path and written.value_span:
                yield written.value_span, path


def _launch_files(robot: OpenRobot, page: Page) -> list[FileUse]:
    """The files that exist and that a launch file names itself."""
    return [
        file
        for file in robot.context.launch.files
        if file.exists and file.span.source.path == page.source.path
    ]


def _launched(robot: OpenRobot, page: Page, offset: int) -> str | None:
    """The file of the innermost reference at a place in a launch file."""
    files = _launch_files(robot, page)
    around = [file for file in files if file.span.start <= offset <= file.span.end]
    nearest = min(around, key=lambda file: file.span.end - file.span.start, default=None)
    return nearest.path if nearest else None


def _described(robot: OpenRobot, page: Page, offset: int) -> str | None:
    """The file that a tag of a description names."""
    here = cursor(page, offset)
    if here.place != "value" or here.node is None or here.attribute is None:
        return None
    return _named(robot, here.node, here.attribute)


def _named(robot: OpenRobot, node: TagNode, written: WrittenAttribute) -> str | None:
    """The file that an attribute names; of several calls of a macro, that of the last."""
    if written.name != "filename" or node.name not in ("mesh", "texture", "xacro:include"):
        return None
    value = (robot.names.expanded(node, "filename") or [written.value])[-1]
    if node.name == "xacro:include":
        value = re.sub(FIND, r"package://\1", value).replace("$(dirname)/", "")
    return robot.resolver.locate(value, node.source.path, robot.path).path


# ------------------------------------------------------------------- renaming


def renamable(robot: OpenRobot, page: Page, offset: int) -> NameUse:
    """The name at a place, if it can be changed everywhere.

    Raises:
        CannotRename: with the reason.
    """
    name = _name(robot, page, offset)
    if name is None or name.kind == "package":
        raise CannotRename("no name to rename here")
    same = robot.names.same(name)
    if not any(one.is_definition for one in same):
        raise CannotRename(f"'{name.text}' is not defined in this robot")
    for one in same:
        if one.is_computed:
            place = f"{os.path.basename(one.span.source.path)}:{one.span.line}"
            raise CannotRename(f"'{one.text}' at {place} comes from an expression; change it there")
    return name


def rename(robot: OpenRobot, page: Page, offset: int, new: str) -> list[Edit]:
    """The edits that give the name at a place another text.

    Raises:
        CannotRename: with the reason.
    """
    name = renamable(robot, page, offset)
    if name.kind in ("macro", "property", "parameter", "arg") and not _IDENTIFIER.fullmatch(new):
        raise CannotRename(
            f"'{new}' is not a valid name for a {name.kind}: letters, digits and '_'"
        )
    if not new.strip() or set(new) & set("<>&\"'${}") or new != new.strip():
        raise CannotRename(f"'{new}' is not a valid name")
    same = robot.names.same(name)
    kinds = {one.kind for one in same if one.is_definition}
    if new in robot.given(*kinds):
        raise CannotRename(f"there is already a {name.kind} '{new}'")
    return [
        Edit(span, new) for span in (*(one.span for one in same), *_elsewhere(robot, name, same))
    ]
