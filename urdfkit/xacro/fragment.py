"""A file that is a part of a robot: what it lacks comes from the file that includes it."""

import os
import re

from urdfkit.core.words import few
from urdfkit.text.diagnostic import Problem, Severity
from urdfkit.text.source import Source, Span, shown
from urdfkit.workspace.includes import top_includer
from urdfkit.workspace.packages import Packages
from urdfkit.xacro.dom import Dom, Node

#: Names that a message lists.
_SHOWN = 3

_LACKING = re.compile(r"(?:macro|name|argument|block) '([^']+)' (?:is not defined|has no value)")


def as_part(
    source: Source, packages: Packages, problems: list[Problem], document: Dom | None
) -> list[Problem]:
    """The problems of a file; if another file includes it, the names it lacks are one hint.

    So they are if no file does any more, and the parent links are not in the file.

    Checked alone, such a part lacks what the including file defines before the include. That is
    no error of the part, and the robot is checked by checking the other file.
    """
    lacking = {number: name for number, one in enumerate(problems) if (name := _lacking(one))}
    if not lacking:
        return problems
    top = top_includer(source.path, packages)
    if top is None:
        if document is None or not _is_loose(document.documentElement):
            return problems
        top = ""
    names = list(dict.fromkeys(lacking.values()))
    which = few([f"'{name}'" for name in names], _SHOWN)
    whole = os.path.relpath(top, os.path.dirname(os.path.abspath(source.path))) if top else ""
    message = f"a part of {whole or 'another file'}, which must define {which}"
    first = next(iter(lacking))
    at, frame = Span(source, 0, 0), problems[first].frame
    hint = Problem("XAC001", at, message, _help(top), frame, severity=Severity.INFO)
    return [hint, *(one for number, one in enumerate(problems) if number not in lacking)]


def _is_loose(root: Node) -> bool:
    """True for a ``<robot>`` without a name whose links all have a parent."""
    links = {link.getAttribute("name") for link in root.getElementsByTagName("link")}
    children = {child.getAttribute("link") for child in root.getElementsByTagName("child")}
    return bool(links) and links <= children and not root.hasAttribute("name")


def _lacking(problem: Problem) -> str:
    """The name that a problem is about, if it is one that another file may define."""
    if problem.code not in ("XAC001", "XAC010"):
        return ""
    found = _LACKING.search(problem.message)
    return found.group(1) if found else ""


def _help(top: str) -> str:
    return f"check the robot instead: urdfkit check {shown(top)}" if top else ""
