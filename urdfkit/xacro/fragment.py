"""Files that are a part of a robot: their missing names are defined by the including file."""

import os
import re
from collections.abc import Iterable, Sequence

from urdfkit.core import disk
from urdfkit.core.words import few
from urdfkit.text.comments import without_comments
from urdfkit.text.diagnostic import Problem, Severity
from urdfkit.text.source import Source, Span, shown
from urdfkit.workspace.file_head import read_head
from urdfkit.workspace.includes import MAX_BYTES, top_includer
from urdfkit.workspace.packages import Packages
from urdfkit.xacro.dom import Dom, Node
from urdfkit.xacro.errors import FAILED

#: Most names in a message.
_MAX_NAMED = 3
#: Missing names from which a ``<robot>`` without a name is a part: fewer may be mistakes.
_MIN_MISSING = 4
#: Most files next to a file that are searched for what it lacks.
_MAX_FILES = 100

_DEFINED = re.compile(rb"""<xacro:(?:macro|property|arg)\s[^<>]*?\bname\s*=\s*["'](\w+)["']""")

_LINK = re.compile(rb"<link\b")
_ADDED = re.compile(rb"<(?:gazebo|ros2_control|transmission)\b")

#: Not those that a ``<property>`` without prefix should define: the file itself is wrong.
_MISSING = re.compile(
    r"(?:macro|name|argument|block) '([^']+)' (?:is not defined(?!: xacro ignores)|has no value)"
)


def merge_missing_names(
    sources: Sequence[Source], packages: Packages, problems: list[Problem], document: Dom | None
) -> list[Problem]:
    """The problems of a file; all missing names become one hint if another file includes it.

    The same applies if no file includes it, but its parent links are not in the file, or it has no
    name and lacks many names, or those of the files next to it: a program may write the including
    file, or another repository have it. It is a warning if the file has the name of a robot, unless
    it only adds to the links of another file, such as the plugins of a simulator.

    The including file defines these names before the include. They are not an error of the part,
    and the robot is checked by checking the including file.

    Args:
        sources: the file, and those that it includes.
    """
    source = sources[0]
    missing = {number: name for number, item in enumerate(problems) if (name := _missing(item))}
    if not missing:
        return problems
    distinct = dict.fromkeys(missing.values())
    top = top_includer(source.path, packages)
    severity = Severity.INFO
    if top is None:
        root = document.documentElement if document else None
        is_addition = len(missing) == len(problems) and _is_addition(sources, problems)
        is_fragment = root is not None and (is_addition or _is_fragment(root, len(distinct)))
        if root is None or not (is_fragment or _is_completed(root, source, distinct)):
            return problems
        is_named = root.hasAttribute("name") and not is_addition
        top, severity = "", Severity.WARNING if is_named else Severity.INFO
    names = few([f"'{name}'" for name in distinct], _MAX_NAMED)
    robot = os.path.relpath(top, os.path.dirname(os.path.abspath(source.path))) if top else ""
    message = f"a part of {robot or 'another file'}, which must define {names}"
    help = "include it in the robot that defines what is missing"
    if top:
        help = f"check the robot instead: urdfkit check {shown(top)}"
    at, frame = Span(source, 0, 0), problems[next(iter(missing))].frame
    hint = Problem("XAC001", at, message, help, frame, severity=severity)
    return [hint, *(item for number, item in enumerate(problems) if number not in missing)]


def _is_addition(sources: Iterable[Source], problems: Iterable[Problem]) -> bool:
    """True if no file has a link or lacks a macro, which might define one, but there are tags.

    The robot may include the file with an argument, such as ``extra_xacro``.
    """
    if any("macro '" in problem.message for problem in problems):
        return False
    texts = [without_comments(source.data) for source in sources]
    return not any(_LINK.search(text) for text in texts) and any(map(_ADDED.search, texts))


def _is_fragment(root: Node, missing: int) -> bool:
    """True if all links have a parent; for a ``<robot>`` without a name, if it lacks many names."""
    links = {link.getAttribute("name") for link in root.getElementsByTagName("link")}
    children = {child.getAttribute("link") for child in root.getElementsByTagName("child")}
    have_parents = bool(links) and links <= children
    if root.hasAttribute("name"):
        return have_parents and not any(FAILED in name for name in links)  # unknown names are equal
    return have_parents or (bool(links) and missing >= _MIN_MISSING)


def _is_completed(root: Node, source: Source, missing: Iterable[str]) -> bool:
    """True for a ``<robot>`` with no name and no includes if files next to it define all names."""
    if root.hasAttribute("name") or b":include" in source.data:
        return False
    directory = os.path.dirname(os.path.abspath(source.path))
    own = os.path.basename(source.path)
    _, _, files = next(iter(disk.walk(directory)), ("", [], []))
    others = [name for name in sorted(files) if name.endswith(".xacro") and name != own]
    heads = (read_head(os.path.join(directory, name), MAX_BYTES) for name in others[:_MAX_FILES])
    defined = {name.decode() for head in heads for name in _DEFINED.findall(head)}
    return defined.issuperset(missing)


def _missing(problem: Problem) -> str:
    """The missing name of a problem that another file may define; empty for other problems."""
    if problem.code not in ("XAC001", "XAC010"):
        return ""
    match = _MISSING.search(problem.message)
    return match.group(1) if match else ""
