"""Navigation and renaming: definitions, references, links to files, edits of a new name."""

import os
import re
from collections.abc import Collection, Iterable, Iterator, Sequence

from urdfkit.errors import UrdfkitError
from urdfkit.lsp.markup import Markup, TagNode, WrittenAttribute
from urdfkit.lsp.names import NameUse
from urdfkit.lsp.open_robot import OpenRobot
from urdfkit.lsp.references import package_references, reference_at
from urdfkit.text.diagnostic import Edit
from urdfkit.text.file_kinds import is_launch
from urdfkit.text.source import Source, Span
from urdfkit.workspace.package_references import FIND

_IDENTIFIER = re.compile(r"[A-Za-z_]\w*")


class CannotRename(UrdfkitError):
    """The name cannot be changed by text edits; the message states the reason."""


def definitions(robot: OpenRobot, markup: Markup, offset: int) -> list[Span]:
    """Definitions of the name, package or file at an offset."""
    if source := _file(robot, markup, offset):
        return [Span(source, 0, 0)]
    name = _name(robot, markup, offset)
    if name is None:
        return []
    if name.kind == "package":
        directory = robot.resolver.packages.known(markup.source.path).get(name.text)
        manifest = os.path.join(directory or "", "package.xml")
        return [Span(robot.source(manifest), 0, 0)] if os.path.isfile(manifest) else []
    return [use.span for use in robot.names.occurrences(name) if use.is_definition]


def references(
    robot: OpenRobot,
    markup: Markup,
    offset: int,
    *,
    definitions: bool,
    others: Sequence[OpenRobot] = (),
) -> list[Span]:
    """References of the name at an offset, with its definitions if requested.

    Args:
        others: further robots that the file belongs to.
    """
    robots = (robot, *others)
    spans: list[Span] = []
    for each in robots:
        name = _name(each, each.markup(markup.source.path), offset)
        if name is not None:
            same = each.names.occurrences(name)
            spans += [use.span for use in same if definitions or not use.is_definition]
            spans += _package_uses(each, name, same, _files_of(robots))
    return _distinct(spans)


def _distinct(spans: Iterable[Span]) -> list[Span]:
    """The spans, each once: robots may share files."""
    places = {(os.path.realpath(span.source.path), *span[1:]): span for span in reversed([*spans])}
    return list(places.values())[::-1]


def _name(robot: OpenRobot, markup: Markup, offset: int) -> NameUse | None:
    """The name at an offset, also in a file that does not belong to the robot."""
    reference = reference_at(markup.source, offset)
    if reference is None:
        return robot.names.at(markup.source, offset)
    kind, span = reference
    defined = (use for use in robot.names.all if use.is_definition and use.kind == kind)
    nodes = [use.node for use in defined if span.text in robot.names.values(use)]
    return NameUse(kind, span.text, span, False, nodes[0]) if nodes else None


def _package_uses(
    robot: OpenRobot, name: NameUse, same: list[NameUse], own: Collection[str]
) -> list[Span]:
    """References to a link or joint in other files of the package than those of the robots."""
    kinds = {use.kind for use in same if use.is_definition} & {"link", "joint"}
    if not kinds:
        return []
    values = robot.names.values(name)
    references = package_references(values, robot.path, own, robot.resolver)
    return [use.span for use in references if use.kind in kinds]


def _files_of(robots: Iterable[OpenRobot]) -> set[str]:
    """The real paths of the files of robots, also of their last readable state."""
    states = (state for robot in robots for state in (robot, robot.before) if state)
    return {path for state in states for path in state.sources}


def _file(robot: OpenRobot, markup: Markup, offset: int) -> Source | None:
    """The file that an include, mesh, texture or launch file references at an offset."""
    name = robot.names.at(markup.source, offset)
    if name is not None and name.kind == "package":
        return None  # the cursor is on the package
    around = [link for link in links(robot, markup) if link[0].start <= offset <= link[0].end]
    _, path = min(around, key=lambda link: link[0].end - link[0].start, default=(None, ""))
    return Source(path, b"") if path else None  # the editor opens it; only the path matters


def links(robot: OpenRobot, markup: Markup) -> Iterator[tuple[Span, str]]:
    """References to existing files, each with the path."""
    if is_launch(markup.source.path):
        for file in robot.context.launch.files:
            if file.exists and file.span.source.path == markup.source.path:
                yield file.span, file.path
        return
    for node in markup.nodes:
        for written in node.attributes:
            path = _referenced_file(robot, node, written) if written.value_span else None
            if path and written.value_span:
                yield written.value_span, path


def _referenced_file(robot: OpenRobot, node: TagNode, written: WrittenAttribute) -> str | None:
    """The file that an attribute references; for several macro calls, that of the last."""
    if written.name != "filename" or node.name not in ("mesh", "texture", "xacro:include"):
        return None
    value = (robot.names.expanded(node, "filename") or [written.value])[-1]
    if node.name == "xacro:include":
        value = re.sub(FIND, r"package://\1", value).replace("$(dirname)/", "")
    return robot.resolver.locate(value, node.source.path, robot.path).path


# ------------------------------------------------------------------- renaming


def renamable(robot: OpenRobot, markup: Markup, offset: int) -> NameUse:
    """The name at an offset, if it can be renamed.

    Raises:
        CannotRename: with the reason.
    """
    name = _name(robot, markup, offset)
    if name is None or name.kind == "package":
        raise CannotRename("no name to rename here")
    same = robot.names.occurrences(name)
    if not any(use.is_definition for use in same):
        raise CannotRename(f"'{name.text}' is not defined in this robot")
    for use in same:
        place = f"{os.path.basename(use.span.source.path)}:{use.span.line}"
        if use.span.text == "^":
            raise CannotRename(f"the macro at {place} forwards '{use.text}' by its name")
        if use.is_computed:
            raise CannotRename(f"'{use.text}' at {place} comes from an expression; change it there")
    return name


def rename(
    robot: OpenRobot, markup: Markup, offset: int, new: str, others: Sequence[OpenRobot] = ()
) -> list[Edit]:
    """The edits that rename the name at an offset.

    Args:
        others: further robots that the file belongs to, which use the name as well.

    Raises:
        CannotRename: with the reason.
    """
    name = renamable(robot, markup, offset)
    if name.kind in ("macro", "property", "parameter", "arg") and not _IDENTIFIER.fullmatch(new):
        raise CannotRename(
            f"'{new}' is not a valid name for a {name.kind}: letters, digits and '_'"
        )
    if not new.strip() or set(new) & set("<>&\"'${}") or new != new.strip():
        raise CannotRename(f"'{new}' is not a valid name")
    robots = (robot, *others)
    for each in robots:
        own = each.markup(markup.source.path)
        if each is not robot and not _is_defined(each, own, offset):
            continue
        same = each.names.occurrences(renamable(each, own, offset))
        kinds = {use.kind for use in same if use.is_definition}
        if new in each.defined(*kinds):
            raise CannotRename(f"there is already a {name.kind} '{new}'")
    spans = references(robot, markup, offset, definitions=True, others=others)
    return [Edit(span, new) for span in spans]


def _is_defined(robot: OpenRobot, markup: Markup, offset: int) -> bool:
    """True if a robot defines the name at an offset."""
    name = _name(robot, markup, offset)
    return name is not None and any(use.is_definition for use in robot.names.occurrences(name))
